// SPDX-License-Identifier: LGPL-2.1-or-later
// The shipped fits keep their claims.
#include "task_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <iomanip>

namespace demold
{
  namespace
  {
    const std::string with_equibiaxial =
      "Static fit/equibiaxial file=" + shipped("data/treloar-equibiaxial.csv");

    constexpr double pi = 3.14159265358979324;

    /// Angular frequencies [rad/s] of the exact series of theory A.4.
    std::vector<double> frequencies()
    {
      std::vector<double> omega;
      for (unsigned int i = 0; i <= 30; ++i)
        omega.push_back(2. * pi * std::pow(10., -3. + .2 * i));
      return omega;
    }

    /// E* [MPa] of a series of theory A.2.
    std::complex<double> modulus(const double               equilibrium,
                                 const std::vector<double> &moduli,
                                 const std::vector<double> &times,
                                 const double               omega)
    {
      std::complex<double> sum = equilibrium;
      for (unsigned int j = 0; j < times.size(); ++j)
        {
          const std::complex<double> z(0., omega * times[j]);
          sum += moduli[j] * z / (1. + z);
        }
      return sum;
    }

    /// R^2 [-] of a fit by its table, rows of weight 0 left out.
    double determination(const CsvTable &fit, const std::vector<double> &weight)
    {
      const auto &data = fit["data [MPa]"], &miss = fit["residual [MPa]"];
      double      n = 0., mean = 0., left = 0., all = 0.;
      for (std::size_t i = 0; i < data.size(); ++i)
        {
          n += weight[i];
          mean += weight[i] * data[i];
        }
      mean /= n;
      for (std::size_t i = 0; i < data.size(); ++i)
        {
          left += weight[i] * miss[i] * miss[i];
          all += weight[i] * (data[i] - mean) * (data[i] - mean);
        }
      return 1. - left / all;
    }
  } // namespace



  // Expected values: theory A.4, an independent least squares.
  TEST(treloar_fit, finds_the_moduli_and_says_what_uniaxial_data_leave_open)
  {
    const TaskRun run(shipped("treloar-fit.prm"));
    EXPECT_NEAR(run.number("mu1 [MPa]"), .20332, 1e-5);
    EXPECT_NEAR(run.number("mu2 [MPa]"), .22236, 1e-5);
    EXPECT_NEAR(run.number("rms [MPa]"), 3.1e-4, 1e-5);
    EXPECT_TRUE(contains(run.words("identifiability"),
                         "Uniaxial data alone do not identify mu2"))
      << run.words("identifiability");

    const TaskRun both(shipped("treloar-fit.prm"), {with_equibiaxial});
    EXPECT_NEAR(both.number("mu1 [MPa]"), .33578, 1e-5);
    EXPECT_NEAR(both.number("mu2 [MPa]"), .04272, 1e-5);
    EXPECT_NEAR(both.number("rms [MPa]"), .0147, 1e-4);
    EXPECT_FALSE(contains(both.words("identifiability"), "do not identify"));
  }

  TEST(treloar_fit, R2_is_that_of_the_table_it_writes)
  {
    const TaskRun  run(shipped("treloar-fit.prm"), {with_equibiaxial});
    const CsvTable fit    = run.table("fit.csv");
    const auto    &weight = fit["weight [-]"];
    // 6 uniaxial and 8 equibiaxial rows reach up to 1.6.
    EXPECT_EQ(std::count(weight.begin(), weight.end(), 1.), 14);
    EXPECT_NEAR(run.number("R2 [-]"), determination(fit, weight), 1e-6);
  }

  TEST(treloar_fit, the_law_of_scenes_tends_to_the_incompressible_one)
  {
    double mu[2][2];
    for (const unsigned int stiff : {0, 1})
      {
        const TaskRun run(shipped("treloar-fit.prm"),
                          {with_equibiaxial,
                           "Static fit/law=mooney-rivlin",
                           stiff == 1 ? "Static fit/lambda=1e5" :
                                        "Static fit/lambda=50"});
        mu[stiff][0] = run.number("mu1 [MPa]");
        mu[stiff][1] = run.number("mu2 [MPa]");
      }
    const double limit[] = {.33578, .04272};
    for (const unsigned int j : {0, 1})
      {
        EXPECT_NEAR(mu[1][j], limit[j], 1e-5);
        EXPECT_GT(std::abs(mu[0][j] - limit[j]), 1e-4);
        EXPECT_NEAR(mu[0][j], limit[j], .02 * (limit[0] + limit[1]));
      }
  }

  TEST(treloar_fit, of_ogden_writes_no_include_and_says_so)
  {
    const TaskRun run(shipped("treloar-fit.prm"),
                      {with_equibiaxial,
                       "Static fit/law=ogden",
                       "Static fit/largest stretch=8"});
    EXPECT_FALSE(std::filesystem::exists(run.file("material.prm")));
    EXPECT_TRUE(contains(run.words("include file"), "no scene has this law"));
    EXPECT_GT(run.number("alpha1 [-]"), 2.); // it hardens
  }

