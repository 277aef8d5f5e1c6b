// SPDX-License-Identifier: LGPL-2.1-or-later
// What an interface holds still, and when, so that Newton settles.
#ifndef demold_contact_newton_stage_h
#define demold_contact_newton_stage_h

namespace demold
{
  /// Stages of one Newton solution, by iteration: at first all states are
  /// free; then pairings are kept, so that no active set can cycle, and
  /// softening bonds may jump; at last the states of bonds are kept as well
  /// (theory C.3).
  struct NewtonStage
  {
    /// Iterations with free pairings and states.
    static constexpr unsigned int freeze_after = 8;

    /// Iterations, counted from there, in which a softening bond shows Newton
    /// a small positive stiffness: this share of its secant. Where the bond
    /// softens faster than the rubber gives way, the true tangent leads back
    /// to the intact bond and round in circles; with this one the gap grows by
    /// the ratio of both stiffnesses until the bond has let go: a jump.
    static constexpr unsigned int jump_iterations = 40;
    static constexpr double       jump_stiffness  = .02;

    unsigned int iteration; ///< of Newton, 0 first

    bool keeps_pairings() const
    {
      return iteration > freeze_after;
    }

    bool lets_bonds_jump() const
    {
      return keeps_pairings() && iteration <= freeze_after + jump_iterations;
    }

    bool keeps_bond_states() const
    {
      return keeps_pairings() && !lets_bonds_jump();
    }
  };
} // namespace demold

#endif
