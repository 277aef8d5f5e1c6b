// SPDX-License-Identifier: LGPL-2.1-or-later
// What every formulation of contact shows to others.
#include "contact/interface_term.h"

#include <deal.II/base/mpi.h>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// Decohesion of one increment may cost this share of G_c A of the nodes
    /// that let go (theory D.4, step rule).
    constexpr double tolerated_decohesion = .1;
  } // namespace

  IncrementError decohesion_error(const AdhesionLaw &law,
                                  const double       lost,
                                  const double       front,
                                  const MPI_Comm     communicator)
  {
    const double loss = Utilities::MPI::sum(lost, communicator);
    const double area = Utilities::MPI::sum(front, communicator);
    if (area <= 0.)
      return {};
    return {loss / (tolerated_decohesion * law.fracture_energy() * area), 1.};
  }
} // namespace demold
