// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables over the state of cure: what they give and what they refuse.
#include "parsed_material.h"

#include <cmath>

using namespace demold;

namespace
{
  RubberModel tread_ref()
  {
    dealii::ParameterHandler prm;
    RubberModel              model;
    model.add_parameters(prm);
    prm.parse_input(DEMOLD_SOURCE_DIR "/prm/materials/tread-ref.prm");
    model.check();
    return model;
  }
} // namespace

TEST(material_tables, are_met_exactly_at_their_levels_by_both_models)
{
  for (const std::string name : {"mooney-rivlin", "mooney-rivlin isochoric"})
    {
      const RubberModel model = parsed("set model = " + name + "\n" + tables);
      const double      f90[] = {.5, .6, .8, 1.}, E[] = {1.2, 1.5, 2.4, 3.};
      const double      E_2[] = {1., .9, .6, .5};
      for (unsigned int i = 0; i < 4; ++i)
        {
          const RubberLaw law = model.at(f90[i]);
          EXPECT_NEAR(3. * law.shear_modulus_relaxed(), E[i], 1e-14);
          EXPECT_NEAR(3. * law.branches[1].modulus, E_2[i], 1e-14);
        }
      const double between = 3. * model.at(.7).shear_modulus_relaxed();
      EXPECT_GT(between, 1.5);
      EXPECT_LT(between, 2.4);
    }
}

TEST(material_tables, split_the_modulus_by_mu2_over_mu1)
{
  const RubberLaw law = parsed(tables + "set table mu2 over mu1 = 0.5").at(1.);
  const auto      elastic = std::get<MooneyRivlin>(law.elastic);
  EXPECT_NEAR(elastic.mu1, 2. / 3., 1e-14);
  EXPECT_NEAR(elastic.mu2, 1. / 3., 1e-14);
  EXPECT_EQ(elastic.lambda, 50.);
}

// A steep table, one branch of which is gone at three of the levels.
TEST(material_tables, stay_admissible_between_their_levels)
{
  const RubberModel model =
    parsed("set relaxation times = 0.1, 1\n"
           "set table f90 = 0.5, 0.6, 0.7, 0.8, 1.0\n"
           "set table equilibrium modulus = 1e-6, 3, 1e-6, 1e-6, 100\n"
           "set table branch moduli = 5, 0; 1, 0; 0, 4; 0, 1e-3; 3, 0");
  model.check();
  for (double f90 = .5; f90 <= 1.; f90 += 1e-4)
    {
      const RubberLaw law = model.at(f90);
      EXPECT_GT(law.shear_modulus_relaxed(), 0.) << f90;
      EXPECT_GE(law.branches[0].modulus, 0.) << f90;
      EXPECT_GE(law.branches[1].modulus, 0.) << f90;
      EXPECT_LE(law.branches[1].modulus, 4. / 3. * (1. + 1e-14)) << f90;
    }
}

TEST(f90_outside_the_table, names_the_entry_and_both_numbers)
{
  expect_words(complaint(tables + "set f90 = 1.3"),
               {"Material/f90", "0.5 to 1", "1.3", "table f90"});
  EXPECT_THROW(parsed(tables).at(.49), ExcParameter);
  EXPECT_THROW(parsed(tables).at(std::nan("")), ExcParameter);
  EXPECT_EQ(parsed(tables).f90_range(), (std::pair<double, double>(.5, 1.)));
}

