// SPDX-License-Identifier: LGPL-2.1-or-later
// A press cycle on a mesh: temperature and f90 at every node.
#include "cure/heat_conduction.h"

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_values.h>

#include <deal.II/grid/grid_tools.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Longer steps are divided for the quadrature of f90 [s].
    constexpr double longest_piece = 5.;

    /// int dt/t90 over @p step for every node, added to @p f90.
    void add_equivalent_time(const ThermalStep   &step,
                             const ArrheniusTime &t90,
                             Vector<double>      &f90)
    {
      const QGauss<1>    quadrature(3);
      const unsigned int n_pieces = static_cast<unsigned int>(
        std::ceil((step.end - step.start) / longest_piece));
      const double h = (step.end - step.start) / n_pieces;
      for (unsigned int piece = 0; piece < n_pieces; ++piece)
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            const double t = step.start + (piece + quadrature.point(q)[0]) * h;
            for (unsigned int i = 0; i < f90.size(); ++i)
              f90[i] += quadrature.weight(q) * h / t90(step.temperature(i, t));
          }
    }
  } // namespace



  template <int dim>
  HeatConduction<dim>::HeatConduction(
    const Triangulation<dim, dim>            &triangulation,
    const PressCycle                         &cycle,
    const std::map<types::boundary_id, Side> &sides)
    : cycle(cycle)
    , element(1)
    , mapping(1)
    , dof_handler(triangulation)
  {
    dof_handler.distribute_dofs(element);
    assemble_body();
    assemble_surface(sides);
    cell_hint = dof_handler.begin_active();
  }



  template <int dim>
  void HeatConduction<dim>::assemble_body()
  {
    DynamicSparsityPattern pattern(dof_handler.n_dofs());
    DoFTools::make_sparsity_pattern(dof_handler, pattern);
    SparsityPattern sparsity;
    sparsity.copy_from(pattern);
    SparseMatrix<double> conductivity(sparsity);
    network.capacity.assign(dof_handler.n_dofs(), 0.);

    FEValues<dim>                        fe_values(mapping,
                            element,
                            QGauss<dim>(2),
                            update_values | update_gradients |
                              update_JxW_values);
    const unsigned int                   n = element.n_dofs_per_cell();
    FullMatrix<double>                   cell_matrix(n, n);
    std::vector<types::global_dof_index> nodes(n);
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        fe_values.reinit(cell);
        cell->get_dof_indices(nodes);
        cell_matrix = 0.;
        for (const unsigned int q : fe_values.quadrature_point_indices())
          for (unsigned int i = 0; i < n; ++i)
            {
              network.capacity[nodes[i]] += cycle.material.heat_capacity *
                                            fe_values.shape_value(i, q) *
                                            fe_values.JxW(q);
              for (unsigned int j = 0; j < n; ++j)
                cell_matrix(i, j) +=
                  cycle.material.conductivity * fe_values.shape_grad(i, q) *
                  fe_values.shape_grad(j, q) * fe_values.JxW(q);
            }
        conductivity.add(nodes, cell_matrix);
      }
    for (unsigned int i = 0; i < conductivity.m(); ++i)
      for (auto entry = conductivity.begin(i); entry != conductivity.end(i);
           ++entry)
        if (entry->column() > i)
          network.links.push_back(
            {i, static_cast<unsigned int>(entry->column()), -entry->value()});
  }



  template <int dim>
  void HeatConduction<dim>::assemble_surface(
    const std::map<types::boundary_id, Side> &sides)
  {
    FEFaceValues<dim>                                       face_values(mapping,
                                  element,
                                  QGauss<dim - 1>(2),
                                  update_values | update_JxW_values);
    std::map<std::pair<unsigned int, unsigned int>, double> areas;
    std::vector<types::global_dof_index> nodes(element.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        {
          const auto side = cell->face(f)->at_boundary() ?
                              sides.find(cell->face(f)->boundary_id()) :
                              sides.end();
          if (side == sides.end())
            continue;
          face_values.reinit(cell, f);
          cell->get_dof_indices(nodes);
          for (unsigned int i = 0; i < nodes.size(); ++i)
            if (element.has_support_on_face(i, f))
              for (const unsigned int q :
                   face_values.quadrature_point_indices())
                areas[{nodes[i], static_cast<unsigned int>(side->second)}] +=
                  face_values.shape_value(i, q) * face_values.JxW(q);
        }
    for (const auto &[node_side, area] : areas)
      network.surface.push_back({node_side.first, node_side.second, area});
  }



  template <int dim>
  std::vector<double> HeatConduction<dim>::run(const ArrheniusTime &t90)
  {
    const double        opening = std::min(cycle.opening_time, cycle.end_time);
    std::vector<double> T(dof_handler.n_dofs(), cycle.initial_temperature);
    std::vector<double> times;
    Vector<double>      f90(dof_handler.n_dofs());
    const auto          on_step = [&](const ThermalStep &step) {
      add_equivalent_time(step, t90, f90);
      times.push_back(step.end);
    };
    const auto fields = [&]() {
      return Fields{Vector<double>(T.begin(), T.end()), f90};
    };
    conduct_heat(network,
                 {cycle.mould, cycle.bladder},
                 0.,
                 opening,
                 cycle.tolerances,
                 T,
                 on_step);
    at_opening = fields();
    if (opening < cycle.end_time)
      conduct_heat(network,
                   {cycle.air, cycle.air},
                   opening,
                   cycle.end_time,
                   cycle.tolerances,
                   T,
                   on_step);
    at_end = fields();
    return times;
  }



  template <int dim>
  double HeatConduction<dim>::value_at(const Vector<double> &field,
                                       const Point<dim>     &point) const
  {
    // Asked cell by cell, the last cell is nearly always the right one.
    Point<dim> unit;
    bool       inside = false;
    try
      {
        unit   = mapping.transform_real_to_unit_cell(cell_hint, point);
        inside = GeometryInfo<dim>::is_inside_unit_cell(unit, 1e-10);
      }
    catch (const typename Mapping<dim>::ExcTransformationFailed &)
      {}
    if (!inside)
      std::tie(cell_hint, unit) =
        GridTools::find_active_cell_around_point(mapping, dof_handler, point);
    double value = 0.;
    for (const unsigned int v : cell_hint->vertex_indices())
      value += field[cell_hint->vertex_dof_index(v, 0)] *
               GeometryInfo<dim>::d_linear_shape_function(unit, v);
    return value;
  }



  template class HeatConduction<2>;
  template class HeatConduction<3>;
} // namespace demold
