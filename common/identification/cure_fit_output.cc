// SPDX-License-Identifier: LGPL-2.1-or-later
// Tables and include file of a cure fit.
#include "identification/cure_fit_output.h"


#include "cure/cure_model.h"
#include "output/result_table.h"

#include <variant>

namespace demold
{
  std::string curve_name(const double temperature)
  {
    return prm_number(temperature) + " degC";
  }



  void write_fit(const std::string                 &folder,
                 const CureFit                     &fit,
                 const CureFitResult               &result,
                 const std::vector<RheometerCurve> &curves)
  {
    ResultTable table(folder + "/fit.csv",
                      {"curve",
                       "time [s]",
                       "storage torque [dNm]",
                       "data [-]",
                       "model [-]",
                       "residual [-]",
                       "used [-]"});
    for (const auto &curve : curves)
      {
        const auto data  = curve.degrees_of_cure();
        const auto model = isothermal_degree_of_cure(result.kinetics,
                                                     curve.temperature,
                                                     curve.times,
                                                     OdeTolerances());
        for (unsigned int i = 0; i < data.size(); ++i)
          table.add_row({curve_name(curve.temperature),
                         curve.times[i],
                         curve.torques[i],
                         data[i],
                         model[i],
                         model[i] - data[i],
                         fit.uses(curve, i) ? 1. : 0.});
      }
  }



  void write_times(const std::string                 &folder,
                   const std::vector<RheometerCurve> &curves)
  {
    ResultTable table(folder + "/times.csv",
                      {"temperature [degC]",
                       "smallest torque [dNm]",
                       "largest torque [dNm]",
                       "t10 [s]",
                       "t50 [s]",
                       "t90 [s]",
                       "reversion [-]"});
    for (const auto &curve : curves)
      table.add_row({curve.temperature,
                     curve.minimum,
                     curve.maximum,
                     curve.time_of(.1),
                     curve.time_of(.5),
                     curve.time_of(.9),
                     curve.reversion()});
  }



  ParameterInclude cure_include(const Kinetics      &kinetics,
                                const ArrheniusTime &t90)
  {
    ParameterInclude cure;
    cure.section = "Cure";
    cure.set("reference temperature", t90.reference_temperature);
    cure.set("t90", t90.reference_value);
    cure.set("activation energy", t90.activation_energy);
    cure.set("kinetics", kinetics.name());

    ParameterInclude piece;
    const auto       set_rate = [&](const std::string   &name,
                              const ArrheniusRate &rate) {
      piece.set(name, rate.reference_value);
      piece.set(name + " energy", rate.activation_energy);
    };
    if (const auto *kamal = std::get_if<KamalSourour>(&kinetics.law))
      {
        piece.section = "Kamal-Sourour";
        set_rate("k1", kamal->k1);
        set_rate("k2", kamal->k2);
        piece.set("m", kamal->m);
        piece.set("n", kamal->n);
      }
    if (const auto *isayev = std::get_if<IsayevDeng>(&kinetics.law))
      {
        piece.section = "Isayev-Deng";
        set_rate("k", isayev->k);
        piece.set("n", isayev->n);
      }
    if (const auto *han = std::get_if<Han>(&kinetics.law))
      {
        piece.section = "Han";
        set_rate("k1", han->k1);
        set_rate("k2", han->k2);
        set_rate("k3", han->k3);
      }
    piece.set("induction time", kinetics.induction.reference_value);
    piece.set("induction energy", kinetics.induction.activation_energy);
    cure.inner.push_back(piece);
    return cure;
  }
} // namespace demold
