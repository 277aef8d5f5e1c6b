// SPDX-License-Identifier: LGPL-2.1-or-later
// Where paths cross: off the one that is followed, along the eigenvector.
#include "solution/path_follower.h"
#include "solution/softening_overview.h"
#include "weak_form/weak_form.h"

#include <algorithm>
#include <cstdio>

namespace demold
{
  namespace
  {
    /// [mm] norm of the nodal displacements that show what a mode opens.
    constexpr double probe = 1e-7;

    /// What counts as opening, over the largest one: the rest is noise of the
    /// inverse iteration.
    constexpr double clear = 1e-2;
  } // namespace

  /// With two negative pivots points soften together that need not (theory
  /// D.3). Those go on which the eigenvector opens, the others unload: a
  /// perturbation of the displacements alone would not do, as the predictor of
  /// a step along which all of them soften takes it back.
  bool PathFollower::try_branch(const Points &points)
  {
    if (!tools.path.branch || is_cylindrical() ||
        stability.negative_pivots < 2 || !(stability.smallest_eigenvalue < 0.))
      return false;
    weak_form.update(mode, probe);
    weak_form.assemble(false, 0);
    const Points        moved = softening_sites(weak_form);
    std::vector<double> opens(points.size(), 0.);
    double              most = 0., least = 0.;
    for (std::size_t k = 0; k < points.size(); ++k)
      if (is_critical(points[k]))
        {
          opens[k] = moved[k].effective - points[k].effective;
          most     = std::max(most, opens[k]);
          least    = std::min(least, opens[k]);
        }
    most                 = max_over_ranks(weak_form, most);
    least                = -max_over_ranks(weak_form, -least);
    const double largest = std::max(most, -least);
    if (std::min(most, -least) <= clear * largest)
      return false; // all of them open together
    // An eigenvector has no sign: towards the point that opens most.
    const double sign = most >= -least ? 1. : -1.;
    unsigned int n    = 0;
    for (const double change : opens)
      n += sign * change > clear * largest ? 1 : 0;
    // Asked point by point in their order, once or more.
    std::size_t  k       = 0;
    const Chosen goes_on = [&](const SofteningSite &) {
      return sign * opens[k++ % opens.size()] > clear * largest;
    };
    if (!try_path(goes_on, false))
      return false;
    char text[160];
    std::snprintf(text,
                  sizeof(text),
                  "time %.6g s: onto another branch at a bifurcation: along "
                  "the eigenvector %.0f points soften, not all",
                  weak_form.time(),
                  sum_over_ranks(weak_form, n));
    result.events.emplace_back(text);
    tools.note(text);
    return true;
  }
} // namespace demold
