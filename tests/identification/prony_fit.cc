// SPDX-License-Identifier: LGPL-2.1-or-later
// Prony series: exact data are recovered, real ones fitted at the optimum.
#include "identification/prony_fit.h"

#include "base/data_file.h"
#include "base/parameter_entries.h"
#include "base/parameter_file.h"
#include "identification/parameter_include.h"
#include "identification/prony_choice.h"
#include "material/rubber_model.h"

#include "scratch_folder.h"

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace
{
  using namespace demold;

  const double pi = dealii::numbers::PI;

  PronyCurve curve_of(const std::vector<double> &omega,
                      const std::vector<double> &storage,
                      const std::vector<double> &loss)
  {
    PronyCurve curve;
    for (unsigned int i = 0; i < omega.size(); ++i)
      {
        curve.points.push_back(
          {PronyQuantity::storage, omega[i], storage[i], 1. / storage[i]});
        curve.points.push_back(
          {PronyQuantity::loss, omega[i], loss[i], 1. / loss[i]});
      }
    return curve;
  }

  /// The exact series of theory A.4 and what it answers at 31 frequencies.
  const PronySeries exact{1.5, {.01, .1, 1., 10.}, {.5, .3, .2, .15}};

  PronyCurve exact_curve()
  {
    std::vector<double> omega, storage, loss;
    for (unsigned int i = 0; i < 31; ++i)
      {
        omega.push_back(2. * pi * std::pow(10., -3. + .2 * i));
        double E1 = exact.equilibrium, E2 = 0.;
        for (unsigned int j = 0; j < 4; ++j)
          {
            const double u = omega[i] * exact.times[j];
            E1 += exact.moduli[j] * u * u / (1. + u * u);
            E2 += exact.moduli[j] * u / (1. + u * u);
          }
        storage.push_back(E1);
        loss.push_back(E2);
      }
    return curve_of(omega, storage, loss);
  }

  PronyCurve tread_ref(const std::string &f90)
  {
    auto data = read_data_file(
      std::string(DEMOLD_SOURCE_DIR) +
        "/prm/step-material/data/tread-ref-dma-f90-" + f90 + ".csv",
      {{"frequency [Hz]"}, {"storage modulus [MPa]"}, {"loss modulus [MPa]"}});
    for (double &f : data.columns[0])
      f *= 2. * pi;
    return curve_of(data.columns[0], data.columns[1], data.columns[2]);
  }

  TEST(prony_fit, recovers_an_exact_series_to_1e_10)
  {
    // Branches that are not there get no modulus.
    const auto result =
      PronyFit().fit_moduli({exact_curve()}, {.001, .01, .1, 1., 10., 100.});
    const auto &series = result.series[0];
    EXPECT_NEAR(series.equilibrium / exact.equilibrium, 1., 1e-10);
    for (unsigned int j = 0; j < 4; ++j)
      EXPECT_NEAR(series.moduli[j + 1] / exact.moduli[j], 1., 1e-10);
    EXPECT_LT(series.moduli[0], 1e-10);
    EXPECT_LT(series.moduli[5], 1e-10);
  }

  TEST(prony_fit, finds_the_relaxation_times_of_an_exact_series)
  {
    const auto result = PronyFit().fit_times({exact_curve()},
                                             logarithmic_times(1e-3, 30., 4),
                                             1e-5,
                                             1e3);
    for (unsigned int j = 0; j < 4; ++j)
      {
        EXPECT_NEAR(result.series[0].times[j] / exact.times[j], 1., 1e-10);
        EXPECT_NEAR(result.series[0].moduli[j] / exact.moduli[j], 1., 1e-10);
      }
  }

  // Optima of an independent solver (theory A.4): 2.675, 2.705, 2.730 %.
  TEST(prony_fit, fits_tread_ref_at_the_optimum_and_better_with_seven_times)
  {
    const struct
    {
      const char *f90;
      double      optimum;
    } cases[] = {{"1.0", 2.675}, {"0.8", 2.705}, {"0.6", 2.730}};
    for (const auto &c : cases)
      {
        const auto curve = tread_ref(c.f90);
        const auto fixed =
          PronyFit().fit_moduli({curve}, logarithmic_times(1e-4, 1e3, 8));
        EXPECT_NEAR(100. * fixed.report.rms, c.optimum, 1e-3);
        const auto free = PronyFit().fit_times({curve},
                                               logarithmic_times(1e-4, 1e3, 7),
                                               1e-5,
                                               1e4);
        EXPECT_LT(free.report.rms, .9 * fixed.report.rms);
      }
  }

  TEST(prony_fit, a_known_equilibrium_modulus_is_kept)
  {
    const PronyFit fit{{1.5}};
    const auto     result = fit.fit_moduli({exact_curve()}, exact.times);
    EXPECT_EQ(result.series[0].equilibrium, 1.5);
    EXPECT_NEAR(result.series[0].moduli[3], .15, 1e-11);
    EXPECT_EQ(result.report.parameters.size(), 4u);
  }

  TEST(prony_curve, derivatives_by_time_match_differences)
  {
    for (const auto quantity : {PronyQuantity::storage,
                                PronyQuantity::loss,
                                PronyQuantity::relaxation})
      for (const double ramp : {0., .4})
        {
          const double x = .7, tau = .3, d = 1e-5;
          const auto   up = prony_kernel(quantity, x, tau * std::exp(d), ramp),
                     down = prony_kernel(quantity, x, tau * std::exp(-d), ramp);
          EXPECT_NEAR(prony_kernel(quantity, x, tau, ramp).by_log_time,
                      (up.value - down.value) / (2. * d),
                      1e-9);
        }
  }

  /// One branch, strain rate 1/R over the ramp: the stress is the integral of
  /// exp(-(t-s)/tau) ds/R.
  TEST(prony_curve, a_ramp_is_the_mean_over_its_pieces)
  {
    const double t = 1., tau = .3, ramp = .4;
    double       sum = 0.;
    const int    n   = 2000;
    for (int i = 0; i < n; ++i)
      sum += std::exp(-(t - (i + .5) / n * ramp) / tau) / n;
    EXPECT_NEAR(prony_kernel(PronyQuantity::relaxation, t, tau, ramp).value,
                sum,
                1e-8);
  }

  // The curve is that of E* = E_inf + dE z/(1+z), z = (i omega t0)^a with a
  // scatter of 0.5 %; what is fitted in time must answer in frequency.
  TEST(prony_fit, a_relaxation_curve_predicts_the_storage_modulus)
  {
    const auto data = read_data_file(std::string(DEMOLD_SOURCE_DIR) +
                                       "/prm/step-material/data/"
                                       "tread-ref-relaxation.csv",
                                     {{"time [s]", DataColumn::increasing},
                                      {"relaxation modulus [MPa]"}});
    PronyCurve curve;
    curve.ramp = .1;
    for (unsigned int i = 0; i < data.n_rows(); ++i)
      curve.points.push_back({PronyQuantity::relaxation,
                              data.columns[0][i],
                              data.columns[1][i],
                              1. / data.columns[1][i]});
    const auto result =
      PronyFit().fit_moduli({curve}, logarithmic_times(.1, 1000., 5));
    EXPECT_LT(result.report.rms, .006);
    for (double omega = .01; omega < 5.; omega *= 1.5)
      {
        const auto   z = std::pow(std::complex<double>(0., omega * 1e-3), .3);
        const double storage = (3. + 3. * z / (1. + z)).real();
        EXPECT_NEAR(result.series[0].storage_modulus(omega) / storage, 1., .02)
          << omega;
      }
  }

  TEST(prony_choice, the_criterion_finds_the_number_of_branches)
  {
    dealii::ParameterHandler prm;
    PronyChoice              choice;
    choice.add_parameters(prm, "Fit");
    prm.set("times", std::string("optimised"));
    prm.set("most branches", 6l);
    const auto   outcome = choice.fit({exact_curve()}, {});
    unsigned int n       = 0;
    for (const double E : outcome.best.series[0].moduli)
      n += E > 1e-8 ? 1 : 0;
    EXPECT_EQ(n, 4u);
    EXPECT_EQ(outcome.trials.size(), 6u);
  }

  TEST(prony_choice, a_scene_reads_the_include_file_and_has_the_moduli)
  {
    dealii::ParameterHandler unused;
    PronyChoice              choice;
    choice.add_parameters(unused, "Fit");
    const ScratchFolder folder;
    choice.material(exact).write(folder / "material.prm");
    const std::string scene =
      folder.write("scene.prm", "include material.prm\n");

    dealii::ParameterHandler prm;
    RubberModel              model;
    model.add_parameters(prm);
    set_entries(prm, read_parameter_file(scene));
    model.check();
    const auto law = model.at(1.);
    EXPECT_NEAR(3. * law.shear_modulus_relaxed(), exact.equilibrium, 1e-10);
    ASSERT_EQ(law.branches.size(), 4u);
    EXPECT_NEAR(3. * law.branches[2].modulus, .2, 1e-11);
    EXPECT_NEAR(law.branches[2].relaxation_time, 1., 1e-11);

    // a table over f90, whose second level is twice as stiff
    PronySeries stiff = exact;
    stiff.equilibrium *= 2.;
    choice.tables({.5, .7, .9, 1.1}, {exact, stiff, stiff, stiff}, .9)
      .write(folder / "material.prm");
    dealii::ParameterHandler prm_of_table;
    RubberModel              table;
    table.add_parameters(prm_of_table);
    set_entries(prm_of_table, read_parameter_file(scene));
    table.check();
    EXPECT_NEAR(3. * table.at(.5).shear_modulus_relaxed(), 1.5, 1e-10);
    EXPECT_NEAR(3. * table.at(.7).shear_modulus_relaxed(), 3., 1e-10);
  }
} // namespace
