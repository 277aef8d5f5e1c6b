// SPDX-License-Identifier: LGPL-2.1-or-later
// Dual multipliers that never enter the system: condensed node by node.
#include "contact/nodal_force.h"
#include "mortar/mortar_term.h"
#include "weak_form/condensed_rows.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <algorithm>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Largest change that may be left of an eliminated multiplier, over the
    /// largest one so far.
    constexpr double eliminated_tolerance = 1e-5;

    /// Inverse of a matrix whose rows and columns from @p dim on are zero.
    Tensor<2, 3> inverse(Tensor<2, 3> a, const unsigned int dim)
    {
      for (unsigned int d = dim; d < 3; ++d)
        a[d][d] = 1.;
      Tensor<2, 3> result = invert(a);
      for (unsigned int d = dim; d < 3; ++d)
        result[d][d] = 0.;
      return result;
    }
  } // namespace

  bool MortarTerm::is_condensed() const
  {
    return description.condensed && description.dual_multipliers &&
           surfaces.master().is_rigid();
  }

  bool MortarTerm::has_own_rows(const unsigned int own) const
  {
    return !shared[own] && !driven[own] && !free[own].empty();
  }

  void MortarTerm::condense(const Configuration &state, CondensedRows &system)
  {
    if (!is_condensed())
      return;
    Timer timer;
    for (unsigned int own = 0; own < trial.size(); ++own)
      if (has_own_rows(own) &&
          (resolvent.holds(committed[own].law) || is_opposed(state, own)))
        condense_point(state, system, own);
    // Newton does not see how far eliminated multipliers are from their end.
    for (double *x : {&largest_found, &largest_behind})
      *x = Utilities::MPI::max(*x, communicator);
    settled =
      settled && largest_behind <= eliminated_tolerance *
                                     std::max(largest_found, largest_accepted);
    seconds += timer.wall_time();
  }

  /// D lambda = f, the force the rest leaves unbalanced. With K and lift, the
  /// rows of the node, D (lambda + dlambda) = f - lift + K du, and the
  /// constraint R(u, lambda) = 0 becomes rows in du alone. lambda is what the
  /// last linear system has implied, not f/D: so Newton goes the way it would
  /// go without condensation. In the end they are the same.
  void MortarTerm::condense_point(const Configuration &state,
                                  CondensedRows       &system,
                                  const unsigned int   own)
  {
    const auto &unknowns = surfaces.node(point(own).node).unknowns;
    const std::vector<unsigned int> &components = free[own];
    const PointGap                   gap        = gap_of(own);
    Assembler::Indices               rows_of_node;
    found[own] = eliminated[own].value(state.u);
    Tensor<1, 3> balanced; // f/D
    for (const unsigned int d : components)
      {
        rows_of_node.push_back(unknowns[d]);
        balanced[d] = system.residual_of(unknowns[d]) / gap.area;
      }
    const ConstraintInput    input    = constraint_input(state, own, gap);
    const ConstraintResponse response = point_constraint(resolvent,
                                                         input,
                                                         committed[own].law,
                                                         newton_memory[own]);

    const unsigned int n = components.size();
    const Tensor<2, 3> scaling =
      row_scaling(response.dgap, resolvent.penalty, stiffness, components);
    const Tensor<1, 3> behind = balanced - found[own];
    const Tensor<1, 3> rest   = response.residual + response.dtraction * behind;
    const Tensor<1, 3> scaled = scaling * rest;
    const Tensor<2, 3> dscaled = scaling * response.dtraction;
    dealii::Vector<double> residual(n);
    FullMatrix<double>     T(n, n);
    for (unsigned int i = 0; i < n; ++i)
      {
        residual(i) = -gap.area * scaled[components[i]];
        for (unsigned int j = 0; j < n; ++j)
          T(i, j) = -dscaled[components[i]][components[j]];
        system.add_force(rows_of_node[i], -gap.area * balanced[components[i]]);
      }
    NodalUnknowns columns;
    for (unsigned int l = 0; l < gap.nodes.size(); ++l)
      columns.add(surfaces.node(gap.nodes[l]), l, surfaces.dim());
    if (system.with_tangent())
      remember_linear(state, system, own, balanced, gap, columns);
    const Tensor<2, 3> dnormal =
      scaled_dnormal(response, scaling, rest, input.normal);
    system.replace(rows_of_node,
                   residual,
                   T,
                   columns.indices,
                   direct_dependence(scaling * response.dgap,
                                     dnormal,
                                     scaling * (response.residual -
                                                response.dtraction * balanced),
                                     gap,
                                     columns,
                                     components));
    account(state, own, input, response, gap);
    keep_largest(found[own], behind);
  }

  /// Keeps D (lambda + dlambda) = f - lift + K du for the next iteration.
  void MortarTerm::remember_linear(const Configuration &state,
                                   const CondensedRows &system,
                                   const unsigned int   own,
                                   const Tensor<1, 3>  &balanced,
                                   const PointGap      &gap,
                                   const NodalUnknowns &columns)
  {
    const auto        &unknowns = surfaces.node(point(own).node).unknowns;
    Tensor<1, 3>       lift;
    Assembler::Indices indices;
    std::vector<Tensor<1, 3>> dlambda;
    for (const unsigned int d : free[own])
      {
        lift[d]                      = system.lift_of(unknowns[d]) / gap.area;
        const CondensedRows::Row row = system.row_of(unknowns[d]);
        for (std::size_t k = 0; k < row.columns.size(); ++k)
          {
            Tensor<1, 3> change;
            change[d] = row.values[k] / gap.area;
            indices.push_back(row.columns[k]);
            dlambda.push_back(change);
          }
      }
    for (unsigned int k = 0; k < columns.indices.size(); ++k)
      {
        const double darea =
          gap.darea[columns.entries[k] / 3][columns.entries[k] % 3];
        if (darea == 0.)
          continue;
        indices.push_back(columns.indices[k]);
        dlambda.push_back(-darea / gap.area * balanced);
      }
    eliminated[own].remember(balanced, -lift, indices, dlambda, state.u);
  }

  void MortarTerm::keep_largest(const Tensor<1, 3> &lambda,
                                const Tensor<1, 3> &behind)
  {
    largest_found  = std::max(largest_found, lambda.norm());
    largest_behind = std::max(largest_behind, behind.norm());
  }

  /// -dR/du at lambda = f/D, without the part through f, in the rows of
  /// @p components; derivatives of the scaled residual are given.
  FullMatrix<double> MortarTerm::direct_dependence(
    const Tensor<2, 3>              &dgap,
    const Tensor<2, 3>              &dnormal,
    const Tensor<1, 3>              &darea,
    const PointGap                  &gap,
    const NodalUnknowns             &columns,
    const std::vector<unsigned int> &components) const
  {
    FullMatrix<double> result(components.size(), columns.indices.size());
    for (unsigned int k = 0; k < columns.indices.size(); ++k)
      {
        const unsigned int l = columns.entries[k] / 3;
        const unsigned int d = columns.entries[k] % 3;
        const Tensor<2, 3> change =
          gap.area * (dgap * gap.dgap[l] + dnormal * gap.dnormal[l]) +
          outer_product(darea, gap.darea[l]);
        for (unsigned int i = 0; i < components.size(); ++i)
          result(i, k) = -change[components[i]][d];
      }
    return result;
  }

  /// A point with compliance: R(u, lambda) = 0 is solved for the change of
  /// lambda, which goes into the rows of its node and is remembered until
  /// Newton has found the change of u.
  void MortarTerm::assemble_eliminated(const Configuration &state,
                                       Assembler           &assembler,
                                       const unsigned int   own)
  {
    const unsigned int    dim         = surfaces.dim();
    const PointGap        gap         = gap_of(own);
    EliminatedMultiplier &kept        = eliminated[own];
    found[own]                        = kept.value(state.u);
    const ConstraintInput    input    = constraint_input(state, own, gap);
    const ConstraintResponse response = point_constraint(resolvent,
                                                         input,
                                                         committed[own].law,
                                                         newton_memory[own]);
    const Tensor<2, 3>       solved   = -1. * inverse(response.dtraction, dim);
    const Tensor<1, 3>       offset   = solved * response.residual;

    const unsigned int n = gap.nodes.size();
    const unsigned int place =
      std::find(gap.nodes.begin(), gap.nodes.end(), point(own).node) -
      gap.nodes.begin();
    NodalUnknowns unknowns;
    for (unsigned int l = 0; l < n; ++l)
      unknowns.add(surfaces.node(gap.nodes[l]), l, dim);
    dealii::Vector<double> r(3 * n);
    FullMatrix<double>     k(3 * n, 3 * n);
    for (unsigned int i = 0; i < 3; ++i)
      r(3 * place + i) = -gap.area * (input.traction + offset)[i];
    std::vector<Tensor<2, 3>> change(n);
    for (unsigned int l = 0; l < n; ++l)
      {
        change[l] =
          solved *
          (response.dgap * gap.dgap[l] + response.dnormal * gap.dnormal[l] +
           outer_product(response.residual, gap.darea[l]) / gap.area);
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            k(3 * place + i, 3 * l + j) =
              -gap.area * change[l][i][j] -
              (input.traction + offset)[i] * gap.darea[l][j];
      }
    if (assembler.with_tangent())
      {
        std::vector<Tensor<1, 3>> dlambda(unknowns.indices.size());
        for (unsigned int k_u = 0; k_u < dlambda.size(); ++k_u)
          for (unsigned int i = 0; i < 3; ++i)
            dlambda[k_u][i] =
              change[unknowns.entries[k_u] / 3][i][unknowns.entries[k_u] % 3];
        kept.remember(input.traction,
                      offset,
                      unknowns.indices,
                      dlambda,
                      state.u);
      }
    add_forces(assembler, unknowns, 1., r, k);
    account(state, own, input, response, gap);
    keep_largest(found[own], offset);
  }
} // namespace demold
