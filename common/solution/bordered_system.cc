// SPDX-License-Identifier: LGPL-2.1-or-later
// A linear system with one row and one column more.
#include "solution/bordered_system.h"

#include "solution/mumps.h"

#include <deal.II/base/mpi.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <Epetra_CrsMatrix.h>

#include <algorithm>
#include <cmath>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Residual of a useful solution over the right-hand side.
    constexpr double good = 1e-8;

    bool leaves_nothing(const BorderedSystem   &s,
                        const BorderedSolution &solution)
    {
      Vector residual(s.r);
      s.K.residual(residual, solution.du, s.r);
      residual.add(solution.dt, s.f);
      const double below = s.c + s.h * solution.du + s.w * solution.dt;
      const double scale =
        s.r.l2_norm() + std::abs(solution.dt) * s.f.l2_norm();
      return residual.l2_norm() <= good * scale + 1e-300 &&
             std::abs(below) <=
               good * (std::abs(s.c) + std::abs(s.w * solution.dt)) + 1e-300;
    }

    BorderedSolution solve_by_parts(const BorderedSystem &s,
                                    LinearSolver         &linear_solver,
                                    const bool            symmetric,
                                    const bool            has_extra_rows)
    {
      BorderedSolution solution;
      solution.du = s.r;
      Vector by_load(s.f);
      if (linear_solver
              .solve(s.K, by_load, s.f, 1e-10, symmetric, has_extra_rows) ==
            LinearSolver::Outcome::singular ||
          linear_solver.solve_again(s.K, solution.du, s.r, 1e-10) ==
            LinearSolver::Outcome::singular)
        return solution;
      const double slope = s.w + s.h * by_load;
      solution.dt        = -(s.c + s.h * solution.du) / slope;
      solution.du.add(solution.dt, by_load);
      solution.solved =
        std::isfinite(solution.dt) && leaves_nothing(s, solution);
      return solution;
    }

    /// The unknowns and, on the last rank, one more.
    IndexSet with_one_more(const IndexSet &owned, const bool is_last)
    {
      IndexSet set(owned.size() + 1);
      set.add_indices(owned);
      if (is_last)
        set.add_index(owned.size());
      set.compress();
      return set;
    }

    /// Calls @p visit with column and value of each entry of an owned @p row.
    /// The iterators of deal.II do not stop at the end of a row whose successor
    /// lies on another rank, as with multipliers behind all displacements.
    template <typename Visit>
    void for_each_entry(const SparseMatrix           &K,
                        const types::global_dof_index row,
                        const Visit                  &visit)
    {
      const Epetra_CrsMatrix &A         = K.trilinos_matrix();
      int                     n_entries = 0, *columns = nullptr;
      double                 *values = nullptr;
      A.ExtractMyRowView(A.LRID(static_cast<int>(row)),
                         n_entries,
                         values,
                         columns);
      for (int k = 0; k < n_entries; ++k)
        visit(A.GCID(columns[k]), values[k]);
    }

    void copy_rows(const BorderedSystem &s,
                   const IndexSet       &owned,
                   SparseMatrix         &A)
    {
      const auto n = owned.size();
      for (const auto row : owned)
        {
          for_each_entry(s.K, row, [&](const int column, const double value) {
            A.add(row, column, value);
          });
          A.add(row, n, -s.f(row));
          A.add(n, row, s.h(row));
        }
    }

    DynamicSparsityPattern pattern_of(const BorderedSystem &s,
                                      const IndexSet       &owned,
                                      const IndexSet       &rows)
    {
      const auto             n = owned.size();
      DynamicSparsityPattern pattern(n + 1, n + 1, rows);
      for (const auto row : owned)
        {
          for_each_entry(s.K, row, [&](const int column, const double) {
            pattern.add(row, column);
          });
          pattern.add(row, n);
          pattern.add(n, row);
        }
      pattern.add(n, n);
      return pattern;
    }
  } // namespace

  BorderedSolution solve_whole(const BorderedSystem &s)
  {
    const MPI_Comm communicator = s.r.get_mpi_communicator();
    const IndexSet owned        = s.r.locally_owned_elements();
    const auto     n            = owned.size();
    const bool is_last = Utilities::MPI::this_mpi_process(communicator) + 1 ==
                         Utilities::MPI::n_mpi_processes(communicator);
    const IndexSet bordered = with_one_more(owned, is_last);
    const IndexSet written  = with_one_more(owned, true);

    DynamicSparsityPattern pattern = pattern_of(s, owned, written);
    SparsityTools::distribute_sparsity_pattern(pattern,
                                               bordered,
                                               communicator,
                                               written);
    SparseMatrix A;
    A.reinit(bordered, bordered, pattern, communicator);
    copy_rows(s, owned, A);
    if (is_last)
      A.add(n, n, s.w);
    A.compress(VectorOperation::add);

    Vector b(bordered, communicator), x(bordered, communicator);
    for (const auto i : owned)
      b(i) = s.r(i);
    if (is_last)
      b(n) = -s.c;
    b.compress(VectorOperation::insert);

    BorderedSolution solution;
    solution.du = s.r;
    Mumps mumps(communicator, false);
    if (mumps.analyse_and_factorise(A) != Mumps::Status::ok)
      return solution;
    mumps.solve(x, b);
    for (const auto i : owned)
      solution.du(i) = x(i);
    solution.du.compress(VectorOperation::insert);
    solution.dt = Utilities::MPI::sum(is_last ? static_cast<double>(x(n)) : 0.,
                                      communicator);
    solution.solved = std::isfinite(solution.dt);
    return solution;
  }

  BorderedSolution solve_bordered(const BorderedSystem &system,
                                  LinearSolver         &linear_solver,
                                  const bool            symmetric,
                                  const bool            has_extra_rows)
  {
    const BorderedSolution by_parts =
      solve_by_parts(system, linear_solver, symmetric, has_extra_rows);
    return by_parts.solved ? by_parts : solve_whole(system);
  }
} // namespace demold
