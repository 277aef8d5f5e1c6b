// SPDX-License-Identifier: LGPL-2.1-or-later
// One run of the rig and the numbers it is asked for.
#include "rig/protocol_run.h"

#include "rig/linear_limit.h"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace demold
{
  namespace
  {
    /// The curve, and the CPU time of one pass [s].
    RigCurve timed_curve(const ProtocolCase &test,
                         const RigMode       mode,
                         double             &seconds)
    {
      constexpr double enough = .05;
      const auto       start  = std::clock();
      RigCurve         curve;
      unsigned int     n = 0;
      do
        {
          curve = run_rig(test.law, mode, test.loading);
          ++n;
          seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      } while (seconds < enough && n < 1000);
      seconds /= n;
      return curve;
    }



    void add_cycles(const ProtocolParameters &p, ProtocolRun &run)
    {
      const double period = 1. / run.test.swept;
      const auto   loop   = [&](const unsigned int i) {
        return run.curve.work_between(i * period, (i + 1) * period);
      };
      run.quantities.emplace_back("hysteresis of first cycle [mJ/mm^3]",
                                  loop(0));
      run.quantities.emplace_back("hysteresis of last cycle [mJ/mm^3]",
                                  loop(p.n_cycles - 1));
    }



    void add_moduli(const ProtocolParameters &p, ProtocolRun &run)
    {
      const auto add = [&](const std::string          &name,
                           const std::complex<double> &modulus) {
        run.quantities.emplace_back(name + "storage modulus [MPa]",
                                    modulus.real());
        run.quantities.emplace_back(name + "loss modulus [MPa]",
                                    modulus.imag());
        run.quantities.emplace_back(name + "tan psi [-]",
                                    modulus.imag() / modulus.real());
      };
      const auto measured =
        measured_modulus(run.curve, run.test.swept, p.strain);
      add("", measured);
      if (!p.wants_reference())
        return;
      const auto exact =
        wiechert_modulus(run.test.law, p.mode(), run.test.swept);
      add("reference ", exact);
      run.quantities.emplace_back("relative error [-]",
                                  std::abs(measured - exact) / std::abs(exact));
    }



    void add_reference(const ProtocolParameters &p, ProtocolRun &run)
    {
      const bool creep  = run.test.loading.stress_prescribed;
      run.reference     = relaxation_reference(run.test.law,
                                           p.mode(),
                                           run.test.loading,
                                           run.curve,
                                           p.tolerance);
      const auto &exact = creep ? run.reference.strain : run.reference.nominal;
      double      largest = 0., largest_gap = 0., gap = 0.;
      for (std::size_t i = 0; i < exact.size(); ++i)
        {
          const RigState &state = run.curve.rows[i].state;
          gap     = std::abs((creep ? state.strain : state.nominal) - exact[i]);
          largest = std::max(largest, std::abs(exact[i]));
          largest_gap = std::max(largest_gap, gap);
        }
      // Cycles end where the stress passes through 0.
      const double scale =
        p.programme() == Programme::cycles ? largest : std::abs(exact.back());
      run.quantities.emplace_back(creep ? "reference strain at end [-]" :
                                          "reference stress at end [MPa]",
                                  exact.back());
      run.quantities.emplace_back("relative error [-]", gap / scale);
      run.quantities.emplace_back("largest relative error [-]",
                                  largest_gap / largest);
      run.quantities.emplace_back("reference steps", run.reference.n_steps);
    }
  } // namespace



  ProtocolRun run_protocol(const ProtocolParameters &p,
                           const ProtocolCase       &test)
  {
    ProtocolRun run;
    double      seconds = 0.;
    run.test            = test;
    run.curve           = timed_curve(test, p.mode(), seconds);

    const RigRow &last    = run.curve.rows.back();
    const double  largest = run.curve.largest_nominal(),
                 smallest = run.curve.smallest_nominal();
    run.quantities        = {
             {"stress at end [MPa]", last.state.nominal},
             {"strain at end [-]", last.state.strain},
             {"lateral stretch at end [-]", last.state.lateral},
             {"peak stress [MPa]", largest > -smallest ? largest : smallest},
             {"stored energy [mJ/mm^3]",
              last.state.stored - run.curve.rows.front().state.stored},
             {"dissipated energy [mJ/mm^3]", last.dissipated},
             {"work [mJ/mm^3]", last.work},
             {"energy balance error [-]", run.curve.energy_balance_error()}};
    if (p.programme() == Programme::cycles)
      add_cycles(p, run);
    if (p.programme() == Programme::frequency_sweep)
      add_moduli(p, run);
    else if (p.wants_reference())
      add_reference(p, run);
    run.quantities.emplace_back("steps", test.loading.times().size());
    run.quantities.emplace_back("newton iterations", run.curve.n_iterations());
    run.quantities.emplace_back("cpu time [s]", seconds);
    return run;
  }
} // namespace demold
