// SPDX-License-Identifier: LGPL-2.1-or-later
// Elastic laws as slow tests show them: parameters and nominal stress.
#include "identification/static_law.h"

#include "rig/rig_point.h"

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace demold
{
  using namespace dealii;

  namespace
  {
    using Numbers = std::vector<double>;

    constexpr double infinity = std::numeric_limits<double>::infinity();

    FitParameter modulus(const std::string &name)
    {
      return {name, "MPa", 0., 0., infinity};
    }



    double mooney_rivlin_stress(const RigMode  mode,
                                const double   x,
                                const Numbers &mu)
    {
      switch (mode)
        {
          case RigMode::uniaxial:
            return (mu[0] + mu[1] / x) * (x - 1. / (x * x));
          case RigMode::equibiaxial:
            return (mu[0] + mu[1] * x * x) * (x - std::pow(x, -5));
          case RigMode::pure_shear:
            return (mu[0] + mu[1]) * (x - std::pow(x, -3));
          case RigMode::simple_shear:
            return (mu[0] + mu[1]) * x;
          default:
            Assert(false, ExcMessage("confined rubber must be compressible"));
            return 0.;
        }
    }



    /// The stress of one term of modulus 1 at @p x, with dW/dl of its principal
    /// stretches l, all of them functions of x.
    double ogden_stress(const RigMode mode, const double x, const double alpha)
    {
      const auto slope = [alpha](const double l) {
        return 2. / alpha * std::pow(l, alpha - 1.);
      };
      switch (mode)
        {
          case RigMode::uniaxial: // (x, x^-1/2, x^-1/2)
            return slope(x) - slope(1. / std::sqrt(x)) * std::pow(x, -1.5);
          case RigMode::equibiaxial: // (x, x, x^-2), two directions pulled
            return slope(x) - slope(1. / (x * x)) * std::pow(x, -3);
          case RigMode::pure_shear: // (x, 1, 1/x)
            return slope(x) - slope(1. / x) / (x * x);
          case RigMode::simple_shear: // (l, 1, 1/l) with l - 1/l = x
            {
              const double l = .5 * x + std::sqrt(1. + .25 * x * x);
              return (slope(l) - slope(1. / l) / (l * l)) / (1. + 1. / (l * l));
            }
          default:
            Assert(false, ExcMessage("confined rubber must be compressible"));
            return 0.;
        }
    }
  } // namespace



  StaticLaw incompressible_mooney_rivlin()
  {
    StaticLaw law;
    law.name       = "mooney-rivlin incompressible";
    law.parameters = {modulus("mu1"), modulus("mu2")};
    law.stress     = mooney_rivlin_stress;
    law.linear     = true;
    law.start      = [](const double mu1, const double mu2) {
      return Numbers{mu1, mu2};
    };
    return law;
  }



  StaticLaw compressible_mooney_rivlin(const double lambda)
  {
    StaticLaw law = incompressible_mooney_rivlin();
    law.name      = MooneyRivlin::name;
    law.linear    = false;
    law.stress =
      [lambda](const RigMode mode, const double x, const Numbers &mu) {
        RubberLaw rubber;
        rubber.elastic = MooneyRivlin{lambda, mu[0], mu[1]};
        return RigPoint(rubber, mode)
          .strain_step(RigKinematics(mode).strain(x), 0.)
          .nominal;
      };
    return law;
  }



  StaticLaw ogden(const unsigned int n_terms)
  {
    constexpr double steepest = 20.;
    StaticLaw        law;
    law.name       = "ogden";
    law.for_scenes = false;
    law.parameters = {modulus("mu1"), {"alpha1", "-", 0., 1., steepest}};
    if (n_terms == 2)
      {
        law.parameters.push_back(modulus("mu2"));
        law.parameters.push_back({"alpha2", "-", 0., -steepest, -1.});
      }
    law.stress = [](const RigMode mode, const double x, const Numbers &q) {
      double sum = 0.;
      for (unsigned int p = 0; p < q.size(); p += 2)
        sum += q[p] * ogden_stress(mode, x, q[p + 1]);
      return sum;
    };
    law.start = [n_terms](const double mu1, const double mu2) {
      if (n_terms == 1)
        return Numbers{mu1 + mu2, 2.};
      // A term without a modulus would not feel its exponent.
      const double least = .05 * (mu1 + mu2);
      return Numbers{std::max(mu1, least), 2., std::max(mu2, least), -2.};
    };
    return law;
  }
} // namespace demold
