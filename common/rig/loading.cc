// SPDX-License-Identifier: LGPL-2.1-or-later
// What the grips do over time: a prescribed strain or stress.
#include "rig/loading.h"

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Rounding of a length over a step must not add one.
    constexpr double slack = 1e-9;

    /// Ends of the steps of a hold: the first of length @p step, each longer
    /// than the one before by @p growth, scaled to end with it.
    void append_growing(const double         start,
                        const double         length,
                        const double         step,
                        const double         growth,
                        std::vector<double> &times)
    {
      std::vector<double> ends;
      double              sum = 0., dt = step;
      while (sum < length * (1. - slack))
        {
          sum += dt;
          dt *= growth;
          ends.push_back(sum);
        }
      for (const double end : ends)
        times.push_back(start + end * (length / sum));
    }

    void append_even(const double         start,
                     const double         length,
                     const double         step,
                     std::vector<double> &times)
    {
      const auto n = std::max(1., std::ceil(length / step - slack));
      for (double i = 1.; i <= n; ++i)
        times.push_back(start + length * (i / n));
    }
  } // namespace



  std::vector<double> Loading::times() const
  {
    std::vector<double> times;
    for (std::size_t i = 1; i < corners.size(); ++i)
      {
        const double start = corners[i - 1], length = corners[i] - start;
        if (i + 1 == corners.size() && growth > 1.)
          append_growing(start, length, time_step, growth, times);
        else
          append_even(start, length, time_step, times);
        times.back() = corners[i];
      }
    return times;
  }



  Loading ramp_and_hold(const double strain,
                        const double rate,
                        const double hold)
  {
    Loading      loading;
    const double duration = rate > 0. ? std::abs(strain) / rate : 0.;
    loading.corners       = {0.};
    if (duration > 0.)
      loading.corners.push_back(duration);
    if (hold > 0.)
      loading.corners.push_back(duration + hold);
    loading.value = [=](const double t) {
      return t >= duration ? strain : strain * (t / duration);
    };
    return loading;
  }

  Loading creep(const double nominal, const double hold)
  {
    Loading loading;
    loading.stress_prescribed = true;
    loading.corners           = {0., hold};
    loading.value             = [=](double) { return nominal; };
    return loading;
  }

  Loading sine(const double       mean,
               const double       amplitude,
               const double       frequency,
               const unsigned int n)
  {
    Loading loading;
    loading.rest_strain = mean;
    loading.corners     = {0., n / frequency};
    loading.value       = [=](const double t) {
      return mean + amplitude * std::sin(2. * numbers::PI * frequency * t);
    };
    return loading;
  }

  Loading triangle(const double       mean,
                   const double       amplitude,
                   const double       frequency,
                   const unsigned int n)
  {
    Loading loading;
    loading.rest_strain = mean;
    loading.corners     = {0.};
    for (unsigned int i = 0; i < n; ++i)
      {
        loading.corners.push_back((i + .25) / frequency);
        loading.corners.push_back((i + .75) / frequency);
      }
    loading.corners.push_back(n / frequency);
    loading.value = [=](const double t) {
      const double phase = frequency * t - std::floor(frequency * t);
      const double wave  = phase < .25 ? 4. * phase :
                           phase < .75 ? 2. - 4. * phase :
                                         4. * phase - 4.;
      return mean + amplitude * wave;
    };
    return loading;
  }
} // namespace demold
