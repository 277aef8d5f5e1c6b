// SPDX-License-Identifier: LGPL-2.1-or-later
// summary.json of a run: how it ended, what it found, what it cost.
#include "scene/run_summary.h"

#include "contact/interface_term.h"
#include "scene/recorder.h"
#include "scene/vulcanised_cure.h"
#include "weak_form/weak_form.h"

#include <deal.II/base/config.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>
#include <deal.II/base/utilities.h>

namespace demold
{
  using namespace dealii;

  namespace
  {
    constexpr double bytes_per_mib = 1 << 20;

    void set_outcome(Summary &summary, const RunAccount &account)
    {
      summary.set("status",
                  account.status() == RunStatus::gave_up ? "gave up" :
                  account.recorder.n_jumps > 0 ? "completed with jumps" :
                                                 "completed");
      summary.set("reason",
                  account.was_stopped ? std::string("stopped by SIGTERM") :
                                        account.result.reason);
    }

    /// Events in one line: the summary is flat.
    void set_events(Summary &summary, const std::vector<std::string> &events)
    {
      std::string line;
      for (const std::string &event : events)
        line += (line.empty() ? "" : "; ") + event;
      summary.set("events", line);
    }

    void set_cure(Summary &summary, const VulcanisedRange &cure)
    {
      summary.set("smallest f90 [-]", cure.smallest);
      summary.set("mean f90 [-]", cure.mean);
      summary.set("largest f90 [-]", cure.largest);
      summary.set("points of clamped f90", cure.n_clamped);
      summary.set("lowest temperature at the opening [degC]", cure.coldest);
      summary.set("highest temperature at the opening [degC]", cure.hottest);
    }

    void set_counts(Summary &summary, const RunAccount &account)
    {
      const LinearSolverStatistics &linear = account.linear;
      summary.set("increments", account.increments);
      summary.set("rejected increments", account.result.rejected);
      summary.set("newton iterations", account.result.newton_iterations);
      summary.set("factorisations", linear.factorisations);
      summary.set("multigrid hierarchies", linear.hierarchies);
      summary.set("krylov iterations", linear.krylov_iterations);
      summary.set("degrees of freedom",
                  static_cast<long long>(account.weak_form.n_unknowns()));
      summary.set("contact nodes",
                  account.interface == nullptr ?
                    0u :
                    account.interface->sums().points);
    }

    /// Bytes this rank holds.
    std::size_t history_bytes(const WeakForm &weak_form)
    {
      std::size_t bytes = 0;
      for (const auto &term : weak_form.term_list())
        bytes += term->history_bytes();
      return bytes;
    }

    void set_cost(Summary          &summary,
                  const RunAccount &account,
                  const MPI_Comm    communicator)
    {
      const auto sum = [communicator](const double of_this_rank) {
        return Utilities::MPI::sum(of_this_rank, communicator);
      };
      summary.set("history [MiB]",
                  sum(history_bytes(account.weak_form)) / bytes_per_mib);
      for (const auto &part : account.times())
        summary.set("time " + part.first + " [s]", part.second);
      Utilities::System::MemoryStats memory;
      Utilities::System::get_memory_stats(memory);
      summary.set("peak memory [MiB]", sum(memory.VmHWM / 1024.));
      summary.set("ranks", Utilities::MPI::n_mpi_processes(communicator));
      summary.set("versions", "demold 0.1, deal.II " DEAL_II_PACKAGE_VERSION);
      summary.set("cpu time [s]", sum(account.timer.cpu_time()));
      summary.set("wall time [s]", account.timer.wall_time());
    }
  } // namespace

  RunStatus RunAccount::status() const
  {
    return result.gave_up || was_stopped ? RunStatus::gave_up :
                                           RunStatus::completed;
  }

  std::vector<std::pair<std::string, double>> RunAccount::times() const
  {
    const double contact = interface == nullptr ? 0. : interface->seconds;
    return {{"assembly", seconds_assembly - contact},
            {"contact", contact},
            {"linear solver", linear.seconds_setup + linear.seconds_solve},
            {"output", seconds_output}};
  }

  Summary summarise(const RunAccount &account, const MPI_Comm communicator)
  {
    Summary summary;
    set_outcome(summary, account);
    if (!account.result.events.empty())
      set_events(summary, account.result.events);
    account.recorder.summarise(summary);
    if (account.cure != nullptr)
      set_cure(summary, *account.cure);
    set_counts(summary, account);
    set_cost(summary, account, communicator);
    return summary;
  }
} // namespace demold
