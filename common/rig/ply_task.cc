// SPDX-License-Identifier: LGPL-2.1-or-later
// Constants of a belt ply by three rules, over cord content and angle.
#include "rig/ply_task.h"

#include "output/plots.h"
#include "output/progress.h"
#include "output/result_table.h"
#include "output/summary.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <cmath>
#include <iostream>
#include <sstream>
#include <vector>

namespace demold
{
  using namespace dealii;

  namespace
  {
    constexpr PlyRule all_rules[] = {PlyRule::halpin_tsai,
                                     PlyRule::gough_tangorra,
                                     PlyRule::akasaka_hirano};

    constexpr const char *closed_form = "akasaka closed form";

    /// A number and the quantity it is of, as columns and keys are named.
    struct Named
    {
      std::string name;
      double      value;
    };

    std::vector<Named> constants(const CordRubber &parts)
    {
      std::vector<Named> list;
      for (const PlyRule rule : all_rules)
        {
          const PlyConstants ply  = ply_constants(rule, parts);
          const std::string  name = name_of(rule);
          list.push_back({"E1 " + name + " [MPa]", ply.E1});
          list.push_back({"E2 " + name + " [MPa]", ply.E2});
          list.push_back({"G12 " + name + " [MPa]", ply.G12});
          list.push_back({"nu12 " + name + " [-]", ply.nu12});
        }
      return list;
    }

    std::vector<Named> pair_constants(const CordRubber &parts,
                                      const double      degree)
    {
      const double       angle = degree * numbers::PI / 180.;
      std::vector<Named> list;
      const auto         append = [&list](const std::string       &name,
                                  const LaminateConstants &pair) {
        list.push_back({"E_x " + name + " [MPa]", pair.E_x});
        list.push_back({"E_y " + name + " [MPa]", pair.E_y});
        list.push_back({"G_xy " + name + " [MPa]", pair.G_xy});
        list.push_back({"nu_xy " + name + " [-]", pair.nu_xy});
      };
      for (const PlyRule rule : all_rules)
        append(name_of(rule), balanced_pair(ply_constants(rule, parts), angle));
      append(closed_form, akasaka_pair(parts, angle));
      return list;
    }

    /// A row for each of @p n_points values of @p x from 0 to @p end.
    template <typename Row>
    void write_table(const std::string &file,
                     const std::string &x,
                     const double       end,
                     const unsigned int n_points,
                     const Row         &row_at)
    {
      std::vector<std::string> columns = {x};
      for (const Named &column : row_at(end))
        columns.push_back(column.name);
      ResultTable table(file, columns);
      for (unsigned int i = 0; i < n_points; ++i)
        {
          const double                    at  = i * end / (n_points - 1);
          std::vector<ResultTable::Value> row = {at};
          for (const Named &entry : row_at(at))
            row.push_back(entry.value);
          table.add_row(row);
        }
    }

    std::string constants_script()
    {
      std::string script =
        plot_head("ply-constants", "Constants of a ply across its cords") +
        "set datafile separator comma\n"
        "set key left top\n"
        "set xlabel 'cord volume fraction [-]'\n"
        "set ylabel 'modulus [MPa]'\n"
        "set yrange [0:*]\n"
        "plot ";
      for (unsigned int k = 0; k < 3; ++k)
        for (const unsigned int quantity : {1u, 2u})
          script +=
            std::string(k + quantity > 1 ? ", \\\n     " : "") +
            "'constants.csv' using 1:" + std::to_string(2 + 4 * k + quantity) +
            " with lines title '" + (quantity == 1 ? "E2 " : "G12 ") +
            name_of(all_rules[k]) + "'";
      return script + "\n";
    }

    std::string pair_script()
    {
      std::string script =
        plot_head("pair-over-angle", "Two plies at +theta and -theta") +
        "set datafile separator comma\n"
        "set key below\n"
        "set logscale y\n"
        "set format y '%g'\n"
        "set xlabel 'theta [degree]'\n"
        "set ylabel 'modulus [MPa]'\n"
        "plot ";
      for (unsigned int k = 0; k < 4; ++k)
        script += std::string(k > 0 ? ", \\\n     " : "") +
                  "'pair.csv' using 1:" + std::to_string(2 + 4 * k) +
                  " with lines title 'E_x " +
                  (k < 3 ? name_of(all_rules[k]) : closed_form) + "'";
      return script +
             ", \\\n     'pair.csv' using 1:4 with lines title "
             "'G_xy " +
             name_of(all_rules[0]) + "'\n";
    }
  } // namespace

  void PlyTask::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Ply");
    ply.add_parameters(prm);
    prm.add_parameter("angle",
                      angle,
                      "theta of the pair of plies in the summary [degree]",
                      Patterns::Double(0., 90.));
    prm.add_parameter("largest volume fraction",
                      largest_content,
                      "V_c at the end of the table of constants [-]",
                      Patterns::Double(.01, .99));
    prm.add_parameter("points",
                      n_points,
                      "number of rows of each table [-]",
                      Patterns::Integer(2, 100000));
    prm.leave_subsection();
  }

  void PlyTask::check() const
  {
    ply.check("Ply");
  }

  std::string PlyTask::preview() const
  {
    std::ostringstream text;
    text << "Ply of cords of " << ply.cord_modulus << " MPa in rubber of "
         << ply.rubber_modulus << " MPa, V_c = " << ply.volume_fraction()
         << ": constants by three rules over V_c up to " << largest_content
         << ",\nand of two plies at +-theta over theta.";
    return text.str();
  }

  RunStatus PlyTask::run(const RunContext &context) const
  {
    // All of it takes milliseconds: one rank does it.
    if (Utilities::MPI::job_supports_mpi() &&
        Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return RunStatus::completed;
    const std::string &folder = context.output_folder;
    const CordRubber   parts  = ply.parts();
    write_table(folder + "/constants.csv",
                "cord volume fraction [-]",
                largest_content,
                n_points,
                [parts](const double V) {
                  CordRubber other      = parts;
                  other.volume_fraction = V;
                  return constants(other);
                });
    write_table(folder + "/pair.csv",
                "angle [degree]",
                90.,
                n_points,
                [parts](const double degree) {
                  return pair_constants(parts, degree);
                });

    Summary summary;
    summary.set("status", "completed");
    summary.set("reason", "");
    summary.set("cord volume fraction [-]", parts.volume_fraction);
    for (const Named &entry : constants(parts))
      summary.set(entry.name, entry.value);
    summary.set("angle of the pair [degree]", angle);
    for (const Named &entry : pair_constants(parts, angle))
      summary.set(entry.name, entry.value);

    Progress progress(std::cout, context.quiet);
    progress.note(draw_scripts(folder,
                               {{"ply-constants.gp", constants_script()},
                                {"pair-over-angle.gp", pair_script()}}));
    progress.print(summary);
    summary.write(folder + "/summary.json");
    return RunStatus::completed;
  }
} // namespace demold
