// SPDX-License-Identifier: LGPL-2.1-or-later
// The tangent of the mortar term is the derivative of its residual in every
// state of contact, friction and bond, with both kinds of multipliers, also
// where a path drives a bond; and what a path sees of a bond is its energy.
#include "contact/term/two_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace demold;
using dealii::Tensor;

namespace
{
  using Values = TwoSurfaces::Values;

  constexpr double tolerance = 1e-7;

  Tensor<1, 3> vector(const double x, const double y, const double z)
  {
    return Tensor<1, 3>({x, y, z});
  }

  double slope(const double x, const double y)
  {
    return .1 * x + .05 * y + .02 * x * x - .01 * x * y;
  }

  AdhesionLaw bond(const ModeFactors factors)
  {
    AdhesionLaw law;
    law.softening = LinearSoftening{.2, .1, 20.};
    law.factors   = factors;
    return law;
  }

  struct Case
  {
    unsigned int dim;
    MasterKind   kind;
    bool         dual;
  };

  std::vector<Case> cases()
  {
    std::vector<Case> list;
    for (const unsigned int dim : {2, 3})
      for (const auto kind : {MasterKind::rigid, MasterKind::deformable})
        for (const bool dual : {false, true})
          list.push_back({dim, kind, dual});
    return list;
  }

  std::string text(const Case &c)
  {
    return std::to_string(c.dim) + "-D, " +
           (c.kind == MasterKind::rigid ? "rigid" : "deformable") +
           " master, " + (c.dual ? "dual" : "standard") + " multipliers";
  }

  /// Slave of 2 to 3 faces on a master of other faces that reaches farther.
  TwoSurfaces surfaces(const Case          &c,
                       InterfaceDescription description,
                       const double         above)
  {
    description.dual_multipliers = c.dual;
    description.stiffness        = 3.;
    const unsigned int n         = c.dim == 2 ? 3 : 2;
    return TwoSurfaces(
      {c.dim,
       n,
       -1.,
       1.05,
       [above](double x, double y) { return slope(x, y) + above; },
       false},
      {c.dim, n + 1, -1.6, 1.7, slope, true},
      c.kind,
      description,
      [](double) { return RigidPlacement(); },
      Formulation::mortar);
  }

  /// The same multiplier [MPa] at every point.
  Values with_multiplier(const TwoSurfaces  &pair,
                         Values              values,
                         const Tensor<1, 3> &lambda)
  {
    for (unsigned int i = pair.n_displacements; i < pair.n; ++i)
      values[i] = lambda[(i - pair.n_displacements) % pair.dim];
    return values;
  }

  Tensor<1, 3> up(const unsigned int dim, const double length)
  {
    return dim == 2 ? vector(0., length, 0.) : vector(0., 0., length);
  }

  /// Lets a path drive all bonds.
  void drive_all(TwoSurfaces &pair)
  {
    auto &path = dynamic_cast<SofteningTerm &>(*pair.term);
    path.drive(std::vector<bool>(path.softening_sites().size(), true));
  }

  std::vector<SofteningSite> sites(const TwoSurfaces &pair)
  {
    return dynamic_cast<const SofteningTerm &>(*pair.term).softening_sites();
  }

  /// Bonded over its whole length on a plane master.
  TwoSurfaces plane_surfaces(const Case &c, const ModeFactors factors)
  {
    InterfaceDescription description;
    description.adhesion         = bond(factors);
    description.dual_multipliers = c.dual;
    description.stiffness        = 3.;
    const unsigned int n         = c.dim == 2 ? 3 : 2;
    const auto         plane     = [](double, double) { return 0.; };
    return TwoSurfaces(
      {c.dim, n, -1., 1.05, plane, false},
      {c.dim, n + 1, -1.6, 1.7, plane, true},
      c.kind,
      description,
      [](double) { return RigidPlacement(); },
      Formulation::mortar);
  }

  /// Bonds that have been in tension: a fresh one is held in iteration 0.
  TwoSurfaces loaded_surfaces(const Case &c, const ModeFactors factors)
  {
    TwoSurfaces pair = plane_surfaces(c, factors);
    pair.accept(with_multiplier(pair, Values(pair.n, 0.), -up(c.dim, .1)));
    return pair;
  }

