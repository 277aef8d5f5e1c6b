// SPDX-License-Identifier: LGPL-2.1-or-later
// Cure computed from a press cycle: a slab, the tables' range, what is refused.
#include "base/parameter_error.h"
#include "cure/cure_model.h"
#include "scene/scene_system.h"

#include <deal.II/base/parameter_handler.h>

#include <deal.II/grid/grid_generator.h>

#include <gtest/gtest.h>

using namespace demold;

namespace
{
  constexpr dealii::types::boundary_id bottom = 2, top = 3;
  constexpr double                     height = 8.; // [mm]

  /// The mould heats from below and a film from above, for 300 s.
  SceneParameters parameters(const std::string &f90_levels,
                             const std::string &more = "")
  {
    dealii::ParameterHandler prm;
    SceneParameters          parameters;
    parameters.add_parameters(prm);
    prm.parse_input_from_string(
      "subsection Material\n"
      "  set cure = vulcanised\n"
      "  set viscosity = false\n"
      "  set table f90 = " +
      f90_levels +
      "\n"
      "  set table equilibrium modulus = 1, 1.5, 1.8, 2\n"
      "end\n"
      "subsection Press\n"
      "  set initial temperature = 60\n"
      "  set opening time = 300\n"
      "  subsection Mould side\n"
      "    set contact = perfect\n"
      "    set temperature = 0: 150, 60: 165\n"
      "  end\n"
      "  subsection Bladder side\n"
      "    set contact = film\n"
      "    set temperature = 190\n"
      "    set film coefficient = 0.03\n"
      "  end\n"
      "end\n" +
      more);
    parameters.check();
    return parameters;
  }

  Scene<2> slab()
  {
    Scene<2> scene;
    scene.make_mesh = [](dealii::Triangulation<2> &mesh) {
      dealii::GridGenerator::subdivided_hyper_rectangle(
        mesh,
        {2, 32},
        dealii::Point<2>(),
        dealii::Point<2>(2., height),
        true);
      for (const auto &cell : mesh.active_cell_iterators())
        cell->set_material_id(0);
    };
    scene.mould_side   = {bottom};
    scene.bladder_side = {top};
    SupportRule held;
    held.boundary  = top;
    held.component = 1;
    scene.supports.push_back(held);
    return scene;
  }
} // namespace

TEST(VulcanisedCure, of_a_slab_is_that_of_its_thickness)
{
  const SceneParameters p     = parameters("0.1, 0.5, 1, 2");
  const Scene<2>        scene = slab();
  SceneSystem<2>        system(scene, p, MPI_COMM_WORLD);
  const SlabHistory     exact(p.press.cycle(), height, 400);
  const auto            f90_of_depth = [&](const double depth) {
    return integrate_cure(p.cure.model(),
                          exact.at(depth),
                          {0., 300.},
                          {1e-8, 1e-10},
                          CureState())[1]
      .f90;
  };
  for (const double depth : {.7, 3.9, 7.4})
    {
      const double f90 = f90_of_depth(depth);
      EXPECT_NEAR(system.cure->f90(dealii::Point<3>(1.3, depth, 0.)),
                  f90,
                  .01 * f90);
    }
  // what the cells show
  for (const CellResult &cell : system.rubber.at(0)->cell_results())
    {
      const auto  &mesh = system.triangulation;
      const double depth =
        std::next(mesh.begin_active(), cell.index)->center()[1];
      const double f90 = f90_of_depth(depth);
      EXPECT_NEAR(cell.f90, f90, .01 * f90) << depth;
    }
  const VulcanisedRange &range = system.cure->range();
  EXPECT_EQ(range.n_points, 64u * 4u);
  EXPECT_EQ(range.n_clamped, 0u);
  EXPECT_EQ(system.cure->warning(), "");
  EXPECT_LT(range.smallest, range.mean);
  EXPECT_LT(range.mean, range.largest);
}

TEST(VulcanisedCure, outside_the_tables_takes_the_nearest_level_and_says_so)
{
  const SceneParameters p =
    parameters("2, 3, 4, 5", "subsection Material\nset f90 = 3\nend\n");
  const Scene<2>          scene = slab();
  const VulcanisedCure<2> cure(scene, p);
  EXPECT_EQ(cure.f90(dealii::Point<3>(1., 4., 0.)), 2.);
  EXPECT_LT(cure.range().largest, 2.);
  EXPECT_EQ(cure.range().n_clamped, cure.range().n_points);
  EXPECT_NE(cure.warning().find("256 of 256"), std::string::npos);
}

TEST(VulcanisedCure, is_refused_where_no_press_touches_the_body)
{
  const SceneParameters p     = parameters("0.1, 0.5, 1, 2");
  Scene<2>              scene = slab();
  scene.mould_side.clear();
  scene.bladder_side.clear();
  EXPECT_THROW(VulcanisedCure<2>(scene, p), ExcParameter);
  EXPECT_THROW(parameters("0.1, 0.5, 1, 2", "set dimension = axisymmetric\n"),
               ExcParameter);
}

TEST(VulcanisedCure, leaves_uniform_and_function_to_the_entry_f90)
{
  const Scene<2> scene  = slab();
  const auto     system = [&](const SceneParameters &p) {
    return std::make_unique<SceneSystem<2>>(scene, p, MPI_COMM_WORLD);
  };
  const auto chosen = [](const std::string &cure, const std::string &f90) {
    return parameters("0.1, 0.5, 1, 2",
                      "subsection Material\nset cure = " + cure +
                        "\nset f90 = " + f90 + "\nend\n");
  };
  for (const std::string cure : {"by f90", "uniform", "function"})
    {
      const SceneParameters p = chosen(cure, "0.7");
      EXPECT_EQ(system(p)->cure, nullptr);
      EXPECT_EQ(system(p)->rubber[0]->cell_results()[0].f90, .7);
    }
  for (const std::string cure : {"by f90", "function"})
    {
      const SceneParameters p = chosen(cure, "0.5 + y/10");
      EXPECT_NEAR(system(p)->rubber[0]->cell_results()[0].f90,
                  .5 + .125 / 10.,
                  1e-12);
    }
  EXPECT_THROW(chosen("uniform", "0.5 + y/10"), ExcParameter);
}
