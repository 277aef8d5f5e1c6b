// SPDX-License-Identifier: LGPL-2.1-or-later
// Rows of the mortar operators D and M for the points that need them.
#include "mortar/mortar_operator.h"

#include "mortar/face_rows.h"
#include "mortar/nodal_normal.h"
#include "mortar/pair_gradients.h"

#include <algorithm>

namespace demold
{
  using namespace dealii;

  MortarOperator::MortarOperator(const MortarSurfaces &surfaces,
                                 const PairOptions    &options,
                                 const bool            dual)
    : surfaces(surfaces)
    , options(options)
    , dual(dual)
    , own_of_point(surfaces.points().size(), numbers::invalid_unsigned_int)
  {
    for (unsigned int own = 0; own < surfaces.own_points().size(); ++own)
      own_of_point[surfaces.own_points()[own]] = own;
  }

  FaceRows MortarOperator::integrate(const unsigned int face,
                                     const bool         with_derivatives) const
  {
    const ContactSurface &master = surfaces.master().surface;
    const auto            own    = surfaces.slave().facet_positions(face);
    const DerivedBy       by     = surfaces.master().is_rigid() ?
                                     DerivedBy::slave :
                                     DerivedBy::slave_and_master;
    FaceRows              rows(surfaces.slave().facet(face), with_derivatives);
    for (const unsigned int f : surfaces.opposite(face))
      {
        const auto                  other = master.facet_positions(f);
        std::array<unsigned int, 4> nodes = master.facet(f).nodes;
        for (unsigned int &node : nodes)
          node += surfaces.n_slave_nodes();
        if (with_derivatives)
          rows.add(pair_gradients(own, other, options, by), nodes);
        else
          rows.add(integrate_pair(own, other, options), nodes);
      }
    if (dual)
      rows.make_dual();
    return rows;
  }

  std::vector<NodalRow>
  MortarOperator::rows(const std::vector<RowDemand> &demand) const
  {
    std::vector<NodalRow> result(demand.size());
    for (unsigned int own = 0; own < demand.size(); ++own)
      result[own].has_derivatives = demand[own] == RowDemand::derivatives;
    for (unsigned int face = 0; face < surfaces.slave().n_facets(); ++face)
      {
        RowDemand most = RowDemand::nothing;
        for (const unsigned int own : own_points_of(face))
          most = std::max(most, own_demand(demand, own));
        if (most == RowDemand::nothing)
          continue;
        const FaceRows face_rows =
          integrate(face, most == RowDemand::derivatives);
        const auto owns = own_points_of(face);
        for (unsigned int a = 0; a < owns.size(); ++a)
          if (own_demand(demand, owns[a]) != RowDemand::nothing)
            face_rows.add_to(result[owns[a]], a);
      }
    return result;
  }

  std::vector<unsigned int>
  MortarOperator::own_points_of(const unsigned int face) const
  {
    std::vector<unsigned int> owns;
    for (unsigned int a = 0; a < surfaces.slave().facet(face).n_nodes; ++a)
      owns.push_back(own_of_point[surfaces.point_of(face, a)]);
    return owns;
  }

  RowDemand MortarOperator::own_demand(const std::vector<RowDemand> &demand,
                                       const unsigned int            own)
  {
    return own == numbers::invalid_unsigned_int ? RowDemand::nothing :
                                                  demand[own];
  }

  std::vector<PointNormal> MortarOperator::normals() const
  {
    std::vector<PointNormal> result;
    for (const unsigned int p : surfaces.own_points())
      {
        const SlavePoint       &point = surfaces.points()[p];
        std::vector<FaceAround> around;
        for (const unsigned int f : point.facets)
          {
            const auto &nodes = surfaces.slave().facet(f).nodes;
            around.push_back(
              {surfaces.slave().facet_positions(f),
               static_cast<unsigned int>(
                 std::find(nodes.begin(), nodes.end(), point.node) -
                 nodes.begin())});
          }
        const NodalNormal averaged = nodal_normal(around);
        PointNormal       normal;
        normal.n = averaged.n;
        for (unsigned int k = 0; k < point.facets.size(); ++k)
          for (unsigned int i = 0; i < around[k].face.n_nodes; ++i)
            normal.add(surfaces.slave().facet(point.facets[k]).nodes[i],
                       averaged.dn[k][i]);
        result.push_back(normal);
      }
    return result;
  }
} // namespace demold
