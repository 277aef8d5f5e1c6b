// SPDX-License-Identifier: LGPL-2.1-or-later
// Derivatives of the mortar integrals of two lines.
#ifndef demold_mortar_pair_gradients_2d_h
#define demold_mortar_pair_gradients_2d_h

#include "mortar/pair_gradients.h"

namespace demold
{
  /// pair_gradients() of two lines in the x-y plane, by automatic
  /// differentiation with respect to the x and y of their nodes.
  PairGradients pair_gradients_2d(const FaceNodes<double> &slave,
                                  const FaceNodes<double> &master,
                                  const PairOptions       &options,
                                  const DerivedBy          derived_by);
} // namespace demold

#endif
