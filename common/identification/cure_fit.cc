// SPDX-License-Identifier: LGPL-2.1-or-later
// Kinetics of cure from rheometer curves at several temperatures at once.
#include "identification/cure_fit.h"

#include "cure/cure_model.h"
#include "identification/bounded_fit.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace demold
{
  using namespace dealii;

  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    /// Far below the scatter of a torque, and smooth enough for differences.
    constexpr OdeTolerances tolerances{1e-10, 1e-12};

    /// Steps of the differences, far above those tolerances.
    constexpr double difference_step = 1e-4;
  } // namespace



  CureFit::CureFit(const std::string                 &law,
                   const std::vector<RheometerCurve> &curves,
                   const double                       reference_temperature)
    : law(law)
    , curves(curves)
    , reference_temperature(reference_temperature)
  {
    add_parameters();
  }



  void CureFit::add_rate(const std::string &name,
                         const double       value,
                         const double       energy)
  {
    const double start = std::log(value);
    parameters.push_back({"ln " + name, start, start - 12., start + 12.});
    parameters.push_back({"energy of " + name, energy, 0., 300.});
  }



  /// Starts from the closed form of Isayev and Deng through t10, t50 and t90.
  void CureFit::add_parameters()
  {
    const auto line = [&](const double degree) {
      return fit_cure_times(curves, degree, reference_temperature).law;
    };
    const double t10 = line(.1).reference_value, t50 = line(.5).reference_value,
                 t90  = line(.9).reference_value,
                 E    = std::max(line(.9).activation_energy, 10.);
    const double bend = t10 + t90 - 2. * t50;
    const double wait =
      bend > 0. ? std::min(std::max((t10 * t90 - t50 * t50) / bend, .05 * t10),
                           .95 * t10) :
                  .5 * t10;
    const double ratio = (t90 - wait) / (t50 - wait);
    if (law == IsayevDeng::name)
      {
        add_rate("k", 1. / (t50 - wait), E);
        parameters.push_back({"n", std::log(9.) / std::log(ratio), 1., 20.});
      }
    else if (law == KamalSourour::name)
      {
        add_rate("k1", 1e-3 / t50, 1.25 * E);
        add_rate("k2", 15. / t50, E);
        parameters.push_back({"m", 1., .1, 5.});
        parameters.push_back({"n", 1.7, .1, 10.});
      }
    else
      {
        const double K = std::log(2.) / (t50 - wait);
        add_rate("k1", .75 * K, E);
        add_rate("k2", .25 * K, E);
        add_rate("k3", .01 * K, 1.5 * E);
      }
    add_rate("t_i", law == KamalSourour::name ? .2 * t50 : wait, E);
    if (law == KamalSourour::name)
      parameters.pop_back();
  }



  Kinetics CureFit::kinetics(const std::vector<double> &q) const
  {
    const auto rate = [&](const unsigned int i) {
      return ArrheniusRate{std::exp(q[i]), q[i + 1], reference_temperature};
    };
    Kinetics result;
    if (law == IsayevDeng::name)
      result.law = IsayevDeng{rate(0), q[2]};
    else if (law == KamalSourour::name)
      result.law = KamalSourour{rate(0), rate(2), q[4], q[5]};
    else
      result.law = Han{rate(0), rate(2), rate(4)};
    // What the start of Kamal and Sourour and a wait do to alpha is so alike
    // that the wait has the energy of the growth there.
    const bool         tied = law == KamalSourour::name;
    const unsigned int last = q.size() - (tied ? 1 : 2);
    result.induction        = {std::exp(q[last]),
                               q[tied ? 3 : last + 1],
                               reference_temperature};
    return result;
  }



  bool CureFit::uses(const RheometerCurve &curve, const unsigned int i) const
  {
    return law == Han::name || curve.times[i] <= curve.time_of_maximum;
  }



  std::vector<double> CureFit::residuals(const std::vector<double> &q) const
  {
    const Kinetics      model = kinetics(q);
    std::vector<double> r;
    for (const auto &curve : curves)
      {
        const auto fitted = isothermal_degree_of_cure(model,
                                                      curve.temperature,
                                                      curve.times,
                                                      tolerances);
        const auto data   = curve.degrees_of_cure();
        for (unsigned int i = 0; i < data.size(); ++i)
          if (uses(curve, i))
            r.push_back(fitted[i] - data[i]);
      }
    return r;
  }



  /// From logarithms to rates and times with their units.
  void CureFit::name_in_units(CureFitResult &result) const
  {
    for (auto &p : result.report.parameters)
      if (p.name.compare(0, 3, "ln ") == 0)
        {
          p.name           = p.name.substr(3);
          p.unit           = p.name == "t_i" ? "s" : "1/s";
          p.value          = std::exp(p.value);
          p.lower          = std::exp(p.lower);
          p.upper          = std::exp(p.upper);
          p.standard_error = p.value * p.standard_error;
        }
  }



  CureFitResult CureFit::fit() const
  {
    FitProblem problem;
    problem.residuals = [&](const std::vector<double> &q) {
      return residuals(q);
    };
    problem.jacobian = [&](const std::vector<double> &q) {
      return jacobian_by_differences(problem, q, difference_step);
    };
    for (const auto &p : parameters)
      {
        problem.start.push_back(p.start);
        problem.lower.push_back(p.lower);
        problem.upper.push_back(p.upper);
      }
    problem.n_residuals = residuals(problem.start).size();
    problem.tolerance   = 1e-6; // the rest is noise of the differences

    const FitResult found = minimise(problem);
    CureFitResult   result;
    result.q        = found.parameters;
    result.slope    = found.slope;
    result.kinetics = kinetics(result.q);
    const auto r    = residuals(result.q);

    std::vector<FitParameter> fitted;
    for (unsigned int j = 0; j < parameters.size(); ++j)
      fitted.push_back({parameters[j].name,
                        parameters[j].name.find("energy") == 0 ? "kJ/mol" : "-",
                        result.q[j],
                        parameters[j].lower,
                        parameters[j].upper});
    result.report = assess(fitted, r, problem.jacobian(result.q));
    name_in_units(result);

    unsigned int row = 0;
    for (const auto &curve : curves)
      {
        double       square = 0.;
        unsigned int n      = 0;
        for (unsigned int i = 0; i < curve.times.size(); ++i)
          if (uses(curve, i))
            {
              square += r[row] * r[row];
              ++row;
              ++n;
            }
        result.rms.push_back(std::sqrt(square / n));
      }
    return result;
  }



  double CureFit::t90(const Kinetics &model, const double temperature) const
  {
    const auto excess = [&](const double time) {
      return isothermal_degree_of_cure(model, temperature, {time}, tolerances)
               .front() -
             .9;
    };
    double below = 0.,
           above =
             fit_cure_times(curves, .9, reference_temperature).law(temperature);
    // With reversion alpha may never reach 0.9.
    for (unsigned int i = 0; excess(above) < 0.; ++i, above *= 2.)
      {
        if (i == 10)
          return std::numeric_limits<double>::quiet_NaN();
        below = above;
      }
    std::uintmax_t n_iterations = 100;
    const auto     bracket      = boost::math::tools::toms748_solve(
      [&](const double t) { return t == 0. ? -.9 : excess(t); },
      below,
      above,
      boost::math::tools::eps_tolerance<double>(40),
      n_iterations);
    return .5 * (bracket.first + bracket.second);
  }



  PredictedTime CureFit::t90(const CureFitResult &result,
                             const double         temperature) const
  {
    std::vector<double> derivative;
    for (unsigned int j = 0; j < result.q.size(); ++j)
      {
        const double h =
          difference_step * std::max(std::abs(result.q[j]), 1e-3);
        auto up = result.q, down = result.q;
        up[j] += h;
        down[j] -= h;
        derivative.push_back(
          (t90(kinetics(up), temperature) - t90(kinetics(down), temperature)) /
          (2. * h));
        // The covariance is that of rates and times, q is their logarithm.
        const auto &p = result.report.parameters[j];
        if (p.unit == "s" || p.unit == "1/s")
          derivative.back() /= p.value;
      }
    double variance = 0.;
    for (unsigned int i = 0; i < derivative.size(); ++i)
      for (unsigned int j = 0; j < derivative.size(); ++j)
        variance +=
          derivative[i] * result.report.covariance(i, j) * derivative[j];
    return {t90(result.kinetics, temperature), std::sqrt(variance)};
  }



  ArrheniusFit fit_cure_times(const std::vector<RheometerCurve> &curves,
                              const double                       degree,
                              const double reference_temperature)
  {
    std::vector<double> temperatures, times;
    for (const auto &curve : curves)
      {
        temperatures.push_back(curve.temperature);
        times.push_back(curve.time_of(degree));
      }
    return fit_arrhenius(temperatures, times, reference_temperature);
  }



  PredictedTime predict(const ArrheniusFit &line, const double temperature)
  {
    const double t = line.law(temperature);
    return {t, t * line.prediction_error(temperature)};
  }
} // namespace demold
