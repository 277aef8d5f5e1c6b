// SPDX-License-Identifier: LGPL-2.1-or-later
// The points of a path, by their columns in history.csv.
#ifndef demold_tests_step_arclength_path_points_h
#define demold_tests_step_arclength_path_points_h

#include "closed_forms.h"
#include "run_scene.h"

namespace demold
{
  inline SceneRun run_arclength(const std::string              &scene,
                                const std::vector<std::string> &overrides = {})
  {
    return run_scene(DEMOLD_STEP_ARCLENGTH,
                     DEMOLD_SOURCE_DIR "/prm/step-arclength/" + scene,
                     overrides);
  }

  struct PathRow
  {
    double u, F, clock, adhesion, bonded;
    int    negative_pivots;
    double eigenvalue; ///< [N/mm]
  };

  inline std::vector<PathRow> path_rows(const SceneRun &run)
  {
    const auto          &h = run.history;
    std::vector<PathRow> rows;
    for (std::size_t i = 0; i < h.n_rows(); ++i)
      rows.push_back({h["opening [mm]"][i],
                      h["force [N]"][i],
                      h["time [s]"][i],
                      h["adhesion dissipation [mJ]"][i],
                      h["bonded area [mm^2]"][i],
                      static_cast<int>(h["negative pivots"][i]),
                      h["smallest eigenvalue [N/mm]"][i]});
    return rows;
  }

  /// A spring in series with a bond, per unit area: theory E.1a.
  struct SpringAndBond
  {
    double k;
    Bond   bond;

    double peak_opening() const
    {
      return bond.strength / k + bond.onset();
    }

    /// Distance of a point to the path, over the peak.
    double deviation(const double u, const double t) const
    {
      const double elastic = std::abs(u - t / k - t / bond.penalty);
      const double softens =
        std::abs(u - t / k - bond.rupture +
                 t * (bond.rupture - bond.onset()) / bond.strength);
      const double free =
        std::max(std::abs(t) / k, std::max(0., bond.rupture - u));
      return std::min({elastic, softens, free}) / peak_opening();
    }

    double released() const
    {
      return std::max(0., .5 * bond.strength * (peak_opening() - bond.rupture));
    }
  };
} // namespace demold

#endif
