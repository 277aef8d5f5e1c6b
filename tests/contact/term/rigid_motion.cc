// SPDX-License-Identifier: LGPL-2.1-or-later
// A rigid rotation of everything turns the tractions of the interface with it
// and changes nothing else: no pressure, no friction, no bond, no energy.
#include "two_surfaces.h"

#include <deal.II/physics/transformations.h>

#include <gtest/gtest.h>

using namespace demold;
using dealii::Tensor;

namespace
{
  using Values = TwoSurfaces::Values;

  constexpr double       total_angle  = 30. * dealii::numbers::PI / 180.;
  constexpr unsigned int n_increments = 6;

  Tensor<2, 3> rotation(const unsigned int dim, const double angle)
  {
    // any axis in space; out of the plane in two dimensions
    const dealii::Point<3> axis = dim == 2 ?
                                    dealii::Point<3>(0., 0., 1.) :
                                    dealii::Point<3>(2. / 7., 3. / 7., 6. / 7.);
    return dealii::Physics::Transformations::Rotations::rotation_matrix_3d(
      axis,
      angle);
  }

  /// Turns with unit angular velocity about a centre off the surfaces.
  struct Turning
  {
    unsigned int dim;
    double       start; ///< time at which it begins to turn

    RigidPlacement operator()(const double time) const
    {
      RigidPlacement placement;
      placement.centre   = centre();
      placement.rotation = rotation(dim, angle(time));
      return placement;
    }

    double angle(const double time) const
    {
      return std::max(0., time - start) * total_angle / n_increments;
    }

    dealii::Point<3> centre() const
    {
      return dim == 2 ? dealii::Point<3>(1., -2., 0.) :
                        dealii::Point<3>(1., -2., .5);
    }
  };

  /// Displacements @p base, then turned as at @p time.
  Values turned(const TwoSurfaces &pair,
                const Turning     &turning,
                const Values      &base,
                const double       time)
  {
    const RigidPlacement placement = turning(time);
    Values               result    = base;
    const auto           turn      = [&](const BoundarySurface &surface) {
      for (const auto &node : surface.nodes)
        {
          dealii::Point<3> x = node.X;
          for (unsigned int d = 0; d < pair.dim; ++d)
            x[d] += base[node.unknowns[d]];
          x = placement.place(x);
          for (unsigned int d = 0; d < pair.dim; ++d)
            result[node.unknowns[d]] = x[d] - node.X[d];
        }
    };
    turn(pair.slave);
    if (pair.kind == MasterKind::deformable)
      turn(pair.master);
    return result;
  }

  struct Scene
  {
    double            gap;     ///< [mm] before anything moves
    double            opening; ///< [mm] along z when the rotation begins
    double            slip;    ///< [mm]
    double            last;    ///< slip when the rotation begins, over `slip`
    double            friction;
    bool              bonded;
    AdhesionUnloading unloading;
    int               state; ///< of all points before the rotation
  };

  void check_rotation(const Scene       &scene,
                      const unsigned int dim,
                      const MasterKind   kind)
  {
    SCOPED_TRACE(std::to_string(dim) + "-D, " +
                 (kind == MasterKind::rigid ? "rigid" : "deformable"));
    InterfaceDescription description;
    description.friction = scene.friction;
    if (scene.bonded)
      {
        AdhesionLaw law;
        law.softening        = LinearSoftening{.2, .1, 20.};
        law.factors          = mode_factors(ModeMixing::energy, .6);
        law.unloading        = scene.unloading;
        description.adhesion = law;
      }
    const double   gap  = scene.gap;
    const HeightOf hill = [](double x, double y) { return .1 * x + .05 * y; };
    const unsigned int n_base = 3;
    const Turning      turning{dim, n_base * 1.};
    TwoSurfaces        pair({dim,
                             3,
                             -1.5,
                             1.3,
                             [=](double x, double y) { return hill(x, y) + gap; },
                             false},
                     {dim, 2, -2., 2., hill, true},
                     kind,
                     description,
                     turning);

    // closes or opens, slides, then slides back or on a little
    Tensor<1, 3> shift;
    Values       base;
    for (const double slip : {0., scene.slip, scene.last * scene.slip})
      {
        shift[0]       = slip;
        shift[dim - 1] = scene.opening;
        base           = pair.with_noise(pair.shifted_slave(shift), .002, 1);
        pair.accept(base);
      }
    for (const int state : pair.states())
      ASSERT_EQ(state, scene.state);
    const auto     before   = pair.term->report();
    const Energies energies = pair.term->energies();

    for (unsigned int k = 1; k <= n_increments; ++k)
      pair.accept(turned(pair, turning, base, turning.start + k));

    const Tensor<2, 3> Q     = rotation(dim, total_angle);
    const auto         after = pair.term->report();
    double             error = 0., largest = 0.;
    for (unsigned int p = 0; p < after.size(); ++p)
      {
        largest = std::max(largest, before[p].force.norm() / before[p].area);
        error   = std::max(error,
                         (after[p].force - Q * before[p].force).norm() /
                           before[p].area);
        EXPECT_NEAR(after[p].pressure, before[p].pressure, 1e-8);
        EXPECT_NEAR(after[p].damage, before[p].damage, 1e-10);
      }
    EXPECT_LT(error, 1e-8) << "MPa";
    EXPECT_GT(largest, .01) << "MPa: nothing to compare";

    const Energies now = pair.term->energies();
    EXPECT_NEAR(now.stored, energies.stored, 1e-10);
    EXPECT_NEAR(now.friction, energies.friction, 1e-10);
    EXPECT_NEAR(now.adhesion, energies.adhesion, 1e-10);
    EXPECT_NEAR(now.impact, energies.impact, 1e-10);
  }

  void check_rotation(const Scene &scene)
  {
    for (const unsigned int dim : {2u, 3u})
      for (const MasterKind kind : {MasterKind::rigid, MasterKind::deformable})
        check_rotation(scene, dim, kind);
  }
} // namespace

TEST(RigidMotion, leaves_the_tractions_of_a_bonded_pair_unchanged)
{
  check_rotation({0., .004, .003, .95, 0., true, AdhesionUnloading::damage, 0});
}

TEST(RigidMotion, leaves_the_tractions_of_damaged_bonds_unchanged)
{
  check_rotation({0., .04, .04, .95, 0., true, AdhesionUnloading::damage, 2});
}

TEST(RigidMotion, leaves_the_tractions_of_plastically_unloaded_bonds_unchanged)
{
  check_rotation({0., .04, .04, .95, 0., true, AdhesionUnloading::plastic, 2});
}

TEST(RigidMotion, leaves_the_tractions_of_bonds_over_a_gap_unchanged)
{
  check_rotation(
    {.03, .004, .003, .95, 0., true, AdhesionUnloading::damage, 0});
}

TEST(RigidMotion, leaves_pressure_and_friction_of_a_sliding_pair_unchanged)
{
  check_rotation({0., -.05, .3, .95, .3, false, AdhesionUnloading::damage, 4});
  check_rotation({0., -.05, .3, 1.1, .3, false, AdhesionUnloading::damage, 5});
}

TEST(RigidMotion, leaves_pressure_friction_and_bonds_together_unchanged)
{
  check_rotation({0., -.05, .1, .95, .3, true, AdhesionUnloading::damage, 2});
}
