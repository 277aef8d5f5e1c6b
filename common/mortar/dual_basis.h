// SPDX-License-Identifier: LGPL-2.1-or-later
// Dual multiplier shape functions of a slave face, also partly covered.
#ifndef demold_mortar_dual_basis_h
#define demold_mortar_dual_basis_h

#include "mortar/pair_integrals.h"

namespace demold
{
  /// Phi_A = sum_B A_AB N_B with int Phi_A N_B = delta_AB int N_A over the
  /// covered part of a slave face (theory B.7; Cichosz & Bischoff 2011).
  ///
  /// A face so little covered that its N_A can hardly be told apart there
  /// falls back to Phi = N with a lumped D: A = 1, and the off-diagonal part
  /// of D is added to its diagonal. Both forms keep int Phi_A = int N_A, hence
  /// a constant pressure and the momentum balance.
  struct DualBasis
  {
    NodeMatrix<double> A{};         ///< [-]
    NodeMatrix<double> inverse{};   ///< [1/mm^2] of M_e = int N_A N_B
    unsigned int       n_nodes = 0; ///< 2 or 4
    bool               lumped  = true;
  };

  /// Condition number (1-norm, M_e scaled to a unit diagonal) beyond which a
  /// face counts as little covered. A fully covered parallelogram has 9, one
  /// covered at a corner alone up to 194. A strip across the middle of which
  /// the width is w times the edge has 9/w^2.
  constexpr double worst_dual_condition = 1e5;

  /// The basis from the standard @p D of a face, summed over all its masters.
  DualBasis dual_basis(const NodeMatrix<double> &D, const unsigned int n_nodes);

  /// dA = (dD_e - A dM_e) M_e^-1 for a change @p dD of the standard D; zero if
  /// lumped.
  NodeMatrix<double> dual_basis_change(const DualBasis          &basis,
                                       const NodeMatrix<double> &dD);

  /// int Phi_A N_C = A M for the standard @p M of one master.
  NodeMatrix<double> dual_M(const DualBasis          &basis,
                            const NodeMatrix<double> &M);

  /// Its change dA M + A dM.
  NodeMatrix<double> dual_M_change(const DualBasis          &basis,
                                   const NodeMatrix<double> &dA,
                                   const NodeMatrix<double> &M,
                                   const NodeMatrix<double> &dM);

  /// The diagonal int N_A of the dual (or lumped) D, from the standard one. Its
  /// change is the same of dD.
  std::array<double, 4> dual_D(const NodeMatrix<double> &D,
                               const unsigned int        n_nodes);
} // namespace demold

#endif
