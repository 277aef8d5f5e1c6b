// SPDX-License-Identifier: LGPL-2.1-or-later
// Heat and cure on meshes against closed forms and the slab.
#include "cure/heat_conduction.h"

#include "cure/cure_model.h"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace demold;

namespace
{
  constexpr double pi = 3.14159265358979323846;

  ThermalSide side_at(const ThermalSide::Contact contact,
                      const TemperatureHistory  &temperature,
                      const double               film = 0.)
  {
    ThermalSide side;
    side.contact          = contact;
    side.temperature      = temperature;
    side.film_coefficient = film;
    return side;
  }

  PressCycle cycle_until(const double opening, const double end)
  {
    PressCycle cycle;
    cycle.initial_temperature = 60.;
    cycle.mould               = side_at(ThermalSide::perfect,
                          TemperatureHistory::table({0., 60.}, {150., 165.}));
    cycle.bladder = side_at(ThermalSide::film, TemperatureHistory(190.), .03);
    cycle.air     = side_at(ThermalSide::film, TemperatureHistory(30.), .02);
    cycle.opening_time = opening;
    cycle.end_time     = end;
    return cycle;
  }

  /// A slab 0 < x < L at 1, its surfaces kept at 0 (Carslaw and Jaeger,
  /// Conduction of Heat in Solids, chapter 3).
  double share_left(const double x, const double t, const double L)
  {
    double share = 0.;
    for (int n = 1; n < 100; n += 2)
      share += 4. / (n * pi) * std::sin(n * pi * x / L) *
               std::exp(-.12 * n * n * pi * pi * t / (L * L));
    return share;
  }

  template <int dim>
  void expect_the_product_of_slabs()
  {
    dealii::Triangulation<dim> mesh;
    dealii::GridGenerator::subdivided_hyper_cube(mesh,
                                                 dim == 2 ? 24 : 16,
                                                 0.,
                                                 8.);
    PressCycle cycle = cycle_until(60., 60.);
    cycle.mould      = side_at(ThermalSide::perfect, TemperatureHistory(160.));
    HeatConduction<dim> heat(mesh,
                             cycle,
                             {{0, HeatConduction<dim>::Side::mould}});
    heat.run(ArrheniusTime{409., 98.5, 160.});
    dealii::Point<dim> point;
    for (const double x : {2., 4.})
      for (const double y : {1.4, 4.})
        {
          double left = 1.;
          for (int d = 0; d < dim; ++d)
            {
              point[d] = d == 1 ? y : x;
              left *= share_left(point[d], 60., 8.);
            }
          EXPECT_NEAR(heat.value_at(heat.at_end.temperature, point),
                      160. - 100. * left,
                      .5)
            << point;
        }
  }

  /// A block whose mesh has no two equal cells, heated at the bottom and
  /// through a film at the top, is a slab.
  template <int dim>
  void expect_a_slab()
  {
    dealii::Triangulation<dim> mesh;
    std::vector<unsigned int>  cells(dim, 3);
    dealii::Point<dim>         low, high;
    for (int d = 0; d < dim; ++d)
      high[d] = 2.;
    high[dim - 1]  = 8.;
    cells[dim - 1] = 24;
    dealii::GridGenerator::subdivided_hyper_rectangle(mesh,
                                                      cells,
                                                      low,
                                                      high,
                                                      true);
    dealii::GridTools::distort_random(.15, mesh, true, 1);
    using Side                = typename HeatConduction<dim>::Side;
    const PressCycle    cycle = cycle_until(300., 500.);
    HeatConduction<dim> heat(mesh,
                             cycle,
                             {{2 * dim - 2, Side::mould},
                              {2 * dim - 1, Side::bladder}});
    const CureModel     model;
    heat.run(model.t90);

    const SlabHistory slab(cycle, 8., 80);
    for (const double depth : {0., 1., 4.1, 7., 8.})
      {
        const auto         temperature = slab.at(depth);
        const auto         states      = integrate_cure(model,
                                           temperature,
                                           {0., 300., 500.},
                                           {1e-8, 1e-10},
                                           CureState());
        dealii::Point<dim> point;
        for (int d = 0; d < dim; ++d)
          point[d] = 1.1;
        point[dim - 1] = depth;
        EXPECT_NEAR(heat.value_at(heat.at_opening.temperature, point),
                    temperature(300.),
                    .5);
        EXPECT_NEAR(heat.value_at(heat.at_end.temperature, point),
                    temperature(500.),
                    .5);
        EXPECT_NEAR(heat.value_at(heat.at_opening.f90, point) / states[1].f90,
                    1.,
                    .02);
        EXPECT_NEAR(heat.value_at(heat.at_end.f90, point) / states[2].f90,
                    1.,
                    .02);
      }
  }
} // namespace

TEST(heat_conduction, into_the_corners_of_a_square_is_the_product_of_slabs)
{
  expect_the_product_of_slabs<2>();
}

TEST(heat_conduction, into_the_corners_of_a_cube_is_the_product_of_slabs)
{
  expect_the_product_of_slabs<3>();
}

TEST(heat_conduction, through_a_distorted_mesh_is_that_of_the_slab_in_2d)
{
  expect_a_slab<2>();
}

TEST(heat_conduction, through_a_distorted_mesh_is_that_of_the_slab_in_3d)
{
  expect_a_slab<3>();
}

TEST(heat_conduction, gives_a_mould_node_the_f90_of_its_mould)
{
  dealii::Triangulation<2> mesh;
  dealii::GridGenerator::subdivided_hyper_cube(mesh, 4, 0., 8.);
  PressCycle cycle = cycle_until(409., 409.);
  cycle.mould      = side_at(ThermalSide::perfect, TemperatureHistory(160.));
  HeatConduction<2> heat(mesh, cycle, {{0, HeatConduction<2>::Side::mould}});
  heat.run(ArrheniusTime{409., 98.5, 160.});
  EXPECT_NEAR(heat.value_at(heat.at_end.f90, dealii::Point<2>(0., 3.)),
              1.,
              1e-12);
}
