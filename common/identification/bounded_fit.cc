// SPDX-License-Identifier: LGPL-2.1-or-later
// Nonlinear least squares between bounds, by Trilinos' ROL.
#include "identification/bounded_fit.h"

#include "identification/least_squares.h"

#include <deal.II/base/exceptions.h>

#include <ROL_Bounds.hpp>
#include <ROL_StdVector.hpp>
#include <ROL_TypeB_LinMoreAlgorithm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace demold
{
  using namespace dealii;

  namespace
  {
    using Numbers = std::vector<double>;

    /// Parameters that are not held by a bound, @p g being the gradient.
    std::vector<unsigned int> free_parameters(const FitProblem &problem,
                                              const Numbers    &q,
                                              const Numbers    &g)
    {
      std::vector<unsigned int> free;
      for (unsigned int j = 0; j < q.size(); ++j)
        if (!(q[j] <= problem.lower[j] && g[j] > 0.) &&
            !(q[j] >= problem.upper[j] && g[j] < 0.))
          free.push_back(j);
      return free;
    }



    /// ROL's view of the problem in z = q/scale, with the Gauss-Newton Hessian.
    class ScaledObjective : public ROL::Objective<double>
    {
    public:
      ScaledObjective(const FitProblem &problem, const Numbers &scale)
        : problem(problem)
        , scale(scale)
      {}

      double value(const ROL::Vector<double> &z, double &) override
      {
        const double cost = half_square(problem.residuals(parameters(z)));
        // A trial the model cannot answer must not be taken.
        return std::isfinite(cost) ? cost : 1e300;
      }

      void gradient(ROL::Vector<double>       &g,
                    const ROL::Vector<double> &z,
                    double &) override
      {
        const Numbers q = parameters(z);
        assign(g, transposed_product(jacobian(q), problem.residuals(q)));
      }

      void hessVec(ROL::Vector<double>       &Hv,
                   const ROL::Vector<double> &v,
                   const ROL::Vector<double> &z,
                   double &) override
      {
        const FullMatrix<double> &J  = jacobian(parameters(z));
        const Numbers             dq = parameters(v);
        Numbers                   Jv(J.m(), 0.);
        for (unsigned int i = 0; i < J.m(); ++i)
          for (unsigned int j = 0; j < J.n(); ++j)
            Jv[i] += J(i, j) * dq[j];
        assign(Hv, transposed_product(J, Jv));
      }

      Numbers parameters(const ROL::Vector<double> &z) const
      {
        Numbers q =
          *dynamic_cast<const ROL::StdVector<double> &>(z).getVector();
        for (unsigned int j = 0; j < q.size(); ++j)
          q[j] *= scale[j];
        return q;
      }

    private:
      /// Writes the derivative by z that belongs to the one by q.
      void assign(ROL::Vector<double> &derivative, Numbers by_q) const
      {
        for (unsigned int j = 0; j < by_q.size(); ++j)
          by_q[j] *= scale[j];
        *dynamic_cast<ROL::StdVector<double> &>(derivative).getVector() = by_q;
      }

      /// Products with the Hessian come in rows for the same point.
      const FullMatrix<double> &jacobian(const Numbers &q)
      {
        if (q != q_of_J)
          {
            J      = problem.jacobian(q);
            q_of_J = q;
          }
        return J;
      }

      const FitProblem  &problem;
      const Numbers      scale;
      FullMatrix<double> J;
      Numbers            q_of_J;
    };



    ROL::ParameterList settings(const double gradient_tolerance)
    {
      ROL::ParameterList list;
      auto              &status = list.sublist("Status Test");
      status.set("Gradient Tolerance", gradient_tolerance);
      status.set("Step Tolerance", 1e-13);
      status.set("Iteration Limit", 200);
      auto &krylov = list.sublist("General").sublist("Krylov");
      krylov.set("Iteration Limit", 500);
      krylov.set("Absolute Tolerance", 1e-14);
      krylov.set("Relative Tolerance", 1e-6);
      list.sublist("General").set("Output Level", 0);
      list.sublist("Step").sublist("Trust Region").set("Initial Radius", 1.);
      return list;
    }



    Numbers optimised(const FitProblem &problem,
                      const Numbers    &start,
                      unsigned int     &n_iterations)
    {
      const auto    J     = problem.jacobian(start);
      const Numbers g     = transposed_product(J, problem.residuals(start));
      Numbers       scale = column_lengths(J);
      for (double &s : scale)
        s = s > 0. ? 1. / s : 1.;

      const unsigned int n           = start.size();
      const auto         make_vector = [&](const Numbers &q) {
        auto z = ROL::makePtr<std::vector<double>>(n);
        for (unsigned int j = 0; j < n; ++j)
          (*z)[j] = std::min(std::max(q[j] / scale[j], -1e300), 1e300);
        return ROL::makePtr<ROL::StdVector<double>>(z);
      };
      double slope = 0.;
      for (unsigned int j = 0; j < n; ++j)
        slope = std::hypot(slope, g[j] * scale[j]);
      if (slope == 0.)
        return start;

      ScaledObjective     objective(problem, scale);
      ROL::Bounds<double> bounds(make_vector(problem.lower),
                                 make_vector(problem.upper));
      auto                list = settings(problem.tolerance * slope);
      const auto          z    = make_vector(start);
      ROL::TypeB::LinMoreAlgorithm<double> algorithm(list);
      Teuchos::oblackholestream            nowhere;
      algorithm.run(*z, objective, bounds, nowhere);
      n_iterations = algorithm.getState()->iter;
      return problem.clipped(objective.parameters(*z));
    }



    /// A Gauss-Newton step of the free parameters of @p q, halved until it does
    /// not increase the cost. False: none does, or none is needed any more.
    bool polish(const FitProblem &problem, Numbers &q)
    {
      const auto    J = problem.jacobian(q);
      const Numbers r = problem.residuals(q);
      const auto free = free_parameters(problem, q, transposed_product(J, r));
      if (free.empty() || free.size() > J.m())
        return false;
      FullMatrix<double> J_free(J.m(), free.size());
      for (unsigned int i = 0; i < J.m(); ++i)
        for (unsigned int k = 0; k < free.size(); ++k)
          J_free(i, k) = J(i, free[k]);
      const Numbers step = ScaledSvd(J_free).solve(r);

      const Numbers length = column_lengths(J);
      double        size = 0., move = 0.;
      for (unsigned int k = 0; k < free.size(); ++k)
        {
          size = std::max(size, std::abs(q[free[k]]) * length[free[k]]);
          move = std::max(move, std::abs(step[k]) * length[free[k]]);
        }
      if (move <= 1e-15 * size)
        return false;
      for (double fraction = 1.; fraction > 1e-4; fraction *= .5)
        {
          Numbers trial = q;
          for (unsigned int k = 0; k < free.size(); ++k)
            trial[free[k]] -= fraction * step[k];
          trial = problem.clipped(trial);
          if (half_square(problem.residuals(trial)) < half_square(r))
            {
              q = trial;
              return true;
            }
        }
      return false;
    }



    double remaining_slope(const FitProblem &problem, const Numbers &q)
    {
      const auto    J      = problem.jacobian(q);
      const Numbers r      = problem.residuals(q);
      const Numbers g      = transposed_product(J, r);
      const Numbers length = column_lengths(J);
      double        size   = std::sqrt(2. * half_square(r));
      double        slope  = 0.;
      // Residuals at round-off have no direction.
      for (unsigned int j = 0; j < q.size(); ++j)
        size = std::max(size, 1e-10 * length[j] * std::abs(q[j]));
      for (const unsigned int j : free_parameters(problem, q, g))
        if (length[j] * size > 0.)
          slope = std::max(slope, std::abs(g[j]) / (length[j] * size));
      return slope;
    }
  } // namespace



  FitResult minimise(const FitProblem &problem)
  {
    FitResult result;
    result.parameters =
      optimised(problem, problem.clipped(problem.start), result.n_iterations);
    for (unsigned int i = 0; i < 50 && polish(problem, result.parameters); ++i)
      {}
    result.slope = remaining_slope(problem, result.parameters);
    return result;
  }
} // namespace demold
