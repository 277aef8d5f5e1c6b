// SPDX-License-Identifier: LGPL-2.1-or-later
// The curve of a programme by an error-controlled integrator.
#include "rig/relaxation_reference.h"

#include "rig/dae_solver.h"
#include "rig/flow_rule.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// The unknowns: what the grips leave free (strain if a stress is
    /// prescribed, lateral stretch), then six of each branch.
    class RigEquations
    {
    public:
      RigEquations(const RubberLaw &law,
                   const RigMode    mode,
                   const Loading   &loading)
        : flow(law)
        , kinematics(mode)
        , loading(loading)
        , n_free((loading.stress_prescribed ? 1 : 0) +
                 (kinematics.n_lateral > 0 ? 1 : 0))
      {}

      unsigned int n_unknowns() const
      {
        return n_free + 6 * flow.n_branches();
      }

      std::vector<bool> differential() const
      {
        std::vector<bool> list(n_unknowns(), true);
        std::fill_n(list.begin(), n_free, false);
        return list;
      }

      /// Driven coordinate and lateral stretch.
      std::pair<double, double> stretches(const double t, const double *y) const
      {
        const double x = loading.stress_prescribed ?
                           *y++ :
                           kinematics.coordinate(loading.value(t));
        return {x, kinematics.n_lateral > 0 ? *y : 1.};
      }

      double strain(const double t, const double *y) const
      {
        return kinematics.strain(stretches(t, y).first);
      }

      static SymmetricTensor<2, 3> tensor(const double *values)
      {
        SymmetricTensor<2, 3> A;
        std::copy(values, values + 6, A.begin_raw());
        return A;
      }

      FlowRule::Point point(const Tensor<2, 3> &F) const
      {
        return flow.at(symmetrize(transpose(F) * F));
      }

      /// Nominal stress [MPa].
      Tensor<2, 3> stress(const double t, const double *y) const
      {
        const auto            s = stretches(t, y);
        const Tensor<2, 3>    F = kinematics.F(s.first, s.second);
        const FlowRule::Point x = point(F);
        SymmetricTensor<2, 3> S = x.S_elastic;
        for (unsigned int j = 0; j < flow.n_branches(); ++j)
          S += flow.stress(x, tensor(y + n_free + 6 * j), j);
        return F * Tensor<2, 3>(S);
      }

      double nominal(const double t, const double *y) const
      {
        return kinematics.component(stress(t, y));
      }

      /// The forces that must vanish, per bulk modulus [-].
      void balance(const double t, const double *y, double *r) const
      {
        const Tensor<2, 3> P = stress(t, y);
        if (loading.stress_prescribed)
          *r++ =
            (kinematics.component(P) - loading.value(t)) / flow.bulk_modulus();
        if (kinematics.n_lateral > 0)
          *r++ = scalar_product(P, kinematics.lateral) / flow.bulk_modulus();
      }

      bool residual(const double  t,
                    const double *y,
                    const double *yp,
                    double       *r) const
      {
        const auto         s = stretches(t, y);
        const Tensor<2, 3> F = kinematics.F(s.first, s.second);
        if (!(determinant(F) > 0.))
          return false;
        balance(t, y, r);
        const FlowRule::Point x = point(F);
        for (unsigned int i = n_free; i < n_unknowns(); i += 6)
          {
            const auto rate = flow.rate(x, tensor(y + i), (i - n_free) / 6);
            for (unsigned int k = 0; k < 6; ++k)
              r[i + k] = yp[i + k] - rate.begin_raw()[k];
          }
        return true;
      }

      /// Makes the balance exact at given inner variables. Where the rubber is
      /// nearly incompressible, an error of the lateral stretch within IDA's
      /// tolerance would be a large stress.
      void polish(const double t, std::vector<double> &y) const
      {
        if (n_free == 0)
          return;
        constexpr unsigned int n_sweeps = 6;
        constexpr double       step     = 1e-6;
        for (unsigned int sweep = 0; sweep < n_sweeps; ++sweep)
          {
            double r[2] = {0., 0.}, K[2][2] = {{1., 0.}, {0., 1.}};
            balance(t, y.data(), r);
            for (unsigned int b = 0; b < n_free; ++b)
              {
                double       plus[2], minus[2];
                const double value = y[b];
                y[b]               = value + step;
                balance(t, y.data(), plus);
                y[b] = value - step;
                balance(t, y.data(), minus);
                y[b] = value;
                for (unsigned int a = 0; a < n_free; ++a)
                  K[a][b] = (plus[a] - minus[a]) / (2. * step);
              }
            const double det = K[0][0] * K[1][1] - K[0][1] * K[1][0];
            y[0] -= (K[1][1] * r[0] - K[0][1] * r[1]) / det;
            if (n_free == 2)
              y[1] -= (K[0][0] * r[1] - K[1][0] * r[0]) / det;
          }
      }

      /// All relaxed at the strain of rest; the free ones as guessed.
      std::vector<double> initial(const RigState &rest,
                                  const RigState &guess) const
      {
        std::vector<double> y;
        if (loading.stress_prescribed)
          y.push_back(kinematics.coordinate(guess.strain));
        if (kinematics.n_lateral > 0)
          y.push_back(guess.lateral);
        const auto x =
          point(kinematics.F(kinematics.coordinate(rest.strain), rest.lateral));
        const SymmetricTensor<2, 3> A = flow.relaxed(x);
        for (unsigned int j = 0; j < flow.n_branches(); ++j)
          y.insert(y.end(), A.begin_raw(), A.begin_raw() + 6);
        return y;
      }

    private:
      const FlowRule      flow;
      const RigKinematics kinematics;
      const Loading      &loading;
      const unsigned int  n_free;
    };
  } // namespace



  RelaxationReference relaxation_reference(const RubberLaw &law,
                                           const RigMode    mode,
                                           const Loading   &loading,
                                           const RigCurve  &curve,
                                           const double     tolerance)
  {
    const RigEquations  equations(law, mode, loading);
    RelaxationReference reference;
    // Rest is an equilibrium, not a solution in time.
    reference.nominal.push_back(curve.rows.front().state.nominal);
    reference.strain.push_back(curve.rows.front().state.strain);
    const auto add = [&](const double t, std::vector<double> y) {
      equations.polish(t, y);
      reference.nominal.push_back(equations.nominal(t, y.data()));
      reference.strain.push_back(equations.strain(t, y.data()));
    };

    const std::size_t   first = loading.jumps() ? 2 : 1;
    std::vector<double> start =
      equations.initial(curve.rows.front().state, curve.rows[first - 1].state);
    equations.polish(0., start);
    if (loading.jumps())
      add(0., start);
    if (equations.n_unknowns() == 0 || law.branches.empty())
      {
        for (std::size_t i = first; i < curve.rows.size(); ++i)
          {
            if (!start.empty())
              start = equations.initial(curve.rows.front().state,
                                        curve.rows[i].state);
            add(curve.rows[i].time, start);
          }
        return reference;
      }

    DaeProblem problem;
    problem.residual =
      [&](const double t, const double *y, const double *yp, double *r) {
        return equations.residual(t, y, yp, r);
      };
    problem.differential       = equations.differential();
    problem.relative_tolerance = tolerance;
    problem.absolute_tolerance = 1e-2 * tolerance;
    auto      corner           = std::next(loading.corners.begin());
    DaeSolver ida(problem, start, *corner);
    for (std::size_t i = first; i < curve.rows.size(); ++i)
      {
        const double time = curve.rows[i].time;
        ida.advance(time, *corner);
        add(time, ida.state());
        if (time == *corner && std::next(corner) != loading.corners.end())
          ida.restart(*++corner);
      }
    reference.n_steps = ida.n_steps();
    return reference;
  }
} // namespace demold
