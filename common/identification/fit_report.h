// SPDX-License-Identifier: LGPL-2.1-or-later
// What a fit knows about its parameters, and what it does not.
#ifndef demold_identification_fit_report_h
#define demold_identification_fit_report_h

#include <deal.II/lac/full_matrix.h>

#include <string>
#include <vector>

namespace demold
{
  class Summary;

  /// A fitted parameter.
  struct FitParameter
  {
    std::string name; ///< as in the prm file: "mu1"
    std::string unit; ///< "MPa", "-"
    double      value = 0.;
    double      lower = 0.; ///< bound
    double      upper = 0.; ///< bound

    /// One sigma; NaN at a bound and where there is no scatter to judge by,
    /// infinite if no residual depends on the parameter.
    double standard_error = 0.;

    /// To nine digits, as an optimiser may stop just before it.
    bool at_bound() const
    {
      const double margin = 1e-9 * (value > 0. ? value : -value);
      return value <= lower + margin * (lower != 0.) || value >= upper - margin;
    }
  };

  /// The judgement on a fit (theory A.4): with J the Jacobian of the weighted
  /// residuals r of n data by the k parameters that are not at a bound,
  /// s^2 = |r|^2/(n - k) and the covariance s^2 (J^T J)^-1. It holds if the
  /// residuals are independent scatter of one size; a model that does not fit
  /// makes the uncertainties too small.
  struct FitReport
  {
    std::vector<FitParameter> parameters;
    unsigned int              n_data = 0;
    double                    rms    = 0.; ///< of r, in its unit

    /// Correlations of parameters, k x k and unity on the diagonal; NaN where a
    /// parameter is at its bound.
    dealii::FullMatrix<double> correlation;

    /// Of J with columns scaled to length one [-]; infinite: the data determine
    /// only some combinations of the parameters.
    double condition = 1.;

    double covariance(unsigned int i, unsigned int j) const;

    /// Largest |correlation| of two parameters [-]; 0 if there are none.
    double largest_correlation() const;

    /// Identifiability in sentences: parameters at bounds, parameters whose
    /// standard error exceeds half their value, pairs correlated beyond 0.95,
    /// a condition number beyond 1e3. One sentence if all is well.
    std::vector<std::string> in_words() const;

    /// The same as one text.
    std::string identifiability() const;

    /// Parameters, standard errors, rms, correlation, condition, words.
    void write(const std::string &rms_unit, Summary &summary) const;

    /// The matrix of correlations as a CSV table.
    void write_correlations(const std::string &file) const;
  };

  /// @p parameters without standard errors, @p residuals and their derivatives
  /// @p jacobian (n x k) at the solution.
  FitReport assess(std::vector<FitParameter>         parameters,
                   const std::vector<double>        &residuals,
                   const dealii::FullMatrix<double> &jacobian);

  /// 1 - sum (y - model)^2 / sum (y - mean y)^2 [-].
  double coefficient_of_determination(const std::vector<double> &y,
                                      const std::vector<double> &model);
} // namespace demold

#endif
