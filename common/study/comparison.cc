// SPDX-License-Identifier: LGPL-2.1-or-later
// Errors, orders and the Pareto front of the runs of a study.
#include "study/comparison.h"

#include "study/accuracy.h"
#include "study/study_parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace demold
{
  namespace
  {
    /// Value of the refined entry.
    double size_of(const StudyParameters &study, const StudyRun &run)
    {
      const std::size_t refined = study.refined();
      return refined < run.values.size() ? first_number(run.values[refined]) :
                                           StudyRun::unknown;
    }



    bool is_finer(const StudyParameters &study, const double a, const double b)
    {
      return study.finest == "smallest value" ? a < b :
             study.finest == "largest value"  ? a > b :
                                                false;
    }



    /// The last of the finest in @p candidates with a quantity; runs.size() if
    /// there is none. @p position tells the place of a run in its series.
    std::size_t finest_of(const std::vector<StudyRun>    &runs,
                          const std::vector<std::size_t> &candidates,
                          const std::vector<std::size_t> &position)
    {
      std::size_t finest = runs.size();
      for (const std::size_t i : candidates)
        if (!std::isnan(runs[i].quantity) &&
            (finest == runs.size() || position[i] >= position[finest]))
          finest = i;
      return finest;
    }



    /// With the three digits the table shows: what differs by less is equal, or
    /// round-off would decide what is on the front.
    double shown(const double error, const double round_off)
    {
      if (!(error > round_off))
        return std::isnan(error) ? error : 0.;
      const double unit = std::pow(10., std::floor(std::log10(error)) - 2.);
      return unit * std::round(error / unit);
    }



    void refer_to_finest(const StudyParameters     &study,
                         const std::vector<Series> &all_series,
                         std::vector<StudyRun>     &runs)
    {
      std::vector<std::size_t> position(runs.size()), everyone(runs.size());
      for (const Series &series : all_series)
        for (std::size_t k = 0; k < series.runs.size(); ++k)
          position[series.runs[k]] = k;
      for (std::size_t i = 0; i < runs.size(); ++i)
        everyone[i] = i;
      for (const Series &series : all_series)
        {
          const std::size_t finest =
            finest_of(runs,
                      study.compare.among == "all runs" ? everyone :
                                                          series.runs,
                      position);
          if (finest == runs.size())
            continue;
          runs[finest].is_reference = true;
          for (const std::size_t i : series.runs)
            runs[i].reference = runs[finest].quantity;
        }
    }



    void find_errors(const StudyParameters &study, std::vector<StudyRun> &runs)
    {
      for (StudyRun &run : runs)
        {
          if (study.compare.reference == "closed form")
            run.reference = evaluate_formula(study.compare.closed_form,
                                             study.symbols(run.values),
                                             "Compare/closed form");
          else if (study.compare.reference == "value")
            run.reference = study.compare.value;
          run.error = std::abs(run.quantity - run.reference);
          if (study.compare.measure == "relative")
            run.error /= std::abs(run.reference);
          if (!std::isfinite(run.error))
            {
              if (run.completed && run.reason.empty() &&
                  study.compare.reference != "none")
                run.reason = "no error: the reference is not a number, or 0";
              run.error = StudyRun::unknown;
            }
        }
    }
  } // namespace



  std::vector<Series> series_of(const StudyParameters       &study,
                                const std::vector<StudyRun> &runs)
  {
    const auto          sweeps = study.sweeps();
    std::vector<Series> list;
    for (std::size_t i = 0; i < runs.size(); ++i)
      {
        std::string name;
        for (std::size_t s = 0; s < sweeps.size(); ++s)
          if (study.refined() < sweeps.size() && !study.varies_in_series(s))
            name += (name.empty() ? "" : ", ") + sweeps[s].heading() + " = " +
                    runs[i].values[s];
        auto series =
          std::find_if(list.begin(), list.end(), [&](const Series &other) {
            return other.name == name;
          });
        if (series == list.end())
          series = list.insert(list.end(), {name, {}, StudyRun::unknown});
        series->runs.push_back(i);
      }
    for (Series &series : list)
      std::stable_sort(series.runs.begin(),
                       series.runs.end(),
                       [&](const std::size_t a, const std::size_t b) {
                         return is_finer(study,
                                         size_of(study, runs[b]),
                                         size_of(study, runs[a]));
                       });
    return list;
  }



  std::vector<Series> compare_runs(const StudyParameters &study,
                                   std::vector<StudyRun> &runs)
  {
    auto list = series_of(study, runs);
    if (study.compare.reference == "finest")
      refer_to_finest(study, list, runs);
    find_errors(study, runs);

    const double round_off = study.compare.round_off;
    for (Series &series : list)
      {
        std::vector<double> errors, sizes;
        for (const std::size_t i : series.runs)
          if (!runs[i].is_reference)
            {
              errors.push_back(runs[i].error);
              sizes.push_back(size_of(study, runs[i]));
              const std::size_t n = errors.size();
              if (n > 1 && errors[n - 1] >= round_off &&
                  errors[n - 2] >= round_off)
                runs[i].order = observed_order(errors[n - 2],
                                               errors[n - 1],
                                               sizes[n - 2],
                                               sizes[n - 1]);
            }
        series.order = fitted_order(errors, sizes, round_off);
      }

    std::vector<double> times, errors;
    for (const StudyRun &run : runs)
      {
        times.push_back(run.cpu_time);
        errors.push_back(run.is_reference ? StudyRun::unknown :
                                            shown(run.error, round_off));
      }
    const auto on_front = pareto_front(times, errors);
    for (std::size_t i = 0; i < runs.size(); ++i)
      runs[i].on_front = on_front[i];
    return list;
  }
} // namespace demold
