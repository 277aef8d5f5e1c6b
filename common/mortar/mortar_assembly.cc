// SPDX-License-Identifier: LGPL-2.1-or-later
// Forces and constraint of one multiplier point.
#include "contact/nodal_force.h"
#include "mortar/mortar_term.h"
#include "mortar/point_gap.h"

#include <deal.II/base/timer.h>

#include <algorithm>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// History of a point that has left the other surface.
    ResolventState without_contact(ResolventState state)
    {
      state.may_stick      = false;
      state.opening        = 0.;
      state.slip           = Tensor<1, 3>();
      state.friction_limit = 0.;
      return state;
    }
  } // namespace

  /// The unknowns of one point and residual and tangent over them: three
  /// entries per node, then three for the multiplier and for each of those that
  /// it leans on.
  class MortarTerm::LocalSystem
  {
  public:
    LocalSystem(const std::vector<unsigned int> &nodes,
                const unsigned int               n_others = 0)
      : nodes(nodes)
      , multiplier(nodes.size())
      , R(3 * (nodes.size() + 1 + n_others))
      , K(R.size(), R.size())
    {}

    unsigned int position(const unsigned int node) const
    {
      return std::find(nodes.begin(), nodes.end(), node) - nodes.begin();
    }

    unsigned int n_others() const
    {
      return R.size() / 3 - nodes.size() - 1;
    }

    void add(const unsigned int row, const Tensor<1, 3> &r)
    {
      for (unsigned int i = 0; i < 3; ++i)
        R(3 * row + i) += r[i];
    }

    void add(const unsigned int  row,
             const unsigned int  column,
             const Tensor<2, 3> &k)
    {
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          K(3 * row + i, 3 * column + j) += k[i][j];
    }

    const std::vector<unsigned int> &nodes;
    const unsigned int               multiplier; ///< its position
    dealii::Vector<double>           R;
    FullMatrix<double>               K;
  };

  bool MortarTerm::assemble(const Configuration &state, Assembler &assembler)
  {
    Timer timer;
    now           = Energies();
    increment     = Increment();
    state_changes = 0;
    settled       = true;
    largest_found = largest_behind = 0.;
    trial                          = committed;
    normals                        = mortar.normals();
    rows = mortar.rows(row_demand(state, assembler.with_tangent()));

    for (unsigned int own = 0; own < trial.size(); ++own)
      if (!resolvent.holds(committed[own].law) && !is_opposed(state, own))
        assemble_idle(state, assembler, own);
      else if (!is_condensed())
        assemble_point(state, assembler, own);
      else if (!has_own_rows(own))
        assemble_eliminated(state, assembler, own);
    seconds += timer.wall_time();
    return true;
  }

  Tensor<1, 3> MortarTerm::multiplier(const Configuration &state,
                                      const unsigned int   own) const
  {
    if (is_condensed())
      return found[own];
    Tensor<1, 3> lambda;
    for (unsigned int d = 0; d < surfaces.dim(); ++d)
      lambda[d] = state.u(first_unknown(own) + d);
    return lambda;
  }

  std::vector<RowDemand> MortarTerm::row_demand(const Configuration &state,
                                                const bool with_tangent) const
  {
    std::vector<RowDemand> demand(committed.size(), RowDemand::values);
    for (unsigned int own = 0; own < demand.size(); ++own)
      if (resolvent.holds(committed[own].law))
        demand[own] = RowDemand::nothing;
    if (!with_tangent)
      return demand;
    // Derivatives are asked for where the constraint is active: of an open
    // point only the multiplier enters.
    const std::vector<NodalRow> values = mortar.rows(demand);
    for (unsigned int own = 0; own < demand.size(); ++own)
      if (demand[own] == RowDemand::values && values[own].area > 0.)
        {
          const Tensor<1, 3> &n = normals[own].n;
          const double        gap =
            n * weighted_gap(surfaces, values[own]) / values[own].area;
          if (is_pressed(state, own).value_or(false) ||
              (is_condensed() && (committed[own].closed || gap <= 0.)) ||
              n * multiplier(state, own) + resolvent.penalty * gap <= 0.)
            demand[own] = RowDemand::derivatives;
        }
    return demand;
  }

  PointGap MortarTerm::frozen_gap(const unsigned int own) const
  {
    const FrozenRow  &bond   = frozen[own];
    const Master     &master = surfaces.master();
    const AnchorPlace place  = master.place(bond.anchor);
    if (master.is_rigid())
      return frozen_point_gap(surfaces,
                              bond.row,
                              bond.row.area * place.x,
                              normals[own]);
    const Tensor<1, 3> turned =
      place.x - master.surface.bound(bond.anchor.facet).centre;
    PointGap gap = frozen_point_gap(surfaces,
                                    bond.row,
                                    -bond.row.area * turned,
                                    normals[own]);
    // The gap there was at bonding turns with the facet. Of the couple this
    // makes with the traction nothing is seen: it is of the order of that gap.
    for (unsigned int i = 0; i < place.n_nodes; ++i)
      gap.dgap[gap.position(surfaces.n_slave_nodes() + place.nodes[i])] -=
        place.doffset[i];
    return gap;
  }

  PointGap MortarTerm::current_gap(const unsigned int own) const
  {
    return current_point_gap(surfaces, rows[own], slip_rows[own], normals[own]);
  }

  PointGap MortarTerm::gap_of(const unsigned int own) const
  {
    return resolvent.holds(committed[own].law) ? frozen_gap(own) :
                                                 current_gap(own);
  }

  const NodalRow &MortarTerm::row_of(const unsigned int own) const
  {
    return resolvent.holds(committed[own].law) ? frozen[own].row : rows[own];
  }

  ConstraintInput MortarTerm::constraint_input(const Configuration &state,
                                               const unsigned int   own,
                                               const PointGap      &gap)
  {
    newton_memory[own].iteration = state.iteration;
    ConstraintInput input;
    input.gap      = gap.gap;
    input.normal   = normals[own].n;
    input.traction = multiplier(state, own);
    if (resolvent.holds(committed[own].law))
      input.old_gap = committed[own].gap;
    input.compliance = compliance[own];
    input.sprung     = input.traction - leaned_on(state, own);
    for (unsigned int d = 0; d < 3; ++d)
      input.old_gap[d] -= compliance[own][d] * committed[own].sprung[d];
    input.pressed = is_pressed(state, own);
    if (state.iteration == 0 && !on_path.empty() && on_path[own])
      input.forced = ForcedBranch::decohesion;
    inputs[own] = input;
    return input;
  }

  void MortarTerm::assemble_idle(const Configuration &state,
                                 Assembler           &assembler,
                                 const unsigned int   own)
  {
    if (is_condensed())
      {
        found[own] = Tensor<1, 3>();
        eliminated[own].restart(found[own]);
      }
    const std::vector<unsigned int> no_nodes;
    LocalSystem                     local(no_nodes);
    Tensor<2, 3>                    row;
    for (unsigned int d = 0; d < 3; ++d)
      row[d][d] = -point(own).area;
    local.add(local.multiplier, row * multiplier(state, own));
    local.add(local.multiplier, local.multiplier, row);
    if (!is_condensed())
      insert(assembler, own, local);
    MultiplierHistory &point = trial[own];
    point                    = MultiplierHistory();
    point.law                = without_contact(committed[own].law);
    point.separation_time    = committed[own].separation_time;
    count_change(own, point.number);
  }

  void MortarTerm::assemble_point(const Configuration &state,
                                  Assembler           &assembler,
                                  const unsigned int   own)
  {
    const PointGap           gap      = gap_of(own);
    const NodalRow          &row      = row_of(own);
    const ConstraintInput    input    = constraint_input(state, own, gap);
    const ConstraintResponse response = point_constraint(resolvent,
                                                         input,
                                                         committed[own].law,
                                                         newton_memory[own]);

    LocalSystem        local(gap.nodes, leaning[own].points.size());
    const Tensor<2, 3> scaling =
      row_scaling(response.dgap, resolvent.penalty, stiffness, components);
    const auto m = local.multiplier;
    local.add(m, gap.area * (scaling * response.residual));
    for (unsigned int k = 0; k < row.nodes.size(); ++k)
      if (!surfaces.is_rigid(row.nodes[k]))
        local.add(local.position(row.nodes[k]),
                  row.weights[k] * input.traction);
    if (assembler.with_tangent())
      {
        local.add(m, m, gap.area * (scaling * response.dtraction));
        const Tensor<2, 3> dgap = scaling * response.dgap;
        const Tensor<2, 3> dnormal =
          scaled_dnormal(response, scaling, response.residual, input.normal);
        for (unsigned int l = 0; l < gap.nodes.size(); ++l)
          local.add(m,
                    l,
                    gap.area * (dgap * gap.dgap[l] + dnormal * gap.dnormal[l]) +
                      outer_product(scaling * response.residual, gap.darea[l]));
        for (unsigned int i = 0; i < leaning[own].points.size(); ++i)
          local.add(m,
                    m + 1 + i,
                    gap.area * (scaling * (-1. * response.dsprung) *
                                leaning[own].share()));
        add_force_tangent(row, input.traction, local);
      }
    insert(assembler, own, local);
    account(state, own, input, response, gap);
  }

  void MortarTerm::add_force_tangent(const NodalRow     &row,
                                     const Tensor<1, 3> &traction,
                                     LocalSystem        &local) const
  {
    for (unsigned int k = 0; k < row.nodes.size(); ++k)
      {
        if (surfaces.is_rigid(row.nodes[k]))
          continue;
        const unsigned int position = local.position(row.nodes[k]);
        Tensor<2, 3>       weight;
        for (unsigned int d = 0; d < 3; ++d)
          weight[d][d] = row.weights[k];
        local.add(position, local.multiplier, weight);
        if (row.has_derivatives)
          for (unsigned int l = 0; l < row.nodes.size(); ++l)
            if (!surfaces.is_rigid(row.nodes[l]))
              local.add(position,
                        local.position(row.nodes[l]),
                        outer_product(traction, row.dweights[k][l]));
      }
  }

  void MortarTerm::insert(Assembler         &assembler,
                          const unsigned int own,
                          const LocalSystem &local) const
  {
    NodalUnknowns unknowns;
    for (unsigned int k = 0; k < local.nodes.size(); ++k)
      unknowns.add(surfaces.node(local.nodes[k]), k, surfaces.dim());
    for (unsigned int d = 0; d < surfaces.dim(); ++d)
      {
        unknowns.indices.push_back(first_unknown(own) + d);
        unknowns.entries.push_back(3 * local.multiplier + d);
      }
    for (unsigned int i = 0; i < local.n_others(); ++i)
      for (unsigned int d = 0; d < surfaces.dim(); ++d)
        {
          unknowns.indices.push_back(first_unknown_of(leaning[own].points[i]) +
                                     d);
          unknowns.entries.push_back(3 * (local.multiplier + 1 + i) + d);
        }
    add_forces(assembler, unknowns, 1., local.R, local.K);
  }
} // namespace demold
