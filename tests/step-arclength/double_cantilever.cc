// SPDX-License-Identifier: LGPL-2.1-or-later
// double-cantilever.prm against the corrected beam (theory E.4).
#include "step-arclength/path_points.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    /// Both arms, opened by delta at their ends, from a crack a_0 on.
    struct Specimen
    {
      double E     = 200. / (1. - .3 * .3); ///< in plane strain [MPa]
      double shear = 200. / 2.6;            ///< [MPa]
      double h = 3., b = 10.;               ///< height of an arm, width [mm]
      double a_0 = 30.;                     ///< [mm]
      double G   = 2. * .5 * 5. * .01; ///< of both halves of the bond [mJ/mm^2]

      /// Root rotation and shear make the crack longer by chi h: Williams
      /// 1989, for E_11 = E_22; the 0.64 = 6^(-1/4) of Kanninen 1973 is without
      /// shear.
      double chi() const
      {
        const double gamma = 1.18 * E / shear, part = gamma / (1. + gamma);
        return std::sqrt(E / (11. * shear) * (3. - 2. * part * part));
      }

      /// Of the arms at the length @p a = crack + chi h. N and @p F below are
      /// the corrections for large openings of Williams 1987, ISO 15024.
      double force(const double delta, const double a) const
      {
        const double N = 1. - 9. / 35. * delta * delta / (a * a);
        return delta * b * E * h * h * h / (8. * a * a * a * N);
      }

      double release_rate(const double delta, const double a) const
      {
        const double F = 1. - 3. / 10. * delta * delta / (a * a);
        return 3. * force(delta, a) * delta / (2. * b * a) * F;
      }

      /// Crack + chi h at the opening @p delta [mm].
      double length(const double delta) const
      {
        const double begin = a_0 + chi() * h;
        if (release_rate(delta, begin) <= G)
          return begin;
        return root_of([&](double a) { return release_rate(delta, a) - G; },
                       begin,
                       4. * begin);
      }
    };
  } // namespace

  TEST(DoubleCantilever, correction_is_that_of_the_literature)
  {
    // Isotropic, nu = 0.3: between 0.64 without shear and 0.7.
    EXPECT_NEAR(Specimen().chi(), .67, .03);
  }

  class DoubleCantilever : public testing::TestWithParam<const char *>
  {};

  // E G/alpha^2 = 0.4 mm: half of it to an eighth.
  TEST_P(DoubleCantilever, opens_by_the_force_of_the_corrected_beam)
  {
    const SceneRun run =
      run_arclength("double-cantilever.prm",
                    {std::string("Body/fine size=") + GetParam()});
    ASSERT_EQ(run.exit_code, 0);
    const Specimen specimen;
    double         worst = 0.;
    for (const PathRow &row : path_rows(run))
      {
        const double delta = 2. * row.u;
        const double exact = specimen.force(delta, specimen.length(delta));
        worst              = std::max(worst, std::abs(row.F / exact - 1.));
      }
    record("largest deviation", worst);
    record("increments", run.history.n_rows());
    EXPECT_LT(worst, .03);
    const double cracked =
      run.number("adhesion dissipation [mJ]") / (.5 * specimen.G * specimen.b);
    EXPECT_GT(cracked, 1.);
    EXPECT_LT(run.number("energy balance error [-]"), 2e-3);
  }

  INSTANTIATE_TEST_SUITE_P(meshes,
                           DoubleCantilever,
                           testing::Values("0.2", "0.1", "0.05"),
                           [](const auto &info) {
                             const std::string size = info.param;
                             return size == "0.2" ? "half_a_cohesive_zone" :
                                    size == "0.1" ? "quarter" :
                                                    "eighth";
                           });
} // namespace demold
