// SPDX-License-Identifier: LGPL-2.1-or-later
// A rejected increment leaves no trace in any term, nor does a detour that was
// given up, and a checkpoint holds all that an increment depends on.
#include "block_on_mould.h"

#include "solution/books.h"
#include "solution/path_detour.h"

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace demold;
using dealii::Tensor;

namespace
{
  constexpr double dt = 1.;

  Tensor<1, 3> vector(const double x, const double y)
  {
    return Tensor<1, 3>({x, y, 0.});
  }

  InterfaceDescription interface(const AdhesionUnloading unloading,
                                 const double            readhesion)
  {
    InterfaceDescription description;
    description.friction = .1;
    AdhesionLaw law;
    law.softening        = LinearSoftening{.05, .1, 20.};
    law.factors          = mode_factors(ModeMixing::energy, .6);
    law.unloading        = unloading;
    law.rest_pressure    = .001;
    law.rest_time        = .5 * dt;
    law.rest_efficiency  = readhesion;
    description.adhesion = law;
    return description;
  }

  /// Presses, then slides until bonds break. Two blocks, 0.25 MPa/mm, are
  /// stiffer than the bonds soften, 0.18 MPa/mm: no jumps.
  Tensor<1, 3> press_and_slide(const dealii::Point<3> &, const double t)
  {
    return vector(.07 * std::max(0., t - dt),
                  -.01 + .001 * std::abs(t - 2. * dt));
  }

  struct Scene
  {
    std::string  name;
    BlockOptions options;

    /// [mm] and [mJ] after further increments. On a deformable master, the
    /// pattern of the matrix depends on when it was built last, and round-off
    /// on the pattern.
    double tolerance = 0.;
  };

  /// Every term alone as far as it can stand, and all of them together.
  std::vector<Scene> scenes()
  {
    BlockOptions elastic;
    elastic.top = press_and_slide;

    BlockOptions viscous = elastic;
    viscous.viscous      = true;

    BlockOptions loaded;
    loaded.interface           = interface(AdhesionUnloading::damage, 0.);
    loaded.interface->friction = 0.;
    loaded.traction            = [](const double t) {
      return vector(.001 * t, -.02 + .005 * std::sin(t));
    };

    BlockOptions on_mould = elastic;
    on_mould.interface    = interface(AdhesionUnloading::damage, 0.);

    BlockOptions plastic = elastic;
    plastic.interface    = interface(AdhesionUnloading::plastic, .3);

    BlockOptions on_block = on_mould;
    on_block.on_block     = true;
    on_block.top          = [](const dealii::Point<3> &X, const double t) {
      return press_and_slide(X, .6 * t) + vector(0., -.02);
    };

    BlockOptions dynamic = on_mould;
    dynamic.viscous      = true;
    dynamic.integrator   = TimeIntegrator();

    BlockOptions blended       = dynamic;
    blended.integrator->scheme = "hht";

    const auto by_mortar =
      [](BlockOptions options, const bool dual, const bool condensed) {
        options.mortar                      = true;
        options.interface->dual_multipliers = dual;
        options.interface->condensed        = condensed;
        options.interface->stiffness        = 3.; // of the order of E [MPa]
        return options;
      };

    return {{"elastic solid", elastic},
            {"viscous solid", viscous},
            {"traction", loaded},
            {"friction and adhesion on a mould", on_mould},
            {"plastic unloading and new bonds", plastic},
            {"friction and adhesion on a block", on_block, 1e-12},
            {"mortar on a mould", by_mortar(on_mould, false, false)},
            {"dual mortar on a mould", by_mortar(on_mould, true, false)},
            {"condensed mortar on a mould", by_mortar(on_mould, true, true)},
            {"mortar on a block", by_mortar(on_block, false, false), 1e-12},
            {"inertia and mortar", by_mortar(dynamic, false, false)},
            {"inertia", dynamic},
            {"inertia and blended bulk forces", blended}};
  }

  /// How well two runs repeat each other: bitwise on one rank; on several the
  /// direct solver adds up contributions in the order of their arrival.
  double repetition()
  {
    return dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1 ? 0. :
                                                                          1e-10;
  }

  void advance(BlockOnMould &block, const unsigned int n)
  {
    for (unsigned int k = 0; k < n; ++k)
      {
        const NewtonReport report = block.advance(block.form->time() + dt);
        ASSERT_TRUE(report.converged) << report.reason;
      }
  }

  /// Displacements [mm] and energies [mJ]; no tolerance: everything, bitwise.
  void expect_same_state(const BlockOnMould &a,
                         const BlockOnMould &b,
                         const double        tolerance)
  {
    if (tolerance == 0.)
      {
        EXPECT_TRUE(a.saved() == b.saved());
      }
    double difference = 0.;
    for (const auto i : a.form->accepted.locally_owned_elements())
      difference =
        std::max(difference,
                 std::abs(a.form->accepted(i) - b.form->accepted(i)));
    EXPECT_LE(difference, tolerance) << "mm";
    const auto of_a = a.form->energies().as_array();
    const auto of_b = b.form->energies().as_array();
    for (unsigned int i = 0; i < of_a.size(); ++i)
      EXPECT_NEAR(of_a[i], of_b[i], tolerance) << Energies::names()[i];
  }
} // namespace

