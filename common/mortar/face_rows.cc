// SPDX-License-Identifier: LGPL-2.1-or-later
// Mortar integrals of one slave face with all facets opposite.
#include "mortar/face_rows.h"

#include "mortar/dual_basis.h"

#include <algorithm>

namespace demold
{
  using namespace dealii;

  FaceRows::FaceRows(const Facet &face, const bool has_derivatives)
    : n_slave(face.n_nodes)
    , nodes(face.nodes.begin(), face.nodes.begin() + face.n_nodes)
    , has_derivatives(has_derivatives)
  {
    for (unsigned int a = 0; a < n_slave; ++a)
      entries[a].resize(n_slave);
  }

  unsigned int FaceRows::position(const unsigned int node)
  {
    const auto found = std::find(nodes.begin() + n_slave, nodes.end(), node);
    if (found != nodes.end())
      return found - nodes.begin();
    nodes.push_back(node);
    for (unsigned int a = 0; a < n_slave; ++a)
      entries[a].emplace_back();
    return nodes.size() - 1;
  }

  void FaceRows::add(const PairIntegrals<double>       &pair,
                     const std::array<unsigned int, 4> &master_nodes)
  {
    if (!pair.overlaps)
      return;
    for (unsigned int k = 0; k < n_slave; ++k)
      {
        const unsigned int c = position(master_nodes[k]);
        for (unsigned int a = 0; a < n_slave; ++a)
          {
            entries[a][k].value += pair.D[a][k];
            entries[a][c].value += pair.M[a][k];
          }
      }
  }

  void FaceRows::add(const PairGradients               &pair,
                     const std::array<unsigned int, 4> &master_nodes)
  {
    if (!pair.value.overlaps)
      return;
    add(pair.value, master_nodes);
    std::vector<unsigned int> places;
    for (unsigned int k = 0; k < n_slave; ++k)
      places.push_back(k);
    for (unsigned int k = 0; k < n_slave; ++k)
      places.push_back(position(master_nodes[k]));
    for (unsigned int a = 0; a < n_slave; ++a)
      for (unsigned int k = 0; k < n_slave; ++k)
        {
          add_changes(pair.dD[a][k], places, entries[a][k]);
          add_changes(pair.dM[a][k], places, entries[a][places[n_slave + k]]);
        }
  }

  void FaceRows::add_changes(const PairGradient              &gradient,
                             const std::vector<unsigned int> &places,
                             Entry                           &entry) const
  {
    entry.change.resize(nodes.size());
    for (unsigned int k = 0; k < places.size(); ++k)
      for (unsigned int d = 0; d < 3; ++d)
        entry.change[places[k]][d] += gradient[3 * k + d];
  }

  void FaceRows::make_dual()
  {
    const auto block = [&](const unsigned int first, const auto &part) {
      NodeMatrix<double> matrix{};
      for (unsigned int a = 0; a < n_slave; ++a)
        for (unsigned int k = 0; k < n_slave; ++k)
          if (first + k < nodes.size())
            matrix[a][k] = part(entries[a][first + k]);
      return matrix;
    };
    const auto set_block = [&](const unsigned int        first,
                               const NodeMatrix<double> &matrix,
                               const auto               &part) {
      for (unsigned int a = 0; a < n_slave; ++a)
        for (unsigned int k = 0; k < n_slave; ++k)
          if (first + k < nodes.size())
            part(entries[a][first + k]) = matrix[a][k];
    };
    const auto value = [](auto &entry) -> auto &
    {
      return entry.value;
    };
    const auto diagonal = [&](const NodeMatrix<double> &D) {
      NodeMatrix<double> result{};
      const auto         sums = dual_D(D, n_slave);
      for (unsigned int a = 0; a < n_slave; ++a)
        result[a][a] = sums[a];
      return result;
    };

    const NodeMatrix<double> D     = block(0, value);
    const DualBasis          basis = dual_basis(D, n_slave);
    const unsigned int       n     = nodes.size();
    for (auto &row : entries)
      for (Entry &entry : row)
        entry.change.resize(has_derivatives ? n : 0);

    // The derivatives first: they need the standard values.
    for (unsigned int l = 0; l < (has_derivatives ? n : 0); ++l)
      for (unsigned int d = 0; d < 3; ++d)
        {
          const auto change = [&](auto &entry) -> auto &
          {
            return entry.change[l][d];
          };
          const NodeMatrix<double> dD = block(0, change);
          const NodeMatrix<double> dA = dual_basis_change(basis, dD);
          for (unsigned int first = n_slave; first < n; first += n_slave)
            set_block(first,
                      dual_M_change(basis,
                                    dA,
                                    block(first, value),
                                    block(first, change)),
                      change);
          set_block(0, diagonal(dD), change);
        }
    for (unsigned int first = n_slave; first < n; first += n_slave)
      set_block(first, dual_M(basis, block(first, value)), value);
    set_block(0, diagonal(D), value);
  }

  void FaceRows::add_to(NodalRow &row, const unsigned int a) const
  {
    if (nodes.size() == n_slave) // nothing opposite
      return;
    std::vector<unsigned int> places;
    for (const unsigned int node : nodes)
      places.push_back(row.position(node));
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const Entry &entry = entries[a][k];
        const double sign  = k < n_slave ? -1. : 1.;
        row.weights[places[k]] += sign * entry.value;
        if (k < n_slave)
          row.area += entry.value;
        if (!row.has_derivatives)
          continue;
        for (unsigned int l = 0; l < entry.change.size(); ++l)
          {
            row.dweights[places[k]][places[l]] += sign * entry.change[l];
            if (k < n_slave)
              row.darea[places[l]] += entry.change[l];
          }
      }
  }
} // namespace demold
