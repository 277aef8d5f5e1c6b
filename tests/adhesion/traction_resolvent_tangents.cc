// SPDX-License-Identifier: LGPL-2.1-or-later
// Derivatives of the point law match central differences on every branch.
#include "resolvents.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>

namespace demold
{
  using namespace dealii;

  using State   = std::pair<AdhesionStatus, ContactStatus>;
  using Reached = std::map<State, unsigned int>;

  /// One argument moved by a small number.
  using Change = std::function<void(ResolventSample &, double)>;

  /// By lambda_hat_N, by lambda_hat_T along two axes, by g_T^n along both.
  struct Direction
  {
    Change  change;
    double  dN;
    Vector3 dT;
    double  dpath;
    double  unit; // of the argument over that of a traction
    bool    has_path;
  };

  std::vector<Direction> directions(const TractionResolvent &law,
                                    const ResolventSample   &s,
                                    const ResolventResponse &r)
  {
    std::vector<Direction> all;
    all.push_back(
      {[](ResolventSample &x, const double h) { x.traction.normal += h; },
       r.dN_dN,
       r.dT_dN,
       r.dpath_dN,
       1.,
       true});
    std::mt19937  engine(7);
    const Vector3 t = random_tangent(s.normal, engine);
    for (const Vector3 &axis : {t, cross_product_3d(s.normal, t)})
      {
        all.push_back({[axis](ResolventSample &x, const double h) {
                         x.traction.tangential += h * axis;
                       },
                       r.dN_dT * axis,
                       r.dT_dT * axis,
                       r.dpath_dT * axis,
                       1.,
                       true});
        if (s.traction.normal < 0. && s.old.slip.norm() > 0.)
          all.push_back({[axis](ResolventSample &x, const double h) {
                           x.old.slip += h * axis;
                         },
                         0.,
                         r.dT_dslip * axis,
                         0.,
                         law.tangential_penalty(),
                         false});
      }
    return all;
  }



  // Compares unless a neighbour is on another branch; true if compared.
  bool compare(const TractionResolvent          &law,
               const ResolventSample            &s,
               const std::optional<ForcedBranch> forced)
  {
    const auto   r    = law.evaluate(s.traction, s.old, forced);
    const double size = std::abs(s.traction.normal) +
                        s.traction.tangential.norm() +
                        law.tangential_penalty() * s.old.slip.norm();
    // Between the strength, over which curves bend, and round-off of the size.
    const double step = 3e-6 * std::sqrt(alpha * (size + .01 * alpha));
    const auto   at   = [&](const Direction &d, const double h) {
      ResolventSample x = s;
      d.change(x, h);
      return law.evaluate(x.traction, x.old, forced);
    };
    const double stiffest = law.penalty - law.smallest_penalty() / 5.;
    const double unit =
      std::max({1., 1. / law.factors().a, law.friction / law.factors().a}) /
      stiffest;
    const auto all = directions(law, s, r);
    for (const Direction &d : all)
      for (const double far : {-30., 30.})
        {
          const auto x = at(d, far * step / d.unit);
          if (x.bond != r.bond || x.contact != r.contact ||
              x.consistent != r.consistent || (x.slide - r.slide).norm() > .05)
            return false;
        }
    for (const Direction &d : all)
      {
        const double h     = step / d.unit;
        const double scale = unit * d.unit;
        const auto   x = at(d, h), y = at(d, -h);
        const auto   xx = at(d, 2. * h), yy = at(d, -2. * h);
        // Fourth order: friction turns sharply where little of it slides.
        const auto slope = [&](const auto value) {
          return (8. * (value(x) - value(y)) - (value(xx) - value(yy))) /
                 (12. * h);
        };
        EXPECT_NEAR(slope([](const auto &q) { return q.gap_N; }),
                    d.dN,
                    1e-7 * scale);
        EXPECT_LT((slope([](const auto &q) { return q.gap_T; }) - d.dT).norm(),
                  1e-7 * scale)
          << int(r.bond) << " " << int(r.contact);
        if (d.has_path && r.bond == AdhesionStatus::decohesion)
          {
            EXPECT_NEAR(slope([](const auto &q) { return q.path_increment; }),
                        d.dpath,
                        1e-7 * scale * alpha);
          }
      }
    return true;
  }



  TEST(traction_resolvent, tangents_match_differences)
  {
    std::mt19937 engine(4);
    Reached      reached;
    for (const TractionResolvent &law : all_resolvents())
      for (unsigned int i = 0; i < 1500; ++i)
        {
          const auto s = random_sample(law, engine);
          if (compare(law, s, {}))
            {
              const auto r = law.evaluate(s.traction, s.old);
              ++reached[{r.bond, r.contact}];
            }
          ASSERT_FALSE(HasFailure());
        }
    EXPECT_EQ(reached.size(), 11u);
    for (const auto &[state, n] : reached)
      EXPECT_GE(n, 100u) << int(state.first) << " " << int(state.second);
  }



  TEST(traction_resolvent, forced_tangents_match_differences)
  {
    std::mt19937 engine(5);
    unsigned int against = 0;
    for (const TractionResolvent &law : all_resolvents())
      for (unsigned int i = 0; i < 500; ++i)
        for (const auto forced : {ForcedBranch::hold, ForcedBranch::decohesion})
          {
            const auto s = random_sample(law, engine);
            if (s.traction.tangential.norm() < .1 * alpha)
              continue;
            compare(law, s, forced);
            against += !law.evaluate(s.traction, s.old, forced).consistent;
            ASSERT_FALSE(HasFailure()) << int(forced);
          }
    EXPECT_GE(against, 1000u);
  }



  TEST(traction_resolvent, tangent_is_symmetric_with_a_potential)
  {
    std::mt19937 engine(6);
    for (const TractionResolvent &law : all_resolvents())
      if (law.adhesion->symmetric() && law.friction == 0.)
        for (unsigned int i = 0; i < 300; ++i)
          {
            const auto   s = random_sample(law, engine);
            const auto   r = law.evaluate(s.traction, s.old);
            const double unit =
              1. /
              (law.factors().a * (law.penalty - law.smallest_penalty() / 5.));
            ASSERT_LT((r.dN_dT - r.dT_dN).norm(), 1e-13 * unit);
            ASSERT_LT((r.dT_dT - transpose(r.dT_dT)).norm(), 1e-13 * unit);
          }
  }
} // namespace demold
