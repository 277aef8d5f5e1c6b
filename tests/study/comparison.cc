// SPDX-License-Identifier: LGPL-2.1-or-later
// Errors, orders and references of runs whose results are known.
#include "study/comparison.h"

#include "study/study_parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace demold
{
  namespace
  {
    constexpr double exact = 5.;

    /// Quantity of a run of order @p p and size @p h.
    double quantity(const double p, const double h)
    {
      return exact * (1. + .2 * std::pow(h, p));
    }

    /// Orders 1 and 2, sizes from @p sizes; the larger the size, the faster.
    struct Case
    {
      explicit Case(const std::string &sizes)
      {
        study.all_sweeps[0].section = "Sweep 1";
        study.all_sweeps[0].entry   = "order";
        study.all_sweeps[0].list    = "1, 2";
        study.all_sweeps[1].section = "Sweep 2";
        study.all_sweeps[1].entry   = "h";
        study.all_sweeps[1].list    = sizes;
        study.refined_sweep         = 2;
        runs                        = planned_runs(study, "out");
        for (StudyRun &run : runs)
          {
            run.completed  = true;
            const double h = first_number(run.values[1]);
            run.quantity   = quantity(first_number(run.values[0]), h);
            run.cpu_time   = 1. / h;
          }
      }

      StudyParameters       study;
      std::vector<StudyRun> runs;
    };
  } // namespace

  TEST(Comparison, orders_are_those_of_the_series)
  {
    Case c("0.4, 0.2, 0.1");
    c.study.compare.reference   = "closed form";
    c.study.compare.closed_form = "5 + 0*h";
    const auto series           = compare_runs(c.study, c.runs);
    ASSERT_EQ(series.size(), 2u);
    for (unsigned int s = 0; s < 2; ++s)
      {
        EXPECT_EQ(series[s].name, "order = " + std::to_string(s + 1));
        EXPECT_NEAR(series[s].order, s + 1., 1e-9);
        EXPECT_TRUE(std::isnan(c.runs[series[s].runs[0]].order));
        for (unsigned int k = 1; k < 3; ++k)
          EXPECT_NEAR(c.runs[series[s].runs[k]].order, s + 1., 1e-9);
      }
    for (const StudyRun &run : c.runs)
      EXPECT_NEAR(run.error,
                  .2 * std::pow(first_number(run.values[1]),
                                first_number(run.values[0])),
                  1e-12);
  }

  TEST(Comparison, only_the_better_of_two_orders_is_on_the_front)
  {
    Case c("0.4, 0.2, 0.1");
    c.study.compare.reference = "value";
    c.study.compare.value     = exact;
    compare_runs(c.study, c.runs);
    for (const StudyRun &run : c.runs)
      EXPECT_EQ(run.on_front, run.values[0] == "2");
  }

  TEST(Comparison, the_finest_is_found_wherever_it_stands_in_the_list)
  {
    for (const char *const sizes : {"0.1, 0.4, 0.2", "0.4, 0.2, 0.1"})
      {
        Case c(sizes);
        c.study.finest = "smallest value";
        compare_runs(c.study, c.runs);
        unsigned int n_references = 0;
        for (const StudyRun &run : c.runs)
          {
            // The last series wins the tie.
            EXPECT_DOUBLE_EQ(run.reference, quantity(2., .1));
            EXPECT_FALSE(run.is_reference && run.on_front);
            n_references += run.is_reference;
          }
        EXPECT_EQ(n_references, 1u);
      }
  }

  TEST(Comparison, every_series_may_have_a_finest_of_its_own)
  {
    Case c("0.4, 0.2, 0.1");
    c.study.compare.among = "own series";
    compare_runs(c.study, c.runs);
    for (const StudyRun &run : c.runs)
      EXPECT_DOUBLE_EQ(run.reference,
                       quantity(first_number(run.values[0]), .1));
  }

  TEST(Comparison, a_failed_run_leaves_a_hole_and_is_no_reference)
  {
    Case c("0.4, 0.2, 0.1");
    for (StudyRun &run : c.runs)
      if (run.values[1] == "0.1")
        {
          run.completed = false;
          run.quantity  = StudyRun::unknown;
        }
    compare_runs(c.study, c.runs);
    for (const StudyRun &run : c.runs)
      {
        EXPECT_DOUBLE_EQ(run.reference, quantity(2., .2));
        EXPECT_EQ(std::isnan(run.error), run.values[1] == "0.1");
      }
  }

  TEST(Comparison, absolute_errors_keep_the_unit)
  {
    Case c("0.4");
    c.study.compare.quantity  = "peak force [N]";
    c.study.compare.measure   = "absolute";
    c.study.compare.reference = "value";
    c.study.compare.value     = exact;
    compare_runs(c.study, c.runs);
    EXPECT_NEAR(c.runs[0].error, quantity(1., .4) - exact, 1e-12);
    EXPECT_EQ(c.study.compare.error_heading(), "error [N]");
  }

  TEST(Comparison, round_off_has_no_order)
  {
    Case c("0.4, 0.2, 0.1");
    for (StudyRun &run : c.runs)
      run.quantity = exact * (1. + 1e-14);
    c.study.compare.reference = "value";
    c.study.compare.value     = exact;
    for (const Series &series : compare_runs(c.study, c.runs))
      EXPECT_TRUE(std::isnan(series.order));
    for (const StudyRun &run : c.runs)
      EXPECT_TRUE(std::isnan(run.order));
  }

  TEST(Comparison, folders_of_runs_differ_even_if_their_names_would_not)
  {
    StudyParameters study;
    study.all_sweeps[0].section = "Sweep 1";
    study.all_sweeps[0].entry   = "s";
    study.all_sweeps[0].list    = "a b; a/b; a, b";
    std::set<std::string> folders;
    for (const StudyRun &run : planned_runs(study, "out"))
      folders.insert(run.folder);
    EXPECT_EQ(folders.size(), 3u);
  }
} // namespace demold
