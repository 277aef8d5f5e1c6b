// SPDX-License-Identifier: LGPL-2.1-or-later
// Points that lie on the master at the start are bonded wherever they lie, and
// none that the depth limit allows is lost on the way in.
#include "two_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace demold;
using dealii::Tensor;

namespace
{
  InterfaceDescription bonded()
  {
    InterfaceDescription description;
    AdhesionLaw          law;
    law.softening        = LinearSoftening{.2, .1, 20.};
    description.adhesion = law;
    return description;
  }

  double bonded_share(const TwoSurfaces &pair)
  {
    const InterfaceSums sums = pair.term->sums();
    return sums.bonded / sums.area;
  }

  constexpr MasterKind both_kinds[] = {MasterKind::rigid,
                                       MasterKind::deformable};

  /// Ridges of two sides 33 degree apart, one smooth patch. A point straight
  /// above the top has its foot on neither side.
  const HeightOf ridge = [](double x, double) { return -.3 * std::abs(x); };
  const HeightOf tip   = [](double x, double y) {
    return -.3 * std::abs(x) - .3 * std::abs(y);
  };
} // namespace

TEST(FirstMeeting, bonds_points_over_an_edge_or_vertex_of_the_master)
{
  for (const unsigned int dim : {2u, 3u})
    for (const MasterKind kind : both_kinds)
      for (const HeightOf &hill : {ridge, tip})
        {
          SCOPED_TRACE(std::to_string(dim) + "-D");
          const auto above = [=](double x, double y) {
            return hill(x, y) + .02;
          };
          TwoSurfaces pair({dim, 2, -1., 1., above, false},
                           {dim, 2, -2., 2., hill, true},
                           kind,
                           bonded());
          EXPECT_NEAR(bonded_share(pair), 1., 1e-12);
          // Free of stress, and alive.
          const auto at_rest = pair.evaluate(TwoSurfaces::Values(pair.n, 0.));
          EXPECT_LT(at_rest.R.linfty_norm(), 1e-12);
          Tensor<1, 3> up;
          up[dim - 1] = .005;
          EXPECT_GT(pair.evaluate(pair.shifted_slave(up)).R.linfty_norm(), .01);
        }
}

TEST(FirstMeeting, bonds_every_point_on_the_border_between_facets)
{
  // Oblique facets of awkward sizes: round-off decides on which side of a
  // border, and of the surface, a node is.
  const HeightOf slope = [](double x, double y) { return .31 * x - .17 * y; };
  for (const unsigned int n : {3u, 7u, 11u})
    for (const double shift : {0., 1.3, 17.9})
      {
        SCOPED_TRACE(n);
        TwoSurfaces pair({3, 2 * n, shift - .7, shift + .7, slope, false},
                         {3, 3 * n, shift - 1.05, shift + 1.05, slope, true},
                         MasterKind::rigid,
                         bonded());
        EXPECT_NEAR(bonded_share(pair), 1., 1e-12);
      }
}

TEST(FirstMeeting, finds_facets_as_deep_as_is_believed)
{
  // Cells of 4 mm believe 2 mm, far beyond the search distance.
  InterfaceDescription description;
  description.search_distance = .05;
  description.skin            = .02;
  const HeightOf plane        = [](double, double) { return 0.; };
  for (const unsigned int dim : {2u, 3u})
    for (const MasterKind kind : both_kinds)
      {
        SCOPED_TRACE(std::to_string(dim) + "-D");
        TwoSurfaces  pair({dim, 2, -1., 1., plane, false},
                         {dim, 2, -2., 2., plane, true},
                         kind,
                         description);
        Tensor<1, 3> down;
        down[dim - 1] = -1.9;
        pair.evaluate(pair.shifted_slave(down));
        EXPECT_EQ(pair.count(4), dim == 2 ? 3u : 9u);
      }
}
