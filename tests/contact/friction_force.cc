// SPDX-License-Identifier: LGPL-2.1-or-later
// Friction of a node on a flat floor: stick, slip, stick point, energies.
#include "contact/contact_kinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace
{
  using namespace demold;
  using dealii::Point;

  constexpr FrictionPenalties penalties{50., 20., 0.3};

  /// A node 0.4 mm along a floor z = 0, the stick point @p behind [mm] it.
  struct NodeOnFloor
  {
    ContactKinematics kin;
    FrictionAnchor    anchor;
  };

  NodeOnFloor node_on_floor(const double behind, const double gap = -0.01)
  {
    const ContactSurface floor({{{{0, 1, 2, 3}}, 4}},
                               {Point<3>(0, 0, 0),
                                Point<3>(1, 0, 0),
                                Point<3>(1, 1, 0),
                                Point<3>(0, 1, 0)});
    const Point<3>       x_s(0.4, 0.3, gap);
    const auto           found =
      find_contact(x_s, Point<3>(0, 0, -1), floor, {0}, 0, {1., 1.});
    NodeOnFloor result{contact_kinematics(found.value(), x_s, floor), {}};
    result.anchor.x = Point<3>(0.4 - behind, 0.3, 0.);
    return result;
  }

  TEST(friction_force, slides_at_the_coulomb_limit_and_drags_the_stick_point)
  {
    auto         pair = node_on_floor(0.1);
    const double L    = 0.3 * 50. * 0.01; // mu c_N |gap|
    const double slip = 0.1 - L / 20.;    // total less the elastic part
    pair.anchor.limit = L;                // the pressure stays
    const auto F      = friction_force(pair.kin, pair.anchor, penalties);
    EXPECT_EQ(F.state, FrictionState::slip);
    EXPECT_NEAR(F.traction[0], L, 1e-14);
    EXPECT_NEAR(F.R[0], L, 1e-14);
    EXPECT_NEAR(F.R[3] + F.R[6] + F.R[9] + F.R[12], -L, 1e-14);
    EXPECT_NEAR(F.slip[0], slip, 1e-14);
    EXPECT_NEAR(F.dissipation, L * slip, 1e-14);
    EXPECT_NEAR(F.stored, 0.5 * L * L / 20., 1e-14);

    FrictionAnchor next;
    next.x = new_anchor(pair.kin, pair.anchor, F, penalties);
    EXPECT_LT((next.x - Point<3>(0.4 - L / 20., 0.3, 0.)).norm(), 1e-14);
    next.limit       = F.limit;
    const auto again = friction_force(pair.kin, next, penalties);
    EXPECT_NEAR(again.trial, L, 1e-13);
    EXPECT_LT(again.dissipation, 1e-13);
  }

  TEST(friction_force, sticks_below_the_limit_without_dissipation)
  {
    const auto pair = node_on_floor(0.005);
    const auto F    = friction_force(pair.kin, pair.anchor, penalties);
    EXPECT_EQ(F.state, FrictionState::stick);
    EXPECT_NEAR(F.traction[0], 20. * 0.005, 1e-14);
    EXPECT_EQ(F.dissipation, 0.);
    EXPECT_NEAR(F.stored, 0.5 * 20. * 0.005 * 0.005, 1e-14);
    EXPECT_EQ(new_anchor(pair.kin, pair.anchor, F, penalties), pair.anchor.x);
  }

  TEST(friction_force, vanishes_without_pressure)
  {
    const auto pair = node_on_floor(0.1, 0.01);
    const auto F    = friction_force(pair.kin, pair.anchor, penalties);
    EXPECT_EQ(F.state, FrictionState::open);
    EXPECT_EQ(F.traction.norm(), 0.);
    EXPECT_LT(
      (new_anchor(pair.kin, pair.anchor, F, penalties) - pair.kin.x_m).norm(),
      1e-14);
  }

  TEST(friction_force, loses_the_mean_of_both_limits_times_the_slip)
  {
    auto         pair = node_on_floor(0.1);
    const double L    = 0.3 * 50. * 0.01;
    const double old  = 0.4 * L; // the pressure was lower
    pair.anchor.limit = old;
    EXPECT_NEAR(friction_force(pair.kin, pair.anchor, penalties).dissipation,
                0.5 * (old + L) * (0.1 - L / 20.),
                1e-14);
  }

  TEST(friction_force, loses_all_it_had_stored_when_the_pressure_goes)
  {
    // Held at t = c_T 0.005 mm, then let go where it is: psi = t^2/2/c_T.
    auto         pair       = node_on_floor(0.005, 0.01);
    const double t          = 20. * 0.005;
    pair.anchor.traction[0] = t;
    EXPECT_NEAR(friction_force(pair.kin, pair.anchor, penalties).dissipation,
                0.5 * t * t / 20.,
                1e-15);
  }

  TEST(friction_force, pulls_back_towards_where_the_node_came_from)
  {
    // The node moved to +x: as a gradient, R at the node points to +x.
    const auto pair = node_on_floor(0.005);
    EXPECT_GT(friction_force(pair.kin, pair.anchor, penalties).R[0], 0.);
  }
} // namespace
