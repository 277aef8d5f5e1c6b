// SPDX-License-Identifier: LGPL-2.1-or-later
// What a fit knows about its parameters, and what it does not.
#include "identification/fit_report.h"

#include "identification/fit_problem.h"
#include "identification/least_squares.h"
#include "output/result_table.h"
#include "output/summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

    std::string shown(const double value, const unsigned int digits = 3)
    {
      std::ostringstream text;
      text.precision(digits);
      text << value;
      return text.str();
    }



    /// Standard errors and correlations of the parameters @p free.
    void add_covariance(const FullMatrix<double>        &jacobian,
                        const std::vector<unsigned int> &free,
                        const double                     variance,
                        FitReport                       &report)
    {
      FullMatrix<double> J(jacobian.m(), free.size());
      for (unsigned int i = 0; i < J.m(); ++i)
        for (unsigned int k = 0; k < free.size(); ++k)
          J(i, k) = jacobian(i, free[k]);
      const ScaledSvd svd(J);
      const auto      inverse = svd.inverse_normal_matrix();
      report.condition        = svd.condition();
      for (unsigned int k = 0; k < free.size(); ++k)
        {
          report.parameters[free[k]].standard_error =
            std::sqrt(variance * inverse(k, k));
          for (unsigned int l = 0; l < free.size(); ++l)
            report.correlation(free[k], free[l]) =
              k == l ? 1. :
              std::isinf(inverse(k, k)) ?
                       not_a_number :
                       inverse(k, l) / std::sqrt(inverse(k, k) * inverse(l, l));
        }
    }



    /// Sentences on single parameters.
    void add_single(const FitReport &report, std::vector<std::string> &words)
    {
      for (const auto &p : report.parameters)
        if (p.at_bound())
          words.push_back(p.name + " is held by its bound " + shown(p.value) +
                          (p.unit == "-" ? "" : " " + p.unit) +
                          ": the data alone would go beyond it.");
        else if (std::isinf(p.standard_error) && !std::isinf(report.condition))
          words.push_back("The model does not feel " + p.name +
                          " where the others stand.");
        else if (p.standard_error > .5 * std::abs(p.value) &&
                 std::isfinite(p.standard_error))
          words.push_back(
            "The data do not identify " + p.name + ": its standard error is " +
            shown(100. * p.standard_error / std::abs(p.value)) + " % of it.");
    }



    /// Sentences on pairs, the three worst.
    void add_pairs(const FitReport &report, std::vector<std::string> &words)
    {
      struct Pair
      {
        double       correlation;
        unsigned int i, j;
      };
      std::vector<Pair> pairs;
      for (unsigned int i = 0; i < report.parameters.size(); ++i)
        for (unsigned int j = i + 1; j < report.parameters.size(); ++j)
          if (std::abs(report.correlation(i, j)) > .95)
            pairs.push_back({report.correlation(i, j), i, j});
      std::sort(pairs.begin(), pairs.end(), [](const Pair &a, const Pair &b) {
        return std::abs(a.correlation) > std::abs(b.correlation);
      });
      for (unsigned int k = 0; k < std::min<std::size_t>(pairs.size(), 3); ++k)
        words.push_back("The data identify " +
                        report.parameters[pairs[k].i].name + " and " +
                        report.parameters[pairs[k].j].name +
                        " only together: their correlation is " +
                        shown(pairs[k].correlation) + ".");
      if (pairs.size() > 3)
        words.push_back(std::to_string(pairs.size() - 3) +
                        " more pairs are correlated beyond 0.95.");
    }
  } // namespace



  double FitReport::covariance(const unsigned int i, const unsigned int j) const
  {
    if (parameters[i].at_bound() || parameters[j].at_bound())
      return 0.;
    return correlation(i, j) * parameters[i].standard_error *
           parameters[j].standard_error;
  }



  double FitReport::largest_correlation() const
  {
    double largest = 0.;
    for (unsigned int i = 0; i < parameters.size(); ++i)
      for (unsigned int j = 0; j < i; ++j)
        if (std::isfinite(correlation(i, j)))
          largest = std::max(largest, std::abs(correlation(i, j)));
    return std::isinf(condition) ? 1. : largest;
  }



  std::vector<std::string> FitReport::in_words() const
  {
    std::vector<std::string> words;
    add_single(*this, words);
    add_pairs(*this, words);
    if (std::isinf(condition))
      words.push_back("The data determine only combinations of the parameters: "
                      "the Jacobian has not full rank.");
    else if (condition > 1e3)
      words.push_back("The parameters are nearly dependent: the condition "
                      "number of the scaled Jacobian is " +
                      shown(condition) + ".");
    unsigned int n_free = 0;
    for (const auto &p : parameters)
      n_free += p.at_bound() ? 0 : 1;
    if (n_data <= n_free)
      words.push_back(std::to_string(n_data) + " data for " +
                      std::to_string(n_free) +
                      " parameters leave no scatter to judge them by.");
    if (words.empty())
      words.push_back("The data identify all parameters.");
    return words;
  }



  std::string FitReport::identifiability() const
  {
    std::string text;
    for (const auto &sentence : in_words())
      text += (text.empty() ? "" : " ") + sentence;
    return text;
  }



  void FitReport::write(const std::string &rms_unit, Summary &summary) const
  {
    for (const auto &p : parameters)
      {
        const std::string unit = " [" + p.unit + "]";
        summary.set(p.name + unit, p.value);
        summary.set("standard error of " + p.name + unit, p.standard_error);
      }
    summary.set("data [-]", n_data);
    summary.set("rms [" + rms_unit + "]", rms);
    summary.set("largest correlation [-]", largest_correlation());
    summary.set("condition of the scaled Jacobian [-]", condition);
    summary.set("identifiability", identifiability());
  }



  void FitReport::write_correlations(const std::string &file) const
  {
    std::vector<std::string> columns{"parameter"};
    for (const auto &p : parameters)
      columns.push_back(p.name);
    ResultTable table(file, columns);
    for (unsigned int i = 0; i < parameters.size(); ++i)
      {
        std::vector<ResultTable::Value> row{parameters[i].name};
        for (unsigned int j = 0; j < parameters.size(); ++j)
          row.emplace_back(correlation(i, j));
        table.add_row(row);
      }
  }



  FitReport assess(std::vector<FitParameter>  parameters,
                   const std::vector<double> &residuals,
                   const FullMatrix<double>  &jacobian)
  {
    FitReport report;
    report.parameters    = std::move(parameters);
    const unsigned int n = report.parameters.size();
    report.n_data        = residuals.size();
    double square        = 0.;
    for (const double r : residuals)
      square += r * r;
    report.rms = std::sqrt(square / report.n_data);

    // A parameter that moves nothing must not spoil the judgement on others.
    const auto                influence = column_lengths(jacobian);
    std::vector<unsigned int> free;
    report.correlation.reinit(n, n);
    report.correlation = not_a_number;
    for (unsigned int j = 0; j < n; ++j)
      {
        report.parameters[j].standard_error = not_a_number;
        if (report.parameters[j].at_bound())
          continue;
        if (influence[j] > 0.)
          free.push_back(j);
        else
          report.parameters[j].standard_error =
            std::numeric_limits<double>::infinity();
      }
    if (!free.empty() && free.size() <= report.n_data)
      add_covariance(jacobian,
                     free,
                     report.n_data > free.size() ?
                       square / (report.n_data - free.size()) :
                       not_a_number,
                     report);
    return report;
  }



  double coefficient_of_determination(const std::vector<double> &y,
                                      const std::vector<double> &model)
  {
    double mean = 0., left = 0., all = 0.;
    for (const double v : y)
      mean += v / y.size();
    for (unsigned int i = 0; i < y.size(); ++i)
      {
        left += (y[i] - model[i]) * (y[i] - model[i]);
        all += (y[i] - mean) * (y[i] - mean);
      }
    return 1. - left / all;
  }
} // namespace demold
