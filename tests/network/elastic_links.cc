// SPDX-License-Identifier: LGPL-2.1-or-later
// Springs and bars: forces are the gradient of the energy, tangents that of the
// forces, and a bar knows finite rotation.
#include "network/elastic_link.h"

#include <gtest/gtest.h>

#include <cmath>

namespace demold
{
  namespace
  {
    template <typename Link>
    void expect_derivatives(const Link &link, std::vector<double> u)
    {
      const LinkResponse at   = link.response(u);
      const double       step = 1e-6;
      for (unsigned int j = 0; j < u.size(); ++j)
        {
          auto plus = u, minus = u;
          plus[j] += step;
          minus[j] -= step;
          const LinkResponse p = link.response(plus);
          const LinkResponse m = link.response(minus);
          EXPECT_NEAR(at.R(j), (p.energy - m.energy) / (2. * step), 1e-8);
          for (unsigned int i = 0; i < u.size(); ++i)
            EXPECT_NEAR(at.K(i, j), (p.R(i) - m.R(i)) / (2. * step), 1e-8);
        }
    }

    const Bar bar{{0, 1, 2, 3}, {0., 0.}, {3., 4.}, 2.};
  } // namespace

  TEST(Spring, has_consistent_derivatives)
  {
    expect_derivatives(Spring{{0, 1}, 1.5}, {.2, -.7});
  }

  TEST(Bar, has_consistent_derivatives)
  {
    expect_derivatives(bar, {.1, -.2, .3, .5});
  }

  TEST(Bar, feels_nothing_of_a_rotation)
  {
    // by a right angle about its first end: (3, 4) to (-4, 3)
    EXPECT_NEAR(bar.response({0., 0., -7., -1.}).energy, 0., 1e-15);
  }

  TEST(Bar, has_the_force_of_green_strain)
  {
    // lengthened to l = 2 L: E = 3/2, force EA E l/L = 6 N along it
    const LinkResponse r = bar.response({0., 0., 3., 4.});
    EXPECT_NEAR(std::hypot(r.R(2), r.R(3)), 2. * 1.5 * 2., 1e-12);
  }
} // namespace demold
