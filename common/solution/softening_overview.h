// SPDX-License-Identifier: LGPL-2.1-or-later
// All points of a weak form that may soften, over terms and ranks.
#ifndef demold_solution_softening_overview_h
#define demold_solution_softening_overview_h

#include "weak_form/algebra.h"
#include "weak_form/softening_sites.h"

#include <functional>
#include <vector>

namespace demold
{
  class WeakForm;

  /// From this utilisation on a point is on the verge of softening.
  constexpr double critical_utilisation = 1. - 1e-4;

  /// Is it, with something left to give?
  bool is_critical(const SofteningSite &site);

  /// Points of this rank at the trial, term by term.
  std::vector<SofteningSite> softening_sites(const WeakForm &weak_form);

  /// Lets those points soften in the next predictor of which @p chosen says
  /// so; returns how many, over all ranks.
  unsigned int drive(WeakForm &weak_form,
                     const std::function<bool(const SofteningSite &)> &chosen);

  /// Adds @p factor times d(gap . along)/du of @p point to @p h, which the
  /// caller compresses.
  void add_gap_gradient(const SofteningSite        &point,
                        const dealii::Tensor<1, 3> &along,
                        const double                factor,
                        Vector                     &h);

  /// Sum or largest over all ranks.
  double sum_over_ranks(const WeakForm &weak_form, const double of_this_rank);
  double max_over_ranks(const WeakForm &weak_form, const double of_this_rank);
} // namespace demold

#endif
