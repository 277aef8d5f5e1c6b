// SPDX-License-Identifier: LGPL-2.1-or-later
// A polite end: SIGTERM asks the run to stop after the current increment.
#include "base/stop_signal.h"

#include <atomic>
#include <csignal>

namespace demold
{
  namespace
  {
    // A signal handler can reach nothing but what is global.
    std::atomic<bool> stop{false};
    static_assert(std::atomic<bool>::is_always_lock_free,
                  "a signal handler may only touch lock-free atomics");

    extern "C" void remember_stop(int)
    {
      stop = true;
    }
  } // namespace



  void catch_stop_signal()
  {
    struct sigaction action = {};
    action.sa_handler       = remember_stop;
    action.sa_flags         = SA_RESTART; // writing a file must not fail
    sigaction(SIGTERM, &action, nullptr);
    sigaction(SIGUSR1, &action, nullptr); // all that mpirun passes on
  }



  bool stop_requested()
  {
    return stop;
  }



  bool stop_requested(const MPI_Comm &communicator)
  {
    return dealii::Utilities::MPI::max(stop ? 1u : 0u, communicator) > 0;
  }
} // namespace demold
