// SPDX-License-Identifier: LGPL-2.1-or-later
// Velocities and accelerations of explicit dynamics, and their energies.
#ifndef demold_solution_central_differences_h
#define demold_solution_central_differences_h

#include "weak_form/term.h"

namespace demold
{
  class WeakForm;

  /// Lumped masses that move by central differences (theory D.4):
  ///   v_{n+1/2} = v_n + dt/2 a_n,  u_{n+1} = u_n + dt v_{n+1/2},
  ///   a_{n+1} = -f_{n+1}/m,        v_{n+1} = v_{n+1/2} + dt/2 a_{n+1},
  /// with f all forces but inertia. Second order, stable below 2/omega of the
  /// highest frequency. Prescribed unknowns go where their supports say.
  ///
  /// Adds nothing to the residual; it keeps the motion, its checkpoint and its
  /// entries of the ledger.
  class CentralDifferences : public Term
  {
  public:
    /// @param mass lumped mass [t] of each owned unknown.
    explicit CentralDifferences(const Vector &mass);

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

    /// Before the first step: accelerations of the forces of the trial of
    /// @p weak_form, loads that are there from the beginning.
    void start(const WeakForm &weak_form);

    /// u_{n+1} - u_n [mm] of a step of @p dt [s]; nonsense at supports.
    Vector increment(const double dt) const;

    /// Velocities and accelerations at t_{n+1} from the forces of the trial of
    /// @p weak_form, and what the step has taken out of the ledger:
    /// (f_n + f_{n+1})/2 . du - change of kinetic energy (theory D.4), for
    /// central differences m dt^2/8 (a_n^2 - a_{n+1}^2) of each free unknown.
    /// It is not lost but comes back, unless dt or f_n jumps.
    void kick(const WeakForm &weak_form, const double dt);

    /// After commit: closed points get the normal velocity of the mould, the
    /// kinetic energy that this takes is booked as impact. Accelerations stay
    /// those of the forces, else the ledger would miss their work.
    void close(const std::vector<ClosedPoint> &points);

    /// [mJ] of the trial without prescribed unknowns; collective.
    double free_kinetic_energy() const;

    const Vector &masses() const
    {
      return mass;
    }

    const Vector &velocity() const
    {
      return committed_velocity;
    }

  private:
    void   find_free_masses(const WeakForm &weak_form);
    double kinetic_energy(const Vector &masses, const Vector &v) const;

    const Vector mass;
    Vector       free_mass; ///< 0 at supports
    Vector       committed_velocity, committed_acceleration;
    Vector       velocity_trial, acceleration_trial;
    double       committed_algorithmic = 0., algorithmic = 0., impact = 0.;
  };
} // namespace demold

#endif
