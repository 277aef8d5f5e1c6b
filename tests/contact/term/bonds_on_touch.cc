// SPDX-License-Identifier: LGPL-2.1-or-later
// With `bonds form = on touch` points bond where they have been pressed, to the
// surface itself, and only once.
#include "two_surfaces.h"

#include <gtest/gtest.h>

using namespace demold;
using dealii::Tensor;

namespace
{
  constexpr double strength = .2, rupture = .1, penalty = 20.;

  /// The slave 0.3 mm above a level master; only x < 0.1 may bond.
  TwoSurfaces surfaces(const unsigned int dim, const MasterKind kind)
  {
    InterfaceDescription description;
    AdhesionLaw          law;
    law.softening              = LinearSoftening{strength, rupture, penalty};
    description.adhesion       = law;
    description.bonds_on_touch = true;
    description.bonded    = [](const dealii::Point<3> &X) { return X[0] < .1; };
    const HeightOf plane  = [](double, double) { return 0.; };
    const HeightOf raised = [](double, double) { return .3; };
    return TwoSurfaces({dim, 2, -1., 1., raised, false},
                       {dim, 3, -2., 2., plane, true},
                       kind,
                       description);
  }

  TwoSurfaces::Values at_gap(const TwoSurfaces &pair, const double gap)
  {
    Tensor<1, 3> shift;
    shift[pair.dim - 1] = gap - .3;
    return pair.shifted_slave(shift);
  }

  template <typename Claim>
  void for_all_masters(const Claim &claim)
  {
    for (const unsigned int dim : {2u, 3u})
      for (const MasterKind kind : {MasterKind::rigid, MasterKind::deformable})
        {
          SCOPED_TRACE(std::to_string(dim) + "-D");
          TwoSurfaces pair = surfaces(dim, kind);
          claim(pair);
        }
  }

  // Points at -1, 0 and 1: the last may not bond.
  constexpr double share = .75;
} // namespace

TEST(BondsOnTouch, form_where_the_scene_lets_them_and_pressure_has_been)
{
  for_all_masters([](TwoSurfaces &pair) {
    const double area = pair.term->sums().area;
    pair.accept(at_gap(pair, .001));
    EXPECT_EQ(pair.term->sums().bonded, 0.);
    pair.accept(at_gap(pair, -.002));
    EXPECT_NEAR(pair.term->sums().bonded, share * area, 1e-12);
  });
}

TEST(BondsOnTouch, pull_from_the_surface_of_the_master)
{
  for_all_masters([](TwoSurfaces &pair) {
    pair.accept(at_gap(pair, -.002));
    for (const double gap : {0., .004})
      {
        pair.evaluate(at_gap(pair, gap));
        EXPECT_NEAR(pair.term->sums().force[pair.dim - 1],
                    -penalty * gap * share * pair.term->sums().area,
                    1e-12);
      }
  });
}

TEST(BondsOnTouch, form_once)
{
  for_all_masters([](TwoSurfaces &pair) {
    const double area = pair.term->sums().area;
    for (const double gap : {-.002, 1.1 * rupture, -.002})
      pair.accept(at_gap(pair, gap));
    EXPECT_EQ(pair.term->sums().bonded, 0.);
    EXPECT_NEAR(pair.term->energies().adhesion,
                .5 * strength * rupture * share * area,
                1e-12);
  });
}
