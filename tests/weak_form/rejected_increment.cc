// SPDX-License-Identifier: LGPL-2.1-or-later
// A rejected increment leaves no trace in any term, and a checkpoint holds all
// that an increment depends on.
#include "block_on_mould.h"

#include <gtest/gtest.h>

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
    description.friction = .3;
    AdhesionLaw law;
    law.softening       = LinearSoftening{.2, .1, 20.};
    law.factors         = mode_factors(ModeMixing::energy, .6);
    law.unloading       = unloading;
    law.rest_pressure   = .01;
    law.rest_time       = .5 * dt;
    law.rest_efficiency = readhesion;
    description.adhesion = law;
    return description;
  }

  /// Presses, then slides until bonds break, then lifts.
  Tensor<1, 3> press_and_slide(const dealii::Point<3> &, const double t)
  {
    return vector(.04 * std::max(0., t - dt), -.03 + .01 * std::abs(t - 2. * dt));
  }

  struct Scene
  {
    std::string  name;
    BlockOptions options;
  };

  /// Every term alone as far as it can stand, and all of them together.
  std::vector<Scene> scenes()
  {
    BlockOptions elastic;
    elastic.top = press_and_slide;

    BlockOptions viscous = elastic;
    viscous.viscous      = true;

    BlockOptions loaded;
    loaded.interface = interface(AdhesionUnloading::damage, 0.);
    loaded.traction  = [](const double t) {
      return vector(.01 * t, .02 * std::sin(t));
    };

    BlockOptions on_mould = elastic;
    on_mould.interface    = interface(AdhesionUnloading::damage, 0.);

    BlockOptions plastic = elastic;
    plastic.interface    = interface(AdhesionUnloading::plastic, .3);

    BlockOptions on_block = on_mould;
    on_block.on_block     = true;

    BlockOptions dynamic = on_mould;
    dynamic.viscous      = true;
    dynamic.integrator   = TimeIntegrator();

    BlockOptions blended = dynamic;
    blended.integrator->scheme = "generalised-alpha";

    return {{"elastic solid", elastic},
            {"viscous solid", viscous},
            {"traction", loaded},
            {"friction and adhesion on a mould", on_mould},
            {"plastic unloading and new bonds", plastic},
            {"friction and adhesion on a block", on_block},
            {"inertia", dynamic},
            {"inertia and blended bulk forces", blended}};
  }

  void advance(BlockOnMould &block, const unsigned int n)
  {
    for (unsigned int k = 0; k < n; ++k)
      {
        const NewtonReport report = block.advance(block.form->time() + dt);
        ASSERT_TRUE(report.converged) << report.reason;
      }
  }

  void expect_same_energies(const BlockOnMould &a, const BlockOnMould &b)
  {
    const auto of_a = a.form->energies().as_array();
    const auto of_b = b.form->energies().as_array();
    for (unsigned int i = 0; i < of_a.size(); ++i)
      EXPECT_EQ(of_a[i], of_b[i]) << Energies::names()[i];
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
      ASSERT_EQ(before, other.saved()) << "runs do not repeat";

      block.assemble_noise(block.form->time() + dt, .02);
      EXPECT_EQ(block.saved(), before) << "committed without commit()";
      block.form->reject();
      EXPECT_EQ(block.saved(), before);
      expect_same_energies(block, other);

      block.try_and_reject(block.form->time() + 2. * dt);
      EXPECT_EQ(block.saved(), before);
      expect_same_energies(block, other);
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
      for (unsigned int k = 0; k < 4; ++k)
        {
          block.assemble_noise(block.form->time() + dt, .02);
          block.form->reject();
          block.try_and_reject(block.form->time() + 1.5 * dt);
          advance(block, 1);
          advance(other, 1);
          EXPECT_EQ(block.saved(), other.saved()) << "increment " << k;
          expect_same_energies(block, other);
        }
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
      EXPECT_EQ(restarted.saved(), state);
      EXPECT_EQ(restarted.form->time(), block.form->time());
      expect_same_energies(restarted, block);

      restarted.newton->largest_force = block.newton->largest_force;
      for (unsigned int k = 0; k < 3; ++k)
        {
          advance(block, 1);
          advance(restarted, 1);
          for (const auto i : block.form->accepted.locally_owned_elements())
            EXPECT_NEAR(restarted.form->accepted(i),
                        block.form->accepted(i),
                        1e-12);
          const auto a = block.form->energies().as_array();
          const auto b = restarted.form->energies().as_array();
          for (unsigned int i = 0; i < a.size(); ++i)
            EXPECT_NEAR(b[i], a[i], 1e-12) << Energies::names()[i];
        }
    }
}
