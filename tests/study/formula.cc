// SPDX-License-Identifier: LGPL-2.1-or-later
// Closed forms in the entries of a sweep.
#include "study/formula.h"

#include "base/parameter_error.h"
#include "scratch_folder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace demold
{
  TEST(Formula, knows_symbols_functions_and_pi)
  {
    EXPECT_DOUBLE_EQ(evaluate_formula("2*sqrt(h) + pi", {{"h", 9.}}, "p"),
                     6. + std::acos(-1.));
    EXPECT_DOUBLE_EQ(evaluate_formula("if(x < 2, x^3, -1)", {{"x", 1.5}}, "p"),
                     1.5 * 1.5 * 1.5);
    EXPECT_DOUBLE_EQ(evaluate_formula("0.4", {}, "p"), .4);
  }

  TEST(Formula, definitions_use_those_before)
  {
    const auto symbols =
      with_definitions({{"h", 3.}}, "a = 2*h; b = a^2 + h", "p");
    EXPECT_DOUBLE_EQ(symbols.at("a"), 6.);
    EXPECT_DOUBLE_EQ(symbols.at("b"), 39.);
  }

  TEST(Formula, an_unknown_name_is_bad_input_that_lists_the_known_ones)
  {
    const auto message = message_of<ExcParameter>([]() {
      evaluate_formula("2*k", {{"h", 1.}}, "Compare/closed form");
    });
    EXPECT_TRUE(contains(message, "Compare/closed form")) << message;
    EXPECT_TRUE(contains(message, "h and pi; got \"2*k\"")) << message;
  }

  TEST(Formula, definitions_must_have_names_of_their_own)
  {
    for (const char *const bad : {"2a = 1", "a 1", "= 3", "h = 2", "a=1; a=2"})
      EXPECT_TRUE(contains(message_of<ExcParameter>([&]() {
                             with_definitions({{"h", 1.}}, bad, "path");
                           }),
                           "path"))
        << bad;
  }
} // namespace demold
