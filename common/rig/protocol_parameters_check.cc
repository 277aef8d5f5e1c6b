// SPDX-License-Identifier: LGPL-2.1-or-later
// Section Protocol: what cannot be run, and why.
#include "rig/protocol_parameters.h"

#include "base/parameter_error.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace demold
{
  namespace
  {
    template <typename... Pieces>
    [[noreturn]] void reject(const std::string &entry, const Pieces &...pieces)
    {
      std::ostringstream text;
      (text << ... << pieces);
      throw ExcParameter("Protocol/" + entry, text.str());
    }
  } // namespace



  void ProtocolParameters::check_strains() const
  {
    if (programme() == Programme::creep)
      return;
    if (strain == 0.)
      reject("strain", "must not be 0: nothing would happen.");
    if (mode() == RigMode::simple_shear)
      return;
    const double lowest =
      has_cycles() ? mean_strain - std::abs(strain) : strain;
    if (!(lowest > -1.))
      reject(has_cycles() && strain > -1. && strain < 1. ? "mean strain" :
                                                           "strain",
             "must leave a stretch greater than 0; the smallest would be ",
             1. + lowest,
             ". Take a smaller strain.");
  }

  void ProtocolParameters::check_programme() const
  {
    if (programme() == Programme::ramp && !(rate > 0.))
      reject("rate",
             "must be greater than 0 in a ramp; got ",
             rate,
             " 1/s. The programme relaxation may strain at once.");
    if (programme() == Programme::relaxation && rate == 0. && !(hold > 0.))
      reject("hold time",
             "must be greater than 0 after a strain at once; got ",
             hold,
             " s.");
    if (programme() == Programme::creep && !(hold > 0.))
      reject("hold time", "must be greater than 0 in creep; got ", hold, " s.");
    if (programme() == Programme::creep && stress == 0.)
      reject("stress", "must not be 0: nothing would happen.");
    if (programme() == Programme::frequency_sweep && n_steps < 8)
      reject("steps",
             "must be at least 8 for each cycle, of which the first harmonic "
             "is taken; got ",
             n_steps,
             '.');
  }

  void ProtocolParameters::check_steps() const
  {
    constexpr double n_max = 2e6;
    double           n     = 0.;
    if (is_sweep())
      n = n_steps * (has_cycles() ? n_cycles : 1.) * swept_values().size();
    else
      {
        const Loading once    = loading(0.);
        const auto   &ends    = once.corners;
        const bool    growing = growth > 1. && ends.size() > 1;
        const double  even =
          growing ? ends[ends.size() - 2] - ends.front() : once.end();
        n = even / time_step;
        if (growing)
          n += std::log1p((growth - 1.) * (once.end() - even) / time_step) /
               std::log(growth);
      }
    n *= std::max<std::size_t>(1, f90_levels.size()) *
         std::max<std::size_t>(1, temperatures.size());
    if (!(n <= n_max))
      reject(is_sweep() ? "steps" : "time step",
             "must give at most ",
             n_max,
             " steps in all; got ",
             n,
             is_sweep() ? ". Take fewer." : ". Take a longer one.");
  }



  void ProtocolParameters::check() const
  {
    material.check();
    check_strains();
    check_programme();
    check_steps();
    if (!temperatures.empty() && !material.shifts_with_temperature())
      reject("temperatures",
             "needs Material/time-temperature shift = WLF or Arrhenius; with "
             "none all runs would be the same. Set it, or leave this empty.");
    cases();
  }
} // namespace demold
