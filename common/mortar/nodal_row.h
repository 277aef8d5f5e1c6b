// SPDX-License-Identifier: LGPL-2.1-or-later
// One row of the mortar operators: the weighted gap of a point as a sum over
// nodes.
#ifndef demold_mortar_nodal_row_h
#define demold_mortar_nodal_row_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace demold
{
  /// Row A of the mortar operators D and M (theory B1, B2), as one list over
  /// slave and master nodes in the numbering of MortarSurfaces:
  ///   weighted gap   sum_k w_k x_k,   w = -D_AB on slave, +M_AC on master
  ///   nodes force          R_k = w_k lambda_A   (residual of node k,
  ///   theory 2.84)
  struct NodalRow
  {
    std::vector<unsigned int> nodes;
    std::vector<double>       weights;   ///< w_k [mm^2]
    double                    area = 0.; ///< sum over B of D_AB [mm^2]

    /// dw_k/dx_l [mm], and darea/dx_l [mm]; empty without derivatives.
    std::vector<std::vector<dealii::Tensor<1, 3>>> dweights;
    std::vector<dealii::Tensor<1, 3>>              darea;

    bool has_derivatives = false;

    /// Position of a node in the list, appended where it is new.
    unsigned int position(const unsigned int node)
    {
      for (unsigned int k = 0; k < nodes.size(); ++k)
        if (nodes[k] == node)
          return k;
      nodes.push_back(node);
      weights.push_back(0.);
      if (has_derivatives)
        {
          darea.emplace_back();
          dweights.emplace_back();
          for (auto &row : dweights)
            row.resize(nodes.size());
        }
      return nodes.size() - 1;
    }

    /// The same row without its derivatives.
    NodalRow values() const
    {
      NodalRow row;
      row.nodes   = nodes;
      row.weights = weights;
      row.area    = area;
      return row;
    }

    std::size_t bytes() const
    {
      return nodes.size() * (sizeof(unsigned int) + sizeof(double));
    }

    /// Weights and area, not the derivatives.
    template <typename Archive>
    void serialize(Archive &archive)
    {
      unsigned int n = nodes.size();
      archive &n  &area;
      nodes.resize(n);
      weights.resize(n);
      for (unsigned int k = 0; k < n; ++k)
        archive &nodes[k] & weights[k];
    }
  };
} // namespace demold

#endif
