// SPDX-License-Identifier: LGPL-2.1-or-later
// Laws of cure at one point: the degree of cure over a temperature history.
#ifndef demold_cure_kinetics_h
#define demold_cure_kinetics_h

#include "cure/arrhenius.h"

#include <array>
#include <string>
#include <variant>

namespace demold
{
  /// What a law remembers. All laws start from zeros, at the end of the
  /// induction period; each says what its entries mean.
  using KineticState = std::array<double, 3>;

  /// Kamal and Sourour (1973): d alpha/dt = (k1 + k2 alpha^m) (1 - alpha)^n
  /// (theory A.3). State: alpha.
  struct KamalSourour
  {
    static constexpr const char *name = "kamal-sourour";

    ArrheniusRate k1;
    ArrheniusRate k2;
    double        m = 1.;
    double        n = 1.;

    /// d alpha/dt [1/s] at @p temperature [degC].
    double rate(const double degree, const double temperature) const;

    KineticState state_rate(const KineticState &state,
                            const double        temperature) const;
    double       degree_of_cure(const KineticState &state) const;
  };

  /// Isayev and Deng (1988): alpha = z^n/(1 + z^n) with z = int k(T) dt, so at
  /// constant temperature alpha = (k t)^n/(1 + (k t)^n) (theory A.3). State: z.
  /// In z the start is regular; in alpha it is not, as d alpha/dt = 0 at 0.
  struct IsayevDeng
  {
    static constexpr const char *name = "isayev-deng";

    ArrheniusRate k;
    double        n = 2.;

    /// d alpha/dt = n k alpha^(1-1/n) (1-alpha)^(1+1/n) [1/s].
    double rate(const double degree, const double temperature) const;

    /// Closed form, @p time [s] since the end of induction.
    double isothermal(const double time, const double temperature) const;

    KineticState state_rate(const KineticState &state,
                            const double        temperature) const;
    double       degree_of_cure(const KineticState &state) const;
  };

  /// Han's law with reversion, as in Milani and Milani (2016): uncured sites
  /// turn into stable crosslinks at the rate k1, into unstable ones at k2, and
  /// the unstable ones are lost at k3. State: sites used up, stable and
  /// unstable crosslinks, each over the number of sites.
  struct Han
  {
    static constexpr const char *name = "han";

    ArrheniusRate k1;
    ArrheniusRate k2;
    ArrheniusRate k3;

    /// K1/(K1+K2) (1 - e^{-(K1+K2)t}) + K2/(K1+K2-K3) (e^{-K3 t} -
    /// e^{-(K1+K2)t}) (theory A.3), also where K1+K2 = K3.
    double isothermal(const double time, const double temperature) const;

    KineticState state_rate(const KineticState &state,
                            const double        temperature) const;
    double       degree_of_cure(const KineticState &state) const;
  };

  using KineticLaw = std::variant<KamalSourour, IsayevDeng, Han>;

  /// A law and the time before it starts. Induction is over when int dt/t_i(T)
  /// = 1; a t_i of zero means none.
  struct Kinetics
  {
    KineticLaw    law;
    ArrheniusTime induction;

    std::string  name() const;
    KineticState state_rate(const KineticState &state,
                            const double        temperature) const;
    double       degree_of_cure(const KineticState &state) const;
  };
} // namespace demold

#endif
