// SPDX-License-Identifier: LGPL-2.1-or-later
// A temperature multiplies all relaxation times by one factor, or is refused.
#include "material/time_temperature_shift.h"

#include "parsed_material.h"

#include <cmath>

using namespace demold;

namespace
{
  std::string two_branches(const std::string &entries)
  {
    return "set relaxation times = 0.1, 10\nset branch moduli = 3, 6\n" +
           entries;
  }
} // namespace

TEST(without_a_shift, the_temperature_matters_nothing)
{
  const RubberModel model = parsed(two_branches("set temperature = -200"));
  model.check();
  EXPECT_EQ(model.at(1.).branches[1].relaxation_time, 10.);
}

// Theory A.2: log10 a_T = -1.74 from 70 to 160 degC with the defaults.
TEST(wlf, shifts_all_relaxation_times_by_its_factor)
{
  const RubberModel model =
    parsed(two_branches("set time-temperature shift = WLF\n"
                        "set temperature = 160"));
  model.check();
  const RubberLaw law   = model.at(1.);
  const double    shift = std::pow(10., -4.41 * 90. / (137.64 + 90.));
  EXPECT_NEAR(std::log10(shift), -1.74, .005);
  EXPECT_NEAR(law.branches[0].relaxation_time / (.1 * shift), 1., 1e-14);
  EXPECT_NEAR(law.branches[1].relaxation_time / (10. * shift), 1., 1e-14);
  EXPECT_EQ(law.branches[1].modulus, 2.);
  EXPECT_EQ(law.shear_modulus_relaxed(), .5);
}

TEST(every_shift, is_one_at_the_reference_temperature)
{
  for (const std::string kind : {"none", "WLF", "Arrhenius"})
    {
      TimeTemperatureShift shift;
      shift.kind              = kind;
      shift.reference         = 23.;
      shift.activation_energy = 100.;
      EXPECT_EQ(shift.factor(23.), 1.) << kind;
    }
}

// Moving T_ref moves c1 and c2 as well: c2' = c2 + d, c1' = c1 c2/c2'.
TEST(wlf, of_another_reference_temperature_is_the_same_curve)
{
  TimeTemperatureShift first, second;
  first.kind = second.kind = "WLF";
  second.reference         = first.reference + 90.;
  second.c2                = first.c2 + 90.;
  second.c1                = first.c1 * first.c2 / second.c2;
  for (const double T : {0., 23., 70., 160.})
    EXPECT_NEAR(first.factor(T) / second.factor(T), first.factor(160.), 1e-12);
}

// ln a_T = E_a/R (1/T - 1/T_ref), by the exact gas constant k_B N_A.
TEST(arrhenius, shifts_by_its_activation_energy)
{
  const RubberModel model =
    parsed(two_branches("set time-temperature shift = Arrhenius\n"
                        "set activation energy = 98.5\n"
                        "set reference temperature = 160\n"
                        "set temperature = 140"));
  model.check();
  const double R = 1.380649e-23 * 6.02214076e23;
  EXPECT_NEAR(model.at(1.).branches[0].relaxation_time /
                (.1 * std::exp(98.5e3 / R * (1. / 413.15 - 1. / 433.15))),
              1.,
              1e-12);
}

TEST(bad_shift, is_refused_with_path_rule_and_numbers)
{
  expect_words(complaint(two_branches("set time-temperature shift = WLF\n"
                                      "set temperature = -68")),
               {"Material/temperature", "-67.64 degC", "pole", "got -68"});
  EXPECT_EQ(complaint(two_branches("set time-temperature shift = WLF\n"
                                   "set temperature = -60")),
            "");
  expect_words(complaint(two_branches("set time-temperature shift = WLF\n"
                                      "set temperature = -67")),
               {"Material/temperature", "100 decades", "-67 degC"});
  expect_words(complaint(two_branches("set time-temperature shift = WLF\n"
                                      "set c1 = -4.41")),
               {"Material/c1", "got -4.41", "sign"});
  expect_words(complaint(
                 two_branches("set time-temperature shift = WLF\nset c2 = 0")),
               {"Material/c2", "got 0"});
  expect_words(complaint(
                 two_branches("set time-temperature shift = Arrhenius")),
               {"Material/activation energy", "got 0", "kJ/mol"});
}
