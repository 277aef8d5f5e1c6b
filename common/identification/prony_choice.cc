// SPDX-License-Identifier: LGPL-2.1-or-later
// Which Prony series a parameter file asks for, and how the best is chosen.
#include "identification/prony_choice.h"

#include "base/parameter_error.h"
#include "identification/parameter_include.h"

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <limits>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Shortest and longest time all the data resolve [s].
    std::pair<double, double> window(const std::vector<PronyCurve> &curves)
    {
      double shortest = std::numeric_limits<double>::infinity(), longest = 0.;
      for (const auto &curve : curves)
        {
          shortest = std::min(shortest, curve.shortest_time());
          longest  = std::max(longest, curve.longest_time());
        }
      return {shortest, longest};
    }
  } // namespace



  void PronyChoice::add_parameters(ParameterHandler  &prm,
                                   const std::string &name)
  {
    section = name;
    prm.add_parameter("weights",
                      weights,
                      "relative: every datum by its size; absolute: all alike "
                      "[-]",
                      Patterns::Selection("relative|absolute"));
    prm.add_parameter("times",
                      kind,
                      "fixed: relaxation times as given or spaced over the "
                      "range of the data; optimised: starting from there [-]",
                      Patterns::Selection("fixed|optimised"));
    prm.add_parameter("relaxation times",
                      times,
                      "tau_j, increasing; none: equally spaced in their "
                      "logarithm [s]");
    prm.add_parameter("branches",
                      branches,
                      "number of relaxation times where none are given; 0: the "
                      "one with the smallest information criterion AICc [-]",
                      Patterns::Integer(0, 40));
    prm.add_parameter("most branches",
                      most_branches,
                      "largest number tried by the criterion [-]",
                      Patterns::Integer(1, 40));
    prm.add_parameter("mu2 over mu1",
                      ratio,
                      "mu2/mu1, not fitted, divides the equilibrium modulus "
                      "in material.prm [-]",
                      Patterns::Double(0.));
    prm.add_parameter("lambda",
                      lambda,
                      "Lambda volumetric stiffness, not fitted, handed on to "
                      "material.prm [MPa]",
                      Patterns::Double(0.));
  }



  unsigned int
  PronyChoice::n_branches_max(const std::vector<PronyCurve> &curves) const
  {
    std::size_t n_least = std::numeric_limits<std::size_t>::max();
    for (const auto &curve : curves)
      n_least = std::min(n_least, curve.points.size());
    // E_inf, E_j and, if sought, tau_j of a curve
    return (n_least - 1) / (kind == "optimised" ? 2 : 1);
  }



  void PronyChoice::check(const std::vector<PronyCurve> &curves) const
  {
    for (unsigned int j = 0; j < times.size(); ++j)
      if (!(times[j] > (j == 0 ? 0. : times[j - 1])))
        throw ExcParameter(section + "/relaxation times",
                           "must be positive and increase; number " +
                             std::to_string(j + 1) + " is " +
                             prm_number(times[j]) + " s.");
    if (!times.empty() && branches != 0 && branches != times.size())
      throw ExcParameter(section + "/branches",
                         "must be the number of relaxation times, " +
                           std::to_string(times.size()) + ", or 0; got " +
                           std::to_string(branches) + ".");
    const unsigned int n =
      times.empty() ? std::max(branches, 1u) : times.size();
    if (n > n_branches_max(curves))
      throw ExcParameter(section +
                           (times.empty() ? "/branches" : "/relaxation times"),
                         "the data can determine at most " +
                           std::to_string(n_branches_max(curves)) +
                           " branches with times = " + kind + "; got " +
                           std::to_string(n) +
                           ". Ask for less or measure more points.");
  }



  PronyResult PronyChoice::fit_one(const std::vector<PronyCurve> &curves,
                                   const std::vector<double>     &equilibrium,
                                   const std::vector<double>     &start) const
  {
    const PronyFit fit{equilibrium};
    if (kind == "fixed")
      return fit.fit_moduli(curves, start);
    // A decade outside the data there is hardly anything left to see.
    const auto [shortest, longest] = window(curves);
    return fit.fit_times(curves,
                         start,
                         std::min(.1 * shortest, start.front()),
                         std::max(10. * longest, start.back()));
  }



  PronyChoice::Outcome
  PronyChoice::fit(const std::vector<PronyCurve> &curves,
                   const std::vector<double>     &equilibrium) const
  {
    const auto [shortest, longest] = window(curves);
    unsigned int n_from = branches, n_to = branches;
    if (!times.empty())
      n_from = n_to = times.size();
    else if (branches == 0)
      {
        n_from = 1;
        n_to   = std::min(most_branches, n_branches_max(curves));
      }

    Outcome outcome;
    for (unsigned int n = n_from; n <= n_to; ++n)
      {
        auto result =
          fit_one(curves,
                  equilibrium,
                  times.empty() ? logarithmic_times(shortest, longest, n) :
                                  times);
        if (n == n_from || result.criterion() < outcome.best.criterion())
          outcome.best = result;
        outcome.trials.push_back(
          {n, result.n_parameters, result.report.rms, result.criterion()});
      }
    return outcome;
  }



  std::string PronyChoice::in_words() const
  {
    const std::string number =
      !times.empty() ? std::to_string(times.size()) + " given" :
      branches > 0   ? std::to_string(branches) + " spaced" :
                       "by information criterion up to " +
                       std::to_string(most_branches) + " spaced";
    return number + " relaxation times, " + kind + ", " + weights + " weights";
  }



  double PronyChoice::weight(const double value) const
  {
    return relative() ? 1. / value : 1.;
  }



  ParameterInclude PronyChoice::material(const PronySeries &series) const
  {
    ParameterInclude    include;
    std::vector<double> tau, moduli;
    for (unsigned int j = 0; j < series.times.size(); ++j)
      if (series.moduli[j] > 0.)
        {
          tau.push_back(series.times[j]);
          moduli.push_back(series.moduli[j]);
        }
    const double shear = series.equilibrium / 3.;
    include.set("model", std::string("mooney-rivlin"));
    include.set("lambda", lambda);
    include.set("mu1", shear / (1. + ratio));
    include.set("mu2", shear * ratio / (1. + ratio));
    include.set("relaxation times", tau);
    include.set("branch moduli", moduli);
    return include;
  }



  ParameterInclude PronyChoice::tables(const std::vector<double>      &f90,
                                       const std::vector<PronySeries> &series,
                                       const double level) const
  {
    std::vector<double>              tau, equilibrium;
    std::vector<std::vector<double>> moduli(series.size());
    for (unsigned int j = 0; j < series[0].times.size(); ++j)
      if (std::any_of(series.begin(), series.end(), [j](const auto &s) {
            return s.moduli[j] > 0.;
          }))
        {
          tau.push_back(series[0].times[j]);
          for (unsigned int c = 0; c < series.size(); ++c)
            moduli[c].push_back(series[c].moduli[j]);
        }
    for (const auto &s : series)
      equilibrium.push_back(s.equilibrium);

    ParameterInclude include;
    include.set("model", std::string("mooney-rivlin"));
    include.set("lambda", lambda);
    include.set("relaxation times", tau);
    include.set("f90", level);
    include.set("table f90", f90);
    include.set("table equilibrium modulus", equilibrium);
    include.set("table mu2 over mu1", ratio);
    include.set("table branch moduli", moduli);
    return include;
  }
} // namespace demold
