// SPDX-License-Identifier: LGPL-2.1-or-later
// The moduli of Mooney and Rivlin from slow tests in several modes at once.
#include "identification/static_fit.h"

#include "identification/least_squares.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>

namespace demold
{
  using namespace dealii;

  std::string in_words(const TestMode mode)
  {
    switch (mode)
      {
        case TestMode::uniaxial:
          return "uniaxial";
        case TestMode::equibiaxial:
          return "equibiaxial";
        case TestMode::pure_shear:
          return "pure shear";
        default:
          return "simple shear";
      }
  }



  std::array<double, 2> stress_by_moduli(const TestMode mode, const double x)
  {
    switch (mode)
      {
        case TestMode::uniaxial:
          {
            const double a = x - 1. / (x * x);
            return {{a, a / x}};
          }
        case TestMode::equibiaxial:
          {
            const double a = x - std::pow(x, -5);
            return {{a, a * x * x}};
          }
        case TestMode::pure_shear:
          {
            const double a = x - std::pow(x, -3);
            return {{a, a}};
          }
        default:
          return {{x, x}};
      }
  }



  double largest_stretch(const TestMode mode, const double x)
  {
    switch (mode)
      {
        case TestMode::uniaxial:
          return std::max(x, 1. / std::sqrt(x));
        case TestMode::equibiaxial:
          return std::max(x, 1. / (x * x));
        case TestMode::pure_shear:
          return std::max(x, 1. / x);
        default:
          return .5 * std::abs(x) + std::sqrt(1. + .25 * x * x);
      }
  }



  bool StaticFit::uses(const TestMode mode, const double x) const
  {
    return largest_stretch(mode, x) <= max_stretch;
  }



  double StaticFit::weight(const double stress) const
  {
    return relative ? 1. / std::max(std::abs(stress), floor) : 1.;
  }



  FitReport StaticFit::fit(const std::vector<TestCurve> &curves) const
  {
    std::vector<std::array<double, 2>> rows;
    std::vector<double>                b;
    for (const auto &curve : curves)
      for (unsigned int i = 0; i < curve.x.size(); ++i)
        if (uses(curve.mode, curve.x[i]))
          {
            auto         row = stress_by_moduli(curve.mode, curve.x[i]);
            const double w   = weight(curve.stress[i]);
            rows.push_back({{w * row[0], w * row[1]}});
            b.push_back(w * curve.stress[i]);
          }

    FullMatrix<double> A(rows.size(), 2);
    for (unsigned int i = 0; i < rows.size(); ++i)
      for (unsigned int j = 0; j < 2; ++j)
        A(i, j) = rows[i][j];
    const auto          mu = nonnegative_least_squares(A, b);
    std::vector<double> r(b.size());
    for (unsigned int i = 0; i < r.size(); ++i)
      r[i] = A(i, 0) * mu[0] + A(i, 1) * mu[1] - b[i];

    constexpr double infinity = std::numeric_limits<double>::infinity();
    return assess({{"mu1", "MPa", mu[0], 0., infinity},
                   {"mu2", "MPa", mu[1], 0., infinity}},
                  r,
                  A);
  }



  std::string advice_on_modes(const std::vector<TestCurve> &curves,
                              const FitReport              &report)
  {
    std::set<TestMode> modes;
    for (const auto &curve : curves)
      modes.insert(curve.mode);
    const bool only_shear = modes.count(TestMode::uniaxial) == 0 &&
                            modes.count(TestMode::equibiaxial) == 0;
    if (only_shear)
      return "Shear data identify only the sum mu1 + mu2. Add a uniaxial and "
             "an equibiaxial test to divide it.";
    if (modes.size() > 1)
      return "";

    const double       correlation = report.correlation(0, 1);
    std::ostringstream text;
    text.precision(3);
    text << in_words(*modes.begin())
         << " data alone do not identify mu2: the stresses of mu1 and mu2 "
            "differ too little in one mode";
    if (std::isfinite(correlation))
      text << " (correlation " << correlation << ")";
    text << ", so that what the model misses goes into mu2. Add a test in "
            "another mode, best uniaxial and equibiaxial together.";
    std::string sentence = text.str();
    sentence[0]          = std::toupper(sentence[0]);
    return sentence;
  }
} // namespace demold
