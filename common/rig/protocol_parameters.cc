// SPDX-License-Identifier: LGPL-2.1-or-later
// Section Protocol: entries, and the runs they ask for.
#include "rig/protocol_parameters.h"

#include <deal.II/base/parameter_handler.h>

namespace demold
{
  using namespace dealii;

  namespace
  {
    constexpr const char *programme_names =
      "ramp|relaxation|creep|cycles|frequency sweep|rate sweep";
  } // namespace



  void ProtocolParameters::add_parameters(ParameterHandler &prm)
  {
    material.add_parameters(prm);
    prm.enter_subsection("Protocol");
    add_programme_entries(prm);
    add_list_entries(prm);
    add_step_entries(prm);
    prm.leave_subsection();
  }



  void ProtocolParameters::add_programme_entries(ParameterHandler &prm)
  {
    prm.add_parameter("mode",
                      mode_name,
                      "what the grips hold; all other directions are free of "
                      "stress [-]",
                      Patterns::Selection(rig_mode_names));
    prm.add_parameter("programme",
                      programme_name,
                      "ramp: to a strain, then held; relaxation: the same, at "
                      "once with a rate of 0; creep: a stress at once; cycles "
                      "of each frequency; frequency sweep: small ones, for E' "
                      "and E''; rate sweep: a ramp of each rate "
                      "[-]",
                      Patterns::Selection(programme_names));
    prm.add_parameter("strain",
                      strain,
                      "at the end of a ramp, or amplitude of cycles: stretch "
                      "less 1, or shear [-]");
    prm.add_parameter("mean strain",
                      mean_strain,
                      "about which cycles go; the rubber has rested there [-]");
    prm.add_parameter("rate",
                      rate,
                      "of the strain of a ramp; 0: at once, relaxation only "
                      "[1/s]",
                      Patterns::Double(0.));
    prm.add_parameter("stress", stress, "nominal stress of creep [MPa]");
    prm.add_parameter("hold time",
                      hold,
                      "after the ramp, or of creep [s]",
                      Patterns::Double(0.));
    prm.add_parameter("shape",
                      shape,
                      "of cycles; those of a frequency sweep are sines [-]",
                      Patterns::Selection("triangle|sine"));
    prm.add_parameter("cycles",
                      n_cycles,
                      "number of cycles; a frequency sweep measures in the "
                      "last, the others let the transient fade [-]",
                      Patterns::Integer(1, 100000));
  }

  void ProtocolParameters::add_list_entries(ParameterHandler &prm)
  {
    const Patterns::List positive(Patterns::Double(1e-12), 1);
    prm.add_parameter("frequencies",
                      frequencies,
                      "of cycles or of a frequency sweep, one run each [Hz]",
                      positive);
    prm.add_parameter("rates", rates, "of a rate sweep [1/s]", positive);
    prm.add_parameter("f90 levels",
                      f90_levels,
                      "t90-factors, one run each [-]; none: Material/f90",
                      Patterns::List(Patterns::Double(0.), 0));
    prm.add_parameter("temperatures",
                      temperatures,
                      "one run each [degC]; none: Material/temperature",
                      Patterns::List(Patterns::Double(-273., 2000.), 0));
  }

  void ProtocolParameters::add_step_entries(ParameterHandler &prm)
  {
    prm.add_parameter("time step",
                      time_step,
                      "dt largest; corners of the programme end a step [s]",
                      Patterns::Double(1e-15));
    prm.add_parameter("step growth",
                      growth,
                      "length of a step of the hold over that before; 1.1 "
                      "crosses a decade in 24 steps [-]",
                      Patterns::Double(1., 10.));
    prm.add_parameter("steps",
                      n_steps,
                      "of each cycle, of each ramp of a "
                      "rate sweep [-]",
                      Patterns::Integer(1, 1000000));
    prm.add_parameter("reference",
                      reference,
                      "ida: the relaxation equations with error control, by "
                      "SUNDIALS IDA; a frequency sweep is compared with "
                      "Wiechert's closed form instead, where the mean strain "
                      "is 0 [-]",
                      Patterns::Selection("none|ida"));
    prm.add_parameter("reference tolerance",
                      tolerance,
                      "of a step of IDA, relative to the stretches [-]",
                      Patterns::Double(1e-13, 1e-2));
  }



  RigMode ProtocolParameters::mode() const
  {
    return rig_mode_by_name(mode_name);
  }

  Programme ProtocolParameters::programme() const
  {
    return programme_name == "relaxation"      ? Programme::relaxation :
           programme_name == "creep"           ? Programme::creep :
           programme_name == "cycles"          ? Programme::cycles :
           programme_name == "frequency sweep" ? Programme::frequency_sweep :
           programme_name == "rate sweep"      ? Programme::rate_sweep :
                                                 Programme::ramp;
  }

  bool ProtocolParameters::is_sweep() const
  {
    return has_cycles() || programme() == Programme::rate_sweep;
  }

  bool ProtocolParameters::has_cycles() const
  {
    return programme() == Programme::frequency_sweep ||
           programme() == Programme::cycles;
  }

  bool ProtocolParameters::wants_reference() const
  {
    return programme() == Programme::frequency_sweep ? mean_strain == 0. :
                                                       reference == "ida";
  }



  Loading ProtocolParameters::loading(const double swept) const
  {
    Loading loading;
    switch (programme())
      {
        case Programme::ramp:
        case Programme::relaxation:
          loading = ramp_and_hold(strain, rate, hold);
          break;
        case Programme::rate_sweep:
          loading = ramp_and_hold(strain, swept, 0.);
          break;
        case Programme::creep:
          loading = creep(stress, hold);
          break;
        case Programme::frequency_sweep:
          loading = sine(mean_strain, strain, swept, n_cycles);
          break;
        default:
          loading = shape == "sine" ?
                      sine(mean_strain, strain, swept, n_cycles) :
                      triangle(mean_strain, strain, swept, n_cycles);
      }
    loading.time_step = is_sweep() ? loading.end() / n_steps : time_step;
    if (has_cycles())
      loading.time_step /= n_cycles;
    // Only a hold may take ever longer steps.
    if (hold > 0. && !has_cycles() && !is_sweep())
      loading.growth = growth;
    return loading;
  }

  std::vector<double> ProtocolParameters::swept_values() const
  {
    return has_cycles()                         ? frequencies :
           programme() == Programme::rate_sweep ? rates :
                                                  std::vector<double>{0.};
  }

  std::vector<ProtocolCase> ProtocolParameters::cases() const
  {
    auto levels = f90_levels, degrees = temperatures;
    if (levels.empty())
      levels = {material.uniform_f90()};
    if (degrees.empty())
      degrees = {material.temperature()};
    std::vector<ProtocolCase> list;
    for (const double f90 : levels)
      for (const double temperature : degrees)
        for (const double swept : swept_values())
          list.push_back({f90,
                          temperature,
                          swept,
                          material.at(f90, temperature),
                          loading(swept)});
    return list;
  }
} // namespace demold
