// SPDX-License-Identifier: LGPL-2.1-or-later
// Mortar integrals over the part a slave and a master face have in common.
#include "mortar/pair_integrals.templates.h"

namespace demold
{
  template PairIntegrals<double> integrate_pair(const FaceNodes<double> &,
                                                const FaceNodes<double> &,
                                                const unsigned int,
                                                const PairOptions &);

  FaceNodes<double> face_nodes(const FacetPositions &facet)
  {
    return {{facet.x[0], facet.x[1], facet.x[2], facet.x[3]}};
  }

  PairIntegrals<double> integrate_pair(const FacetPositions &slave,
                                       const FacetPositions &master,
                                       const PairOptions    &options)
  {
    return integrate_pair(face_nodes(slave),
                          face_nodes(master),
                          slave.n_nodes,
                          options);
  }
} // namespace demold
