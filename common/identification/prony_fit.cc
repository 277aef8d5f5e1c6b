// SPDX-License-Identifier: LGPL-2.1-or-later
// Prony series of one compound at several states of cure, times in common.
#include "identification/prony_fit.h"

#include "identification/bounded_fit.h"
#include "identification/least_squares.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace demold
{
  using namespace dealii;

  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();

    /// The unknowns: ln tau_j if they are sought, then for each curve E_inf if
    /// it is sought and E_j.
    struct Unknowns
    {
      const std::vector<PronyCurve> &curves;
      std::vector<double>            equilibrium; // < 0: unknown
      std::vector<double>            times;       // starts or fixed
      bool                           with_times;

      unsigned int n_branches() const
      {
        return times.size();
      }

      bool seeks_equilibrium(const unsigned int c) const
      {
        return c >= equilibrium.size() || equilibrium[c] < 0.;
      }

      /// Index of E_inf of curve @p c, or of its first modulus where E_inf is
      /// known.
      unsigned int first(const unsigned int c) const
      {
        unsigned int i = with_times ? n_branches() : 0;
        for (unsigned int b = 0; b < c; ++b)
          i += n_branches() + (seeks_equilibrium(b) ? 1 : 0);
        return i;
      }

      unsigned int size() const
      {
        return first(curves.size());
      }

      unsigned int n_points() const
      {
        unsigned int n = 0;
        for (const auto &curve : curves)
          n += curve.points.size();
        return n;
      }

      std::vector<PronySeries> series(const std::vector<double> &q) const
      {
        std::vector<PronySeries> result(curves.size());
        for (unsigned int c = 0; c < curves.size(); ++c)
          {
            unsigned int i = first(c);
            result[c].equilibrium =
              seeks_equilibrium(c) ? q[i++] : equilibrium[c];
            for (unsigned int j = 0; j < n_branches(); ++j)
              {
                result[c].times.push_back(with_times ? std::exp(q[j]) :
                                                       times[j]);
                result[c].moduli.push_back(q[i + j]);
              }
          }
        return result;
      }

      std::vector<double> residuals(const std::vector<double> &q) const
      {
        const auto          all = series(q);
        std::vector<double> r;
        for (unsigned int c = 0; c < curves.size(); ++c)
          for (unsigned int i = 0; i < curves[c].points.size(); ++i)
            r.push_back(
              curves[c].points[i].weight *
              (curves[c].model(all[c], i) - curves[c].points[i].value));
        return r;
      }

      FullMatrix<double> jacobian(const std::vector<double> &q) const
      {
        const auto         all = series(q);
        FullMatrix<double> J(n_points(), size());
        unsigned int       row = 0;
        for (unsigned int c = 0; c < curves.size(); ++c)
          for (const auto &point : curves[c].points)
            {
              unsigned int column = first(c);
              if (seeks_equilibrium(c))
                J(row, column++) =
                  point.quantity == PronyQuantity::loss ? 0. : point.weight;
              for (unsigned int j = 0; j < n_branches(); ++j)
                {
                  const auto kernel  = prony_kernel(point.quantity,
                                                   point.x,
                                                   all[c].times[j],
                                                   curves[c].ramp);
                  J(row, column + j) = point.weight * kernel.value;
                  if (with_times)
                    J(row, j) +=
                      point.weight * all[c].moduli[j] * kernel.by_log_time;
                }
              ++row;
            }
        return J;
      }

      /// Names, units and bounds for the report.
      std::vector<FitParameter>
      parameters(const std::vector<double> &q,
                 const std::vector<double> &lower,
                 const std::vector<double> &upper) const
      {
        std::vector<FitParameter> result;
        for (unsigned int j = 0; with_times && j < n_branches(); ++j)
          result.push_back(
            {"ln tau_" + std::to_string(j + 1), "-", q[j], lower[j], upper[j]});
        for (unsigned int c = 0; c < curves.size(); ++c)
          {
            const std::string of =
              curves.size() > 1 ? " of curve " + std::to_string(c + 1) : "";
            unsigned int i = first(c);
            if (seeks_equilibrium(c))
              {
                result.push_back(
                  {"E_inf" + of, "MPa", q[i], lower[i], upper[i]});
                ++i;
              }
            for (unsigned int j = 0; j < n_branches(); ++j)
              result.push_back({"E_" + std::to_string(j + 1) + of,
                                "MPa",
                                q[i + j],
                                lower[i + j],
                                upper[i + j]});
          }
        return result;
      }
    };



    PronyResult make_result(const Unknowns            &unknowns,
                            const std::vector<double> &q,
                            const std::vector<double> &lower,
                            const std::vector<double> &upper)
    {
      PronyResult result;
      result.series = unknowns.series(q);
      const auto r  = unknowns.residuals(q);
      result.report =
        assess(unknowns.parameters(q, lower, upper), r, unknowns.jacobian(q));
      unsigned int row = 0;
      for (const auto &curve : unknowns.curves)
        {
          double square = 0.;
          for (unsigned int i = 0; i < curve.points.size(); ++i, ++row)
            square += r[row] * r[row];
          result.rms.push_back(std::sqrt(square / curve.points.size()));
        }
      result.n_parameters = 0;
      for (const auto &p : result.report.parameters)
        result.n_parameters += p.at_bound() ? 0 : 1;
      result.slope = 0.;
      return result;
    }



    /// Puts the branches in @p q in the order of their times.
    void sort_branches(const Unknowns &unknowns, std::vector<double> &q)
    {
      const unsigned int        n = unknowns.n_branches();
      std::vector<unsigned int> order(n);
      std::iota(order.begin(), order.end(), 0u);
      std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
        return q[a] < q[b];
      });
      std::vector<unsigned int> starts{0};
      for (unsigned int c = 0; c < unknowns.curves.size(); ++c)
        starts.push_back(unknowns.first(c) +
                         (unknowns.seeks_equilibrium(c) ? 1 : 0));
      const std::vector<double> old = q;
      for (const unsigned int start : starts)
        for (unsigned int j = 0; j < n; ++j)
          q[start + j] = old[start + order[j]];
    }



    /// Moduli that are exact for the times in @p q.
    void solve_moduli(const Unknowns &unknowns, std::vector<double> &q)
    {
      const auto series = unknowns.series(q);
      for (unsigned int c = 0; c < unknowns.curves.size(); ++c)
        {
          const std::vector<PronyCurve> one{unknowns.curves[c]};
          std::vector<double>           known;
          if (!unknowns.seeks_equilibrium(c))
            known.push_back(unknowns.equilibrium[c]);
          const Unknowns      alone{one, known, series[c].times, false};
          std::vector<double> zero(alone.size(), 0.);
          std::vector<double> b = alone.residuals(zero);
          for (double &v : b)
            v = -v;
          const auto x = nonnegative_least_squares(alone.jacobian(zero), b);
          std::copy(x.begin(), x.end(), q.begin() + unknowns.first(c));
        }
    }
  } // namespace



  double PronyResult::criterion() const
  {
    const double n = report.n_data, k = n_parameters;
    if (n <= k + 1.)
      return infinity;
    // Data without scatter end at round-off, not at minus infinity.
    const double rms_floor = std::max(report.rms, 1e-12);
    return 2. * n * std::log(rms_floor) + 2. * k +
           2. * k * (k + 1.) / (n - k - 1.);
  }



  PronyResult PronyFit::fit_moduli(const std::vector<PronyCurve> &curves,
                                   const std::vector<double>     &times) const
  {
    const Unknowns      unknowns{curves, equilibrium, times, false};
    std::vector<double> q(unknowns.size(), 0.);
    solve_moduli(unknowns, q);
    const std::vector<double> lower(q.size(), 0.), upper(q.size(), infinity);
    return make_result(unknowns, q, lower, upper);
  }



  PronyResult PronyFit::fit_times(const std::vector<PronyCurve> &curves,
                                  const std::vector<double>     &times,
                                  const double                   shortest,
                                  const double                   longest) const
  {
    const Unknowns unknowns{curves, equilibrium, times, true};
    FitProblem     problem;
    problem.n_residuals = unknowns.n_points();
    problem.residuals   = [&](const std::vector<double> &q) {
      return unknowns.residuals(q);
    };
    problem.jacobian = [&](const std::vector<double> &q) {
      return unknowns.jacobian(q);
    };
    problem.start.assign(unknowns.size(), 0.);
    problem.lower.assign(unknowns.size(), 0.);
    problem.upper.assign(unknowns.size(), infinity);
    for (unsigned int j = 0; j < times.size(); ++j)
      {
        problem.start[j] = std::log(times[j]);
        problem.lower[j] = std::log(shortest);
        problem.upper[j] = std::log(longest);
      }
    solve_moduli(unknowns, problem.start);

    const auto          result = minimise(problem);
    std::vector<double> q      = result.parameters;
    sort_branches(unknowns, q);
    solve_moduli(unknowns, q); // the exact zeros
    PronyResult fitted = make_result(unknowns, q, problem.lower, problem.upper);
    fitted.slope       = result.slope;
    return fitted;
  }



  std::vector<double> logarithmic_times(const double       shortest,
                                        const double       longest,
                                        const unsigned int n)
  {
    if (n == 1)
      return {std::sqrt(shortest * longest)};
    std::vector<double> times;
    for (unsigned int j = 0; j < n; ++j)
      times.push_back(shortest * std::pow(longest / shortest, j / (n - 1.)));
    return times;
  }
} // namespace demold
