// SPDX-License-Identifier: LGPL-2.1-or-later
// A misspelt name leads to the right one.
#include "base/nearest_names.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    const std::vector<std::string> entries = {"dimension",
                                              "Adhesion/law",
                                              "Adhesion/strength",
                                              "Adhesion/rupture gap",
                                              "Friction/coefficient",
                                              "Solver/linear"};

    TEST(NearestNames, edit_distance_of_textbook_words)
    {
      // Wagner and Fischer 1974 and every textbook since
      EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
      EXPECT_EQ(edit_distance("saturday", "sunday"), 3u);
      EXPECT_EQ(edit_distance("", "abc"), 3u);
      EXPECT_EQ(edit_distance("abc", ""), 3u);
      EXPECT_EQ(edit_distance("abc", "abc"), 0u);
    }

    TEST(NearestNames, edit_distance_is_symmetric)
    {
      for (const auto &a : entries)
        for (const auto &b : entries)
          EXPECT_EQ(edit_distance(a, b), edit_distance(b, a));
    }

    TEST(NearestNames, a_misspelt_letter_finds_the_entry)
    {
      EXPECT_EQ(nearest_names("Adhesion/strenght", entries).at(0),
                "Adhesion/strength");
      EXPECT_EQ(nearest_names("dimensions", entries).at(0), "dimension");
    }

    TEST(NearestNames, case_does_not_count)
    {
      EXPECT_EQ(nearest_names("FRICTION/COEFFICIENT", entries).at(0),
                "Friction/coefficient");
    }

    TEST(NearestNames, a_forgotten_or_wrong_section_finds_the_entry)
    {
      EXPECT_EQ(nearest_names("rupture gap", entries).at(0),
                "Adhesion/rupture gap");
      EXPECT_EQ(nearest_names("Contact/strength", entries).at(0),
                "Adhesion/strength");
    }

    TEST(NearestNames, gives_as_many_as_asked_or_as_there_are)
    {
      EXPECT_EQ(nearest_names("x", entries, 2).size(), 2u);
      EXPECT_EQ(nearest_names("x", entries, 99).size(), entries.size());
      EXPECT_TRUE(nearest_names("x", {}).empty());
    }

    TEST(NearestNames, sentence_lists_them_in_quotes)
    {
      EXPECT_EQ(nearest_names_sentence("a", {"a", "b"}),
                "Nearest: \"a\", \"b\".");
    }
  } // namespace
} // namespace demold
