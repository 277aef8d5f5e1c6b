// SPDX-License-Identifier: LGPL-2.1-or-later
// The longest step at which central differences are stable.
#include "solution/critical_step.h"

#include "weak_form/weak_form.h"

#include <cmath>
#include <limits>

namespace demold
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int most_products = 500;
    constexpr double       tolerance     = 1e-6; ///< of one product
    constexpr unsigned int calm_products = 5;    ///< in a row below it

    /// All frequencies, the high ones above all; the same on any partition.
    double start(const types::global_dof_index i)
    {
      return std::sin(1. + 2.399963 * static_cast<double>(i));
    }
  } // namespace

  double largest_eigenvalue(const SparseMatrix &K, const Vector &mass)
  {
    // x = M^(1/2) u, so that the matrix M^(-1/2) K M^(-1/2) is symmetric.
    Vector scale(mass), x(mass), y(mass);
    for (const auto i : mass.locally_owned_elements())
      {
        scale(i) = mass(i) > 0. ? 1. / std::sqrt(mass(i)) : 0.;
        x(i)     = mass(i) > 0. ? start(i) : 0.;
      }
    scale.compress(VectorOperation::insert);
    x.compress(VectorOperation::insert);
    double       largest = 0.;
    unsigned int calm    = 0;
    double       size    = x.l2_norm();
    for (unsigned int k = 0; k < most_products && size > 0.; ++k)
      {
        x /= size;
        x.scale(scale);
        K.vmult(y, x);
        y.scale(scale);
        size               = y.l2_norm();
        const double first = largest;
        largest            = std::max(largest, size);
        calm = largest - first <= tolerance * largest ? calm + 1 : 0;
        if (calm >= calm_products)
          break;
        x = y;
      }
    return largest;
  }

  double critical_step(WeakForm &weak_form, const Vector &mass, const double dt)
  {
    Vector free(mass);
    weak_form.set_supports_to_zero(free);
    weak_form.begin_increment(weak_form.time() + dt, 0.);
    weak_form.assemble(true, 0);
    const double square = largest_eigenvalue(weak_form.matrix, free);
    weak_form.reject();
    return square > 0. ? 2. / std::sqrt(square) :
                         std::numeric_limits<double>::max();
  }
} // namespace demold
