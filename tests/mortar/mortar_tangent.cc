// SPDX-License-Identifier: LGPL-2.1-or-later
// The tangent of the mortar term is the derivative of its residual in every
// state of contact, friction and bond, with both kinds of multipliers.
#include "contact/term/two_surfaces.h"

#include <gtest/gtest.h>

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
