// SPDX-License-Identifier: LGPL-2.1-or-later
// What every formulation of contact shows to others.
#ifndef demold_contact_interface_term_h
#define demold_contact_interface_term_h

#include "adhesion/adhesion_law.h"
#include "contact/boundary_surface.h"
#include "weak_form/term.h"

#include <deal.II/base/tensor.h>

#include <mpi.h>

#include <vector>

namespace demold
{
  /// States of theory C.5 of points without a bond that holds.
  constexpr int state_contact = 4, state_slip = 5, state_free = 6;

  /// One slave point as others see it.
  struct PointReport
  {
    BoundarySurface::Node node;
    double                area;     ///< [mm^2]
    double                gap;      ///< [mm], 1e300: nothing near
    double                pressure; ///< [MPa], compression positive
    dealii::Tensor<1, 3>  force;    ///< [N] on the rubber
    bool                  bonded;   ///< carries a bond that is not ruptured
    double                damage;   ///< kappa over rupture gap, 0 to 1
    int                   state;    ///< theory C.5, 0 to 5; 6: free
    double                separation_time; ///< [s], -1: never
  };

  /// Sums over all slave points and ranks.
  struct InterfaceSums
  {
    dealii::Tensor<1, 3> force;       ///< [N] of the mould on the rubber
    double               area   = 0.; ///< [mm^2] of the slave surface
    double               bonded = 0.; ///< [mm^2] with a bond
    double               closed = 0.; ///< [mm^2] under pressure
    unsigned int         points = 0;
  };

  /// Error of an increment by what decohesion has cost in it, over .1 G_c of
  /// the area that decoheres now (step rule of theory D.4). @p lost [mJ] and
  /// @p front [mm^2] are this rank's share; collective.
  IncrementError decohesion_error(const AdhesionLaw &law,
                                  const double       lost,
                                  const double       front,
                                  MPI_Comm           communicator);

  /// Contact, friction and adhesion between two surfaces, in any formulation.
  class InterfaceTerm : public Term
  {
  public:
    /// Points of this rank in the trial state.
    virtual std::vector<PointReport> report() const = 0;

    /// Collective.
    virtual InterfaceSums sums() const = 0;

    /// Seconds spent in search and assembly.
    double seconds = 0.;
  };
} // namespace demold

#endif
