// SPDX-License-Identifier: LGPL-2.1-or-later
// The tangent of every branch law is what Sacado makes of theory's formulas.
#include "random_deformation.h"

#include <Sacado.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace demold;

namespace
{
  // A second path to stress and tangent: the formulas of theory A.1 and A.2
  // written down once more, in plain matrices and without a closed form of any
  // derivative, differentiated automatically.
  using Number = Sacado::Fad::SFad<double, 6>;
  template <typename T>
  using Matrix = std::array<std::array<T, 3>, 3>;
  using Fixed  = Matrix<double>;
  using Active = Matrix<Number>;

  constexpr unsigned int rows[]    = {0, 1, 2, 0, 0, 1};
  constexpr unsigned int columns[] = {0, 1, 2, 1, 2, 2};

  template <typename A, typename B>
  Active sum(const A &a, const B &b, const Number &f)
  {
    Active c;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        c[i][j] = a[i][j] + f * b[i][j];
    return c;
  }

  template <typename T>
  Active times(const Matrix<T> &a, const Number &f)
  {
    return sum(Fixed{}, a, f);
  }

  template <typename A, typename B>
  Number contracted(const A &a, const B &b)
  {
    Number s = 0.;
    for (unsigned int k = 0; k < 9; ++k)
      s += a[k / 3][k % 3] * b[k / 3][k % 3];
    return s;
  }

  template <typename T>
  T det(const Matrix<T> &a)
  {
    return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
           a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
           a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
  }

  template <typename T>
  Matrix<T> inverted(const Matrix<T> &a)
  {
    Matrix<T> b;
    const T   d = det(a);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        {
          const unsigned int k = (i + 1) % 3, l = (i + 2) % 3;
          const unsigned int m = (j + 1) % 3, n = (j + 2) % 3;
          b[j][i] = (a[k][m] * a[l][n] - a[k][n] * a[l][m]) / d;
        }
    return b;
  }

  const Fixed one{{{{1., 0., 0.}}, {{0., 1., 0.}}, {{0., 0., 1.}}}};

  /// Isochoric Mooney-Rivlin with bulk modulus K, p = J^(-2/3).
  Active
  isochoric(const Active &C, const double C10, const double C01, const double K)
  {
    const Active inv = inverted(C);
    const Number J   = sqrt(det(C));
    const Number p   = pow(J, -2. / 3.);
    const Number I1  = contracted(C, one);
    const Number I2  = .5 * (I1 * I1 - contracted(C, C));
    Active       S   = times(sum(one, inv, -I1 / 3.), 2. * C10 * p);
    S                = sum(S, one, 2. * C01 * p * p * I1);
    S                = sum(S, C, -2. * C01 * p * p);
    S                = sum(S, inv, -4. / 3. * C01 * p * p * I2);
    return sum(S, inv, K * J * (J - 1.));
  }

  /// (A2)
  Active mooney_rivlin(const Active &C, const MooneyRivlin &law)
  {
    const Number I1 = contracted(C, one);
    const Number k  = .5 * law.lambda * (det(C) - 1.) - law.mu1 - 2. * law.mu2;
    Active       S  = times(one, law.mu1 + law.mu2 * I1);
    S               = sum(S, C, Number(-law.mu2));
    return sum(S, inverted(C), k);
  }

  Fixed read(const double *six)
  {
    Fixed a;
    for (unsigned int k = 0; k < 6; ++k)
      a[rows[k]][columns[k]] = a[columns[k]][rows[k]] = six[k];
    return a;
  }

  /// old Ci + start C_n + end C of theory A.2, by its formulas.
  Active remembered(const double  h,
                    const double  phi,
                    const bool    backward_euler,
                    const Fixed  &Ci,
                    const Fixed  &before,
                    const Active &now)
  {
    if (backward_euler)
      return sum(Ci, now, Number(h));
    const double e = std::exp(-phi * h);
    const double q = h > 0. ? (1. - e) / (phi * h) : 1.;
    Active       A = times(Ci, Number(e));
    A              = sum(A, before, Number((q - e) / phi));
    return sum(A, now, Number((1. - q) / phi));
  }

