// SPDX-License-Identifier: LGPL-2.1-or-later
// column.prm: rubber in series with its bond, through the snap-back.
#include "step-arclength/path_points.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    constexpr double area = 2., height = 40.; // [mm^2], [mm]

    /// Opening [mm] at nominal stress @p t on the softening branch.
    double softening_opening(const Rubber &rubber,
                             const Bond   &bond,
                             const double  t)
    {
      return bond.rupture - t * (bond.rupture - bond.onset()) / bond.strength +
             height * (rubber.confined_stretch(t) - 1.);
    }

    double elastic_opening(const Rubber &rubber,
                           const Bond   &bond,
                           const double  t)
    {
      return t / bond.penalty + height * (rubber.confined_stretch(t) - 1.);
    }
  } // namespace

  TEST(Column, comes_back_along_the_closed_form)
  {
    const Rubber   rubber;
    const Bond     bond;
    const SceneRun run = run_arclength("column.prm");
    ASSERT_EQ(run.exit_code, 0);
    const double peak    = elastic_opening(rubber, bond, bond.strength);
    double       worst   = 0.;
    unsigned int softens = 0;
    for (const PathRow &row : path_rows(run))
      {
        const double t = row.F / area;
        const double u = row.bonded == 0. ? row.u :
                         row.adhesion > 0. ?
                                            softening_opening(rubber, bond, t) :
                                            elastic_opening(rubber, bond, t);
        worst          = std::max(worst, std::abs(row.u - u) / peak);
        if (row.bonded == 0.)
          EXPECT_NEAR(t, 0., 1e-3 * bond.strength);
        softens += row.bonded > 0. && row.adhesion > 0. ? 1 : 0;
      }
    record("largest deviation", worst);
    EXPECT_LT(worst, 1e-3);
    EXPECT_GE(softens, 4u);

    const double stretch = rubber.confined_stretch(bond.strength);
    const double released =
      area * (height * integral_of([&](double l) { return rubber.confined(l); },
                                   1.,
                                   stretch) +
              bond.work(bond.onset()) - bond.fracture_energy());
    EXPECT_NEAR(run.number("released energy [mJ]"), released, 5e-3 * released);
    EXPECT_LT(run.number("energy balance error [-]"), 1e-3);
  }
} // namespace demold
