// SPDX-License-Identifier: LGPL-2.1-or-later
// The summary is valid json in the order given, and never half written.
#include "output/summary.h"

#include "scratch_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace demold
{
  namespace
  {
    using nlohmann::ordered_json;

    TEST(Summary, keeps_the_order_and_replaces_in_place)
    {
      Summary summary;
      summary.set("status", "gave up");
      summary.set("peak force [N]", 12.5);
      summary.set("ranks", 2u);
      summary.set("status", "completed");
      ASSERT_EQ(summary.entries().size(), 3u);
      EXPECT_EQ(summary.entries()[0].first, "status");
      EXPECT_EQ(std::get<std::string>(summary.entries()[0].second),
                "completed");
      EXPECT_EQ(summary.entries()[2].first, "ranks");
    }

    TEST(Summary, json_gives_back_what_was_put_in)
    {
      ScratchFolder folder;
      Summary       summary;
      const double  third = 1. / 3.;
      summary.set("status", "a \"quoted\"\nline");
      summary.set("bytes", (1LL << 40) + 1);
      summary.set("force [N]", third);
      summary.write(folder / "s.json");
      const auto json = ordered_json::parse(folder.read("s.json"));
      EXPECT_EQ(json.at("status"), "a \"quoted\"\nline");
      EXPECT_EQ(json.at("bytes").get<long long>(), (1LL << 40) + 1);
      EXPECT_EQ(json.at("force [N]").get<double>(), third); // every bit
      EXPECT_EQ(json.begin().key(), "status");
    }

    TEST(Summary, what_json_cannot_say_becomes_null_or_a_replacement)
    {
      ScratchFolder folder;
      Summary       summary;
      summary.set("nan", std::nan(""));
      summary.set("infinite", std::numeric_limits<double>::infinity());
      summary.set("not utf-8", "\xff");
      summary.write(folder / "s.json");
      const auto json = ordered_json::parse(folder.read("s.json"));
      EXPECT_TRUE(json.at("nan").is_null());
      EXPECT_TRUE(json.at("infinite").is_null());
      EXPECT_TRUE(json.at("not utf-8").is_string());
    }

    TEST(Summary, an_empty_one_is_an_empty_object)
    {
      ScratchFolder folder;
      Summary().write(folder / "s.json");
      EXPECT_EQ(ordered_json::parse(folder.read("s.json")),
                ordered_json::object());
    }

    TEST(Summary, replaces_the_file_in_one_go_and_leaves_no_other)
    {
      ScratchFolder folder;
      Summary       summary;
      summary.write(folder.write("s.json", "old"));
      EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path),
                              std::filesystem::directory_iterator()),
                1);
      EXPECT_NE(folder.read("s.json"), "old");
    }

    TEST(Summary, a_file_that_cannot_be_written_is_an_error_not_a_loss)
    {
      ScratchFolder folder;
      EXPECT_THROW(Summary().write(folder / "no/s.json"), std::runtime_error);
    }

    TEST(Summary, the_table_shows_every_entry)
    {
      Summary summary;
      summary.set("peak force [N]", 12.345678);
      summary.set("ranks", 1);
      std::ostringstream out;
      summary.print(out);
      EXPECT_TRUE(contains(out.str(), "peak force [N]  12.3457\n"));
      EXPECT_TRUE(contains(out.str(), "ranks           1\n"));
    }
  } // namespace
} // namespace demold
