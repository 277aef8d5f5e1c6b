// SPDX-License-Identifier: LGPL-2.1-or-later
// The candidate lists miss no facet within reach, as long as nothing has moved
// by more than half the skin.
#include "contact/candidate_search.h"
#include "contact/closest_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace
{
  using namespace demold;
  using dealii::Point;
  using dealii::Tensor;

  struct Random
  {
    std::mt19937 engine{5};

    double operator()(const double size)
    {
      return std::uniform_real_distribution<double>(-size, size)(engine);
    }

    Point<3> point(const double size)
    {
      const double x = (*this)(size), y = (*this)(size), z = (*this)(size);
      return Point<3>(x, y, z);
    }

    /// A vector of exactly this length.
    Tensor<1, 3> direction(const double length)
    {
      const Tensor<1, 3> v = point(1.);
      return length / v.norm() * v;
    }
  };

  constexpr double reach = 0.3, skin = 0.2;

  /// A bumpy floor of n x n facets over [-1,1]^2.
  ContactSurface floor(Random &random, const unsigned int n)
  {
    std::vector<Point<3>> x;
    std::vector<Facet>    facets;
    for (unsigned int j = 0; j <= n; ++j)
      for (unsigned int i = 0; i <= n; ++i)
        x.push_back(Point<3>(2. * i / n - 1., 2. * j / n - 1., random(0.05)));
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          const unsigned int k = j * (n + 1) + i;
          facets.push_back({{{k, k + 1, k + n + 2, k + n + 1}}, 4});
        }
    return ContactSurface(facets, x);
  }

  std::vector<Point<3>> slaves(Random &random)
  {
    std::vector<Point<3>> result(100);
    for (auto &x : result)
      x = random.point(1.);
    return result;
  }

  /// Distance to a facet, sampled: never below the true one.
  double sampled_distance(const Point<3> &x, const FacetPositions &facet)
  {
    double result = 1e10;
    for (int i = -10; i <= 10; ++i)
      for (int j = -10; j <= 10; ++j)
        result =
          std::min(result,
                   (x - facet_frame(facet, {{0.1 * i, 0.1 * j}}).x).norm());
    return result;
  }

  unsigned int n_missed(const CandidateSearch       &search,
                        const ContactSurface        &master,
                        const std::vector<Point<3>> &x,
                        const double                 within)
  {
    unsigned int missed = 0;
    for (unsigned int s = 0; s < x.size(); ++s)
      for (unsigned int f = 0; f < master.n_facets(); ++f)
        if (sampled_distance(x[s], master.facet_positions(f)) <= within &&
            !std::binary_search(search.candidates(s).begin(),
                                search.candidates(s).end(),
                                f))
          ++missed;
    return missed;
  }

  TEST(candidate_search, finds_every_facet_within_reach_and_skin)
  {
    Random          random;
    const auto      master = floor(random, 12);
    const auto      x      = slaves(random);
    CandidateSearch search(reach, skin);
    search.rebuild(master, x);
    EXPECT_EQ(n_missed(search, master, x, reach + skin), 0u);

    // And it does leave out most of the others.
    std::size_t n_candidates = 0;
    for (unsigned int s = 0; s < x.size(); ++s)
      n_candidates += search.candidates(s).size();
    EXPECT_LT(n_candidates, x.size() * master.n_facets() / 4);
    EXPECT_GT(n_candidates, 0u);
  }

  TEST(candidate_search, misses_nothing_until_it_says_it_is_outdated)
  {
    Random          random;
    auto            master = floor(random, 12);
    auto            x      = slaves(random);
    CandidateSearch search(reach, skin);
    search.rebuild(master, x);

    // The worst case: every node moves by just less than half the skin.
    for (auto &p : x)
      p += Tensor<1, 3>(random.direction(0.499 * skin));
    auto nodes = master.positions();
    for (auto &p : nodes)
      p += Tensor<1, 3>(random.direction(0.499 * skin));
    master.set_positions(nodes);
    EXPECT_FALSE(search.is_outdated(master, x));
    EXPECT_EQ(n_missed(search, master, x, reach), 0u);
  }

  TEST(candidate_search, is_outdated_once_any_node_moved_by_half_the_skin)
  {
    Random          random;
    auto            master = floor(random, 4);
    const auto      x      = slaves(random);
    CandidateSearch search(reach, skin);
    EXPECT_TRUE(search.is_outdated(master, x)); // never built
    search.rebuild(master, x);
    EXPECT_FALSE(search.is_outdated(master, x));

    auto moved = x;
    moved[17] += random.direction(0.501 * skin);
    EXPECT_TRUE(search.is_outdated(master, moved));

    auto nodes = master.positions();
    nodes[3] += random.direction(0.501 * skin);
    master.set_positions(nodes);
    EXPECT_TRUE(search.is_outdated(master, x));
    search.rebuild(master, x);
    EXPECT_FALSE(search.is_outdated(master, x));

    moved.push_back(Point<3>());
    EXPECT_TRUE(search.is_outdated(master, moved)); // another slave node
  }

  TEST(candidate_search, lists_are_ascending_and_repeat_exactly)
  {
    Random          random;
    const auto      master = floor(random, 12);
    const auto      x      = slaves(random);
    CandidateSearch first(reach, skin), second(reach, skin);
    first.rebuild(master, x);
    second.rebuild(master, x);
    second.rebuild(master, x);
    for (unsigned int s = 0; s < x.size(); ++s)
      {
        const auto &list = first.candidates(s);
        EXPECT_TRUE(std::is_sorted(list.begin(), list.end()));
        EXPECT_EQ(std::adjacent_find(list.begin(), list.end()), list.end());
        EXPECT_EQ(list, second.candidates(s));
      }
  }

  TEST(candidate_search, finds_the_contact_that_all_facets_together_find)
  {
    Random          random;
    const auto      master = floor(random, 12);
    const auto      x      = slaves(random);
    CandidateSearch search(reach, skin);
    search.rebuild(master, x);
    std::vector<unsigned int> all(master.n_facets());
    for (unsigned int f = 0; f < all.size(); ++f)
      all[f] = f;
    const Tensor<1, 3> down    = Point<3>(0, 0, -1);
    unsigned int       n_found = 0;
    for (unsigned int s = 0; s < x.size(); ++s)
      {
        const ContactLimits limits{reach, reach};
        const auto expected = find_contact(x[s], down, master, all, 0, limits);
        const auto found =
          find_contact(x[s], down, master, search.candidates(s), 0, limits);
        ASSERT_EQ(found.has_value(), expected.has_value());
        n_found += found.has_value();
        if (found)
          {
            EXPECT_EQ(found->nodes, expected->nodes);
            EXPECT_EQ(found->gap, expected->gap);
          }
      }
    EXPECT_GT(n_found, 10u);
  }
} // namespace
