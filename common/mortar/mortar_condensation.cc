// SPDX-License-Identifier: LGPL-2.1-or-later
// Dual multipliers that never enter the system: condensed node by node.
#include "contact/nodal_force.h"
#include "mortar/mortar_term.h"
#include "weak_form/condensed_rows.h"

#include <deal.II/base/timer.h>

#include <algorithm>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Relative accuracy of a multiplier found from its own gap.
    constexpr double local_tolerance = 1e-13;

    /// No rule of Newton's applies to a single point.
    NewtonMemory free_choice()
    {
      NewtonMemory memory;
      memory.iteration = 1;
      memory.bond      = AdhesionStatus::decohesion;
      return memory;
    }

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

  bool MortarTerm::is_lone(const unsigned int own) const
  {
    return compliance[own].norm_square() == 0.;
  }

  void MortarTerm::condense(const Configuration &state, CondensedRows &system)
  {
    if (!is_condensed())
      return;
    Timer timer;
    for (unsigned int own = 0; own < trial.size(); ++own)
      if (is_lone(own) &&
          (resolvent.holds(committed[own].law) || is_opposed(state, own)))
        condense_point(state, system, own);
    seconds += timer.wall_time();
  }

  /// With D lambda = f, the force the rest leaves unbalanced, the constraint
  /// R(u, lambda) = 0 linearises to T K du - dR/du du = R + T lift, where K and
  /// lift are the rows of the node and T = -dR/dlambda / D.
  void MortarTerm::condense_point(const Configuration &state,
                                  CondensedRows       &system,
                                  const unsigned int   own)
  {
    const unsigned int       dim   = surfaces.dim();
    const auto              &first = surfaces.node(point(own).node).unknowns;
    const Assembler::Indices rows_of_node(first.begin(), first.begin() + dim);
    const PointGap           gap = gap_of(own);
    for (unsigned int d = 0; d < dim; ++d)
      found[own][d] = system.residual_of(rows_of_node[d]) / gap.area;
    const ConstraintInput    input    = constraint_input(state, own, gap);
    const ConstraintResponse response = point_constraint(resolvent,
                                                         input,
                                                         committed[own].law,
                                                         newton_memory[own]);

    const double           scale = resolvent.penalty * gap.area;
    dealii::Vector<double> residual(dim);
    FullMatrix<double>     T(dim, dim);
    for (unsigned int i = 0; i < dim; ++i)
      {
        residual(i) = -scale * response.residual[i];
        for (unsigned int j = 0; j < dim; ++j)
          T(i, j) = -resolvent.penalty * response.dtraction[i][j];
      }
    Assembler::Indices columns;
    FullMatrix<double> more;
    if (system.with_tangent())
      {
        NodalUnknowns unknowns;
        for (unsigned int l = 0; l < gap.nodes.size(); ++l)
          unknowns.add(surfaces.node(gap.nodes[l]), l, dim);
        columns = unknowns.indices;
        more.reinit(dim, columns.size());
        for (unsigned int k = 0; k < columns.size(); ++k)
          {
            const unsigned int l = unknowns.entries[k] / 3;
            const unsigned int d = unknowns.entries[k] % 3;
            const Tensor<2, 3> change =
              scale * (response.dgap * gap.dgap[l] +
                       response.dnormal * gap.dnormal[l]) +
              resolvent.penalty *
                outer_product(response.residual -
                                response.dtraction * input.traction,
                              gap.darea[l]);
            for (unsigned int i = 0; i < dim; ++i)
              more(i, k) = -change[i][d];
          }
      }
    system.replace(rows_of_node, residual, T, columns, more);
    account(state, own, input, response, gap);
  }

  /// Of a point with compliance: its multiplier follows from its own gap.
  bool MortarTerm::assemble_springlike(const Configuration &state,
                                       Assembler           &assembler,
                                       const unsigned int   own)
  {
    const unsigned int dim   = surfaces.dim();
    const PointGap     gap   = gap_of(own);
    ConstraintInput    input = constraint_input(state, own, gap);
    newton_memory[own]       = free_choice();
    ConstraintResponse response;
    const double       goal =
      local_tolerance * (input.gap.norm() + 1. / resolvent.penalty);
    Tensor<2, 3> by_gap; // dlambda/dgap at a fixed normal, as an inverse first
    for (unsigned int iteration = 0;; ++iteration)
      {
        response = point_constraint(resolvent,
                                    input,
                                    committed[own].law,
                                    newton_memory[own]);
        by_gap   = -1. * inverse(response.dtraction, dim);
        if (response.residual.norm() <= goal)
          break;
        if (iteration == 100)
          return false;
        input.traction += by_gap * response.residual;
      }
    found[own] = input.traction;

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
      r(3 * place + i) = -gap.area * input.traction[i];
    for (unsigned int l = 0; l < n; ++l)
      {
        const Tensor<2, 3> change =
          gap.area * (by_gap * (response.dgap * gap.dgap[l] +
                                response.dnormal * gap.dnormal[l])) +
          outer_product(input.traction, gap.darea[l]);
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            k(3 * place + i, 3 * l + j) -= change[i][j];
      }
    add_forces(assembler, unknowns, 1., r, k);
    account(state, own, input, response, gap);
    return true;
  }
} // namespace demold
