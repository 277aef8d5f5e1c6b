// SPDX-License-Identifier: LGPL-2.1-or-later
// One summand of the weak form.
#ifndef demold_weak_form_term_h
#define demold_weak_form_term_h

#include "weak_form/algebra.h"
#include "weak_form/energies.h"

#include <deal.II/base/index_set.h>

#include <array>
#include <iosfwd>
#include <string>
#include <vector>

namespace dealii
{
  class DynamicSparsityPattern;
  template <typename number>
  class AffineConstraints;
} // namespace dealii

namespace demold
{
  class Assembler;
  class CondensedRows;

  /// What a term sees when it is evaluated: the trial state at t_{n+1} and the
  /// accepted one at t_n. Both vectors are readable at every unknown the term
  /// named in needed_unknowns().
  struct Configuration
  {
    const Vector &u;         ///< [mm] trial at t_{n+1}
    const Vector &u_old;     ///< [mm] accepted at t_n
    double        time;      ///< [s]  t_{n+1} of supports, mould and loads
    double        dt;        ///< [s]  t_{n+1} - t_n, negative on the way back
    unsigned int  iteration; ///< of Newton, 0 first

    /// Is u only what the last increment makes expect?
    bool extrapolated = false;

    /// Time [s] that passes for the material: dt, but 0 while a path is behind
    /// the latest time it has been to (theory D.2, rate dependence).
    double elapsed = dt;
  };

  /// How a term enters a time integrator: `bulk` forces are blended between
  /// t_n and t_{n+1} by generalised-alpha, `interface` forces enter at t_{n+1}
  /// (theory D.4), `inertia` blends by itself.
  enum class TermKind
  {
    bulk,
    interface,
    inertia
  };

  /// How far a converged increment is from what a term tolerates.
  struct IncrementError
  {
    double ratio = 0.; ///< error over tolerance
    double order = 1.; ///< the error grows like dt^order
  };

  /// A node that has met the mould: its velocity along `normal` is that of the
  /// mould (persistency, theory D.4).
  struct ClosedPoint
  {
    std::vector<dealii::types::global_dof_index> unknowns; ///< dim entries
    std::array<double, 3>                        normal;
    std::array<double, 3>                        velocity; ///< [mm/s]
  };

  /// One summand of the weak form g(u) = sum of terms. It owns its histories,
  /// committed and trial; assemble() writes trial states only, commit() is the
  /// only way into the committed ones, revert() drops the trial ones.
  class Term
  {
  public:
    virtual ~Term() = default;

    /// Short name for tables.
    virtual std::string name() const = 0;

    virtual TermKind kind() const = 0;

    /// Is the tangent symmetric in every state the term can reach?
    virtual bool symmetric() const = 0;

    /// Ranks that own the extra unknowns of this term (one entry per unknown,
    /// the same list on every rank). They follow the displacements. Their
    /// rows are scaled as forces [N]: Newton judges them with these.
    virtual std::vector<unsigned int> extra_unknown_owners() const
    {
      return {};
    }

    /// Tells the term where its extra unknowns begin.
    virtual void set_first_extra_unknown(dealii::types::global_dof_index)
    {}

    /// Adds the unknowns this rank must read beyond those of its cells.
    virtual void needed_unknowns(dealii::IndexSet &) const
    {}

    /// Adds the couplings of the tangent that this rank will write.
    virtual void add_couplings(dealii::DynamicSparsityPattern &,
                               const dealii::AffineConstraints<double> &) const
    {}

    /// Does the tangent need couplings that were not announced? Asked after
    /// prepare(); the weak form then builds its matrix anew.
    virtual bool couplings_changed() const
    {
      return false;
    }

    /// Called once per assembly before assemble(), on every rank.
    virtual void prepare(const Configuration &)
    {}

    /// Adds residual [N] and, where asked, tangent [N/mm]. Returns false if
    /// the trial state is inadmissible (an element turned inside out); that
    /// ends the increment.
    virtual bool assemble(const Configuration &, Assembler &) = 0;

    /// Replaces rows of the system after all terms have been assembled, where
    /// the term eliminates unknowns of its own node by node.
    virtual void condense(const Configuration &, CondensedRows &)
    {}

    /// Interface or material states that differ from the last assembly; the
    /// active set has settled when this is 0. Counts this rank's points.
    virtual unsigned int n_state_changes() const
    {
      return 0;
    }

    /// May the trial be accepted? False if the last assembly took a branch
    /// that the state does not ask for, so that Newton would not cycle.
    virtual bool has_settled() const
    {
      return true;
    }

    /// Error of the converged trial increment over what the term tolerates
    /// (above 1: too long) and the power of dt it follows; all ranks agree.
    virtual IncrementError increment_error() const
    {
      return {};
    }

    /// Points of this rank that have closed in the last accepted increment.
    /// (Those of a penalty bond move against the mould while the bond gives,
    /// so holding them longer would feed energy into the body.)
    virtual std::vector<ClosedPoint> closed_points() const
    {
      return {};
    }

    /// Energies [mJ] of the trial state, this rank's share.
    virtual Energies energies() const = 0;

    virtual void commit() = 0;
    virtual void revert() = 0;

    /// Bytes of history held by this rank.
    virtual std::size_t history_bytes() const = 0;

    /// Writes and reads the committed history of this rank.
    virtual void save(std::ostream &) const
    {}
    virtual void load(std::istream &)
    {}
  };
} // namespace demold

#endif
