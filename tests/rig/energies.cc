// SPDX-License-Identifier: LGPL-2.1-or-later
// The ledger of a curve, its hysteresis, and small vibrations.
#include "rig/linear_limit.h"
#include "rig/rig_curve.h"
#include "test_rubber.h"

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <cmath>

namespace demold
{
  namespace
  {
    constexpr RigMode   all_modes[] = {RigMode::uniaxial,
                                       RigMode::equibiaxial,
                                       RigMode::pure_shear,
                                       RigMode::simple_shear,
                                       RigMode::confined};
    constexpr BranchLaw all_laws[]  = {BranchLaw::isochoric,
                                       BranchLaw::linear,
                                       BranchLaw::lubliner,
                                       BranchLaw::convolution};

    /// Loss over cycles within the reach of every mode.
    RigCurve cycles(const RubberLaw &law, const RigMode mode, const unsigned n)
    {
      Loading loading =
        triangle(0., mode == RigMode::confined ? .02 : .4, 1., 2);
      loading.time_step = 1. / n;
      return run_rig(law, mode, loading);
    }
  } // namespace



  TEST(RigLedger, closes_with_order_two_in_every_mode_and_variant)
  {
    RubberLaw law = test_rubber({{.5, .2}, {.3, 2.}});
    for (const BranchLaw branch_law : all_laws)
      for (const RigMode mode : all_modes)
        {
          law.branch_law      = branch_law;
          const double coarse = cycles(law, mode, 100).energy_balance_error();
          const double fine   = cycles(law, mode, 200).energy_balance_error();
          EXPECT_LT(coarse, 5e-3);
          EXPECT_NEAR(std::log2(coarse / fine), 2., .2)
            << static_cast<int>(branch_law) << ' ' << static_cast<int>(mode)
            << ' ' << coarse;
        }
  }

  TEST(RigLedger, a_jump_is_elastic)
  {
    RubberLaw law = test_rubber({{.5, .2}});
    for (const RigMode mode : all_modes)
      {
        Loading loading      = ramp_and_hold(.5, 0., 1e-9);
        loading.time_step    = 1e-9;
        const RigCurve curve = run_rig(law, mode, loading);
        EXPECT_EQ(curve.rows[1].time, 0.);
        EXPECT_EQ(curve.rows[1].dissipated, 0.);
        EXPECT_GT(curve.rows[1].work, .05);
        EXPECT_NEAR(curve.rows[1].work,
                    curve.rows[1].state.stored,
                    1e-8 * curve.rows[1].work);
      }
  }

  TEST(RigLedger, closes_in_creep_jump_included)
  {
    const RubberLaw law = test_rubber({{.5, .2}});
    for (const RigMode mode : all_modes)
      {
        Loading loading      = creep(.3, .4);
        loading.time_step    = 1e-3;
        const RigCurve curve = run_rig(law, mode, loading);
        EXPECT_GT(curve.rows[1].work, 1e-4);
        EXPECT_LT(curve.energy_balance_error(), 1e-4);
      }
  }

  TEST(RigLedger, an_elastic_law_has_no_hysteresis)
  {
    const RigCurve curve = cycles(test_rubber(), RigMode::uniaxial, 100);
    EXPECT_NEAR(curve.work_between(0., 1.), 0., 1e-14);
    EXPECT_EQ(curve.rows.back().dissipated, 0.);
  }

  TEST(Hysteresis, of_small_cycles_is_pi_times_loss_modulus_times_amplitude2)
  {
    const double tau = .3, f = 2., amplitude = 1e-3;
    for (const RigMode mode : all_modes)
      {
        const RubberLaw law     = test_rubber({{.5, tau}});
        Loading         loading = sine(0., amplitude, f, 12);
        loading.time_step       = 1. / f / 800.;
        const RigCurve curve    = run_rig(law, mode, loading);
        const double   factor   = mode == RigMode::equibiaxial ? 2. : 1.;
        const double   exact    = factor * dealii::numbers::PI *
                             wiechert_modulus(law, mode, f).imag() * amplitude *
                             amplitude;
        EXPECT_NEAR(curve.work_between(11. / f, 12. / f), exact, 2e-3 * exact);
      }
  }



  TEST(Wiechert, a_standard_linear_solid_has_the_values_of_E9)
  {
    // E_inf = 1, E_1 = 0.5 MPa, omega tau = 1; incompressible in the limit.
    RubberLaw    law;
    MooneyRivlin elastic;
    elastic.lambda      = 1e9;
    elastic.mu1         = 1. / 3.;
    elastic.mu2         = 0.;
    law.elastic         = elastic;
    law.branches        = {{.5 / 3., .2}};
    const double two_pi = 2. * dealii::numbers::PI;
    const auto   E      = wiechert_modulus(law, RigMode::uniaxial, 5. / two_pi);
    EXPECT_NEAR(E.real(), 1.25, 1e-8);
    EXPECT_NEAR(E.imag(), .25, 1e-8);
    const auto tan_psi = [&](const double omega) {
      const auto E = wiechert_modulus(law, RigMode::uniaxial, omega / two_pi);
      return E.imag() / E.real();
    };
    EXPECT_NEAR(tan_psi(4.0824829), .20412415, 5.1e-9);
    EXPECT_LT(tan_psi(4.), .20412415);
    EXPECT_LT(tan_psi(4.2), .20412415);
  }

  TEST(Wiechert, the_rig_finds_it_in_every_mode_and_variant)
  {
    RubberLaw law = test_rubber({{.5, .01}, {.3, .2}, {.2, 30.}});
    for (const BranchLaw branch_law : all_laws)
      for (const RigMode mode : all_modes)
        for (const double f : {.1, 1., 10.})
          {
            law.branch_law    = branch_law;
            Loading loading   = sine(0., 1e-4, f, 15);
            loading.time_step = 1. / f / 200.;
            const auto measured =
              measured_modulus(run_rig(law, mode, loading), f, 1e-4);
            const auto exact = wiechert_modulus(law, mode, f);
            EXPECT_LT(std::abs(measured - exact), 1e-4 * std::abs(exact))
              << static_cast<int>(branch_law) << ' ' << static_cast<int>(mode)
              << ' ' << f << ' ' << measured << exact;
          }
  }
} // namespace demold
