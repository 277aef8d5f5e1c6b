// SPDX-License-Identifier: LGPL-2.1-or-later
// The bonds the adhesion tests try: every softening, mixing and unloading.
#ifndef demold_tests_adhesion_bonds_h
#define demold_tests_adhesion_bonds_h

#include "adhesion/adhesion_law.h"

#include <random>
#include <vector>

namespace demold
{
  using Vector3 = dealii::Tensor<1, 3>;

  constexpr ModeMixing all_mixings[] = {ModeMixing::isotropic,
                                        ModeMixing::slip_limit,
                                        ModeMixing::energy,
                                        ModeMixing::proportional};

  constexpr double coupling = 0.6;

  inline AdhesionLaw
  make_bond(const Softening        &softening,
            const ModeMixing        mixing    = ModeMixing::energy,
            const AdhesionUnloading unloading = AdhesionUnloading::damage)
  {
    AdhesionLaw law;
    law.softening = softening;
    law.factors   = mode_factors(mixing, coupling);
    law.unloading = unloading;
    return law;
  }

  /// All combinations; alpha = 0.2 MPa, penalty 20 MPa/mm as in theory C.2.
  inline std::vector<AdhesionLaw> all_bonds()
  {
    std::vector<AdhesionLaw> bonds;
    for (const Softening &softening :
         {Softening(LinearSoftening{0.2, 0.1, 20.}),
          Softening(ExponentialSoftening{0.2, 0.05, 20.})})
      for (const ModeMixing mixing : all_mixings)
        for (const auto unloading :
             {AdhesionUnloading::damage, AdhesionUnloading::plastic})
          bonds.push_back(make_bond(softening, mixing, unloading));
    return bonds;
  }

  inline Vector3 vector(const double x, const double y, const double z)
  {
    Vector3 v;
    v[0] = x;
    v[1] = y;
    v[2] = z;
    return v;
  }

  inline const Vector3 up = vector(0., 0., 1.);

  /// Isotropic random direction.
  inline Vector3 random_direction(std::mt19937 &engine)
  {
    std::normal_distribution<double> normal;
    Vector3                          v;
    for (unsigned int d = 0; d < 3; ++d)
      v[d] = normal(engine);
    return v / v.norm();
  }

  /// A direction at right angles to @p normal.
  inline Vector3 random_tangent(const Vector3 &normal, std::mt19937 &engine)
  {
    Vector3 t = random_direction(engine);
    t -= (t * normal) * normal;
    return t / t.norm();
  }
} // namespace demold

#endif
