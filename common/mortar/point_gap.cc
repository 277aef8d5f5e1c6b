// SPDX-License-Identifier: LGPL-2.1-or-later
// The gap vector of a multiplier point and how it depends on the nodes.
#include "mortar/point_gap.h"


#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>

namespace demold
{
  using namespace dealii;

  namespace
  {
    const Tensor<2, 3> unit = unit_symmetric_tensor<3>();

    /// A gap over the nodes with unknowns of all @p lists, with the derivatives
    /// of the normal.
    PointGap
    over_nodes(const MortarSurfaces                                 &surfaces,
               const PointNormal                                    &normal,
               const std::vector<const std::vector<unsigned int> *> &lists)
    {
      PointGap gap;
      for (const auto *list : lists)
        for (const unsigned int node : *list)
          if (!surfaces.is_rigid(node))
            gap.position(node);
      for (unsigned int k = 0; k < normal.nodes.size(); ++k)
        gap.dnormal[gap.position(normal.nodes[k])] = normal.dn[k];
      return gap;
    }

    /// Calls @p f with the place in @p row and in @p gap of every node that
    /// has unknowns.
    template <typename Function>
    void for_each_moving(const MortarSurfaces &surfaces,
                         const NodalRow       &row,
                         const PointGap       &gap,
                         const Function       &f)
    {
      for (unsigned int k = 0; k < row.nodes.size(); ++k)
        if (!surfaces.is_rigid(row.nodes[k]))
          f(k,
            std::find(gap.nodes.begin(), gap.nodes.end(), row.nodes[k]) -
              gap.nodes.begin());
    }

    /// Adds a times the derivative of sum_k w_k x_k, and that of the area.
    void add_derivative(const MortarSurfaces &surfaces,
                        const NodalRow       &row,
                        const Tensor<2, 3>   &a,
                        PointGap             &gap)
    {
      for_each_moving(surfaces, row, gap, [&](const auto l, const auto place) {
        Tensor<2, 3> change = row.weights[l] * unit;
        if (row.has_derivatives)
          {
            for (unsigned int k = 0; k < row.nodes.size(); ++k)
              change +=
                outer_product(surfaces.x(row.nodes[k]), row.dweights[k][l]);
            gap.darea[place] = row.darea[l];
          }
        gap.dgap[place] += a * change;
      });
    }
  } // namespace

  Tensor<1, 3> weighted_gap(const MortarSurfaces &surfaces, const NodalRow &row)
  {
    Tensor<1, 3> sum;
    for (unsigned int k = 0; k < row.nodes.size(); ++k)
      sum += row.weights[k] * surfaces.x(row.nodes[k]);
    return sum;
  }

  unsigned int PointGap::position(const unsigned int node)
  {
    const auto found = std::find(nodes.begin(), nodes.end(), node);
    if (found != nodes.end())
      return found - nodes.begin();
    nodes.push_back(node);
    dgap.emplace_back();
    dnormal.emplace_back();
    darea.emplace_back();
    return nodes.size() - 1;
  }

  NodalRow slave_side(const MortarSurfaces &surfaces, const NodalRow &row)
  {
    NodalRow result;
    result.area = row.area;
    for (unsigned int k = 0; k < row.nodes.size(); ++k)
      if (surfaces.is_slave(row.nodes[k]))
        {
          const unsigned int position = result.position(row.nodes[k]);
          result.weights[position]    = row.weights[k];
        }
    return result;
  }

  Point<3> slave_point(const MortarSurfaces &surfaces, const NodalRow &row)
  {
    return Point<3>(weighted_gap(surfaces, slave_side(surfaces, row)) /
                    -row.area);
  }

  PointGap frozen_point_gap(const MortarSurfaces &surfaces,
                            const NodalRow       &row,
                            const Tensor<1, 3>   &offset,
                            const PointNormal    &normal)
  {
    PointGap gap = over_nodes(surfaces, normal, {&row.nodes, &normal.nodes});
    gap.area     = row.area;
    gap.gap      = (offset + weighted_gap(surfaces, row)) / row.area;
    add_derivative(surfaces, row, unit / row.area, gap);
    return gap;
  }

  PointGap current_point_gap(const MortarSurfaces &surfaces,
                             const NodalRow       &row,
                             const NodalRow       &old_row,
                             const PointNormal    &normal)
  {
    PointGap gap =
      over_nodes(surfaces, normal, {&row.nodes, &old_row.nodes, &normal.nodes});
    const Tensor<1, 3> &n      = normal.n;
    const Tensor<2, 3>  along  = outer_product(n, n);
    const Tensor<1, 3>  opened = weighted_gap(surfaces, row);
    const bool          slides = !old_row.nodes.empty();
    const Tensor<2, 3>  across = slides ? unit - along : Tensor<2, 3>();
    const Tensor<1, 3>  slid =
      slides ? weighted_gap(surfaces, old_row) - opened : Tensor<1, 3>();

    gap.area = row.area;
    gap.gap  = (along * opened + across * slid) / row.area;
    add_derivative(surfaces, row, (along - across) / row.area, gap);
    for_each_moving(surfaces,
                    old_row,
                    gap,
                    [&](const auto l, const auto place) {
                      gap.dgap[place] += old_row.weights[l] / row.area * across;
                    });
    const Tensor<1, 3> turning = opened - slid;
    for (unsigned int l = 0; l < gap.nodes.size(); ++l)
      {
        gap.dgap[l] += (n * turning) / row.area * gap.dnormal[l] +
                       outer_product(n, turning * gap.dnormal[l]) / row.area;
        gap.dgap[l] -= outer_product(gap.gap, gap.darea[l]) / row.area;
      }
    return gap;
  }
} // namespace demold
