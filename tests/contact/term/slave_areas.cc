// SPDX-License-Identifier: LGPL-2.1-or-later
// Areas of slave points: closed forms of the integrals of shape functions.
#include "contact/slave_points.h"

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

#include <functional>

using namespace demold;
using dealii::Point;

namespace
{
  constexpr double pi = dealii::numbers::PI;

  /// One face of a grid over a box.
  template <int dim>
  struct Face
  {
    Point<dim>                            from, to;
    std::vector<unsigned int>             cells;
    unsigned int                          degree;
    std::set<dealii::types::boundary_id>  sides = {2 * dim - 2}; ///< y or z
    std::function<Point<dim>(Point<dim>)> map = [](Point<dim> p) { return p; };
    PlaneModel                            plane = {};
  };

  /// A point's place, and its area.
  using Area = std::pair<Point<3>, double>;

  template <int dim>
  std::vector<Area> areas(const Face<dim> &face)
  {
    dealii::Triangulation<dim> triangulation;
    dealii::GridGenerator::subdivided_hyper_rectangle(triangulation,
                                                      face.cells,
                                                      face.from,
                                                      face.to,
                                                      true);
    dealii::GridTools::transform(face.map, triangulation);
    const dealii::FESystem<dim> fe(dealii::FE_Q<dim>(face.degree), dim);
    dealii::DoFHandler<dim>     dofs(triangulation);
    dofs.distribute_dofs(fe);
    const auto surface = extract_surface<dim>(dofs, face.sides);

    std::vector<Area> result;
    for (const SlavePoint &point :
         collect_slave_points(surface,
                              ContactSurface(surface.facets,
                                             surface.positions()),
                              face.plane))
      result.emplace_back(surface.nodes[point.node].X, point.area);
    return result;
  }

  double sum(const std::vector<Area> &areas)
  {
    double total = 0.;
    for (const Area &area : areas)
      total += area.second;
    return total;
  }

  /// Integral of the shape function of the node at @p s in 0, 1/2, 1 over a
  /// unit length, times the value there of a linear weight: Simpson's rule,
  /// exact for the cubic integrand.
  double simpson(const double s)
  {
    return s == .5 ? 4. / 6. : 1. / 6.;
  }
} // namespace

TEST(SlaveAreas, quadratic_line_has_one_four_one_sixths)
{
  Face<2> face{{1., 0.}, {4., 1.}, {1, 1}, 2};
  face.plane.thickness = 5.;
  const auto found     = areas(face);
  ASSERT_EQ(found.size(), 3u);
  for (const auto &[X, area] : found)
    EXPECT_NEAR(area, 5. * 3. * simpson((X[0] - 1.) / 3.), 1e-14) << X;
}

TEST(SlaveAreas, linear_line_has_halves_and_its_nodes_sum_over_faces)
{
  const auto found = areas(Face<2>{{0., 0.}, {4., 1.}, {2, 1}, 1});
  ASSERT_EQ(found.size(), 3u);
  for (const auto &[X, area] : found)
    EXPECT_NEAR(area, X[0] == 2. ? 2. : 1., 1e-14) << X;
}

TEST(SlaveAreas, quadratic_faces_share_the_node_between_them)
{
  const auto found = areas(Face<2>{{0., 0.}, {4., 1.}, {2, 1}, 2});
  ASSERT_EQ(found.size(), 5u);
  for (const auto &[X, area] : found)
    EXPECT_NEAR(area,
                2. * simpson(std::fmod(X[0], 2.) / 2.) * (X[0] == 2. ? 2. : 1.),
                1e-14)
      << X;
}

TEST(SlaveAreas, quadratic_line_of_revolution_weighs_each_node_by_its_radius)
{
  for (const double inner : {0., 3.})
    {
      Face<2> face{{inner, 0.}, {inner + 2., 1.}, {1, 1}, 2};
      face.plane.axisymmetric = true;
      const auto found        = areas(face);
      ASSERT_EQ(found.size(), 3u);
      for (const auto &[X, area] : found)
        EXPECT_NEAR(area,
                    2. * pi * X[0] * 2. * simpson((X[0] - inner) / 2.),
                    1e-13)
          << X;
      EXPECT_NEAR(sum(found),
                  pi * ((inner + 2.) * (inner + 2.) - inner * inner),
                  1e-13);
    }
}

TEST(SlaveAreas, quadratic_square_has_products_of_sixths)
{
  const auto found = areas(Face<3>{{0., 0., 0.}, {1., 1., 1.}, {1, 1, 1}, 2});
  ASSERT_EQ(found.size(), 9u);
  for (const auto &[X, area] : found)
    EXPECT_NEAR(area, simpson(X[0]) * simpson(X[1]), 1e-15) << X;
}

TEST(SlaveAreas, linear_square_has_quarters)
{
  const auto found = areas(Face<3>{{0., 0., 0.}, {1., 1., 1.}, {1, 1, 1}, 1});
  ASSERT_EQ(found.size(), 4u);
  for (const auto &[X, area] : found)
    EXPECT_NEAR(area, .25, 1e-15) << X;
}

TEST(SlaveAreas, quadratic_trapezium_weighs_each_node_by_its_width)
{
  Face<3> face{{0., 0., 0.}, {1., 1., 1.}, {1, 1, 1}, 2};
  face.map = [](const Point<3> &p) {
    return Point<3>(p[0] * (1. + 2. * p[1]), p[1], p[2]);
  };
  const auto found = areas(face);
  ASSERT_EQ(found.size(), 9u);
  for (const auto &[X, area] : found)
    {
      const double width = 1. + 2. * X[1];
      EXPECT_NEAR(area, width * simpson(X[0] / width) * simpson(X[1]), 1e-14)
        << X;
    }
}

TEST(SlaveAreas, every_side_of_a_quadratic_box_keeps_its_area)
{
  Face<3> face{{0., 0., 0.}, {2., 3., 4.}, {2, 1, 2}, 2};
  face.sides       = {0, 1, 2, 3, 4, 5};
  const auto found = areas(face);
  // 5 x 3 x 5 nodes: those of a side once for each side they lie on
  EXPECT_EQ(found.size(), 2u * (5 * 3 + 3 * 5 + 5 * 5));
  EXPECT_NEAR(sum(found), 2. * (2. * 3. + 3. * 4. + 2. * 4.), 1e-13);
}