TEST(bad_tables, are_refused_with_path_rule_and_numbers)
{
  expect_words(complaint("set table f90 = 0.5, 0.8, 1\n"
                         "set table equilibrium modulus = 1, 2, 3"),
               {"Material/table f90", "at least 4", "got 3"});
  expect_words(complaint("set table f90 = 0.5, 0.8, 0.7, 1\n"
                         "set table equilibrium modulus = 1, 2, 3, 4"),
               {"Material/table f90", "0.7 after 0.8"});
  expect_words(complaint("set table f90 = 0.5, 0.6, 0.7, 1\n"
                         "set table equilibrium modulus = 1, 2, 3"),
               {"Material/table equilibrium modulus", "4 levels", "got 3"});
  expect_words(complaint(tables + "set table branch moduli = 1, 1; 1, 1"),
               {"Material/table branch moduli", "4 rows", "got 2"});
  expect_words(complaint(tables +
                         "set table branch moduli = 1, 1; 1, 1; 1; 1, 1"),
               {"Material/table branch moduli", "2 entries", "got 1 in row 3"});
  expect_words(complaint(tables +
                         "set table branch moduli = 1, 1; 1, -2; 1, 1; 1, 1"),
               {"Material/table branch moduli", "got -2 in row 2", "0.6"});
  expect_words(complaint(tables + "set table equilibrium modulus = 1, 0, 2, 3"),
               {"Material/table equilibrium modulus", "got 0 as number 2"});
  expect_words(complaint(tables + "set branch moduli = 1, 2"),
               {"Material/branch moduli", "2 moduli", "4 levels"});
  expect_words(complaint("set table equilibrium modulus = 1, 2"),
               {"Material/table f90", "0 levels", "2 equilibrium"});
}

// Expected values: theory A.4, Prony rows of TREAD-REF.
TEST(tread_ref, is_the_compound_of_theory)
{
  const RubberModel model = tread_ref();
  EXPECT_EQ(model.uniform_f90(), .8);
  EXPECT_EQ(model.n_branches(), 8u);

  const RubberLaw law = model.at(.8);
  EXPECT_NEAR(3. * law.shear_modulus_relaxed(), 2.2727, 1e-12);
  const auto elastic = std::get<MooneyRivlin>(law.elastic);
  EXPECT_NEAR(elastic.mu2 / elastic.mu1, .25, 1e-12);
  EXPECT_EQ(elastic.lambda, 50.);
  EXPECT_EQ(law.density, 1.12e-9);

  const double E[] = {.5108, .5347, .5208, .3916, .2530, .1468, .0871, .0185};
  for (unsigned int j = 0; j < 8; ++j)
    {
      EXPECT_NEAR(3. * law.branches[j].modulus, E[j], 1e-12);
      EXPECT_NEAR(law.branches[j].relaxation_time / std::pow(10., j - 4.),
                  1.,
                  1e-12);
    }
  EXPECT_NEAR(3. * model.at(.6).shear_modulus_relaxed(), 1.3290, 1e-12);
  EXPECT_NEAR(3. * model.at(1.).branches[7].modulus, .0097, 1e-12);
}

// The fractional Zener model of theory A.4 at 1 Hz; the fit is good to 6.3 %.
TEST(tread_ref, has_the_complex_modulus_it_was_made_from)
{
  const double      expected[3][3] = {{1., 3.5061, .2071},
                                      {.8, 2.8961, .2473},
                                      {.6, 2.1267, .2637}};
  const RubberModel model          = tread_ref();
  for (const auto &[f90, storage, loss] : expected)
    {
      const RubberLaw law = model.at(f90);
      double          E1 = 3. * law.shear_modulus_relaxed(), E2 = 0.;
      for (const MaxwellBranch &branch : law.branches)
        {
          const double w = 2. * M_PI * branch.relaxation_time;
          E1 += 3. * branch.modulus * w * w / (1. + w * w);
          E2 += 3. * branch.modulus * w / (1. + w * w);
        }
      EXPECT_NEAR(E1 / storage, 1., .063);
      EXPECT_NEAR(E2 / loss, 1., .063);
    }
}

TEST(tread_ref, stiffens_steadily_with_cure)
{
  const RubberModel model = tread_ref();
  double            last  = 0.;
  for (double f90 = .5; f90 <= 1.2; f90 += .01)
    {
      const RubberLaw law = model.at(f90);
      EXPECT_GT(law.shear_modulus_relaxed(), last);
      last = law.shear_modulus_relaxed();
    }
}
