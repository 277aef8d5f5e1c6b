// SPDX-License-Identifier: LGPL-2.1-or-later
// Rubber on a rigid body that is bonded within a circle, and lets go from its
// border.
#ifndef demold_tests_step_arclength_circular_front_h
#define demold_tests_step_arclength_circular_front_h

#include "step-arclength/path_points.h"

namespace demold
{
  constexpr double pi = 3.14159265358979323846;

  /// Of the rubber of jkr.prm and punch.prm: E = 3 MPa, nu = 0.49.
  constexpr double reduced_modulus = 3. / (1. - .49 * .49); // E* [MPa]

  struct FrontRow
  {
    double u; ///< opening [mm]
    double F; ///< [N]
    double a; ///< radius of what has not released its energy [mm]
    bool   bonded;
    bool   envelope; ///< a machine comes here: its clock goes on
  };

  /// @p w is the work of separation [mJ/mm^2]. The radius goes by the energy:
  /// a cohesive zone counts as what it has released.
  inline std::vector<FrontRow> front_rows(const SceneRun &run, const double w)
  {
    const auto           &h      = run.history;
    const auto           &bonded = h["bonded area [mm^2]"];
    const auto           &clock  = h["time [s]"];
    const double          area   = *std::max_element(bonded.begin(), //
                                          bonded.end());
    std::vector<FrontRow> rows;
    for (std::size_t i = 0; i < h.n_rows(); ++i)
      {
        const double left = area - h["adhesion dissipation [mJ]"][i] / w;
        rows.push_back({h["opening [mm]"][i],
                        h["force [N]"][i],
                        std::sqrt(std::max(left, 0.) / pi),
                        bonded[i] > 0.,
                        i == 0 || clock[i] > clock[i - 1]});
      }
    return rows;
  }
} // namespace demold

#endif
