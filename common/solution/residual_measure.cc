// SPDX-License-Identifier: LGPL-2.1-or-later
// How large a residual is, beside the forces and beside round-off.
#include "solution/residual_measure.h"

#include "weak_form/weak_form.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  namespace
  {
    /// An iteration that has run away has so much round-off that any residual
    /// would do; a sound one has not many times that of the first.
    constexpr double growth = 100.;

    /// Of the displacements, and of F = 1 + H in a body at rest, whose elements
    /// are of the order of a millimetre.
    double round_off_of(const WeakForm &weak_form)
    {
      return weak_form.matrix.linfty_norm() *
             (1e-14 * weak_form.residual_norms().unknowns +
              1e-15 * std::sqrt(static_cast<double>(weak_form.n_unknowns())));
    }
  } // namespace

  double ResidualMeasure::operator()(const WeakForm &weak_form,
                                     const double    largest_force,
                                     const bool      with_tangent)
  {
    const ResidualNorms norms = weak_form.residual_norms();
    if (with_tangent)
      {
        const double found = round_off_of(weak_form);
        if (largest_sane < 0.)
          largest_sane = growth * found;
        round_off = std::min(found, largest_sane);
      }
    const double scale = std::max({norms.scale, 1e-4 * largest_force, 1e-300});
    return std::max(std::max(norms.free, norms.extra) - round_off, 0.) / scale;
  }
} // namespace demold
