// SPDX-License-Identifier: LGPL-2.1-or-later
// The entries of the energy ledger.
#ifndef demold_weak_form_energies_h
#define demold_weak_form_energies_h

#include <array>
#include <string>

namespace demold
{
  /// Energies [mJ] at one time: `stored` and `kinetic` are what is in the body
  /// now, all others are sums since the start. Every entry comes from its own
  /// formula, none is the remainder of the others.
  struct Energies
  {
    double external       = 0.; ///< work done on the rubber
    double stored         = 0.; ///< elastic, penalty and bond energy
    double kinetic        = 0.;
    double viscous        = 0.; ///< dissipated in Maxwell branches
    double adhesion       = 0.; ///< dissipated by decohesion
    double friction       = 0.; ///< dissipated by sliding
    double impact         = 0.; ///< lost when surfaces meet (theory D.4)
    double regularisation = 0.; ///< dissipated by viscous regularisation
    double algorithmic    = 0.; ///< damping of the time integrator (D.4)

    static constexpr unsigned int n_entries = 9;

    /// Names for tables, in the order of as_array().
    static const std::array<std::string, n_entries> &names()
    {
      static const std::array<std::string, n_entries> list = {
        {"external work",
         "stored energy",
         "kinetic energy",
         "viscous dissipation",
         "adhesion dissipation",
         "friction dissipation",
         "impact dissipation",
         "regularisation dissipation",
         "algorithmic dissipation"}};
      return list;
    }

    std::array<double, n_entries> as_array() const
    {
      return {{external,
               stored,
               kinetic,
               viscous,
               adhesion,
               friction,
               impact,
               regularisation,
               algorithmic}};
    }

    static Energies from_array(const std::array<double, n_entries> &e)
    {
      return {e[0], e[1], e[2], e[3], e[4], e[5], e[6], e[7], e[8]};
    }

    Energies &operator+=(const Energies &other)
    {
      const auto a = as_array(), b = other.as_array();
      auto       c = a;
      for (unsigned int i = 0; i < n_entries; ++i)
        c[i] = a[i] + b[i];
      return *this = from_array(c);
    }

    /// What is not accounted for: external work minus everything it became.
    double gap() const
    {
      return external - stored - kinetic - viscous - adhesion - friction -
             impact - regularisation - algorithmic;
    }
  };
} // namespace demold

#endif
