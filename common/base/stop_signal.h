// SPDX-License-Identifier: LGPL-2.1-or-later
// A polite end: SIGTERM asks the run to stop after the current increment.
#ifndef demold_base_stop_signal_h
#define demold_base_stop_signal_h

#include <deal.II/base/mpi.h>

namespace demold
{
  /// From now on SIGTERM no longer kills the process but is remembered; so is
  /// SIGUSR1, which mpirun passes on to its ranks.
  void catch_stop_signal();

  /// Has SIGTERM arrived at this process?
  bool stop_requested();

  /// Has SIGTERM arrived at any rank of @p communicator? Collective; strategies
  /// ask this between increments, because signals reach the ranks at different
  /// times and all must stop at the same increment.
  bool stop_requested(const MPI_Comm &communicator);
} // namespace demold

#endif
