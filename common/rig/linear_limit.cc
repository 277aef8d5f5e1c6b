// SPDX-License-Identifier: LGPL-2.1-or-later
// Small vibrations: what the rig measures, and what Wiechert's model says.
#include "rig/linear_limit.h"

#include <deal.II/base/numbers.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <cmath>

namespace demold
{
  using namespace dealii;

  std::complex<double> measured_modulus(const RigCurve &curve,
                                        const double    frequency,
                                        const double    amplitude)
  {
    constexpr unsigned int n     = 7;
    const double           omega = 2. * numbers::PI * frequency;
    const double           end   = curve.rows.back().time;
    const double           start = end - (1. + 1e-9) / frequency;
    FullMatrix<double>     normal(n, n);
    Vector<double>         right(n), solution(n);
    for (const RigRow &row : curve.rows)
      {
        if (row.time < start)
          continue;
        const double t = 2. * (row.time - start) / (end - start) - 1.;
        const std::array<double, n> basis = {{std::sin(omega * row.time),
                                              std::cos(omega * row.time),
                                              std::sin(2. * omega * row.time),
                                              std::cos(2. * omega * row.time),
                                              1.,
                                              t,
                                              t * t}};
        for (unsigned int a = 0; a < n; ++a)
          {
            right[a] += basis[a] * row.state.nominal;
            for (unsigned int b = 0; b < n; ++b)
              normal(a, b) += basis[a] * basis[b];
          }
      }
    normal.gauss_jordan();
    normal.vmult(solution, right);
    return {solution[0] / amplitude, solution[1] / amplitude};
  }



  std::complex<double> wiechert_modulus(const RubberLaw &law,
                                        const RigMode    mode,
                                        const double     frequency)
  {
    using Complex          = std::complex<double>;
    const double omega     = 2. * numbers::PI * frequency;
    const double G_relaxed = law.shear_modulus_relaxed();
    const double rise      = law.shear_modulus_instantaneous() - G_relaxed;
    const double bulk_to_shear =
      rise > 0. ?
        (law.bulk_modulus_instantaneous() - law.bulk_modulus()) / rise :
        0.;
    Complex branches = 0.;
    for (const MaxwellBranch &branch : law.branches)
      {
        const Complex z(0., omega * branch.relaxation_time);
        branches += branch.modulus * z / (1. + z);
      }
    const Complex G = G_relaxed + branches;
    const Complex K = law.bulk_modulus() + bulk_to_shear * branches;
    switch (mode)
      {
        case RigMode::uniaxial:
          return 9. * K * G / (3. * K + G);
        case RigMode::equibiaxial:
          return 18. * K * G / (3. * K + 4. * G);
        case RigMode::pure_shear:
          return 4. * G * (3. * K + G) / (3. * K + 4. * G);
        case RigMode::simple_shear:
          return G;
        default:
          return K + 4. / 3. * G;
      }
  }
} // namespace demold
