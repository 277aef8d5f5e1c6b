// SPDX-License-Identifier: LGPL-2.1-or-later
// Pictures of the runs of a protocol.
#include "output/plots.h"
#include "rig/protocol_output.h"

#include <algorithm>
#include <sstream>

namespace demold
{
  namespace
  {
    /// The seventh is black, which is the colour of references.
    constexpr unsigned int n_colours = 6;

    /// What tells a run from the others, for a legend.
    std::string title(const ProtocolParameters &p, const ProtocolRun &run)
    {
      std::ostringstream text;
      if (p.f90_levels.size() > 1)
        text << "f90 = " << run.test.f90 << "  ";
      if (p.temperatures.size() > 1)
        text << run.test.temperature << " degC  ";
      if (p.has_cycles() && p.frequencies.size() > 1)
        text << run.test.swept << " Hz";
      if (p.programme() == Programme::rate_sweep)
        text << run.test.swept << " 1/s";
      return text.str().empty() ? "rig" : text.str();
    }

    /// A column of one case as gnuplot reads it.
    std::string of_case(const unsigned int number, const std::string &column)
    {
      return "(column(\"case [-]\") == " + std::to_string(number) +
             " ? column(\"" + column + "\") : NaN)";
    }



    /// One curve for each run, with its reference.
    std::string curve_script(const ProtocolParameters       &p,
                             const std::vector<ProtocolRun> &runs,
                             const std::string              &name,
                             const std::string              &x,
                             const std::string              &y)
    {
      std::ostringstream script;
      script << plot_head(name,
                          p.mode_name + ", " + p.programme_name + ", " +
                            std::to_string(runs.size()) +
                            (runs.size() > 1 ? " runs" : " run"))
             << "set datafile separator comma\nset xlabel \"" << x
             << "\"\nset ylabel \"" << y << "\"\n"
             << (x == "time [s]" && p.growth > 1. ?
                   "set logscale x\nset format x \"%g\"\n" :
                   "")
             << "set key below\nplot ";
      const bool with_reference =
        runs.front().has_reference() &&
        y == (p.programme() == Programme::creep ? "strain [-]" :
                                                  "nominal stress [MPa]");
      for (unsigned int i = 0; i < runs.size(); ++i)
        {
          script << (i == 0 ? "" : ", \\\n     ") << "'history.csv' using "
                 << of_case(i + 1, x) << ':' << of_case(i + 1, y)
                 << " with lines linetype " << i % n_colours + 1 << " title \""
                 << title(p, runs[i]) << '"';
          if (with_reference)
            script << ", \\\n     '' using " << of_case(i + 1, x) << ':'
                   << of_case(i + 1, reference_column(p))
                   << " with lines dashtype 2 linecolor rgb 'black' title \""
                   << (i == 0 ? "IDA" : "") << '"';
        }
      script << '\n';
      return script.str();
    }



    /// Moduli or the loss factor over frequency, with Wiechert's.
    std::string sweep_script(const ProtocolParameters       &p,
                             const std::vector<ProtocolRun> &runs,
                             const std::string              &name,
                             const std::vector<std::string> &quantities)
    {
      std::ostringstream script;
      script << plot_head(name, "Dynamic response, " + p.mode_name)
             << "set datafile separator comma\nset logscale "
             << (quantities.size() > 1 ? "xy" : "x") << "\n"
             << "set xlabel \"" << swept_column(p) << "\"\nset ylabel \""
             << (quantities.size() > 1 ? "modulus [MPa]" : quantities.front())
             << "\"\nset key below\nplot ";
      const std::size_t n_swept =
        runs.size() / std::max<std::size_t>(1, p.f90_levels.size()) /
        std::max<std::size_t>(1, p.temperatures.size());
      unsigned int n_drawn = 0;
      for (std::size_t block = 0; block < runs.size(); block += n_swept)
        for (const auto &quantity : quantities)
          {
            const std::string rows = " every ::" + std::to_string(block) +
                                     "::" + std::to_string(block + n_swept - 1);
            const auto using_column = [&](const std::string &column) {
              return rows + " using (column(\"" + swept_column(p) +
                     "\")):(column(\"" + column + "\"))";
            };
            std::ostringstream group;
            if (p.f90_levels.size() > 1)
              group << "  f90 = " << runs[block].test.f90;
            if (p.temperatures.size() > 1)
              group << "  " << runs[block].test.temperature << " degC";
            script << (n_drawn == 0 ? "" : ", \\\n     ") << "'cases.csv'"
                   << using_column(quantity) << " with points linetype "
                   << n_drawn % n_colours + 1
                   << " pointtype 7 pointsize 0.6 title \"" << quantity
                   << group.str() << '"';
            if (p.wants_reference() &&
                p.programme() == Programme::frequency_sweep)
              script << ", \\\n     ''" << using_column("reference " + quantity)
                     << " with lines linecolor rgb 'black' linewidth 1 title \""
                     << (n_drawn == 0 ? "Wiechert" : "") << '"';
            ++n_drawn;
          }
      script << '\n';
      return script.str();
    }
  } // namespace



  std::string draw_protocol(const std::string              &output_folder,
                            const ProtocolParameters       &p,
                            const std::vector<ProtocolRun> &runs)
  {
    std::vector<std::pair<std::string, std::string>> scripts;
    const auto                                       curves =
      [&](const std::string &name, const std::string &x, const std::string &y) {
        scripts.emplace_back(name + ".gp", curve_script(p, runs, name, x, y));
      };
    if (p.programme() == Programme::frequency_sweep)
      {
        scripts.emplace_back("moduli.gp",
                             sweep_script(p,
                                          runs,
                                          "moduli",
                                          {"storage modulus [MPa]",
                                           "loss modulus [MPa]"}));
        scripts.emplace_back("tan-psi.gp",
                             sweep_script(p, runs, "tan-psi", {"tan psi [-]"}));
        return draw_scripts(output_folder, scripts);
      }
    if (p.programme() == Programme::creep)
      curves("strain-over-time", "time [s]", "strain [-]");
    else
      {
        if (p.programme() == Programme::relaxation)
          curves("stress-over-time", "time [s]", "nominal stress [MPa]");
        else
          curves("stress-over-strain", "strain [-]", "nominal stress [MPa]");
        if (p.programme() == Programme::cycles && p.frequencies.size() > 1)
          scripts.emplace_back(
            "hysteresis-over-frequency.gp",
            sweep_script(p,
                         runs,
                         "hysteresis-over-frequency",
                         {"hysteresis of last cycle [mJ/mm^3]"}));
        if (p.programme() == Programme::rate_sweep)
          scripts.emplace_back(
            "stress-over-rate.gp",
            sweep_script(p, runs, "stress-over-rate", {"stress at end [MPa]"}));
      }
    curves("dissipation-over-time", "time [s]", "dissipated energy [mJ/mm^3]");
    return draw_scripts(output_folder, scripts);
  }
} // namespace demold