  /// The slave lifted by @p lift and shifted by @p shift [mm], every bond on
  /// its softening branch: lambda = s(gap)/gap (g_N, a g_T), theory C4.
  Values softened(const TwoSurfaces &pair,
                  const ModeFactors  factors,
                  const double       lift,
                  const double       shift)
  {
    const double gap       = std::hypot(lift, factors.b * shift);
    const double stiffness = .2 * (1. - gap / .1) / gap;
    return with_multiplier(
      pair,
      pair.shifted_slave(up(pair.dim, lift) + vector(shift, 0., 0.)),
      -stiffness * (up(pair.dim, lift) + factors.a * vector(shift, 0., 0.)));
  }
} // namespace

TEST(MortarTangent, of_frictionless_contact_matches_differences)
{
  for (const Case &c : cases())
    {
      TwoSurfaces  pair = surfaces(c, InterfaceDescription(), .1);
      const Values state =
        pair.with_noise(with_multiplier(pair,
                                        pair.shifted_slave(up(c.dim, -.12)),
                                        up(c.dim, .05)),
                        .01,
                        7);
      EXPECT_LT(pair.tangent_error(state), tolerance) << text(c);
      EXPECT_GT(pair.count(state_contact), 3u) << text(c);
    }
}

TEST(MortarTangent, of_stick_and_slip_matches_differences)
{
  for (const Case &c : cases())
    for (const double shear : {.0, .03})
      {
        const Tensor<1, 3>   pressure = up(c.dim, shear > 0. ? .05 : .5);
        InterfaceDescription description;
        description.friction = .3;
        TwoSurfaces  pair    = surfaces(c, description, .1);
        const Values pressed =
          with_multiplier(pair, pair.shifted_slave(up(c.dim, -.11)), pressure);
        pair.accept(pressed);
        const Values state = pair.with_noise(
          with_multiplier(pair,
                          pair.shifted_slave(up(c.dim, -.11) +
                                             vector(2. * shear, 0., 0.)),
                          pressure + vector(-shear, 0., 0.)),
          .002,
          3);
        pair.evaluate(state, 1);
        EXPECT_LT(pair.tangent_error(state, 1), tolerance) << text(c);
        EXPECT_GT(pair.count(shear > 0. ? state_slip : state_contact), 3u)
          << text(c);
      }
}

TEST(MortarTangent, of_bonds_matches_differences)
{
  for (const Case &c : cases())
    for (const double lift : {0., .03, .15})
      {
        InterfaceDescription description;
        description.adhesion    = bond({.25, .5});
        TwoSurfaces        pair = surfaces(c, description, 0.);
        const Tensor<1, 3> gap  = up(c.dim, lift) + vector(.3 * lift, 0., 0.);
        const Values       state =
          pair.with_noise(with_multiplier(pair,
                                          pair.shifted_slave(gap),
                                          lift == 0. ? -up(c.dim, .05) :
                                                       Tensor<1, 3>()),
                          lift == 0. ? 1e-4 : .005,
                          5);
        // A bond does not skip decohesion: it separates in the second look.
        pair.evaluate(state, 1);
        EXPECT_LT(pair.tangent_error(state, 1), tolerance) << text(c);
        const int expected = lift == 0. ? 0 : lift < .1 ? 1 : state_free;
        EXPECT_GT(pair.count(expected), 3u) << text(c) << ", lift " << lift;
      }
}

