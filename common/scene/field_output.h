// SPDX-License-Identifier: LGPL-2.1-or-later
// ParaView files of the rubber: displacement, stress, cure, interface.
#ifndef demold_scene_field_output_h
#define demold_scene_field_output_h

#include "contact/interface_term.h"
#include "scene/file_series.h"
#include "solid/cell_results.h"
#include "weak_form/algebra.h"

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_q.h>

#include <map>
#include <string>
#include <vector>

namespace demold
{
  /// Writes fields/NNNN.vtu (one file, written by all ranks) and fields.pvd.
  /// At the nodes: `displacement` [mm]; where there is an interface also
  /// `contact_pressure` [MPa], `damage` [-], `interface_state` (theory C.5, 0
  /// to 5; 6: free; -1: no slave node) and `gap` [mm], at most the search
  /// distance. Where slave points share a node, the largest pressure, damage
  /// and state and the smallest gap are shown. A mean per cell: Cauchy
  /// `stress_xx` ... [MPa], `largest_principal_tension` [MPa],
  /// `largest_principal_stretch` [-] and `cure` (f90) [-].
  template <int dim>
  class FieldOutput
  {
  public:
    /// @p dof_handler and @p solids must live as long as this.
    FieldOutput(const dealii::DoFHandler<dim, dim>     &dof_handler,
                const std::vector<const CellResults *> &solids,
                double                                  search_distance,
                const std::string                      &output_folder);

    /// Collective. @p displacement owned entries; @p interface may be null;
    /// @p time [s].
    void write(const Vector        &displacement,
               const InterfaceTerm *interface,
               double               time);

    FileSeries series;

  private:
    /// What a node of the interface shows, in the order of the names above.
    struct PointField
    {
      std::string                                       name;
      double                                            elsewhere;
      std::map<dealii::types::global_dof_index, double> values;
    };

    std::vector<PointField> point_fields(const InterfaceTerm &interface) const;
    void                    find_nodes();

    const dealii::DoFHandler<dim, dim>    &dof_handler;
    const std::vector<const CellResults *> solids;
    const double                           search_distance;

    /// One unknown per node, and which one belongs to the node with a given
    /// first displacement unknown, for nodes of boundary cells.
    const dealii::FE_Q<dim> node_element;
    dealii::DoFHandler<dim> nodes;
    std::map<dealii::types::global_dof_index, dealii::types::global_dof_index>
      node_of_unknown;
  };
} // namespace demold

#endif
