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

  /// Overstress of a branch at one time, as the dissipation needs it.
  struct Overstress
  {
    Nine   M;      ///< dev(Cbar C_i^-1) = F^T dev(be_bar) F^-T [-]
    double square; ///< tr M^2 = |dev be_bar|^2 >= 0 [-]
    double energy; ///< 2 W / mu = Cbar : C_i^-1 - 3 >= 0 [-]

    /// From Cbar C_i^-1, both factors of determinant one.
    explicit Overstress(const Nine &product);
  };

  /// Dissipated energy over a step, divided by mu [-], from the overstress at
  /// its ends; @p h is the step over the relaxation time.
  ///
  /// The rate is the exact D = mu/(2 tau) |dev be_bar|^2 (theory A8), and with
  /// x^2 = 2 W/mu it reads D = mu (phi/tau) x^2, phi = |dev be_bar|^2/(2 x^2),
  /// phi -> 1 at small strain. Where the strain moves at a constant rate the
  /// branch obeys x' = rate - (phi/tau) x; the integral of x^2 along that
  /// solution, between the known x at both ends, is closed form:
  ///   D/mu = alpha x0^2 + beta x0 x1 cos + gamma x1^2,  H = h (phi0+phi1)/2.
  /// A step much shorter than tau gives H/3 (x0^2 + x0 x1 + x1^2), one much
  /// longer than tau the stored energy lost, x0^2/2, plus steady flow H x1^2.
  /// Never negative, second order, and sensible for any h, where a trapezoid
  /// of D over a relaxing step would be wrong by the factor h.
  double dissipation_over_step(const Overstress &start,
                               const Overstress &end,
                               double            h);

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
