// SPDX-License-Identifier: LGPL-2.1-or-later
// Modes of the rig against the reference values of theory A.1.
#include "rig/rig_point.h"
#include "test_rubber.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace demold
{
  namespace
  {
    /// Half the last of eight decimals.
    constexpr double rounding = 5.1e-9;

    RubberLaw nearly_incompressible()
    {
      RubberLaw law                              = test_rubber();
      std::get<MooneyRivlin>(law.elastic).lambda = 1e6;
      return law;
    }

    RigState stretched(const RubberLaw &law,
                       const RigMode    mode,
                       const double     strain)
    {
      RigPoint point(law, mode);
      return point.strain_step(strain, 1.);
    }
  } // namespace



  TEST(RigModes, are_found_by_their_names)
  {
    std::istringstream names(rig_mode_names);
    unsigned int       n = 0;
    for (std::string name; std::getline(names, name, '|'); ++n)
      EXPECT_EQ(name_of(rig_mode_by_name(name)), name);
    EXPECT_EQ(n, 5u);
  }

  TEST(RigModes, uniaxial_extension_has_the_values_of_theory_A1)
  {
    const double table[][3] = {{0.8, 1.11653439, -0.39785933},
                               {1.2, 0.91356683, 0.24390404},
                               {1.5, 0.81761696, 0.49221603},
                               {2.0, 0.70833002, 0.78741328}};
    for (const auto &[stretch, lateral, nominal] : table)
      {
        const RigState state =
          stretched(test_rubber(), RigMode::uniaxial, stretch - 1.);
        EXPECT_NEAR(state.lateral, lateral, rounding);
        EXPECT_NEAR(state.nominal, nominal, rounding);
        EXPECT_NEAR(state.cauchy[1][1], 0., 1e-13);
        EXPECT_NEAR(state.cauchy[2][2], 0., 1e-13);
      }
  }

  TEST(RigModes, confined_compression_has_the_values_of_theory_A1)
  {
    const double table[][3] = {{0.98, -1.03444898, -1.01424490},
                               {0.99, -0.51458586, -0.50453535},
                               {1.01, 0.50946535, 0.49951485},
                               {1.05, 2.49904762, 2.45023810}};
    for (const auto &[stretch, nominal, side] : table)
      {
        const RigState state =
          stretched(test_rubber(), RigMode::confined, stretch - 1.);
        EXPECT_NEAR(state.nominal, nominal, rounding);
        EXPECT_NEAR(state.cauchy[1][1], side, rounding);
      }
  }

  TEST(RigModes, simple_shear_has_the_values_of_theory_A1)
  {
    const RigState state = stretched(test_rubber(), RigMode::simple_shear, .5);
    EXPECT_NEAR(state.cauchy[0][0], .125, 1e-14);
    EXPECT_NEAR(state.cauchy[0][1], .25, 1e-14);
    EXPECT_NEAR(state.cauchy[1][1], 0., 1e-14);
    EXPECT_NEAR(state.cauchy[2][2], .025, 1e-14);
  }

  TEST(RigModes, equibiaxial_and_pure_shear_tend_to_the_incompressible_forms)
  {
    const double mu1 = .4, mu2 = .1;
    for (const double x : {.8, 1.3, 2.})
      {
        const double biaxial = (mu1 + mu2 * x * x) * (x - std::pow(x, -5.));
        const double shear   = (mu1 + mu2) * (x - std::pow(x, -3.));
        EXPECT_NEAR(stretched(nearly_incompressible(),
                              RigMode::equibiaxial,
                              x - 1.)
                      .nominal,
                    biaxial,
                    1e-5 * std::abs(biaxial));
        EXPECT_NEAR(stretched(nearly_incompressible(),
                              RigMode::pure_shear,
                              x - 1.)
                      .nominal,
                    shear,
                    1e-5 * std::abs(shear));
      }
  }

  TEST(RigModes, a_prescribed_stress_gives_the_stretches_of_theory_A1)
  {
    const double uniaxial[][3] = {{.1, 1.07255867, .96589589},
                                  {-.1, .93811223, 1.03211420},
                                  {.05, 1.03481724, .98319406},
                                  {-.05, .96784638, 1.01630654},
                                  {.2, 1.15791300, .92990169}};
    for (const auto &[nominal, stretch, lateral] : uniaxial)
      {
        RigPoint        point(test_rubber(), RigMode::uniaxial);
        const RigState &state = point.stress_step(nominal, 1.);
        EXPECT_NEAR(1. + state.strain, stretch, rounding);
        EXPECT_NEAR(state.lateral, lateral, rounding);
        EXPECT_NEAR(state.nominal, nominal, 1e-13);
      }
    RigPoint confined(test_rubber(), RigMode::confined);
    EXPECT_NEAR(confined.stress_step(-.1, 1.).strain, .99804878 - 1., rounding);
    EXPECT_NEAR(confined.stress_step(.1, 1.).strain, 1.00195503 - 1., rounding);
  }

  TEST(RigModes, a_prescribed_stress_is_found_in_every_mode)
  {
    for (const RigMode mode : {RigMode::uniaxial,
                               RigMode::equibiaxial,
                               RigMode::pure_shear,
                               RigMode::simple_shear,
                               RigMode::confined})
      for (const RubberLaw &law : {test_rubber(), nearly_incompressible()})
        {
          RigPoint     point(law, mode);
          const double strain = point.stress_step(.3, 1.).strain;
          EXPECT_NEAR(stretched(law, mode, strain).nominal, .3, 1e-8);
        }
  }



  /// Corrections e_k of Newton's method, quadratic: e_k+1 <= c e_k^2. Of two
  /// errors below round-off nothing can be said.
  void expect_quadratic(const std::vector<double> &corrections)
  {
    unsigned int n_pairs = 0;
    for (std::size_t k = 0; k + 1 < corrections.size(); ++k)
      if (corrections[k] < .1 && corrections[k + 1] > 1e-13)
        {
          EXPECT_LT(corrections[k + 1], 10. * corrections[k] * corrections[k]);
          ++n_pairs;
        }
    EXPECT_GE(n_pairs, 2u);
  }

  TEST(RigNewton, is_quadratic_in_the_lateral_stretch_for_every_branch_law)
  {
    for (const BranchLaw branch_law : {BranchLaw::isochoric,
                                       BranchLaw::linear,
                                       BranchLaw::lubliner,
                                       BranchLaw::convolution})
      for (const RigMode mode :
           {RigMode::uniaxial, RigMode::equibiaxial, RigMode::pure_shear})
        {
          // Soft in volume, so that the first guess is a bad one.
          RubberLaw law = test_rubber({{.5, 1.}, {.3, 10.}});
          std::get<MooneyRivlin>(law.elastic).lambda = .5;
          law.branch_law                             = branch_law;
          RigPoint point(law, mode);
          point.strain_step(.4, 1.);
          expect_quadratic(point.corrections());
        }
  }

  TEST(RigNewton, is_quadratic_in_both_unknowns_of_creep)
  {
    RigPoint point(test_rubber({{.5, 1.}, {.3, 10.}}), RigMode::uniaxial);
    point.stress_step(.6, 1.);
    expect_quadratic(point.corrections());
  }

  TEST(RigNewton, a_stress_no_state_can_carry_is_an_error)
  {
    RubberLaw law                           = test_rubber();
    std::get<MooneyRivlin>(law.elastic).mu1 = 0.;
    std::get<MooneyRivlin>(law.elastic).mu2 = 0.;
    RigPoint fluid(law, RigMode::simple_shear);
    EXPECT_THROW(fluid.stress_step(.1, 1.), std::runtime_error);
  }

  TEST(RigPoint, a_step_that_is_not_committed_leaves_no_trace)
  {
    const RubberLaw law = test_rubber({{.5, 1.}});
    RigPoint        once(law, RigMode::uniaxial), twice(law, RigMode::uniaxial);
    twice.strain_step(1.5, .1);
    EXPECT_NEAR(once.strain_step(.5, .1).nominal,
                twice.strain_step(.5, .1).nominal,
                1e-12);
  }
} // namespace demold
