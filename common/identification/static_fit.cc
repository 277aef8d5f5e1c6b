// SPDX-License-Identifier: LGPL-2.1-or-later
// The parameters of an elastic law from slow tests in several modes at once.
#include "identification/static_fit.h"

#include "identification/bounded_fit.h"
#include "identification/least_squares.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    using Numbers = std::vector<double>;

    /// The data within reach, one after the other.
    struct Data
    {
      std::vector<RigMode> modes;
      Numbers              x, stress, weight;
    };



    Data used_data(const StaticFit &fit, const std::vector<TestCurve> &curves)
    {
      Data data;
      for (const auto &curve : curves)
        for (unsigned int i = 0; i < curve.x.size(); ++i)
          if (fit.uses(curve.mode, curve.x[i]))
            {
              data.modes.push_back(curve.mode);
              data.x.push_back(curve.x[i]);
              data.stress.push_back(curve.stress[i]);
              data.weight.push_back(fit.weight(curve.stress[i]));
            }
      return data;
    }



    Numbers stresses(const StaticLaw &law, const Data &data, const Numbers &q)
    {
      Numbers P(data.x.size());
      for (unsigned int i = 0; i < P.size(); ++i)
        P[i] = law.stress(data.modes[i], data.x[i], q);
      return P;
    }



    Numbers residuals(const StaticLaw &law, const Data &data, const Numbers &q)
    {
      Numbers r = stresses(law, data, q);
      for (unsigned int i = 0; i < r.size(); ++i)
        r[i] = data.weight[i] * (r[i] - data.stress[i]);
      return r;
    }



    /// Weighted stresses of unit parameters, the matrix of a linear law.
    FullMatrix<double> unit_stresses(const StaticLaw &law, const Data &data)
    {
      const unsigned int n = law.parameters.size();
      FullMatrix<double> A(data.x.size(), n);
      for (unsigned int j = 0; j < n; ++j)
        {
          Numbers unit(n, 0.);
          unit[j]         = 1.;
          const Numbers P = stresses(law, data, unit);
          for (unsigned int i = 0; i < P.size(); ++i)
            A(i, j) = data.weight[i] * P[i];
        }
      return A;
    }



    Numbers linear_solution(const StaticLaw &law, const Data &data)
    {
      const Numbers none(law.parameters.size(), 0.);
      Numbers       b = residuals(law, data, none);
      for (double &v : b)
        v = -v;
      return nonnegative_least_squares(unit_stresses(law, data), b);
    }



    FitProblem problem_of(const StaticLaw &law, const Data &data)
    {
      FitProblem problem;
      problem.n_residuals = data.x.size();
      problem.residuals   = [&law, &data](const Numbers &q) {
        return residuals(law, data, q);
      };
      for (const auto &parameter : law.parameters)
        {
          problem.lower.push_back(parameter.lower);
          problem.upper.push_back(parameter.upper);
        }
      const Numbers mu = linear_solution(incompressible_mooney_rivlin(), data);
      problem.start    = law.start(mu[0], mu[1]);
      return problem;
    }
  } // namespace



  double largest_stretch(const RigMode mode, const double x)
  {
    switch (mode)
      {
        case RigMode::uniaxial:
          return std::max(x, 1. / std::sqrt(x));
        case RigMode::equibiaxial:
          return std::max(x, 1. / (x * x));
        case RigMode::pure_shear:
          return std::max(x, 1. / x);
        case RigMode::simple_shear:
          return .5 * std::abs(x) + std::sqrt(1. + .25 * x * x);
        default:
          return std::max(x, 1.);
      }
  }



  std::vector<double> StaticFitResult::values() const
  {
    Numbers q;
    for (const auto &parameter : report.parameters)
      q.push_back(parameter.value);
    return q;
  }



  bool StaticFit::uses(const RigMode mode, const double x) const
  {
    return largest_stretch(mode, x) <= max_stretch;
  }



  unsigned int StaticFit::n_used(const std::vector<TestCurve> &curves) const
  {
    return used_data(*this, curves).x.size();
  }



  double StaticFit::weight(const double stress) const
  {
    return relative ? 1. / std::max(std::abs(stress), floor) : 1.;
  }



  StaticFitResult StaticFit::fit(const StaticLaw              &law,
                                 const std::vector<TestCurve> &curves) const
  {
    const Data         data = used_data(*this, curves);
    StaticFitResult    result;
    Numbers            q;
    FullMatrix<double> J;
    if (law.linear)
      {
        q            = linear_solution(law, data);
        J            = unit_stresses(law, data);
        result.slope = 0.;
      }
    else
      {
        FitProblem problem = problem_of(law, data);
        problem.jacobian   = [&problem](const Numbers &at) {
          return jacobian_by_differences(problem, at);
        };
        const FitResult found = minimise(problem);
        q                     = found.parameters;
        J                     = problem.jacobian(q);
        result.slope          = found.slope;
      }

    auto parameters = law.parameters;
    for (unsigned int j = 0; j < q.size(); ++j)
      parameters[j].value = q[j];
    result.report = assess(parameters, residuals(law, data, q), J);
    result.determination =
      coefficient_of_determination(data.stress, stresses(law, data, q));
    return result;
  }



  std::string advice_on_modes(const std::vector<TestCurve> &curves,
                              const FitReport              &report)
  {
    std::set<RigMode> modes;
    for (const auto &curve : curves)
      modes.insert(curve.mode);
    const bool only_shear = modes.count(RigMode::uniaxial) == 0 &&
                            modes.count(RigMode::equibiaxial) == 0;
    if (only_shear)
      return "Shear data identify only the sum mu1 + mu2. Add a uniaxial and "
             "an equibiaxial test to divide it.";
    if (modes.size() > 1)
      return "";

    const double       correlation = report.correlation(0, 1);
    std::ostringstream text;
    text.precision(3);
    text << name_of(*modes.begin())
         << " data alone do not identify mu2: the stresses of mu1 and mu2 "
            "differ too little in one mode";
    if (std::isfinite(correlation))
      text << " (correlation " << correlation << ")";
    text << ", so that what the model misses goes into mu2. Add a test in "
            "another mode, best uniaxial and equibiaxial together.";
    std::string sentence = text.str();
    sentence[0]          = std::toupper(sentence[0]);
    return sentence;
  }
} // namespace demold
