// SPDX-License-Identifier: LGPL-2.1-or-later
// Section Press of a parameter file: heating in the mould, opening, cooling.
#ifndef demold_cure_press_parameters_h
#define demold_cure_press_parameters_h

#include "cure/press_cycle.h"

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  /// Entries of Press. The defaults are a tread block in a tire press.
  class PressParameters
  {
  public:
    void add_parameters(dealii::ParameterHandler &prm);

    /// Throws ExcParameter for temperatures and times that make no sense.
    void check() const;

    PressCycle cycle() const;

  private:
    /// A side of the block while the press is closed.
    struct Side
    {
      std::string contact, temperature;
      double      film_coefficient;

      void        add_parameters(dealii::ParameterHandler &prm,
                                 const std::string        &name);
      ThermalSide side(const std::string &name) const;
    };

    double      conductivity        = .27;
    double      heat_capacity       = 2.25;
    double      initial_temperature = 60.;
    Side        mould               = {"perfect", "0: 150, 60: 165", .5};
    Side        bladder             = {"film", "0: 160, 60: 190", .03};
    double      opening_time        = 480.;
    double      end_time            = 1080.;
    std::string air                 = "30";
    double      air_film            = .02;
    double      tolerance           = 1e-6;
  };
} // namespace demold

#endif