TEST(RejectedIncrement, leaves_every_term_bitwise_as_it_was)
{
  for (const Scene &scene : scenes())
    {
      SCOPED_TRACE(scene.name);
      BlockOnMould block(scene.options), other(scene.options);
      advance(block, 3);
      advance(other, 3);
      const std::string before = block.saved();
      expect_same_state(block, other, repetition());

      block.assemble_noise(block.form->time() + dt, .02);
      EXPECT_TRUE(block.saved() == before) << "committed without commit()";
      block.form->reject();
      EXPECT_TRUE(block.saved() == before);
      expect_same_state(block, other, repetition());

      block.try_and_reject(block.form->time() + 2. * dt);
      EXPECT_TRUE(block.saved() == before);
      expect_same_state(block, other, repetition());
    }
}

TEST(RejectedIncrement, does_not_change_the_increments_that_follow)
{
  for (const Scene &scene : scenes())
    {
      SCOPED_TRACE(scene.name);
      BlockOnMould block(scene.options), other(scene.options);
      advance(block, 2);
      advance(other, 2);
      for (unsigned int k = 0; k < 6; ++k)
        {
          SCOPED_TRACE("increment " + std::to_string(k));
          block.assemble_noise(block.form->time() + dt, .02);
          block.form->reject();
          block.try_and_reject(block.form->time() + 1.5 * dt);
          advance(block, 1);
          advance(other, 1);
          expect_same_state(block,
                            other,
                            std::max(scene.tolerance, repetition()));
        }
    }
}

/// A bond that softens faster than the block gives way: 10 MPa/mm.
TEST(Detour, passes_a_jump_or_leaves_no_trace)
{
  BlockOptions steep;
  steep.interface           = interface(AdhesionUnloading::damage, 0.);
  steep.interface->friction = 0.;
  steep.interface->adhesion->softening = LinearSoftening{.05, .005, 50.};
  steep.top = [](const dealii::Point<3> &, const double t) {
    return vector(0., .002 * t);
  };
  IncrementState      state;
  IncrementParameters increments;
  increments.state    = &state;
  increments.smallest = .01 * dt;
  increments.largest  = dt;
  for (const bool mortar : {false, true})
    {
      SCOPED_TRACE(mortar ? "mortar" : "node to segment");
      steep.mortar               = mortar;
      steep.interface->stiffness = 3.; // of the order of E [MPa]
      const auto at_the_limit    = [&] {
        auto block = std::make_unique<BlockOnMould>(steep);
        for (double step = dt; step > 1e-4 * dt;)
          {
            const std::string before = block->saved();
            const double      time   = block->form->time() + step;
            Books             books(*block->form);
            if (block->try_and_reject(time).converged)
              {
                block->advance(time);
                books.trial = block->form->energies();
                if (!books.are_open())
                  continue;
              }
            block->load(before);
            step *= .5;
          }
        return block;
      };
      const auto detour = [&](BlockOnMould &block, const DetourLimits &limits) {
        return try_detour(*block.form,
                          {*block.newton, *block.solver, {}, {}},
                          increments,
                          1000. * dt,
                          limits);
      };
      const auto free   = at_the_limit();
      const auto passed = detour(*free, {1e300, 400});
      ASSERT_TRUE(passed.has_value());
      const double released = passed->path->released;
      EXPECT_GT(released, 0.);
      EXPECT_GT(free->form->energies().adhesion, 0.);

      const auto block = at_the_limit(), other = at_the_limit();
      const auto before = block->saved();
      const auto force  = block->newton->largest_force;
      for (const DetourLimits limits :
           {DetourLimits{1e300, 5}, DetourLimits{.01 * released, 400}})
        {
          state = IncrementState();
          EXPECT_FALSE(detour(*block, limits).has_value());
          EXPECT_GT(state.newton_iterations, 5u);
          EXPECT_TRUE(block->saved() == before);
          EXPECT_EQ(block->newton->largest_force, force);
        }
      const auto again = detour(*block, {1e300, 400});
      ASSERT_TRUE(again.has_value());
      EXPECT_NEAR(again->path->released, released, 1e-9 * released);
      EXPECT_NEAR(again->time, passed->time, 1e-9 * passed->time);
    }
}

TEST(Checkpoint, of_a_weak_form_is_bitwise_and_complete)
{
  for (const Scene &scene : scenes())
    {
      SCOPED_TRACE(scene.name);
      BlockOnMould block(scene.options);
      advance(block, 4);
      const std::string state = block.saved();

      BlockOnMould restarted(scene.options);
      restarted.load(state);
      EXPECT_TRUE(restarted.saved() == state);
      EXPECT_EQ(restarted.form->time(), block.form->time());
      expect_same_state(restarted, block, 0.);

      restarted.newton->largest_force = block.newton->largest_force;
      for (unsigned int k = 0; k < 3; ++k)
        {
          advance(block, 1);
          advance(restarted, 1);
          expect_same_state(restarted, block, std::max(1e-12, repetition()));
        }
    }
}
