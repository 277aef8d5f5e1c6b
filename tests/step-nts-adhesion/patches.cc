// SPDX-License-Identifier: LGPL-2.1-or-later
// contact-patch.prm, adhesion-patch.prm: what one-pass node-to-segment contact
// gets right and what it misses (theory E.10, thesis 5.2.5).
#include "step-nts-adhesion/run_nts.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    constexpr double nominal = .1, area = 100., volume = 1000.;
    const Rubber     rubber;

    struct Deviation
    {
      double force   = 0.; ///< of the sum [N], upwards
      double largest = 0.; ///< of nodal traction over the exact one [-]
      double mean    = 0.; ///< weighted with area [-]
    };

    /// Of the tractions per reference area from @p exact.
    Deviation deviation(const CsvTable &points, const double exact)
    {
      Deviation result;
      double    total = 0.;
      for (std::size_t i = 0; i < points.n_rows(); ++i)
        {
          const double A = points["area [mm^2]"][i];
          const double f = points["force z [N]"][i];
          const double d = std::abs(f / A / exact - 1.);
          result.force += f;
          result.largest = std::max(result.largest, d);
          result.mean += A * d;
          total += A;
        }
      EXPECT_NEAR(total, area, 1e-9 * area);
      result.mean /= total;
      return result;
    }

    void record_both(const Deviation &d)
    {
      record("largest deviation", d.largest);
      record("mean deviation", d.mean);
    }

    /// Energy of both blocks stretched uniformly [mJ].
    double uniform_energy(const double stretch)
    {
      return volume * integral_of([](double l) { return rubber.uniaxial(l); },
                                  1.,
                                  stretch,
                                  200);
    }

    /// Both blocks and the bonds of adhesion-patch.prm, all uniform [mJ].
    double bonded_energy()
    {
      return uniform_energy(rubber.uniaxial_stretch(nominal)) +
             .5 * nominal * nominal / 20. * area;
    }
  } // namespace

  TEST(Patch, closed_form_has_the_values_of_theory_E10)
  {
    const double pressed = rubber.uniaxial_stretch(-nominal);
    EXPECT_NEAR(pressed, .93811223, 1e-8);
    EXPECT_NEAR(-nominal / std::pow(rubber.free_width(pressed), 2),
                -.09387382,
                1e-8);
    EXPECT_NEAR(rubber.uniaxial_stretch(nominal), 1.07255867, 1e-8);
  }

  TEST(ContactPatch, carries_the_force_exactly_and_misses_the_pressure)
  {
    const SceneRun  run = run_nts("contact-patch.prm");
    const Deviation d   = deviation(run.interface, nominal);
    record_both(d);
    EXPECT_NEAR(d.force, nominal * area, 1e-7 * nominal * area);
    EXPECT_GT(d.largest, .01); // known: NTS fails the patch test
    EXPECT_LT(d.largest, .6);
    EXPECT_LT(d.mean, .2);
    EXPECT_LT(run.number("energy balance error [-]"), .005);
  }

  TEST(ContactPatch, is_exact_where_the_meshes_match)
  {
    const SceneRun  run = run_nts("contact-patch.prm", {"Base/cells=7, 7, 5"});
    const Deviation d   = deviation(run.interface, nominal);
    EXPECT_LT(d.largest, 1e-6);
    const double energy =
      uniform_energy(rubber.uniaxial_stretch(-nominal)) +
      .5 * nominal * nominal / 1000. * area; // in the penalty
    EXPECT_NEAR(run.number("stored energy [mJ]"), energy, 1e-4 * energy);
  }

  TEST(ContactPatch, is_exact_with_quadratic_elements_where_the_meshes_match)
  {
    const SceneRun run =
      run_nts("contact-patch.prm",
              {"element=q2", "Body/cells=3, 3, 2", "Base/cells=3, 3, 2"});
    EXPECT_LT(deviation(run.interface, nominal).largest, 1e-6);
  }

  TEST(AdhesionPatch, carries_the_force_exactly_and_misses_the_gap)
  {
    const SceneRun  run = run_nts("adhesion-patch.prm");
    const Deviation d   = deviation(run.interface, -nominal);
    record_both(d);
    EXPECT_NEAR(d.force, -nominal * area, 1e-7 * nominal * area);
    EXPECT_GT(d.largest, .01);
    EXPECT_LT(d.largest, .6);
    EXPECT_LT(d.mean, .2);
    double gap = 0.;
    for (std::size_t i = 0; i < run.interface.n_rows(); ++i)
      gap += run.interface["gap [mm]"][i] * run.interface["area [mm^2]"][i];
    EXPECT_NEAR(gap / area, nominal / 20., .01 * nominal / 20.); // mean
    EXPECT_EQ(run.number("adhesion dissipation [mJ]"), 0.);
    const double misfit =
      run.number("stored energy [mJ]") / bonded_energy() - 1.;
    record("misfit of the energy", misfit);
    EXPECT_GT(misfit, .001);
    EXPECT_LT(misfit, .03);
  }

  // The misfit sits at the interface, so its share of the energy goes down with
  // the element size. The tractions next to it do not become better.
  TEST(AdhesionPatch, wastes_less_energy_on_finer_meshes)
  {
    const auto misfit = [](const std::string &body, const std::string &base) {
      const SceneRun run =
        run_nts("adhesion-patch.prm",
                {"Body/cells=" + body, "Base/cells=" + base});
      return run.number("stored energy [mJ]") / bonded_energy() - 1.;
    };
    const double coarse = misfit("4, 4, 2", "6, 6, 3");
    const double fine   = misfit("8, 8, 4", "12, 12, 6");
    record("coarse", coarse);
    record("fine", fine);
    EXPECT_LT(fine, .7 * coarse);
  }

  TEST(AdhesionPatch, is_exact_where_the_meshes_match)
  {
    const SceneRun run = run_nts("adhesion-patch.prm", {"Base/cells=7, 7, 5"});
    EXPECT_LT(deviation(run.interface, -nominal).largest, 1e-6);
    for (const double gap : run.interface["gap [mm]"])
      EXPECT_NEAR(gap, nominal / 20., 1e-6 * nominal / 20.);
    EXPECT_NEAR(run.number("stored energy [mJ]"),
                bonded_energy(),
                1e-4 * bonded_energy());
  }
} // namespace demold
