// SPDX-License-Identifier: LGPL-2.1-or-later
// Tangents of the bond match central differences on every branch.
#include "adhesion/adhesion_law.h"
#include "adhesion/gap_path.h"

#include "bonds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace demold
{
  using namespace dealii;

  struct Sample
  {
    Vector3       gap, normal;
    AdhesionState old;
  };

  // Gaps on every branch, opened and pressed, with random damage before.
  Sample random_sample(const AdhesionLaw &law, std::mt19937 &engine)
  {
    std::uniform_real_distribution<double> unit(0., 1.);
    Sample                                 s;
    s.normal             = random_direction(engine);
    const Vector3 t      = random_tangent(s.normal, engine);
    const double  angle  = 2. * std::acos(-1.) * unit(engine);
    const double  c      = std::cos(angle);
    const double  opened = c > 0. ? c : 0.;
    const double  slip   = std::sin(angle);
    const double  length =
      std::sqrt(opened * opened + std::pow(law.factors.b * slip, 2));
    // Most of the traction is lost over the first few lengths of a long tail.
    const double reach = std::min(law.rupture_gap(), 0.3);
    const double size  = unit(engine) < .3 ? law.onset_gap() : 1.1 * reach;
    s.gap = size * unit(engine) / length * (c * s.normal + slip * t);
    if (unit(engine) < .7)
      s.old.kappa = law.onset_gap() + unit(engine) * reach * .8;
    return s;
  }

  bool pressed(const Sample &s)
  {
    return s.gap * s.normal < 0.;
  }

  double effective_gap(const AdhesionLaw &law, const Sample &s)
  {
    return std::sqrt(
      GapPath{s.gap, s.gap, s.normal, law.factors}.effective_squared(0.));
  }

  // Near a kink differences mix two branches.
  bool on_one_branch(const AdhesionLaw &law, const Sample &s, const double h)
  {
    const auto   r   = law.evaluate(s.gap, s.normal, s.old);
    const double far = 10. * h;
    for (unsigned int d = 0; d < 3; ++d)
      for (const double sign : {-1., 1.})
        {
          Vector3 gap = s.gap;
          gap[d] += sign * far * (1. + 1. / law.factors.b);
          const auto q = law.evaluate(gap, s.normal, s.old);
          if (q.status != r.status)
            return false;
        }
    return std::abs(s.gap * s.normal) > far;
  }

  using Reached = std::map<std::pair<AdhesionStatus, bool>, unsigned int>;

  void compare(const AdhesionLaw &law, const Sample &s, const double h)
  {
    const auto   r = law.evaluate(s.gap, s.normal, s.old);
    Tensor<2, 3> by_gap;
    Vector3      increment, kappa;
    for (unsigned int d = 0; d < 3; ++d)
      {
        Vector3 step;
        step[d]         = h;
        const auto plus = law.evaluate(s.gap + step, s.normal, s.old);
        const auto less = law.evaluate(s.gap - step, s.normal, s.old);
        for (unsigned int e = 0; e < 3; ++e)
          by_gap[e][d] = (plus.traction[e] - less.traction[e]) / (2. * h);
        increment[d] = (plus.path_increment - less.path_increment) / (2. * h);
        kappa[d]     = (plus.state.kappa - less.state.kappa) / (2. * h);
      }
    const double scale = std::max(r.dt_dg.norm(), 1e-3);
    EXPECT_LT((r.dt_dg - by_gap).norm(), 1e-6 * scale);
    EXPECT_LT((r.path_gradient - increment).norm(), 1e-7);
    EXPECT_LT((r.dkappa_dg - kappa).norm(), 1e-6);

    std::mt19937 engine(3);
    const double size = s.gap.norm();
    for (unsigned int i = 0; i < 2; ++i)
      {
        const Vector3 t    = random_tangent(s.normal, engine);
        const double  turn = h / size;
        const auto    at   = [&](const double sign) {
          const Vector3 n = s.normal + sign * turn * t;
          return law.evaluate(s.gap, n / n.norm(), s.old).traction;
        };
        const Vector3 by_normal = (at(1.) - at(-1.)) / (2. * turn);
        EXPECT_LT((r.dt_dn * t - by_normal).norm(),
                  1e-6 * std::max(r.dt_dn.norm(), scale * size));
      }
    // g_T = g - g_N n keeps that many digits less at right angles to n.
    const double digits = size / effective_gap(law, s);
    EXPECT_LT((r.dt_dn * s.normal).norm(),
              1e-14 * (1. + digits) * (1. + r.dt_dn.norm()));
  }

  TEST(adhesion_tangents, match_differences_on_every_branch)
  {
    std::mt19937 engine(20140627);
    for (const AdhesionLaw &law : all_bonds())
      {
        Reached reached;
        for (unsigned int i = 0; i < 1000; ++i)
          {
            const Sample s = random_sample(law, engine);
            // A pressed gap is long, but what bends the law is its effective
            // part.
            const double h = 3e-6 * effective_gap(law, s);
            if (!on_one_branch(law, s, h))
              continue;
            compare(law, s, h);
            const auto r = law.evaluate(s.gap, s.normal, s.old);
            ++reached[{r.status, pressed(s)}];
          }
        for (const auto status : {AdhesionStatus::adhering,
                                  AdhesionStatus::decohesion,
                                  AdhesionStatus::unloading})
          for (const bool closed : {false, true})
            EXPECT_GT((reached[{status, closed}]), 5u);
        if (law.rupture_gap() < .3)
          {
            EXPECT_GT((reached[{AdhesionStatus::separated, false}]), 5u);
          }
      }
  }

  TEST(adhesion_tangents, are_symmetric_exactly_if_the_law_says_so)
  {
    std::mt19937 engine(7);
    for (const AdhesionLaw &law : all_bonds())
      {
        double       worst = 0.;
        unsigned int n     = 0;
        while (n < 50)
          {
            const Sample s = random_sample(law, engine);
            const auto   r = law.evaluate(s.gap, s.normal, s.old);
            if (r.status != AdhesionStatus::decohesion || pressed(s))
              continue;
            ++n;
            worst =
              std::max(worst,
                       (r.dt_dg - transpose(r.dt_dg)).norm() / r.dt_dg.norm());
          }
        EXPECT_EQ(worst < 1e-14, law.symmetric());
        EXPECT_EQ(worst < 1e-2, law.symmetric());
      }
    EXPECT_TRUE(make_bond(LinearSoftening(), ModeMixing::energy).symmetric());
    EXPECT_TRUE(
      make_bond(LinearSoftening(), ModeMixing::isotropic).symmetric());
    EXPECT_FALSE(
      make_bond(LinearSoftening(), ModeMixing::slip_limit).symmetric());
    EXPECT_FALSE(
      make_bond(LinearSoftening(), ModeMixing::proportional).symmetric());
  }
} // namespace demold
