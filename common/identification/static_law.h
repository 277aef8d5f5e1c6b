// SPDX-License-Identifier: LGPL-2.1-or-later
// Elastic laws as slow tests show them: parameters and nominal stress.
#ifndef demold_identification_static_law_h
#define demold_identification_static_law_h

#include "identification/fit_report.h"
#include "rig/rig_mode.h"

#include <functional>
#include <string>
#include <vector>

namespace demold
{
  /// A law of which a static fit finds the parameters.
  struct StaticLaw
  {
    std::string name;

    /// Names, units, bounds; their values are without meaning.
    std::vector<FitParameter> parameters;

    /// Nominal stress [MPa] in a test of the mode at the stretch @p x, or at
    /// the shear gamma in simple shear [-], of parameters @p q.
    std::function<double(RigMode mode, double x, const std::vector<double> &q)>
      stress;

    /// The stress is linear in the parameters.
    bool linear = false;

    /// Scenes know this law, as Material/model = mooney-rivlin.
    bool for_scenes = true;

    /// Where the search begins: the parameters that answer like incompressible
    /// Mooney-Rivlin rubber of mu1 and mu2 [MPa], or nearly so.
    std::function<std::vector<double>(double mu1, double mu2)> start;
  };

  /// Incompressible Mooney-Rivlin rubber, linear in mu1, mu2 >= 0, which makes
  /// the energy polyconvex (theory A.1):
  ///   uniaxial     P = (mu1 + mu2/x) (x - x^-2)
  ///   equibiaxial  P = (mu1 + mu2 x^2) (x - x^-5)
  ///   pure shear   P = (mu1 + mu2) (x - x^-3)
  ///   simple shear P = (mu1 + mu2) x
  StaticLaw incompressible_mooney_rivlin();

  /// The law of scenes, MooneyRivlin, with @p lambda [MPa] > 0 given; the free
  /// directions are solved for by RigPoint.
  StaticLaw compressible_mooney_rivlin(double lambda);

  /// Ogden (1972), incompressible, one or two terms, as Abaqus writes it:
  ///   W = sum_p 2 mu_p/alpha_p^2 (l_1^alpha_p + l_2^alpha_p + l_3^alpha_p - 3)
  /// of principal stretches l_i, mu_p >= 0, alpha_1 >= 1, alpha_2 <= -1, which
  /// makes it polyconvex; sum mu_p is the shear modulus. alpha = 2, -2 is
  /// Mooney-Rivlin.
  StaticLaw ogden(unsigned int n_terms);
} // namespace demold

#endif
