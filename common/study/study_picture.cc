// SPDX-License-Identifier: LGPL-2.1-or-later
// Error over CPU time of a study, with orders and the Pareto front.
#include "study/study_picture.h"

#include "output/plots.h"
#include "study/study_parameters.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace demold
{
  namespace
  {
    struct Mark
    {
      double      x = 0., y = 0.;
      std::string text;
    };

    using Curve = std::vector<Mark>;

    /// Labels at the points of more series would cover each other.
    constexpr std::size_t most_labelled = 4;

    /// A text as gnuplot reads it between single quotes.
    std::string quoted(const std::string &text)
    {
      std::string result = "'";
      for (const char c : text)
        result += c == '\'' ? std::string("''") : std::string(1, c);
      return result + "'";
    }



    std::string without_white(std::string text)
    {
      std::replace(text.begin(), text.end(), ' ', '_');
      std::replace(text.begin(), text.end(), '"', '_');
      return text.empty() ? "-" : text;
    }



    void put_block(std::ostream      &script,
                   const std::string &name,
                   const Curve       &curve)
    {
      script << '$' << name << " << END\n";
      for (const Mark &mark : curve)
        script << mark.x << ' ' << mark.y << ' ' << without_white(mark.text)
               << '\n';
      script << "END\n";
    }



    std::string key_of(const Series &series)
    {
      if (std::isnan(series.order))
        return series.name;
      char order[40];
      std::snprintf(order, sizeof(order), "order %.2f", series.order);
      return series.name + (series.name.empty() ? "" : ": ") + order;
    }



    StudyPicture error_picture(const StudyParameters       &study,
                               const std::vector<StudyRun> &runs,
                               const std::vector<Series>   &all_series)
    {
      std::ostringstream script, plot;
      script.precision(15);
      script << plot_head("error-over-cpu-time", study.title)
             << "set logscale xy\n"
             << "set format y '%.0e'\nset format x '%g'\n"
             << "set offsets graph 0.08, graph 0.08, graph 0.05, graph 0.05\n"
             << "set xlabel 'CPU time [s]'\n"
             << "set ylabel "
             << quoted(study.compare.error_heading() + " of " +
                       study.compare.quantity)
             << "\nset key below font ',12'\n";

      const bool   has_labels = all_series.size() <= most_labelled;
      Curve        front;
      unsigned int n = 0;
      for (const Series &series : all_series)
        {
          Curve curve;
          for (const std::size_t i : series.runs)
            if (const StudyRun &run = runs[i];
                run.error > 0. && run.cpu_time > 0. && !run.is_reference)
              {
                curve.push_back(
                  {run.cpu_time,
                   run.error,
                   study.refined() < run.values.size() ?
                     run.values[study.refined()] :
                     combination_text(study.sweeps(), run.values)});
                if (run.on_front)
                  front.push_back(curve.back());
              }
          if (curve.empty())
            continue;
          const std::string block = "series" + std::to_string(++n);
          put_block(script, block, curve);
          plot << "$" << block << " using 1:2 with linespoints linetype " << n
               << " pointtype 7 title " << quoted(key_of(series))
               << ", \\\n     ";
          if (has_labels)
            plot << "$" << block
                 << " using 1:2:3 with labels offset 0,0.8 font ',10' notitle, "
                    "\\\n     ";
        }
      if (n == 0)
        return {};
      std::sort(front.begin(), front.end(), [](const Mark &a, const Mark &b) {
        return a.x < b.x;
      });
      put_block(script, "front", front);
      script << "plot " << plot.str()
             << "$front using 1:2 with linespoints linewidth 1 dashtype 2 "
                "pointtype 6 pointsize 2 linecolor rgb '#000000' title 'Pareto "
                "front'\n";
      return {"error-over-cpu-time", script.str()};
    }



    StudyPicture quantity_picture(const StudyParameters       &study,
                                  const std::vector<StudyRun> &runs,
                                  const std::vector<Series>   &all_series)
    {
      const auto sweeps = study.sweeps();
      if (study.refined() >= sweeps.size())
        return {};
      std::ostringstream script, plot;
      script.precision(15);
      script << plot_head("quantity", study.title) << "set xlabel "
             << quoted(sweeps[study.refined()].heading()) << "\nset ylabel "
             << quoted(study.compare.quantity)
             << "\nset offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05\n"
             << "set key below font ',12'\n";
      const unsigned int marks[] = {7, 4, 8}; // disc, square, triangle
      unsigned int       n       = 0;
      for (const Series &series : all_series)
        {
          Curve curve;
          for (const std::size_t i : series.runs)
            {
              const auto  &word  = runs[i].values[study.refined()];
              const double value = first_number(word);
              if (!std::isnan(value) && !std::isnan(runs[i].quantity))
                curve.push_back({value, runs[i].quantity, word});
            }
          if (curve.empty())
            continue;
          const std::string block = "series" + std::to_string(++n);
          put_block(script, block, curve);
          // Curves may coincide: dashes and open marks let both be seen.
          plot << (n == 1 ? "" : ", \\\n     ") << "$" << block
               << " using 1:2 with linespoints linetype " << n << " dashtype "
               << (n - 1) % 3 + 1 << " pointtype " << marks[(n - 1) % 3]
               << " title " << quoted(series.name);
        }
      if (n == 0)
        return {};
      script << "plot " << plot.str() << '\n';
      return {"quantity", script.str()};
    }
  } // namespace



  StudyPicture picture_of(const StudyParameters       &study,
                          const std::vector<StudyRun> &runs,
                          const std::vector<Series>   &all_series)
  {
    return study.compare.reference == "none" ?
             quantity_picture(study, runs, all_series) :
             error_picture(study, runs, all_series);
  }
} // namespace demold
