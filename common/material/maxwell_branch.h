// SPDX-License-Identifier: LGPL-2.1-or-later
// One Maxwell branch at finite strain: isochoric neo-Hooke spring and dashpot.
#ifndef demold_material_maxwell_branch_h
#define demold_material_maxwell_branch_h

#include "material/response_sums.h"

namespace demold
{
  /// How the inelastic metric is advanced over a step (theory A9). All are
  /// closed forms, unconditionally stable, and exact where nothing moves.
  enum class ViscousUpdate
  {
    exp2, ///< second order at finite strain, exact in the linear limit
    be,   ///< backward Euler: first order
    lin   ///< exact in the linear limit, first order at finite strain
  };

  /// A step in time of one point, as all its branches see it.
  struct ViscousStep
  {
    const Deformation &x;        ///< at t_n+1
    Six                Cbar;     ///< J^(-2/3) C at t_n+1
    Six                Cbar_old; ///< the same at t_n
    double             dt;       ///< [s]
    ViscousUpdate      update;
    bool               with_tangent;
    bool               with_energies;
  };

  /// A branch (theory A7 to A10, variant V1): W = mu/2 (Cbar:C_i^-1 - 3),
  /// with Cbar = J^(-2/3) C and the unimodular inelastic metric C_i.
  struct MaxwellBranch
  {
    double modulus;         ///< mu = E/3 [MPa]
    double relaxation_time; ///< tau [s]

    /// Adds the branch's stress and, on demand, algorithmic tangent (A10),
    /// stored energy and dissipation over the step. @p Ci_old: six doubles of
    /// C_i at t_n; @p Ci_new: at t_n+1, computed here.
    void add(const ViscousStep &step,
             const double      *Ci_old,
             double            *Ci_new,
             ResponseSums      &sums) const;
  };
} // namespace demold

#endif
