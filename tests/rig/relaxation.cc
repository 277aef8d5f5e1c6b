// SPDX-License-Identifier: LGPL-2.1-or-later
// Relaxation and creep of the rig, and IDA, against the closed forms of E.9.
#include "closed_relaxation.h"
#include "rig/relaxation_reference.h"
#include "rig/rig_curve.h"
#include "test_rubber.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace demold
{
  namespace
  {
    constexpr double mu = .5, tau = .2;

    RubberLaw rubber(const BranchLaw branch_law)
    {
      RubberLaw law  = test_rubber({{mu, tau}});
      law.branch_law = branch_law;
      return law;
    }

    Loading with_steps(Loading loading, const unsigned int n)
    {
      loading.time_step = loading.end() / n;
      return loading;
    }

    /// Shear stress of the branch over mu at the end, the elastic part taken
    /// off: (mu1 + mu2) gamma.
    double branch_shear(const double stress, const double gamma)
    {
      return (stress - .5 * gamma) / mu;
    }

    double end_of_rig(const RubberLaw &law, const Loading &loading)
    {
      return run_rig(law, RigMode::simple_shear, loading)
        .rows.back()
        .state.nominal;
    }

    double end_of_ida(const RubberLaw &law, const Loading &loading)
    {
      return relaxation_reference(law,
                                  RigMode::simple_shear,
                                  loading,
                                  run_rig(law, RigMode::simple_shear, loading))
        .nominal.back();
    }
  } // namespace



  TEST(ClosedForms, are_the_tabulated_ones)
  {
    EXPECT_NEAR(relaxed_shear(.1, .5), .06054113, 5.1e-9);
    EXPECT_NEAR(relaxed_shear(1., 1.), .30170331, 5.1e-9);
    EXPECT_NEAR(relaxed_shear(2., 2.), .15355218, 5.1e-9);
    EXPECT_NEAR(relaxed_extension(1.2, .5), .33736863, 5.1e-9);
    EXPECT_NEAR(relaxed_extension(2., 1.), .64082930, 5.1e-9);
    EXPECT_NEAR(relaxed_shear_linear(1., 1.), .29847161, 5.1e-9);
  }

  TEST(Relaxation, of_finite_shear_is_that_of_E9_within_1e_6)
  {
    for (const double gamma : {.1, .5, 1., 2.})
      for (const double t : {.5, 1., 2.})
        {
          const auto loading =
            with_steps(ramp_and_hold(gamma, 0., t * tau), 600);
          const double exact = relaxed_shear(gamma, t);
          EXPECT_NEAR(branch_shear(end_of_rig(rubber(BranchLaw::isochoric),
                                              loading),
                                   gamma),
                      exact,
                      1e-6)
            << gamma << ' ' << t;
          EXPECT_NEAR(branch_shear(end_of_ida(rubber(BranchLaw::isochoric),
                                              loading),
                                   gamma),
                      exact,
                      1e-8);
        }
  }

  TEST(Relaxation, of_uniaxial_extension_is_that_of_E9_within_1e_6)
  {
    RubberLaw law                              = rubber(BranchLaw::isochoric);
    std::get<MooneyRivlin>(law.elastic).lambda = 1e7;
    for (const double x : {1.2, 1.5, 2.})
      for (const double t : {.5, 1., 2.})
        {
          const auto loading =
            with_steps(ramp_and_hold(x - 1., 0., t * tau), 1200);
          const double elastic = (.4 + .1 / x) * (x - 1. / (x * x));
          const double exact   = elastic + mu / x * relaxed_extension(x, t);
          const auto   curve   = run_rig(law, RigMode::uniaxial, loading);
          EXPECT_NEAR(curve.rows.back().state.nominal, exact, 1e-6);
          EXPECT_NEAR(
            relaxation_reference(law, RigMode::uniaxial, loading, curve)
              .nominal.back(),
            exact,
            3e-7); // compressible by G/K = 1e-7
        }
  }

  TEST(Relaxation, of_linear_evolution_in_shear_is_its_closed_form)
  {
    for (const double t : {.5, 1., 2.})
      {
        const auto   loading = with_steps(ramp_and_hold(1., 0., t * tau), 7);
        const double exact   = relaxed_shear_linear(1., t);
        EXPECT_NEAR(branch_shear(end_of_rig(rubber(BranchLaw::linear), loading),
                                 1.),
                    exact,
                    1e-13);
        EXPECT_NEAR(branch_shear(end_of_ida(rubber(BranchLaw::linear), loading),
                                 1.),
                    exact,
                    1e-8);
      }
  }

  TEST(Ida, ramps_have_the_stresses_of_E9)
  {
    const Loading ramp = with_steps(ramp_and_hold(1., 1. / tau, 0.), 5);
    EXPECT_NEAR(branch_shear(end_of_ida(rubber(BranchLaw::isochoric), ramp),
                             1.),
                .5774801429,
                1e-8);
    EXPECT_NEAR(branch_shear(end_of_ida(rubber(BranchLaw::linear), ramp), 1.),
                .5599409088,
                1e-8);
  }

  TEST(Ida, small_strains_relax_like_a_prony_series_in_every_variant)
  {
    RubberLaw law = test_rubber({{.5, .2}, {.25, 3.}});
    for (const BranchLaw branch_law : {BranchLaw::isochoric,
                                       BranchLaw::linear,
                                       BranchLaw::lubliner,
                                       BranchLaw::convolution})
      {
        law.branch_law      = branch_law;
        const double  gamma = 1e-4, t = 1.;
        const Loading loading = with_steps(ramp_and_hold(gamma, 0., t), 3);
        const double  exact =
          .5 + .5 * std::exp(-t / .2) + .25 * std::exp(-t / 3.);
        EXPECT_NEAR(end_of_ida(law, loading) / gamma, exact, 1e-7);
      }
  }



  class Variants : public testing::TestWithParam<BranchLaw>
  {};

  TEST_P(Variants, converge_to_IDA_with_order_two)
  {
    for (const RigMode mode : {RigMode::uniaxial, RigMode::simple_shear})
      {
        double errors[2];
        for (unsigned int i = 0; i < 2; ++i)
          {
            Loading loading       = sine(.2, .5, 1., 1);
            loading.time_step     = 1. / (i == 0 ? 400 : 800);
            const RubberLaw law   = rubber(GetParam());
            const RigCurve  curve = run_rig(law, mode, loading);
            const auto      exact =
              relaxation_reference(law, mode, loading, curve).nominal;
            errors[i] = 0.;
            for (std::size_t k = 0; k < exact.size(); ++k)
              errors[i] =
                std::max(errors[i],
                         std::abs(curve.rows[k].state.nominal - exact[k]));
          }
        EXPECT_LT(errors[1], 1e-4);
        EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2., .1);
      }
  }

  INSTANTIATE_TEST_SUITE_P(All,
                           Variants,
                           testing::Values(BranchLaw::isochoric,
                                           BranchLaw::linear,
                                           BranchLaw::lubliner,
                                           BranchLaw::convolution));

  TEST(Updates, backward_euler_is_of_order_one)
  {
    RubberLaw law      = rubber(BranchLaw::isochoric);
    law.update         = ViscousUpdate::be;
    double       error = 0., ratio = 0.;
    const double exact = .5774801429;
    for (const unsigned int n : {80, 160})
      {
        const double e =
          branch_shear(
            end_of_rig(law, with_steps(ramp_and_hold(1., 1. / tau, 0.), n)),
            1.) -
          exact;
        ratio = error / e;
        error = e;
      }
    EXPECT_NEAR(std::log2(ratio), 1., .05);
  }



  TEST(Creep, of_a_standard_linear_solid_is_that_of_E9)
  {
    // E_inf = 1, E_1 = 0.5 MPa, tau = 0.2 s; strain per stress at t = tau.
    RubberLaw    law;
    MooneyRivlin elastic;
    elastic.lambda        = 1e6;
    elastic.mu1           = 1. / 3.;
    elastic.mu2           = 0.;
    law.elastic           = elastic;
    law.branches          = {{.5 / 3., tau}};
    const double  stress  = 1e-6;
    const Loading loading = with_steps(creep(stress, tau), 400);
    const auto    curve   = run_rig(law, RigMode::uniaxial, loading);
    EXPECT_NEAR(curve.rows.back().state.strain / stress, .82886096, 1e-5);
    // A strain of 1e-6 of stretches of 1 needs a tighter tolerance.
    const auto reference =
      relaxation_reference(law, RigMode::uniaxial, loading, curve, 1e-12);
    EXPECT_NEAR(reference.strain.back() / stress, .82886096, 1e-5);
  }

  TEST(Creep, at_finite_strain_agrees_with_IDA_in_every_mode)
  {
    for (const RigMode mode : {RigMode::uniaxial,
                               RigMode::equibiaxial,
                               RigMode::pure_shear,
                               RigMode::simple_shear,
                               RigMode::confined})
      {
        const RubberLaw law     = rubber(BranchLaw::isochoric);
        const Loading   loading = with_steps(creep(.25, 2. * tau), 800);
        const auto      curve   = run_rig(law, mode, loading);
        EXPECT_NEAR(
          curve.rows.back().state.strain,
          relaxation_reference(law, mode, loading, curve).strain.back(),
          1e-6);
      }
  }

  TEST(Loading, growing_steps_end_where_they_should)
  {
    Loading loading   = ramp_and_hold(.1, .1, 1000.);
    loading.time_step = .01;
    loading.growth    = 1.2;
    const auto times  = loading.times();
    EXPECT_EQ(times.back(), 1001.);
    EXPECT_NE(std::find(times.begin(), times.end(), 1.), times.end());
    EXPECT_LT(times.size(), 160u);
    EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
    EXPECT_LE(times[100] - times[99], .0101);
  }
} // namespace demold
