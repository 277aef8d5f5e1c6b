// SPDX-License-Identifier: LGPL-2.1-or-later
// Bonds whose damage takes time, as a term: exact tangent, its own entry in the
// ledger, no trace of rejected increments, restart.
#include "two_surfaces.h"

#include <gtest/gtest.h>

#include <sstream>

using namespace demold;

namespace
{
  using Values = TwoSurfaces::Values;

  constexpr double viscous_time = .5; // [s]; increments last 1 s

  TwoSurfaces bonded(const unsigned int dim, const double time)
  {
    InterfaceDescription description;
    AdhesionLaw          law;
    law.softening        = LinearSoftening{.2, .1, 20.};
    law.factors          = {.25, .5};
    law.viscous_time     = time;
    description.adhesion = law;
    const auto plane     = [](double, double) { return 0.; };
    return TwoSurfaces({dim, 2, -1., 1., plane, false},
                       {dim, 2, -2., 2., plane, true},
                       MasterKind::rigid,
                       description);
  }

  Values lifted(const TwoSurfaces &pair, const double lift)
  {
    dealii::Tensor<1, 3> shift;
    shift[0]            = .3 * lift;
    shift[pair.dim - 1] = lift;
    return pair.shifted_slave(shift);
  }
} // namespace

TEST(ViscousBonds, have_an_exact_tangent)
{
  for (const unsigned int dim : {2, 3})
    {
      TwoSurfaces pair = bonded(dim, viscous_time);
      pair.accept(lifted(pair, .02));
      const Values state = pair.with_noise(lifted(pair, .06), .005, 3);
      EXPECT_LT(pair.tangent_error(state), 1e-6);
      EXPECT_GT(pair.count(1), 2u);
    }
}

TEST(ViscousBonds, lose_what_others_lose_and_beyond_it_what_viscosity_takes)
{
  TwoSurfaces slow = bonded(2, viscous_time);
  TwoSurfaces fast = bonded(2, 0.);
  for (const double lift : {.02, .05, .4})
    for (TwoSurfaces *pair : {&slow, &fast})
      pair->accept(lifted(*pair, lift));
  const Energies a = slow.term->energies();
  const Energies b = fast.term->energies();
  EXPECT_NEAR(a.adhesion, b.adhesion, 1e-12); // both have let go
  EXPECT_NEAR(b.adhesion, .01 * 2., 1e-12);   // G_c times area
  EXPECT_GT(a.regularisation, .1 * a.adhesion);
  EXPECT_EQ(b.regularisation, 0.);
}

TEST(ViscousBonds, show_no_trace_of_rejected_increments)
{
  TwoSurfaces pair = bonded(2, viscous_time);
  pair.accept(lifted(pair, .03));
  const std::string before  = pair.saved();
  const auto        entries = pair.term->energies().as_array();
  pair.evaluate(lifted(pair, .09));
  EXPECT_GT(pair.term->energies().regularisation,
            Energies::from_array(entries).regularisation);
  pair.term->revert();
  EXPECT_EQ(pair.saved(), before);
  EXPECT_EQ(pair.term->energies().as_array(), entries);
}

TEST(ViscousBonds, go_on_from_what_was_saved)
{
  TwoSurfaces whole = bonded(2, viscous_time), again = bonded(2, viscous_time);
  whole.accept(lifted(whole, .03));
  std::istringstream in(whole.saved());
  again.term->load(in);
  again.accepted = whole.accepted;
  again.time     = whole.time;
  for (TwoSurfaces *pair : {&whole, &again})
    pair->accept(lifted(*pair, .05));
  EXPECT_EQ(whole.saved(), again.saved());
  EXPECT_EQ(whole.term->energies().regularisation,
            again.term->energies().regularisation);
}
