// SPDX-License-Identifier: LGPL-2.1-or-later
// Laws of cure at one point: the degree of cure over a temperature history.
#include "cure/kinetics.h"

#include <algorithm>
#include <cmath>

namespace demold
{
  double KamalSourour::rate(const double degree, const double temperature) const
  {
    // A trial state of an integrator may lie a little outside 0 to 1.
    const double alpha = std::min(std::max(degree, 0.), 1.);
    return (k1(temperature) + k2(temperature) * std::pow(alpha, m)) *
           std::pow(1. - alpha, n);
  }

  KineticState KamalSourour::state_rate(const KineticState &state,
                                        const double        temperature) const
  {
    return {{rate(state[0], temperature), 0., 0.}};
  }

  double KamalSourour::degree_of_cure(const KineticState &state) const
  {
    return state[0];
  }



  double IsayevDeng::rate(const double degree, const double temperature) const
  {
    const double alpha = std::min(std::max(degree, 0.), 1.);
    return n * k(temperature) * std::pow(alpha, 1. - 1. / n) *
           std::pow(1. - alpha, 1. + 1. / n);
  }

  double IsayevDeng::isothermal(const double time,
                                const double temperature) const
  {
    return degree_of_cure({{k(temperature) * time, 0., 0.}});
  }

  KineticState IsayevDeng::state_rate(const KineticState &,
                                      const double temperature) const
  {
    return {{k(temperature), 0., 0.}};
  }

  double IsayevDeng::degree_of_cure(const KineticState &state) const
  {
    const double z_n = std::pow(std::max(state[0], 0.), n);
    // large z^n may overflow, but then all sites are used
    return std::isfinite(z_n) ? z_n / (1. + z_n) : 1.;
  }



  double Han::isothermal(const double time, const double temperature) const
  {
    const double K1 = k1(temperature), K2 = k2(temperature),
                 K3 = k3(temperature), K = K1 + K2;
    if (time <= 0. || K == 0.)
      return 0.;
    // e^{-K3 t} - e^{-K t} over K - K3, written without a difference of like
    // numbers
    const double d = (K - K3) * time;
    const double difference_quotient =
      d == 0. ? time * std::exp(-K * time) :
                time * std::exp(-K * time) * std::expm1(d) / d;
    const double far = (std::exp(-K3 * time) - std::exp(-K * time)) / (K - K3);
    return -K1 / K * std::expm1(-K * time) +
           K2 * (std::abs(d) < 1. ? difference_quotient : far);
  }

  KineticState Han::state_rate(const KineticState &state,
                               const double        temperature) const
  {
    const double K1 = k1(temperature), K2 = k2(temperature),
                 K3 = k3(temperature), unused = 1. - state[0];
    return {{(K1 + K2) * unused, K1 * unused, K2 * unused - K3 * state[2]}};
  }

  double Han::degree_of_cure(const KineticState &state) const
  {
    return state[1] + state[2];
  }



  std::string Kinetics::name() const
  {
    return std::visit([](const auto &l) { return std::string(l.name); }, law);
  }

  KineticState Kinetics::state_rate(const KineticState &state,
                                    const double        temperature) const
  {
    return std::visit(
      [&](const auto &l) { return l.state_rate(state, temperature); },
      law);
  }

  double Kinetics::degree_of_cure(const KineticState &state) const
  {
    return std::visit([&](const auto &l) { return l.degree_of_cure(state); },
                      law);
  }
} // namespace demold