  TEST(dma_fit, recovers_an_exact_series_to_1e_10)
  {
    const std::vector<double> times{.01, .1, 1., 10.}, moduli{.5, .3, .2, .15};
    std::ostringstream        csv;
    csv << std::setprecision(17)
        << "frequency [Hz],storage modulus [MPa],loss modulus [MPa]\n";
    for (const double omega : frequencies())
      {
        const auto E = modulus(1.5, moduli, times, omega);
        csv << omega / (2. * pi) << ',' << E.real() << ',' << E.imag() << '\n';
      }
    const ScratchFolder data;
    const TaskRun       run(shipped("dma-fit.prm"),
                      {"Dma fit/relaxation times=0.01, 0.1, 1, 10",
                             "Dma fit/Level 1/data file=" +
                               data.write("exact.csv", csv.str()),
                             "Dma fit/Level 1/f90=1",
                             "Dma fit/Level 2/data file=",
                             "Dma fit/Level 3/data file="});
    const auto found = run.table("series.csv")["modulus at f90 1 [MPa]"];
    ASSERT_EQ(found.size(), 5u);
    for (unsigned int j = 0; j < 4; ++j)
      EXPECT_NEAR(found[j], moduli[j], 1e-10);
    EXPECT_NEAR(found[4], 1.5, 1e-10);
    EXPECT_LT(run.number("rms [%]"), 1e-8);
  }

  // Optima of nonnegative moduli: theory A.4 and an independent solver.
  TEST(dma_fit, of_tread_ref_is_the_optimum_and_seven_free_times_do_better)
  {
    const TaskRun                         fixed(shipped("dma-fit.prm"));
    const TaskRun                         free(shipped("dma-fit.prm"),
                       {"Dma fit/relaxation times=",
                                                "Dma fit/times=optimised",
                                                "Dma fit/branches=7"});
    const std::pair<const char *, double> optima[] = {{"0.6", 2.730},
                                                      {"0.8", 2.705},
                                                      {"1", 2.675}};
    for (const auto &[f90, optimum] : optima)
      {
        const std::string key = std::string("rms at f90 ") + f90 + " [%]";
        EXPECT_NEAR(fixed.number(key), optimum, 1e-3);
        EXPECT_LE(fixed.number(key), 2.74);
      }
    EXPECT_LT(free.number("rms [%]"), fixed.number("rms [%]"));
    EXPECT_EQ(free.number("branches [-]"), 7.);
  }

  // The data: fractional Zener solid of E_inf = dE = 3 MPa, a = 0.3, 1 ms.
  TEST(relaxation_fit, predicts_the_storage_modulus_it_has_not_seen)
  {
    const TaskRun  run(shipped("relaxation-fit.prm"));
    const CsvTable series  = run.table("series.csv");
    auto           times   = series["relaxation time [s]"];
    auto           moduli  = series["modulus [MPa]"];
    const double   relaxed = moduli.back();
    times.pop_back();
    moduli.pop_back();
    for (const double omega : {.01, .05, .2, 1., 5.})
      {
        const auto   z = std::pow(std::complex<double>(0., omega * 1e-3), .3);
        const double storage = (3. + 3. * z / (1. + z)).real();
        EXPECT_NEAR(modulus(relaxed, moduli, times, omega).real() / storage,
                    1.,
                    .02);
      }
    // The scatter of the data is 0.5 %.
    EXPECT_NEAR(run.number("rms [%]"), .5, .1);
    const CsvTable            fit = run.table("fit.csv");
    const std::vector<double> all(fit.n_rows(), 1.);
    EXPECT_NEAR(run.number("R2 [-]"), determination(fit, all), 1e-6);
  }

  // 98.5 +- 3 kJ/mol: theory A.3, of the same rubber.
  TEST(cure_fit, of_three_curves_predicts_a_temperature_it_has_not_seen)
  {
    const TaskRun run(shipped("cure-fit.prm"));
    EXPECT_NEAR(run.number("activation energy from t90 [kJ/mol]"), 98.5, 3.);
    EXPECT_LE(run.number("rms of the degree of cure [-]"), .02);

    const double line  = run.number("t90 at 150 degC by Arrhenius' line [s]"),
                 law   = run.number("t90 at 150 degC by the kinetics [s]"),
                 lower = run.number("95 % lower bound of t90 at 150 degC [s]"),
                 upper = run.number("95 % upper bound of t90 at 150 degC [s]");
    EXPECT_LT(lower, std::min(line, law));
    EXPECT_GT(upper, std::max(line, law));
    EXPECT_GT(run.number("standard error of t90 at 150 degC by the kinetics "
                         "[s]"),
              0.);
    // By hand from t90 = 409 s at 160 degC.
    const double by_hand =
      409. * std::exp(98.5e3 / 8.314462618 * (1. / 423.15 - 1. / 433.15));
    EXPECT_NEAR(line / by_hand, 1., .05);
    EXPECT_NEAR(law / by_hand, 1., .05);
  }
} // namespace demold
