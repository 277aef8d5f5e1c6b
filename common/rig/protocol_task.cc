// SPDX-License-Identifier: LGPL-2.1-or-later
// The task `protocol`: rubber driven through a test, without a mesh.
#include "rig/protocol_task.h"

#include "output/progress.h"
#include "rig/protocol_output.h"

#include <deal.II/base/mpi.h>

#include <iostream>
#include <sstream>

namespace demold
{
  using namespace dealii;

  void ProtocolTask::add_parameters(ParameterHandler &prm)
  {
    parameters.add_parameters(prm);
  }

  void ProtocolTask::check() const
  {
    parameters.check();
  }



  std::string ProtocolTask::preview() const
  {
    const auto         cases = parameters.cases();
    const RubberLaw   &law   = cases.front().law;
    std::size_t        n     = 0;
    std::ostringstream text;
    for (const auto &test : cases)
      n += test.loading.times().size();
    text << "  rubber      " << law.branches.size()
         << " Maxwell branches, shear modulus " << law.shear_modulus_relaxed()
         << " MPa relaxed, " << law.shear_modulus_instantaneous()
         << " instantaneous, bulk modulus " << law.bulk_modulus() << " MPa\n"
         << "  test        " << parameters.mode_name << ", "
         << parameters.programme_name << "\n"
         << "  runs        " << cases.size() << ", " << n << " steps in all\n"
         << "  reference   "
         << (!parameters.wants_reference() ? "none" :
             parameters.programme() == Programme::frequency_sweep ?
                                             "Wiechert's closed form" :
                                             "SUNDIALS IDA");
    return text.str();
  }



  RunStatus ProtocolTask::run(const RunContext &context) const
  {
    // A point of rubber is no work to share.
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return RunStatus::completed;
    std::vector<ProtocolRun> runs;
    for (const auto &test : parameters.cases())
      runs.push_back(run_protocol(parameters, test));

    const std::string &folder = context.output_folder;
    write_curves(folder + "/history.csv", parameters, runs);
    write_cases(folder + "/cases.csv", parameters, runs);
    const Summary summary = protocol_summary(runs);
    Progress      progress(std::cout, context.quiet);
    progress.note(draw_protocol(folder, parameters, runs));
    progress.print(summary);
    summary.write(folder + "/summary.json");
    return RunStatus::completed;
  }
} // namespace demold
