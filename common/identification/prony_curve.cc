// SPDX-License-Identifier: LGPL-2.1-or-later
// What a Prony series answers in a test, and the data of such a test.
#include "identification/prony_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace demold
{
  namespace
  {
    double sum(const PronySeries  &series,
               const PronyQuantity quantity,
               const double        x,
               const double        ramp)
    {
      double result = quantity == PronyQuantity::loss ? 0. : series.equilibrium;
      for (unsigned int j = 0; j < series.times.size(); ++j)
        result += series.moduli[j] *
                  prony_kernel(quantity, x, series.times[j], ramp).value;
      return result;
    }



    /// Relaxation after a ramp of length R in units of tau, s = t/tau:
    /// e^-s (e^R - 1)/R.
    PronyKernel relaxation_kernel(const double s, const double R)
    {
      const double e = std::exp(-s);
      if (R == 0.)
        return {e, s * e};
      // The held part of the ramp alone: t is at least its length, so that
      // e^(R-s) cannot overflow.
      const double held  = std::exp(R - s);
      const double value = -held * std::expm1(-R) / R;
      // d/d ln tau = -s d/ds - R d/dR
      return {value, s * value - held + value};
    }



    double resolved_time(const PronyCurve::Point &point)
    {
      return point.quantity == PronyQuantity::relaxation ? point.x :
                                                           1. / point.x;
    }
  } // namespace



  double PronySeries::relaxation_modulus(const double time) const
  {
    return sum(*this, PronyQuantity::relaxation, time, 0.);
  }



  double PronySeries::storage_modulus(const double frequency) const
  {
    return sum(*this, PronyQuantity::storage, frequency, 0.);
  }



  double PronySeries::loss_modulus(const double frequency) const
  {
    return sum(*this, PronyQuantity::loss, frequency, 0.);
  }



  PronyKernel prony_kernel(const PronyQuantity quantity,
                           const double        x,
                           const double        time,
                           const double        ramp)
  {
    if (quantity == PronyQuantity::relaxation)
      return relaxation_kernel(x / time, ramp / time);
    const double u = x * time, square = u * u, d = 1. + square;
    if (quantity == PronyQuantity::storage)
      return {square / d, 2. * square / (d * d)};
    return {u / d, u * (1. - square) / (d * d)};
  }



  double PronyCurve::model(const PronySeries &series,
                           const unsigned int i) const
  {
    return sum(series, points[i].quantity, points[i].x, ramp);
  }



  double PronyCurve::shortest_time() const
  {
    double time = std::numeric_limits<double>::infinity();
    for (const auto &point : points)
      if (resolved_time(point) > 0.)
        time = std::min(time, resolved_time(point));
    return time;
  }



  double PronyCurve::longest_time() const
  {
    double time = 0.;
    for (const auto &point : points)
      time = std::max(time, resolved_time(point));
    return time;
  }
} // namespace demold