  /// Stress of a branch of @p law whose first six history values are
  /// @p before and whose own are @p state.
  Active branch_stress(const RubberLaw     &law,
                       const MaxwellBranch &branch,
                       const double         dt,
                       const Fixed         &before,
                       const Fixed         &state,
                       const Active        &C)
  {
    const double h   = dt / branch.relaxation_time;
    const Active inv = inverted(C);
    const Number mu  = branch.modulus;
    if (law.branch_law == BranchLaw::isochoric)
      {
        const Number p   = pow(det(C), -1. / 3.);
        const double phi = law.update == ViscousUpdate::exp2 ?
                             contracted(before, inverted(state)).val() / 3. :
                             1.;
        const bool   be  = law.update == ViscousUpdate::be;
        const Active A   = remembered(h, phi, be, state, before, times(C, p));
        const Active B   = times(inverted(A), pow(det(A), 1. / 3.));
        return times(sum(B, inv, -contracted(C, B) / 3.), mu * p);
      }
    if (law.branch_law == BranchLaw::linear)
      {
        const Active Ci = remembered(h, 1., false, state, before, C);
        return times(sum(inverted(Ci), inv, Number(-1.)), mu);
      }
    if (law.branch_law == BranchLaw::lubliner)
      {
        const Active B = remembered(h, 1., false, state, inverted(before), inv);
        return times(sum(B, inv, Number(-1.)), mu);
      }
    const double r =
      std::visit([](const auto &elastic) { return elastic.share_of_I2(); },
                 law.elastic);
    const double e = std::exp(-h), q = h > 0. ? (1. - e) / h : 1.;
    Active       C_old;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        C_old[i][j] = before[i][j];
    Active rise = isochoric(C, .5 * (1. - r), .5 * r, 0.);
    rise = sum(rise, isochoric(C_old, .5 * (1. - r), .5 * r, 0.), Number(-1.));
    return sum(times(state, Number(e)), rise, mu * q);
  }

  Active stress(const RubberLaw             &law,
                const SymmetricTensor<2, 3> &C_given,
                const double                 dt,
                const std::vector<double>   &history)
  {
    Active C;
    for (unsigned int k = 0; k < 6; ++k)
      C[rows[k]][columns[k]] = C[columns[k]][rows[k]] =
        Number(6, k, C_given[rows[k]][columns[k]]);

    Active S;
    if (law.elastic.index() == 0)
      S = mooney_rivlin(C, std::get<MooneyRivlin>(law.elastic));
    else
      {
        const auto &elastic = std::get<IsochoricMooneyRivlin>(law.elastic);
        S = isochoric(C, elastic.C10, elastic.C01, elastic.bulk);
      }
    for (unsigned int j = 0; j < law.branches.size(); ++j)
      S = sum(S,
              branch_stress(law,
                            law.branches[j],
                            dt,
                            read(history.data()),
                            read(history.data() + 6 + 6 * j),
                            C),
              Number(1.));
    return S;
  }

  /// Largest difference of @p point's stress and of its tangent to those of
  /// Sacado, relative to the norm.
  void compare(const Point                 &point,
               const SymmetricTensor<2, 3> &C,
               const double                 dt,
               const std::string           &what)
  {
    BulkResponse        response;
    std::vector<double> trial(point.history.size());
    point.law
      .evaluate(C, dt, point.history.data(), trial.data(), true, response);
    const Active S = stress(point.law, C, dt, point.history);

    const double scale = response.dS_dE.norm();
    for (unsigned int i = 0; i < 6; ++i)
      {
        const Number &S_i = S[rows[i]][columns[i]];
        EXPECT_NEAR(response.S[rows[i]][columns[i]], S_i.val(), 1e-12 * scale)
          << what;
        // dE_kl, k != l, counts twice in the derivative by the entry C_kl.
        for (unsigned int k = 0; k < 6; ++k)
          EXPECT_NEAR(response.dS_dE[rows[i]][columns[i]][rows[k]][columns[k]],
                      (k < 3 ? 2. : 1.) * S_i.dx(k),
                      1e-9 * scale)
            << what << ", entry " << i << ' ' << k;
      }
  }
} // namespace

TEST(tangent, of_every_branch_law_alone_is_that_of_sacado)
{
  std::mt19937 generator(12);
  for (const Variant &variant : all_variants)
    for (const double dt : {0., 1e-3, .3, 3., 50.})
      for (unsigned int sample = 0; sample < 5; ++sample)
        {
          Point point(bare_branch(variant));
          for (unsigned int step = 0; step < 3; ++step)
            point.move_to(random_gradient(generator, .3), .5);
          compare(point,
                  right_cauchy_green(random_gradient(generator, .3)),
                  dt,
                  variant.name + (" at dt = " + std::to_string(dt)));
        }
}

TEST(tangent, of_whole_rubbers_is_that_of_sacado)
{
  std::mt19937 generator(13);
  for (const bool isochoric : {false, true})
    for (const Variant &variant : all_variants)
      for (const double dt : {0., 1e-3, .3, 3., 50.})
        {
          RubberLaw law;
          if (isochoric)
            law.elastic = IsochoricMooneyRivlin{.3, .1, 40.};
          else
            law.elastic = MooneyRivlin{50., .4, .1};
          law.branches   = {{.3, .01}, {.5, .2}, {.2, 5.}};
          law.branch_law = variant.branch_law;
          law.update     = variant.update;
          Point point(law);
          for (unsigned int step = 0; step < 3; ++step)
            point.move_to(random_gradient(generator, .25), .05);
          compare(point,
                  right_cauchy_green(random_gradient(generator, .25)),
                  dt,
                  variant.name + (" at dt = " + std::to_string(dt)));
        }
}
