// SPDX-License-Identifier: LGPL-2.1-or-later
// A study file that makes no sense is refused with its path and both numbers.
#include "study/study_parameters.h"

#include "base/parameter_entries.h"
#include "base/parameter_error.h"
#include "base/parameter_file.h"
#include "scratch_folder.h"

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    using Overrides = std::vector<std::pair<std::string, std::string>>;

    /// A study of one sweep that is in order, but for @p overrides.
    std::string complaint_about(const Overrides &overrides)
    {
      StudyParameters          study;
      dealii::ParameterHandler prm;
      study.add_parameters(prm);
      use_printed_defaults(prm);
      return message_of<ExcParameter>([&]() {
        set_entries(prm,
                    Overrides{{"scene file", "scene.prm"},
                              {"Sweep 1/entry", "A/h"},
                              {"Sweep 1/values", "1, 2, 4"}});
        set_entries(prm, overrides);
        check_mandatory_entries(prm);
        study.check();
      });
    }

    struct BadStudy
    {
      std::string              name;
      Overrides                overrides;
      std::vector<std::string> words;
    };

    void PrintTo(const BadStudy &bad, std::ostream *out)
    {
      *out << bad.name;
    }

    class Refused : public testing::TestWithParam<BadStudy>
    {};
  } // namespace

  TEST(StudyFile, in_order_is_accepted)
  {
    EXPECT_EQ(complaint_about({}), "");
    EXPECT_EQ(complaint_about({{"Compare/reference", "closed form"},
                               {"Compare/definitions", "a = 2; b = a*h"},
                               {"Compare/closed form", "b + sqrt(h)"}}),
              "");
  }

  TEST_P(Refused, with_path_rule_and_value)
  {
    const std::string message = complaint_about(GetParam().overrides);
    for (const auto &word : GetParam().words)
      EXPECT_TRUE(contains(message, word))
        << "no " << word << " in: " << message;
  }

  INSTANTIATE_TEST_SUITE_P(
    studies,
    Refused,
    testing::Values(
      BadStudy{"nothing_swept", {{"Sweep 1/entry", ""}}, {"Sweep 1/entry"}},
      BadStudy{"no_values",
               {{"Sweep 1/values", ""}},
               {"Sweep 1/values", "at least one", "A/h"}},
      BadStudy{"list_and_range",
               {{"Sweep 1/number", "4"}},
               {"Sweep 1/number", "must be 0", "got 4"}},
      BadStudy{"range_of_one_point",
               {{"Sweep 1/values", ""},
                {"Sweep 1/number", "3"},
                {"Sweep 1/from", "2"},
                {"Sweep 1/to", "2"}},
               {"Sweep 1/to", "= 2", "3 values"}},
      BadStudy{
        "logarithm_of_zero",
        {{"Sweep 1/values", ""}, {"Sweep 1/number", "3"}, {"Sweep 1/to", "2"}},
        {"Sweep 1/scale", "greater than 0", "0 and 2", "linear"}},
      BadStudy{"value_twice",
               {{"Sweep 1/values", "1, 2, 1"}},
               {"Sweep 1/values", "\"1\" twice"}},
      BadStudy{"entry_twice",
               {{"Sweep 2/entry", "A/h"}, {"Sweep 2/values", "1"}},
               {"Sweep 2/entry", "A/h"}},
      BadStudy{"label_twice",
               {{"Sweep 2/entry", "B/h"}, {"Sweep 2/values", "1"}},
               {"Sweep 2/label", "\"h\" twice"}},
      BadStudy{"symbol_is_no_name",
               {{"Sweep 1/symbol", "2h"}},
               {"Sweep 1/symbol", "2h"}},
      BadStudy{"paired_with_an_unused_one",
               {{"Sweep 1/paired with", "3"}},
               {"Sweep 1/paired with", "got 3"}},
      BadStudy{"paired_with_itself",
               {{"Sweep 1/paired with", "1"}},
               {"Sweep 1/paired with", "got 1"}},
      BadStudy{"refined_sweep_is_not_used",
               {{"Refinement/sweep", "2"}},
               {"Refinement/sweep", "got 2"}},
      BadStudy{"finest_of_nothing",
               {{"Refinement/sweep", "0"}},
               {"Refinement/sweep", "finest"}},
      BadStudy{"closed_form_missing",
               {{"Compare/reference", "closed form"}},
               {"Compare/closed form", "must be given"}},
      BadStudy{"closed_form_with_an_unknown_name",
               {{"Compare/reference", "closed form"},
                {"Compare/closed form", "2*k"}},
               {"Compare/closed form", "h and pi", "2*k"}},
      BadStudy{"relative_to_zero",
               {{"Compare/reference", "value"}},
               {"Compare/value", "absolute"}},
      BadStudy{"settings_without_value",
               {{"settings", "A/b"}},
               {"settings", "A/b"}},
      BadStudy{"unknown_word",
               {{"Compare/reference", "oracle"}},
               {"Compare/reference", "closed form", "oracle"}},
      BadStudy{"misspelt_entry",
               {{"Compare/quantitty", "x"}},
               {"Compare/quantity", "Nearest"}}),
    [](const auto &info) { return info.param.name; });

  TEST(StudyFile, needs_a_scene)
  {
    StudyParameters          study;
    dealii::ParameterHandler prm;
    study.add_parameters(prm);
    EXPECT_TRUE(contains(message_of<ExcParameter>(
                           [&]() { check_mandatory_entries(prm); }),
                         "scene file"));
  }
} // namespace demold
