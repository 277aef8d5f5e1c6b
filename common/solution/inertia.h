// SPDX-License-Identifier: LGPL-2.1-or-later
// Mass, velocities and accelerations: the term that makes a run dynamic.
#ifndef demold_solution_inertia_h
#define demold_solution_inertia_h

#include "weak_form/term.h"

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  class WeakForm;

  /// The Newmark family by its four numbers (theory D.4):
  ///   a_{n+1} = (u_{n+1}-u_n)/(beta dt^2) - v_n/(beta dt) - (1/(2 beta)-1) a_n
  ///   v_{n+1} = v_n + dt ((1-gamma) a_n + gamma a_{n+1})
  ///   M ((1-alpha_m) a_{n+1} + alpha_m a_n)
  ///     + (1-alpha_f) f_{n+1} + alpha_f f_n + interface_{n+1} = 0.
  /// `bossak` (Wood, Bossak and Zienkiewicz 1980) is the member with alpha_f =
  /// 0 and the default: as the interface forces enter at t_{n+1} anyway, a
  /// bulk force taken earlier would be out of balance by alpha_f times the
  /// change of the interface force, which in long, nearly static increments
  /// is a first-order error with negative algorithmic dissipation.
  struct TimeIntegrator
  {
    std::string scheme          = "bossak";
    double      spectral_radius = .8;
    double      newmark_damping = 0.;
    double      hht_alpha       = -.1;

    void add_parameters(dealii::ParameterHandler &prm);

    double alpha_m() const;
    double alpha_f() const;
    double gamma() const;
    double beta() const;
  };

  /// Inertia with a lumped mass matrix (row sums).
  ///
  /// At rest it takes no part: velocities follow the increments, so that motion
  /// goes on from them when it is woken, and nothing is in the ledger. What
  /// kinetic energy the waking brings and the rest takes is booked as
  /// algorithmic.
  class Inertia : public Term
  {
  public:
    /// @param mass lumped mass [t] of each owned unknown.
    /// @param length [mm] by which an error of the displacement is judged.
    Inertia(const Vector         &mass,
            const TimeIntegrator &integrator,
            const double          length);

    std::string name() const override;
    TermKind    kind() const override;
    bool        symmetric() const override;
    bool        assemble(const Configuration &, Assembler &) override;
    Energies    energies() const override;
    void        commit() override;
    void        revert() override;
    std::size_t history_bytes() const override;
    void        save(std::ostream &) const override;
    void        load(std::istream &) override;

    /// Before commit: books the damping of the integrator,
    /// (f_n + f_{n+1})/2 . du - change of kinetic energy with the forces f of
    /// @p weak_form (theory D.4).
    void account_damping(const WeakForm &weak_form);

    /// e = dt^2 |beta - 1/6| max |a_{n+1} - a_n| over twice the tolerated
    /// length, third order in dt (theory D.4, step rule).
    IncrementError increment_error() const override;

    /// After commit: gives closed points the normal velocity of the mould and
    /// no relative normal acceleration, and books the kinetic energy lost.
    void close(const std::vector<ClosedPoint> &points);

    /// Between increments.
    void set_at_rest(const bool at_rest);

    /// Between increments at rest: no velocities, where those of the last one
    /// say nothing.
    void forget_velocities();

    bool is_at_rest() const
    {
      return at_rest;
    }

    /// |M a| [N] of the last accepted increment; collective.
    double force_norm() const;

    /// Kinetic energy [mJ] of the accepted velocities, moving or at rest;
    /// collective.
    double kinetic_energy() const;

    const Vector &velocity() const
    {
      return committed_velocity;
    }

  private:
    double kinetic_energy(const Vector &v) const;
    void   follow(const Configuration &now);

    const Vector         mass;
    const TimeIntegrator integrator;
    const double         length;
    bool                 at_rest = false;
    double               dt      = 0.;
    Vector               committed_velocity, committed_acceleration;
    Vector               velocity_trial, acceleration_trial;
    double committed_algorithmic = 0., algorithmic = 0., impact = 0.;
  };
} // namespace demold

#endif
