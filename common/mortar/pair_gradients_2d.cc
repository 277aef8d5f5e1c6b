// SPDX-License-Identifier: LGPL-2.1-or-later
// Derivatives of the mortar integrals of two lines.
#include "mortar/pair_gradients_2d.h"

#include "mortar/pair_integrals.templates.h"

#include <Sacado.hpp>

namespace demold
{
  namespace
  {
    /// The nodes of a line; their x and y are the variables @p first and
    /// following, if there are so many.
    template <int n_variables>
    FaceNodes<Sacado::Fad::SFad<double, n_variables>>
    variables(const FaceNodes<double> &x, const int first)
    {
      using Number = Sacado::Fad::SFad<double, n_variables>;
      FaceNodes<Number> result;
      for (int i = 0; i < 2; ++i)
        for (int c = 0; c < 3; ++c)
          {
            const int variable = first + 2 * i + c;
            if (c < 2 && variable < n_variables)
              result[i][c] = Number(n_variables, variable, x[i][c]);
            else
              result[i][c] = x[i][c];
          }
      return result;
    }

    template <int n_variables>
    PairGradient gradient(const Sacado::Fad::SFad<double, n_variables> &number)
    {
      PairGradient result{};
      for (int variable = 0; variable < n_variables; ++variable)
        result[3 * (variable / 2) + variable % 2] = number.dx(variable);
      return result;
    }

    template <int n_variables>
    PairGradients derived(const FaceNodes<double> &slave,
                          const FaceNodes<double> &master,
                          const PairOptions       &options)
    {
      const auto    sums = integrate_pair(variables<n_variables>(slave, 0),
                                       variables<n_variables>(master, 4),
                                       2,
                                       options);
      PairGradients result;
      if (!sums.overlaps)
        return result;
      result.value.overlaps = true;
      result.value.area     = sums.area.val();
      result.darea          = gradient<n_variables>(sums.area);
      for (unsigned int A = 0; A < 2; ++A)
        for (unsigned int B = 0; B < 2; ++B)
          {
            result.value.D[A][B] = sums.D[A][B].val();
            result.value.M[A][B] = sums.M[A][B].val();
            result.dD[A][B]      = gradient<n_variables>(sums.D[A][B]);
            result.dM[A][B]      = gradient<n_variables>(sums.M[A][B]);
          }
      return result;
    }
  } // namespace

  PairGradients pair_gradients_2d(const FaceNodes<double> &slave,
                                  const FaceNodes<double> &master,
                                  const PairOptions       &options,
                                  const DerivedBy          derived_by)
  {
    return derived_by == DerivedBy::slave ? derived<4>(slave, master, options) :
                                            derived<8>(slave, master, options);
  }
} // namespace demold
