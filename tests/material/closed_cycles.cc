// SPDX-License-Identifier: LGPL-2.1-or-later
// Over a closed cycle of strain a branch gives back no more than it stored.
#include "random_deformation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace demold;

namespace
{
  constexpr unsigned int n_chains = 10000, n_cycles_per_chain = 10;
  constexpr unsigned int n_steps = 40; // per cycle

  /// A closed path F(s), 0 <= s <= 1, through F = 1.
  struct Cycle
  {
    Tensor<2, 3> swing, excursion;

    /// Of a size from 0.001 to 0.4, nowhere compressed below half the volume.
    explicit Cycle(std::mt19937 &generator)
    {
      std::uniform_real_distribution<double> exponent(-3., 0.), part(-.4, .4);
      const double size = std::pow(10., exponent(generator));
      do
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            {
              swing[i][j]     = size * part(generator);
              excursion[i][j] = size * part(generator);
            }
      while (smallest_volume() < .5);
    }

    Tensor<2, 3> F(const double s) const
    {
      return Tensor<2, 3>(dealii::unit_symmetric_tensor<3>()) +
             std::sin(2. * M_PI * s) * swing +
             .5 * (1. - std::cos(2. * M_PI * s)) * excursion;
    }

    double smallest_volume() const
    {
      double J = 1.;
      for (unsigned int i = 1; i < n_steps; ++i)
        J = std::min(J, determinant(F(double(i) / n_steps)));
      return J;
    }

    SymmetricTensor<2, 3> C(const unsigned int step) const
    {
      return step == n_steps ? dealii::unit_symmetric_tensor<3>() :
                               right_cauchy_green(F(double(step) / n_steps));
    }
  };

  struct Sums
  {
    double work = 0., dissipated = 0., stored = 0.; ///< [mJ/mm^3]
  };

  /// Drives @p point through a cycle in steps of @p dt; the work is
  /// S : dC/2 by the trapezoidal rule, `stored` what it is at the end.
  Sums drive(Point &point, const Cycle &cycle, const double dt)
  {
    Sums sums;
    auto C = cycle.C(0);
    // At the start of a cycle the branch may still be under stress.
    std::vector<double> next(point.history);
    point.law.evaluate(C,
                       0.,
                       point.history.data(),
                       next.data(),
                       false,
                       point.response);
    auto S = point.response.S;
    for (unsigned int i = 1; i <= n_steps; ++i)
      {
        const auto C_new = cycle.C(i);
        point.law.evaluate(C_new,
                           dt,
                           point.history.data(),
                           next.data(),
                           false,
                           point.response);
        std::swap(point.history, next);
        sums.work += .25 * ((S + point.response.S) * (C_new - C));
        sums.dissipated += point.response.dissipated;
        C = C_new;
        S = point.response.S;
      }
    sums.stored = point.response.stored;
    return sums;
  }

  /// Calls check(sums of the cycle, energy stored before it) for 1e5 random
  /// cycles with sub-steps of at most 0.05 tau. Ten follow each other, the next
  /// beginning with the overstress of the last.
  template <typename Check>
  void drive_many(const RubberLaw &law, const Check &check)
  {
    std::mt19937                           generator(2014);
    std::uniform_real_distribution<double> sub_step(.002, .05);
    for (unsigned int chain = 0; chain < n_chains; ++chain)
      {
        Point  point(law);
        double stored = 0.;
        for (unsigned int k = 0; k < n_cycles_per_chain; ++k)
          {
            const Cycle cycle(generator);
            const Sums  sums = drive(point, cycle, sub_step(generator));
            check(sums, stored);
            stored = sums.stored;
          }
      }
  }

  class ClosedCycles : public testing::TestWithParam<Variant>
  {};

  std::string name(const testing::TestParamInfo<Variant> &info)
  {
    std::string text = info.param.name;
    std::replace(text.begin(), text.end(), ' ', '_');
    return text;
  }
} // namespace

TEST_P(ClosedCycles, take_at_least_the_difference_in_stored_energy)
{
  double smallest = 1e9, unexplained = 0., dissipated = 0.;
  drive_many(bare_branch(GetParam()),
             [&](const Sums &sums, const double stored_before) {
               const double excess = sums.work - (sums.stored - stored_before);
               smallest            = std::min(smallest, excess);
               unexplained += excess - sums.dissipated;
               dissipated += sums.dissipated;
             });
  EXPECT_GE(smallest, -1e-8);
  // The reported dissipation is the rest of the balance.
  EXPECT_LT(std::abs(unexplained), .01 * dissipated);
}

// All but the last, the stress convolution, which claims nothing of the kind.
INSTANTIATE_TEST_SUITE_P(all,
                         ClosedCycles,
                         testing::ValuesIn(all_variants, all_variants + 5),
                         name);

TEST(stress_convolution, reports_all_its_work_as_dissipated)
{
  double largest = 0., least = 0.;
  drive_many(bare_branch(all_variants[5]), [&](const Sums &sums, double) {
    EXPECT_EQ(sums.stored, 0.);
    largest = std::max(largest, std::abs(sums.work - sums.dissipated));
    least   = std::min(least, sums.dissipated);
  });
  EXPECT_LT(largest, 1e-12);
  // Some cycles give back what earlier ones took.
  EXPECT_LT(least, -.01);
}
