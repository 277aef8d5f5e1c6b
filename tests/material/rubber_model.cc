// SPDX-License-Identifier: LGPL-2.1-or-later
// Section Material: what it gives and what it refuses.
#include "parsed_material.h"

#include <cmath>

using namespace demold;

TEST(material_section, has_defaults_that_pass_its_own_check)
{
  EXPECT_EQ(complaint(""), "");
  EXPECT_EQ(complaint("set model = mooney-rivlin isochoric"), "");
  EXPECT_EQ(complaint(tables), "");
}

TEST(material_section, gives_the_same_small_strain_stiffness_to_both_models)
{
  const RubberLaw first  = parsed("").at(1.);
  const RubberLaw second = parsed("set model = mooney-rivlin isochoric").at(1.);
  EXPECT_EQ(second.elastic.index(), 1u);
  EXPECT_NEAR(first.bulk_modulus(), second.bulk_modulus(), 1e-4);
  EXPECT_DOUBLE_EQ(first.shear_modulus_relaxed(),
                   second.shear_modulus_relaxed());
}

TEST(material_section, turns_young_moduli_of_branches_into_shear_moduli)
{
  const RubberLaw law = parsed("set relaxation times = 0.1, 1\n"
                               "set branch moduli = 0.3, 0.6\n"
                               "set update = BE")
                          .at(7.);
  ASSERT_EQ(law.branches.size(), 2u);
  EXPECT_DOUBLE_EQ(law.branches[1].modulus, .2);
  EXPECT_DOUBLE_EQ(law.branches[1].relaxation_time, 1.);
  EXPECT_EQ(law.update, ViscousUpdate::be);
}

TEST(branch_law, is_chosen_by_name)
{
  const std::string branches = "set relaxation times = 0.1, 1\n"
                               "set branch moduli = 0.3, 0.6\n";
  EXPECT_EQ(parsed(branches).at(1.).branch_law, BranchLaw::isochoric);
  const std::pair<std::string, BranchLaw> names[] = {
    {"isochoric neo-hooke", BranchLaw::isochoric},
    {"linear evolution", BranchLaw::linear},
    {"lubliner", BranchLaw::lubliner},
    {"stress convolution", BranchLaw::convolution}};
  for (const auto &[name, law] : names)
    for (const std::string &entries : {branches, tables})
      {
        const RubberModel model =
          parsed(entries + "set branch law = " + name + "\n");
        model.check();
        EXPECT_EQ(model.at(.8).branch_law, law) << name;
      }
}

TEST(branch_law, refuses_an_update_that_is_not_its_own)
{
  const std::string entries = "set relaxation times = 1\n"
                              "set branch moduli = 1\n";
  for (const std::string name :
       {"linear evolution", "lubliner", "stress convolution"})
    for (const std::string update : {"BE", "LIN"})
      expect_words(complaint(entries + "set branch law = " + name +
                             "\nset update = " + update),
                   {"Material/update", name, "EXP2", "got " + update});
  EXPECT_EQ(complaint(entries + "set update = BE"), "");
}

TEST(viscosity, is_switched_off_by_one_entry)
{
  const std::string constants = "set relaxation times = 0.1, 1\n"
                                "set branch moduli = 0.3, 0.6\n";
  for (const std::string &entries : {constants, tables})
    {
      const RubberModel off = parsed(entries + "set viscosity = false");
      off.check();
      const RubberLaw elastic = off.at(.8), viscous = parsed(entries).at(.8);
      EXPECT_EQ(off.n_branches(), 0u);
      EXPECT_TRUE(elastic.branches.empty());
      EXPECT_EQ(elastic.n_history(), 0u);
      EXPECT_EQ(elastic.shear_modulus_relaxed(),
                viscous.shear_modulus_relaxed());
      EXPECT_EQ(elastic.shear_modulus_instantaneous(),
                elastic.shear_modulus_relaxed());
      EXPECT_EQ(viscous.branches.size(), 2u);
    }
}

TEST(viscosity, may_be_off_and_its_entries_are_checked_all_the_same)
{
  expect_words(complaint("set viscosity = false\n"
                         "set relaxation times = 1, 2, 3\n"
                         "set branch moduli = 1, 2"),
               {"Material/branch moduli", "3 entries", "got 2"});
  expect_words(complaint(tables + "set viscosity = false\n"
                                  "set table branch moduli = 1, 1; 1, 1"),
               {"Material/table branch moduli", "4 rows", "got 2"});
}

TEST(f90, may_be_an_expression)
{
  const RubberModel model = parsed("set f90 = 0.6 + 0.05*z");
  model.check();
  EXPECT_FALSE(model.f90_is_uniform());
  EXPECT_EQ(model.f90_expression(), "0.6 + 0.05*z");
  EXPECT_THROW(model.uniform_f90(), ExcParameter);
  EXPECT_TRUE(parsed("set f90 = 0.85").f90_is_uniform());
  EXPECT_EQ(parsed("set f90 = 0.85").uniform_f90(), .85);
  expect_words(complaint("set f90 = 0.6 + bottom"),
               {"Material/f90", "0.6 + bottom"});
  expect_words(complaint("set f90 = -1"), {"Material/f90", "-1"});
}

TEST(bad_material, is_refused_with_path_rule_and_numbers)
{
  expect_words(complaint("set lambda = 0"), {"Material/lambda", "got 0"});
  expect_words(complaint("set mu1 = 0"), {"Material/mu1", "got 0"});
  expect_words(complaint("set density = 0"), {"Material/density", "got 0"});
  expect_words(complaint("set model = mooney-rivlin isochoric\n"
                         "set bulk modulus = 0"),
               {"Material/bulk modulus", "got 0"});
  expect_words(complaint("set relaxation times = 1, 2, 3\n"
                         "set branch moduli = 1, 2"),
               {"Material/branch moduli", "3 entries", "got 2"});
  expect_words(complaint("set relaxation times = 1, -2\n"
                         "set branch moduli = 1, 2"),
               {"Material/relaxation times", "got -2"});
  expect_words(complaint("set relaxation times = 1, 2, 1\n"
                         "set branch moduli = 1, 2, 3"),
               {"Material/relaxation times", "got 1 s", "1 and 3"});
  expect_words(complaint("set relaxation times = 1, 2\n"
                         "set branch moduli = 1, 0"),
               {"Material/branch moduli", "got 0", "number 2"});
}
