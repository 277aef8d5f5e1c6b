// SPDX-License-Identifier: LGPL-2.1-or-later
// Impossible tread blocks are refused with path, rule and both numbers.
#include "geometry/tread_block.h"

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "base/parameter_error.h"
#include "tread_block_closed_form.h"

using namespace demold;

namespace
{
  std::string refusal(const std::function<void(TreadBlock &)> &spoil,
                      const unsigned int                       sipes = 3)
  {
    TreadBlock block = sharp_block(sipes);
    spoil(block);
    try
      {
        block.check(3);
      }
    catch (const ExcParameter &error)
      {
        return error.what();
      }
    return "accepted";
  }

  void expect_words(const std::string              &text,
                    const std::vector<std::string> &words)
  {
    for (const std::string &word : words)
      EXPECT_NE(text.find(word), std::string::npos)
        << '"' << word << "\" is missing in: " << text;
  }
} // namespace

TEST(TreadBlock, sipes_that_do_not_fit_are_refused_with_both_lengths)
{
  // 5 sipes every 5 mm need 20.6 mm; the block is 20 mm long.
  expect_words(refusal([](TreadBlock &b) { b.sipes = 5; }),
               {"Block/sipes: ", "need 20.6 mm", "is 20 mm", "fewer"});
  // The corner radius takes its share: 10.6 of 12 - 2 mm.
  expect_words(refusal([](TreadBlock &b) {
                 b.length        = 12;
                 b.corner_radius = 1;
               }),
               {"Block/sipes: ", "need 10.6 mm", "is 10 mm"});
}

TEST(TreadBlock, impossible_dimensions_are_refused_with_path_and_both_numbers)
{
  expect_words(refusal([](TreadBlock &b) { b.sipe_depth = 9; }),
               {"Block/sipe depth: ", "= 8 mm", "got 9 mm"});
  expect_words(refusal([](TreadBlock &b) { b.sipe_spacing = 0.5; }),
               {"Block/sipe spacing: ", "0.6 mm", "got 0.5 mm"});
  // 20 - 2 * 8 tan 60 degree = -7.71281
  expect_words(refusal([](TreadBlock &b) { b.draft_angle = -60; }, 0),
               {"Block/draft angle: ", "above 0 mm", "got -7.7128"});
  // 0.6 - 2 * 6 tan 5 degree = -0.449864
  expect_words(refusal([](TreadBlock &b) { b.sipe_draft_angle = 5; }),
               {"Block/sipe draft angle: ", "above 0 mm", "got -0.44986"});
  expect_words(refusal([](TreadBlock &b) { b.corner_radius = 7; }),
               {"Block/corner radius: ", "below 6 mm", "got 7 mm"});
  expect_words(refusal([](TreadBlock &b) { b.wall_element_size = 3; }),
               {"Block/wall element size: ", "= 2 mm", "got 3 mm"});
  expect_words(refusal([](TreadBlock &b) { b.wall_element_size = 1e-5; }),
               {"Block/wall element size: ", "= 0.01 mm", "got 1e-05 mm"});
  expect_words(refusal([](TreadBlock &b) { b.facet_size = 1e-5; }),
               {"Mould/facet size: ", "= 0.01 mm", "got 1e-05 mm"});
  expect_words(refusal([](TreadBlock &b) {
                 b.element_size = b.wall_element_size = 0.02;
               }),
               {"Block/element size: ", "at most 5e+06", "got "});
  expect_words(refusal([](TreadBlock &b) {
                 b.base_thickness = 0;
                 b.base_overhang  = 1;
               }),
               {"Block/base overhang: ", "above 0 mm", "got 0 mm"});
  EXPECT_EQ(refusal([](TreadBlock &) {}), "accepted");
}

TEST(TreadBlock, prm_entries_reach_the_block)
{
  TreadBlock               block;
  dealii::ParameterHandler prm;
  block.add_parameters(prm);
  prm.parse_input_from_string("subsection Block\n"
                              "set length = 12.5\n set sipes = 2\n"
                              "set symmetry = half y\nend\n"
                              "subsection Mould\nset facet size = 0.7\nend\n");
  EXPECT_EQ(block.length, 12.5);
  EXPECT_EQ(block.sipes, 2u);
  EXPECT_EQ(block.symmetry, "half y");
  EXPECT_EQ(block.facet_size, 0.7);
  EXPECT_EQ(block.height, TreadBlock().height);
}
