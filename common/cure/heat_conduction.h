// SPDX-License-Identifier: LGPL-2.1-or-later
// A press cycle on a mesh: temperature and f90 at every node.
#ifndef demold_cure_heat_conduction_h
#define demold_cure_heat_conduction_h

#include "cure/arrhenius.h"
#include "cure/press_cycle.h"

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q.h>

#include <deal.II/lac/vector.h>

#include <map>
#include <vector>

namespace demold
{
  /// Temperature and equivalent curing time of a block over a press cycle, as
  /// PressCycle describes it: linear elements with lumped heat capacity,
  /// ARKODE in time, f90 by Gauss quadrature in time at every node. Heat
  /// conduction does not know the cure (the heat of the reaction is neglected).
  /// Every rank computes the whole of @p triangulation, which must be serial
  /// and outlive this. A slice (dim = 2) conducts no heat across its plane.
  template <int dim>
  class HeatConduction
  {
  public:
    /// What a boundary touches in the press. Boundaries not named are
    /// insulated throughout (symmetry); mould and bladder sides meet the air
    /// after the opening.
    enum class Side
    {
      mould   = 0,
      bladder = 1
    };

    HeatConduction(const dealii::Triangulation<dim, dim> &triangulation,
                   const PressCycle                      &cycle,
                   const std::map<dealii::types::boundary_id, Side> &sides);
    HeatConduction(const HeatConduction &) = delete;

    /// Runs the cycle for a compound with @p t90 over temperature. Steps of the
    /// integrator are returned by their end times [s].
    std::vector<double> run(const ArrheniusTime &t90);

    /// The state at the opening and at the end of the cycle, one entry a node.
    struct Fields
    {
      dealii::Vector<double> temperature; ///< [degC]
      dealii::Vector<double> f90;         ///< [-]
    };
    Fields at_opening, at_end;

    /// @p field at a point of the mesh. Points of one cell after the other are
    /// found fast.
    double value_at(const dealii::Vector<double> &field,
                    const dealii::Point<dim>     &point) const;

    /// The nodes: for pictures and for integrals over cells.
    const dealii::DoFHandler<dim> &nodes() const
    {
      return dof_handler;
    }

  private:
    void assemble_body();
    void
    assemble_surface(const std::map<dealii::types::boundary_id, Side> &sides);

    const PressCycle        cycle;
    dealii::FE_Q<dim>       element;
    dealii::MappingQ<dim>   mapping;
    dealii::DoFHandler<dim> dof_handler;
    ThermalNetwork          network;

    mutable typename dealii::DoFHandler<dim>::active_cell_iterator cell_hint;
  };
} // namespace demold

#endif
