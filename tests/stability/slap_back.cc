// SPDX-License-Identifier: LGPL-2.1-or-later
// A block thrown against the mould comes back without more energy than it had.
#include "solution/dynamics.h"
#include "weak_form/block_on_mould.h"

#include <gtest/gtest.h>

using namespace demold;

namespace
{
  constexpr double distance = .05;  // [mm] to the mould
  constexpr double speed    = 2e3;  // [mm/s]
  constexpr double end      = 3e-4; // [s], long after it has come back

  BlockOptions options(const std::string &scheme, const double friction)
  {
    BlockOptions         result;
    InterfaceDescription interface;
    interface.friction        = friction;
    result.interface          = interface;
    result.integrator         = TimeIntegrator();
    result.integrator->scheme = scheme;
    result.mould              = [](double) {
      RigidPlacement placement;
      placement.translation[1] = -distance;
      return placement;
    };
    return result;
  }

  /// Throws a block at @p speed, sideways too, and follows it.
  void check_throw(const std::string &scheme, const double friction)
  {
    SCOPED_TRACE(scheme + ", friction " + std::to_string(friction));
    for (const double dt : {2.5e-7, 1e-6, 1e-5})
      {
        SCOPED_TRACE("increments of " + std::to_string(1e6 * dt) + " us");
        BlockOnMould block(options(scheme, friction));
        block.throw_with(dealii::Tensor<1, 3>({.5 * speed, -speed, 0.}));
        const double before = block.inertia->energies().kinetic;

        IncrementParameters increments;
        increments.first = increments.largest = dt;
        increments.smallest                   = 1e-3 * dt;
        double     largest = 0., stored = 0., after = 0., gap = 0.;
        bool       touched = false;
        const auto watch   = [&](const IncrementRecord &) {
          const Energies e = block.form->energies();
          largest          = std::max(largest, e.kinetic + e.stored);
          stored           = std::max(stored, e.stored);
          after            = e.kinetic;
          gap              = std::max(gap, std::abs(e.gap() + before));
          touched          = touched || block.contact->sums().closed > 0.;
          return true;
        };
        const auto result = run_dynamics(*block.form,
                                         *block.newton,
                                         *block.inertia,
                                         *block.options.integrator,
                                         increments,
                                         end,
                                         watch);
        ASSERT_FALSE(result.gave_up) << result.reason;
        EXPECT_TRUE(touched);
        EXPECT_EQ(block.contact->sums().closed, 0.) << "did not come back";
        EXPECT_LE(largest, 1.001 * before);
        EXPECT_LE(after, before);
        // Friction loses by the mean of its limits before and after.
        const double tolerance = friction == 0. ? .005 : .01;
        EXPECT_LT(gap, tolerance * before);
      }
  }
} // namespace

TEST(SlapBack, never_gains_kinetic_energy_without_friction)
{
  for (const char *scheme : {"bossak", "generalised-alpha", "hht", "newmark"})
    check_throw(scheme, 0.);
}

TEST(SlapBack, never_gains_kinetic_energy_with_friction)
{
  for (const char *scheme : {"bossak", "newmark"})
    check_throw(scheme, .5);
}
