// SPDX-License-Identifier: LGPL-2.1-or-later
// Did all ranks fail, or do the others wait for this one?
#ifndef demold_base_error_agreement_h
#define demold_base_error_agreement_h

#include <deal.II/base/mpi.h>

namespace demold
{
  /// An error found on all ranks is printed once and the program ends in order.
  /// An error on one rank alone leaves the others in a collective call: they
  /// have to be killed. The ranks find out which it is over a communicator of
  /// their own, which no computation uses.
  class ErrorAgreement
  {
  public:
    explicit ErrorAgreement(const MPI_Comm &communicator);
    ErrorAgreement(const ErrorAgreement &)            = delete;
    ErrorAgreement &operator=(const ErrorAgreement &) = delete;
    ~ErrorAgreement();

    /// Call where an exception has been caught. Waits up to @p patience [s] for
    /// the other ranks to arrive here, too.
    bool all_ranks_failed(const double patience = 10.) const;

  private:
    MPI_Comm own;
  };
} // namespace demold

#endif