// Iteration 0 of a driven bond: it softens below its limit, beyond rupture, and
// from damage it has had before.
TEST(MortarTangent, of_driven_bonds_matches_differences)
{
  for (const Case &c : cases())
    for (const double tension : {.05, .15})
      {
        TwoSurfaces  pair = loaded_surfaces(c, {.25, .5});
        const Values state =
          pair.with_noise(with_multiplier(pair,
                                          Values(pair.n, 0.),
                                          -up(c.dim, tension) +
                                            vector(.01, 0., 0.)),
                          1e-4,
                          5);
        pair.evaluate(state);
        EXPECT_EQ(pair.count(1), 0u);
        drive_all(pair);
        EXPECT_LT(pair.tangent_error(state), tolerance) << text(c);
        EXPECT_GT(pair.count(1), 3u) << text(c);
        EXPECT_FALSE(pair.term->has_settled()) << text(c);
        // In the next iteration the bond is free again.
        pair.evaluate(state, 1);
        EXPECT_EQ(pair.count(1), 0u) << text(c);
      }
  for (const Case &c : cases())
    for (const double lift : {.02, .031, .12})
      {
        TwoSurfaces pair = loaded_surfaces(c, {.25, .5});
        pair.accept(softened(pair, {.25, .5}, .03, .01));
        EXPECT_GT(pair.count(1), 3u) << text(c);
        drive_all(pair);
        const Values state =
          pair.with_noise(softened(pair, {.25, .5}, lift, .01), 1e-4, 9);
        EXPECT_LT(pair.tangent_error(state), tolerance) << text(c);
        EXPECT_GT(pair.count(1), 3u) << text(c) << ", lift " << lift;
      }
}

TEST(MortarPath, sees_gap_energy_and_how_near_bonds_are_to_give_way)
{
  for (const Case &c : cases())
    {
      TwoSurfaces  pair = loaded_surfaces(c, {.25, .5});
      const Values intact =
        with_multiplier(pair, Values(pair.n, 0.), -up(c.dim, .12));
      pair.evaluate(intact);
      for (const SofteningSite &site : sites(pair))
        {
          EXPECT_NEAR(site.utilisation, .6, 1e-9);
          EXPECT_EQ(site.released, 0.);
          EXPECT_NEAR(site.whole, .01 * site.area, 1e-14);
          EXPECT_EQ(site.left, site.whole);
          EXPECT_FALSE(site.separated);
        }
      // a rigid bond with linear softening has lost alpha/2 per gap (theory C6)
      const double gap = std::hypot(.03, .5 * .01);
      pair.accept(softened(pair, {.25, .5}, .03, .01));
      pair.evaluate(pair.accepted);
      for (const SofteningSite &site : sites(pair))
        {
          EXPECT_NEAR(site.largest, gap, 1e-9);
          EXPECT_NEAR(site.effective, gap, 1e-9);
          EXPECT_NEAR(site.utilisation, 1., 1e-7);
          EXPECT_NEAR(site.left, site.area * (.01 - .1 * gap), 1e-9);
        }
      drive_all(pair);
      for (const double lift : {.025, .05, .12})
        {
          pair.evaluate(softened(pair, {.25, .5}, lift, .01));
          for (const SofteningSite &site : sites(pair))
            EXPECT_NEAR(site.released,
                        site.area * .1 * (std::hypot(lift, .005) - gap),
                        1e-9)
              << text(c);
        }
      // and nothing is left of being driven
      pair.term->revert();
      for (const SofteningSite &site : sites(pair))
        EXPECT_FALSE(site.driven);
    }
}

TEST(MortarPath, released_energy_has_its_gradient)
{
  for (const Case &c : cases())
    {
      TwoSurfaces pair = loaded_surfaces(c, {1., 1.});
      pair.evaluate(Values(pair.n, 0.));
      drive_all(pair);
      const Values state = softened(pair, {1., 1.}, .03, .01);
      pair.evaluate(state);
      const auto at = sites(pair);
      ASSERT_GT(at.size(), 3u);
      const double h = 1e-6;
      for (unsigned int j = 0; j < pair.n_displacements; ++j)
        {
          if (!pair.is_moving(j))
            continue;
          Values plus = state, minus = state;
          plus[j] += h;
          minus[j] -= h;
          pair.evaluate(plus);
          const auto more = sites(pair);
          pair.evaluate(minus);
          const auto less = sites(pair);
          for (std::size_t i = 0; i < at.size(); ++i)
            {
              double gradient = 0.;
              for (std::size_t k = 0; k < at[i].unknowns.size(); ++k)
                if (at[i].unknowns[k] == j)
                  gradient += at[i].weights[k] *
                              at[i].released_gradient[at[i].components[k]];
              EXPECT_NEAR(gradient,
                          (more[i].released - less[i].released) / (2. * h),
                          1e-7)
                << text(c);
            }
        }
    }
}
