// SPDX-License-Identifier: LGPL-2.1-or-later
// Test matrices of known spectrum, spread over the ranks on purpose badly.
#ifndef demold_tests_solution_block_stiffness_h
#define demold_tests_solution_block_stiffness_h

#include "weak_form/algebra.h"

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace demold
{
  /// Matrix, vectors and rows of this rank for n unknowns and some extra
  /// rows. Rank 0 owns the first share of the unknowns and all extra rows, so
  /// that with several ranks its rows are not contiguous.
  class TestSystem
  {
  public:
    using Entry    = std::function<double(unsigned int, unsigned int)>;
    using Coupling = std::function<std::vector<unsigned int>(unsigned int)>;

    SparseMatrix A;
    Vector       b, x, exact;

    /// @param coupling  columns of a row
    /// @param block     rows that must stay on one rank
    TestSystem(const unsigned int n,
               const unsigned int n_extra,
               const Coupling    &coupling,
               const unsigned int block = 1)
      : owned(n + n_extra)
    {
      const unsigned int n_ranks =
        dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
      const unsigned int rank =
        dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
      const unsigned int n_blocks = n / block;
      owned.add_range(block * (n_blocks * rank / n_ranks),
                      block * (n_blocks * (rank + 1) / n_ranks));
      if (rank == 0)
        owned.add_range(n, n + n_extra);

      dealii::TrilinosWrappers::SparsityPattern pattern(owned, MPI_COMM_WORLD);
      for (const auto row : owned)
        for (const auto column : coupling(row))
          pattern.add(row, column);
      pattern.compress();
      A.reinit(pattern);
      for (Vector *vector : {&b, &x, &exact})
        vector->reinit(owned, MPI_COMM_WORLD);
    }

    /// Fills all entries of the pattern.
    void fill(const Coupling &coupling, const Entry &entry)
    {
      for (const auto row : owned)
        for (const auto column : coupling(row))
          A.set(row, column, entry(row, column));
      A.compress(dealii::VectorOperation::insert);
    }

    /// b = A exact for a solution that has nothing to do with A.
    void make_right_hand_side()
    {
      for (const auto row : owned)
        exact(row) = 1. + std::sin(1. + row);
      exact.compress(dealii::VectorOperation::insert);
      A.vmult(b, exact);
    }

    /// |x - exact| / |exact|
    double error() const
    {
      Vector difference(x);
      difference -= exact;
      return difference.l2_norm() / exact.l2_norm();
    }

    /// |b - A x| / |b|
    double residual() const
    {
      Vector r(b);
      return A.residual(r, x, b) / b.l2_norm();
    }

    dealii::IndexSet owned;
  };


  /// A chain of n unit springs, both ends held: tridiagonal -1, 2, -1 with
  /// the eigenvalues 2 - 2 cos(k pi / (n + 1)), k = 1 ... n.
  inline TestSystem::Coupling chain(const unsigned int n)
  {
    return [n](const unsigned int i) {
      std::vector<unsigned int> columns;
      if (i > 0)
        columns.push_back(i - 1);
      columns.push_back(i);
      if (i + 1 < n)
        columns.push_back(i + 1);
      return columns;
    };
  }


  /// Stiffness of a cube of edge 1 under small strains with mean dilatation
  /// (constant pressure), nodes in lexical order, unknown 3 node + component.
  using CubeStiffness = std::array<std::array<double, 24>, 24>;

  inline CubeStiffness cube_stiffness(const double bulk_modulus,
                                      const double shear_modulus)
  {
    CubeStiffness               k{};
    std::array<double, 24>      mean{}; // of the divergence
    const std::array<double, 2> gauss = {
      {.5 - .5 / std::sqrt(3.), .5 + .5 / std::sqrt(3.)}};
    for (unsigned int q = 0; q < 8; ++q)
      {
        std::array<std::array<double, 3>, 8> gradient;
        for (unsigned int a = 0; a < 8; ++a)
          for (unsigned int c = 0; c < 3; ++c)
            {
              gradient[a][c] = 1.;
              for (unsigned int d = 0; d < 3; ++d)
                {
                  const double x   = gauss[(q >> d) & 1];
                  const bool   far = ((a >> d) & 1) != 0;
                  gradient[a][c] *=
                    d == c ? (far ? 1. : -1.) : (far ? x : 1. - x);
                }
              mean[3 * a + c] += gradient[a][c] / 8.;
            }
        for (unsigned int i = 0; i < 24; ++i)
          for (unsigned int j = 0; j < 24; ++j)
            {
              const auto        &g  = gradient[i / 3];
              const auto        &h  = gradient[j / 3];
              const unsigned int ci = i % 3, cj = j % 3;
              double             s = g[cj] * h[ci] - 2. / 3. * g[ci] * h[cj];
              if (ci == cj)
                s += g[0] * h[0] + g[1] * h[1] + g[2] * h[2];
              k[i][j] += shear_modulus * s / 8.;
            }
      }
    for (unsigned int i = 0; i < 24; ++i)
      for (unsigned int j = 0; j < 24; ++j)
        k[i][j] += bulk_modulus * mean[i] * mean[j];
    return k;
  }


  /// A block of n^3 cubes. Held: bottom and top nodes keep their rows, with
  /// the diagonal only.
  class BlockOfCubes
  {
  public:
    BlockOfCubes(const unsigned int n, const bool held)
      : n(n)
      , held(held)
      , system(
          3 * (n + 1) * (n + 1) * (n + 1),
          0,
          [this](const unsigned int i) { return columns(i); },
          3)
    {}

    /// @param softer  shear modulus of a cube, as a factor, by its number
    void assemble(const double                               bulk_modulus,
                  const std::function<double(unsigned int)> &stiffness,
                  const double                               skew = 0.)
    {
      const CubeStiffness soft = cube_stiffness(0., .8);
      const CubeStiffness hard = cube_stiffness(bulk_modulus, 0.);
      system.A                 = 0.;
      for (unsigned int cube = 0; cube < n * n * n; ++cube)
        for (unsigned int i = 0; i < 24; ++i)
          {
            const unsigned int row = unknown(cube, i);
            if (!system.owned.is_element(row))
              continue;
            for (unsigned int j = 0; j < 24; ++j)
              {
                const unsigned int column = unknown(cube, j);
                double value = stiffness(cube) * soft[i][j] + hard[i][j] +
                               skew * (i < j ? 1. : (i > j ? -1. : 0.));
                if (is_held(row) || is_held(column))
                  value = row == column ? std::abs(value) : 0.;
                system.A.add(row, column, value);
              }
          }
      system.A.compress(dealii::VectorOperation::add);
      system.make_right_hand_side();
    }

    /// Three translations and three rotations.
    std::vector<Vector> rigid_body_modes() const
    {
      std::vector<Vector> modes(6, system.x);
      for (const auto row : system.owned)
        {
          const std::array<double, 3> p = {
            {double(row / 3 % (n + 1)),
             double(row / 3 / (n + 1) % (n + 1)),
             double(row / 3 / (n + 1) / (n + 1))}};
          const unsigned int c = row % 3, d = (c + 1) % 3, e = (c + 2) % 3;
          modes[c](row)     = 1.;
          modes[3 + d](row) = p[e];
          modes[3 + e](row) = -p[d];
        }
      for (Vector &mode : modes)
        mode.compress(dealii::VectorOperation::insert);
      return modes;
    }

  private:
    bool is_held(const unsigned int row) const
    {
      const unsigned int layer = row / 3 / (n + 1) / (n + 1);
      return held && (layer == 0 || layer == n);
    }

    unsigned int unknown(const unsigned int cube, const unsigned int i) const
    {
      const unsigned int a = i / 3;
      const unsigned int x = cube % n + (a & 1);
      const unsigned int y = cube / n % n + ((a >> 1) & 1);
      const unsigned int z = cube / n / n + (a >> 2);
      return 3 * ((z * (n + 1) + y) * (n + 1) + x) + i % 3;
    }

    std::vector<unsigned int> columns(const unsigned int row) const
    {
      const int m = n + 1;
      const int x = row / 3 % m, y = row / 3 / m % m, z = row / 3 / m / m;
      std::vector<unsigned int> result;
      for (int k = std::max(z - 1, 0); k <= std::min(z + 1, m - 1); ++k)
        for (int j = std::max(y - 1, 0); j <= std::min(y + 1, m - 1); ++j)
          for (int i = std::max(x - 1, 0); i <= std::min(x + 1, m - 1); ++i)
            for (int c = 0; c < 3; ++c)
              result.push_back(3 * ((k * m + j) * m + i) + c);
      return result;
    }

    const unsigned int n;
    const bool         held;

  public:
    TestSystem system;
  };
} // namespace demold

#endif
