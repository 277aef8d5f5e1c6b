// SPDX-License-Identifier: LGPL-2.1-or-later
// Newton's method for what the grips leave free.
#include "rig/rig_point.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace demold
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int n_iterations_max = 60;

    // Newton's error after a correction is of the order of its square, so that
    // one of this size leaves round-off only.
    constexpr double last_correction = 1e-9;

    // After this many relaxation times what is left is below round-off.
    constexpr double long_time = 1e15;

    double longest_relaxation_time(const RubberLaw &law)
    {
      double longest = 1.;
      for (const auto &branch : law.branches)
        longest = std::max(longest, branch.relaxation_time);
      return longest;
    }

    SymmetricTensor<2, 3> right_cauchy_green(const Tensor<2, 3> &F)
    {
      return symmetrize(transpose(F) * F);
    }
  } // namespace



  RigPoint::RigPoint(const RubberLaw &law, const RigMode mode)
    : law(law)
    , kinematics(mode)
    , old_history(law.n_history())
    , new_history(law.n_history())
  {
    law.initialize(old_history.data());
  }

  void RigPoint::rest(const double strain)
  {
    strain_step(strain, long_time * longest_relaxation_time(law));
    now.dissipated = 0.;
    commit();
  }

  const RigState &RigPoint::strain_step(const double strain, const double dt)
  {
    solve(strain, false, 0., dt);
    return now;
  }

  const RigState &RigPoint::stress_step(const double nominal, const double dt)
  {
    solve(committed.strain, true, nominal, dt);
    return now;
  }

  void RigPoint::commit()
  {
    std::swap(old_history, new_history);
    committed = now;
  }



  RigPoint::Equations RigPoint::evaluate(const double x,
                                         const double l,
                                         const double dt,
                                         const double nominal)
  {
    const Tensor<2, 3> F = kinematics.F(x, l);
    law.evaluate(right_cauchy_green(F),
                 dt,
                 old_history.data(),
                 new_history.data(),
                 true,
                 response,
                 false);
    const Tensor<2, 3> S         = response.S;
    const Tensor<2, 3> modes[]   = {kinematics.driven, kinematics.lateral};
    const double       applied[] = {kinematics.n_driven * nominal, 0.};

    Equations equations;
    for (unsigned int a = 0; a < 2; ++a)
      {
        equations.residual[a] = scalar_product(F * S, modes[a]) - applied[a];
        for (unsigned int b = 0; b < 2; ++b)
          {
            const SymmetricTensor<2, 3> dE =
              symmetrize(transpose(F) * modes[b]);
            const Tensor<2, 3> dS = response.dS_dE * dE;
            equations.tangent[a][b] =
              scalar_product(modes[b] * S + F * dS, modes[a]);
          }
      }
    return equations;
  }



  std::array<double, 2> RigPoint::correction(const Equations &equations,
                                             const bool       driven_free) const
  {
    const auto &r = equations.residual;
    const auto &K = equations.tangent;
    if (kinematics.n_lateral == 0)
      return {{driven_free ? -r[0] / K[0][0] : 0., 0.}};
    if (!driven_free)
      return {{0., -r[1] / K[1][1]}};
    const double det = K[0][0] * K[1][1] - K[0][1] * K[1][0];
    return {{(K[0][1] * r[1] - K[1][1] * r[0]) / det,
             (K[1][0] * r[0] - K[0][0] * r[1]) / det}};
  }



  void RigPoint::solve(const double strain,
                       const bool   driven_free,
                       const double nominal,
                       const double dt)
  {
    const RigKinematics &k = kinematics;
    // The volume hardly changes: start from that of the last step.
    const double x_old = k.coordinate(committed.strain);
    double       J     = determinant(k.F(x_old, committed.lateral));
    double       x     = k.coordinate(strain);
    double       l     = k.lateral_of_volume(x, J);

    newton_corrections.clear();
    for (;;)
      {
        if (!driven_free && k.n_lateral == 0)
          break;
        const auto delta = correction(evaluate(x, l, dt, nominal), driven_free);
        const double relative_x = delta[0] / (k.is_shear ? 1. : x);
        const double relative_l = delta[1] / l;
        const double size =
          std::max(std::abs(relative_x), std::abs(relative_l));
        const double stretching =
          k.is_shear ? 0. : k.n_driven * relative_x + k.n_lateral * relative_l;
        newton_corrections.push_back(size);
        if (newton_corrections.size() > n_iterations_max ||
            !std::isfinite(size))
          {
            std::ostringstream text;
            text << "the rig finds no equilibrium at a strain of "
                 << k.strain(x) << ", step of " << dt
                 << " s. A smaller strain or stress, or a smaller time step "
                    "may help; under a prescribed stress there may be none.";
            throw std::runtime_error(text.str());
          }

        // Neither turn inside out nor run away. The volume is what is stiff:
        // it takes the linear change, and the lateral stretch follows.
        const double limit =
          std::min(1., .5 / std::max({size, std::abs(stretching), 1e-300}));
        J *= 1. + limit * stretching;
        x += limit * delta[0];
        l = k.lateral_of_volume(x, J);
        if (size <= last_correction)
          break;
      }
    finish(x, l, dt);
  }



  void RigPoint::finish(const double x, const double l, const double dt)
  {
    const Tensor<2, 3> F = kinematics.F(x, l);
    law.evaluate(right_cauchy_green(F),
                 dt,
                 old_history.data(),
                 new_history.data(),
                 false,
                 response);
    const Tensor<2, 3> S = response.S;
    const Tensor<2, 3> P = F * S;
    now.strain           = kinematics.strain(x);
    now.lateral          = l;
    now.nominal          = kinematics.component(P);
    now.force            = scalar_product(P, kinematics.driven);
    now.cauchy           = symmetrize(P * transpose(F)) / determinant(F);
    now.stored           = response.stored;
    now.dissipated       = response.dissipated;
    now.n_iterations     = newton_corrections.size();
  }
} // namespace demold
