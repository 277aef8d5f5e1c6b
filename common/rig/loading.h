// SPDX-License-Identifier: LGPL-2.1-or-later
// What the grips do over time: a prescribed strain or stress.
#ifndef demold_rig_loading_h
#define demold_rig_loading_h

#include <functional>
#include <vector>

namespace demold
{
  /// A programme from time 0 on. Before, the rubber has rested at a strain
  /// until all had relaxed; a value at time 0 that differs is a jump.
  struct Loading
  {
    bool   stress_prescribed = false;
    double rest_strain       = 0.; ///< [-]

    /// Strain [-] or nominal stress [MPa] over time [s], smooth between the
    /// corners.
    std::function<double(double)> value;
    std::vector<double>           corners; ///< increasing, from 0 on [s]

    double time_step = 0.; ///< largest between corners [s]

    /// Each step after the last corner but one is this much longer than the
    /// one before [-], >= 1: for what relaxes over decades of time.
    double growth = 1.;

    /// Is there a jump at time 0?
    bool jumps() const
    {
      return stress_prescribed ? value(0.) != 0. : value(0.) != rest_strain;
    }

    double end() const
    {
      return corners.back();
    }

    /// Ends of all steps [s], without 0.
    std::vector<double> times() const;
  };

  /// To @p strain [-] at @p rate [1/s] > 0, or at once with a rate of 0, then
  /// held for @p hold [s].
  Loading ramp_and_hold(double strain, double rate, double hold);

  /// @p nominal stress [MPa], at once and for @p hold [s].
  Loading creep(double nominal, double hold);

  /// @p n cycles of @p amplitude [-] and @p frequency [Hz] about @p mean [-],
  /// upwards first.
  Loading sine(double mean, double amplitude, double frequency, unsigned int n);
  Loading
  triangle(double mean, double amplitude, double frequency, unsigned int n);
} // namespace demold

#endif
