// SPDX-License-Identifier: LGPL-2.1-or-later
// Did all ranks fail, or do the others wait for this one?
#include "base/error_agreement.h"

#include <chrono>
#include <thread>

namespace demold
{
  ErrorAgreement::ErrorAgreement(const MPI_Comm &communicator)
  {
    MPI_Comm_dup(communicator, &own);
  }



  ErrorAgreement::~ErrorAgreement()
  {
    MPI_Comm_free(&own);
  }



  bool ErrorAgreement::all_ranks_failed(const double patience) const
  {
    using clock = std::chrono::steady_clock;
    MPI_Request request;
    MPI_Ibarrier(own, &request);
    int        arrived = 0;
    const auto begin   = clock::now();
    while (true)
      {
        MPI_Test(&request, &arrived, MPI_STATUS_IGNORE);
        if (arrived)
          return true;
        if (std::chrono::duration<double>(clock::now() - begin).count() >
            patience)
          return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
  }
} // namespace demold
