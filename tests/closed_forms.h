// SPDX-License-Identifier: LGPL-2.1-or-later
// Closed forms that scenes of one body on a mould or a base are compared with.
#ifndef demold_tests_closed_forms_h
#define demold_tests_closed_forms_h

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>

namespace demold
{
  /// A figure for the report of the test, next to its verdict.
  inline void record(const std::string &name, const double value)
  {
    char text[40];
    std::snprintf(text, sizeof(text), "%.3e", value);
    testing::Test::RecordProperty(name, text);
  }

  /// Root of @p f between @p a and @p b, where it changes its sign.
  inline double root_of(const std::function<double(double)> &f,
                        double                               a,
                        double                               b)
  {
    const bool rises = f(b) > 0.;
    for (unsigned int i = 0; i < 200; ++i)
      {
        const double middle                   = .5 * (a + b);
        (((f(middle) > 0.) == rises) ? b : a) = middle;
      }
    return .5 * (a + b);
  }

  /// Integral of @p f from @p a to @p b, composite midpoint rule.
  inline double integral_of(const std::function<double(double)> &f,
                            const double                         a,
                            const double                         b,
                            const unsigned int                   n = 20000)
  {
    double sum = 0.;
    for (unsigned int i = 0; i < n; ++i)
      sum += f(a + (i + .5) * (b - a) / n);
    return sum * (b - a) / n;
  }

  /// Mooney-Rivlin of theory A1: lambda, mu1, mu2 [MPa].
  struct Rubber
  {
    double lambda = 50., mu1 = .4, mu2 = .1;

    /// Second Piola-Kirchhoff stress along axis 1 for F = diag(l, q, q) (A2).
    double S(const double l, const double q, const bool along) const
    {
      const double J  = l * q * q;
      const double I1 = l * l + 2. * q * q;
      const double C  = along ? l * l : q * q;
      return mu1 + mu2 * (I1 - C) +
             (.5 * lambda * (J * J - 1.) - mu1 - 2. * mu2) / C;
    }

    /// Nominal stress [MPa] of a column that cannot become thinner.
    double confined(const double l) const
    {
      return l * S(l, 1., true);
    }

    /// Stretch of that column at nominal stress @p P.
    double confined_stretch(const double P) const
    {
      return root_of([&](double l) { return confined(l) - P; }, .5, 2.);
    }

    /// Lateral stretch of a bar with free sides, and its nominal stress.
    double free_width(const double l) const
    {
      return root_of([&](double q) { return S(l, q, false); }, .5, 2.);
    }

    double uniaxial(const double l) const
    {
      return l * S(l, free_width(l), true);
    }

    double uniaxial_stretch(const double P) const
    {
      return root_of([&](double l) { return uniaxial(l) - P; }, .7, 1.5);
    }
  };

  /// Bilinear bond of theory C.2: strength [MPa], rupture gap [mm], penalty
  /// [MPa/mm].
  struct Bond
  {
    double strength = .2, rupture = .1, penalty = 20.;

    double onset() const
    {
      return strength / penalty;
    }

    double traction(const double gap) const
    {
      if (gap <= onset())
        return penalty * gap;
      return gap >= rupture ? 0. :
                              strength * (rupture - gap) / (rupture - onset());
    }

    /// Work [mJ/mm^2] of opening to @p gap.
    double work(const double gap) const
    {
      if (gap <= onset())
        return .5 * penalty * gap * gap;
      const double t = traction(gap);
      return fracture_energy() - .5 * t * (rupture - std::min(gap, rupture));
    }

    double fracture_energy() const
    {
      return .5 * strength * rupture;
    }
  };

  /// For the names of tests.
  inline void PrintTo(const Bond &bond, std::ostream *out)
  {
    *out << bond.strength << " MPa " << bond.rupture << " mm";
  }
} // namespace demold

#endif
