// SPDX-License-Identifier: LGPL-2.1-or-later
// column-mortar.prm: rubber in series with a bond that is rigid until its
// limit, through the snap-back.
#include "step-arclength/path_points.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    constexpr double area = 2., height = 40.; // [mm^2], [mm]

    /// Opening [mm] at nominal stress @p t while the bond of gap 0 to delta
    /// softens (theory C1), or holds.
    double opening(const Rubber &rubber,
                   const Bond   &bond,
                   const double  t,
                   const bool    softens)
    {
      const double gap = softens ? bond.rupture * (1. - t / bond.strength) : 0.;
      return gap + height * (rubber.confined_stretch(t) - 1.);
    }

    class MortarColumn : public testing::TestWithParam<std::string>
    {};
  } // namespace

  TEST_P(MortarColumn, comes_back_along_the_closed_form)
  {
    const Rubber   rubber;
    const Bond     bond;
    const SceneRun run =
      run_arclength("column-mortar.prm",
                    {"Solution/path constraint=" + GetParam()});
    ASSERT_EQ(run.exit_code, 0);
    const double peak    = opening(rubber, bond, bond.strength, false);
    double       worst   = 0.;
    unsigned int softens = 0, back = 0;
    double       last = 0.;
    for (const PathRow &row : path_rows(run))
      {
        const double t = row.F / area;
        const double u = row.bonded == 0. ?
                           row.u :
                           opening(rubber, bond, t, row.adhesion > 0.);
        worst          = std::max(worst, std::abs(row.u - u) / peak);
        softens += row.bonded > 0. && row.adhesion > 0. ? 1 : 0;
        back += row.u < last ? 1 : 0;
        last = row.u;
      }
    record("largest deviation", worst);
    EXPECT_LT(worst, 1e-3);
    EXPECT_GE(softens, 4u);
    EXPECT_GE(back, 4u);

    // What the column had stored at the peak, less G_c of the bond.
    const double released =
      area * (height * integral_of([&](double l) { return rubber.confined(l); },
                                   1.,
                                   rubber.confined_stretch(bond.strength)) -
              bond.fracture_energy());
    EXPECT_NEAR(run.number("released energy [mJ]"), released, 5e-3 * released);
    EXPECT_LT(run.number("energy balance error [-]"), 1e-3);
  }

  INSTANTIATE_TEST_SUITE_P(
    constraints,
    MortarColumn,
    testing::Values("adaptive", "dissipation", "largest opening", "interface"));
} // namespace demold
