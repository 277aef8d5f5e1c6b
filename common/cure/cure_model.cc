// SPDX-License-Identifier: LGPL-2.1-or-later
// The state of cure of a point, integrated over its temperature history.
#include "cure/cure_model.h"

#include <algorithm>
#include <memory>
#include <stdexcept>

namespace demold
{
  namespace
  {
    // y = (f90, induction, inner state of the law)
    constexpr std::size_t n_inner = std::tuple_size<KineticState>::value;

    std::vector<double> as_vector(const CureState &state)
    {
      std::vector<double> y = {state.f90, state.induction};
      y.insert(y.end(), state.inner.begin(), state.inner.end());
      return y;
    }

    CureState as_state(const std::vector<double> &y)
    {
      CureState state;
      state.f90       = y[0];
      state.induction = y[1];
      std::copy(y.begin() + 2, y.end(), state.inner.begin());
      return state;
    }



    bool waits(const CureModel &model, const CureState &state)
    {
      return model.kinetics && model.kinetics->induction.reference_value > 0. &&
             state.induction < 1.;
    }



    /// While the induction lasts (@p waiting) the kinetics rest.
    OdeProblem cure_problem(const CureModel          &model,
                            const TemperatureHistory &temperature,
                            const bool                waiting)
    {
      OdeProblem problem;
      problem.rate = [&model, &temperature, waiting](const double  t,
                                                     const double *y,
                                                     double       *rate) {
        const double T = temperature(t);
        rate[0]        = 1. / model.t90(T);
        rate[1]        = waiting ? 1. / model.kinetics->induction(T) : 0.;
        KineticState inner{{}};
        if (model.kinetics && !waiting)
          {
            std::copy(y + 2, y + 2 + n_inner, inner.begin());
            inner = model.kinetics->state_rate(inner, T);
          }
        std::copy(inner.begin(), inner.end(), rate + 2);
      };
      if (waiting)
        problem.event = [](const double, const double *y) { return y[1] - 1.; };
      return problem;
    }
  } // namespace



  Conversion default_conversion()
  {
    return {{0., .4, .5, .55, .6, .65, .7, .75, .8, .9, 1., 1.2, 1.5},
            {0.,
             .028,
             .05,
             .077,
             .172,
             .383,
             .551,
             .672,
             .752,
             .848,
             .9,
             .954,
             .988}};
  }



  double degree_of_cure(const CureModel &model, const CureState &state)
  {
    if (model.kinetics)
      return model.kinetics->degree_of_cure(state.inner);
    return model.conversion(
      std::min(std::max(state.f90, model.conversion.min()),
               model.conversion.max()));
  }



  std::vector<CureState> integrate_cure(const CureModel           &model,
                                        const TemperatureHistory  &temperature,
                                        const std::vector<double> &times,
                                        const OdeTolerances       &tolerances,
                                        const CureState           &initial)
  {
    if (!std::is_sorted(times.begin(), times.end()))
      throw std::invalid_argument("the times of a cure must increase");
    std::vector<CureState> states;
    if (times.empty())
      return states;

    double                     now   = times.front();
    CureState                  state = initial;
    std::unique_ptr<OdeSolver> solver;
    const auto                &stops = temperature.breakpoints;
    for (const double t : times)
      {
        while (now < t)
          {
            const auto stop = std::upper_bound(stops.begin(), stops.end(), now);
            const double limit   = stop == stops.end() ?
                                     times.back() :
                                     std::min(*stop, times.back());
            const bool   waiting = waits(model, state);
            if (!solver)
              solver = std::make_unique<OdeSolver>(cure_problem(model,
                                                                temperature,
                                                                waiting),
                                                   now,
                                                   as_vector(state),
                                                   tolerances);
            const bool over = solver->advance(std::min(t, limit), limit);
            now             = solver->time();
            state           = as_state(solver->state());
            if (over)
              state.induction = 1.;
            // The rates jump here.
            if (over || now >= limit)
              solver.reset();
          }
        states.push_back(state);
      }
    return states;
  }



  std::vector<double>
  isothermal_degree_of_cure(const Kinetics            &kinetics,
                            const double               temperature,
                            const std::vector<double> &times,
                            const OdeTolerances       &tolerances)
  {
    const double        wait = kinetics.induction(temperature);
    std::vector<double> degrees;
    if (!std::holds_alternative<KamalSourour>(kinetics.law))
      {
        for (const double t : times)
          if (const auto *law = std::get_if<IsayevDeng>(&kinetics.law))
            degrees.push_back(
              law->isothermal(std::max(t - wait, 0.), temperature));
          else
            degrees.push_back(
              std::get<Han>(kinetics.law)
                .isothermal(std::max(t - wait, 0.), temperature));
        return degrees;
      }
    CureModel model;
    model.kinetics           = kinetics;
    std::vector<double> grid = {0.};
    grid.insert(grid.end(), times.begin(), times.end());
    const auto states = integrate_cure(model,
                                       TemperatureHistory(temperature),
                                       grid,
                                       tolerances,
                                       CureState());
    for (std::size_t i = 1; i < states.size(); ++i)
      degrees.push_back(degree_of_cure(model, states[i]));
    return degrees;
  }
} // namespace demold
