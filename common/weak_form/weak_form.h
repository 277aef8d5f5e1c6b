// SPDX-License-Identifier: LGPL-2.1-or-later
// Unknowns, supports and a list of terms: what a strategy solves.
#ifndef demold_weak_form_weak_form_h
#define demold_weak_form_weak_form_h

#include "weak_form/algebra.h"
#include "weak_form/energies.h"
#include "weak_form/term.h"

#include <deal.II/base/index_set.h>

#include <deal.II/lac/affine_constraints.h>

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace dealii
{
  class DynamicSparsityPattern;
}

namespace demold
{
  /// The displacement unknowns before any term adds its own.
  struct DisplacementSpace
  {
    MPI_Comm         communicator;
    dealii::IndexSet owned;
    dealii::IndexSet relevant;

    /// Adds the couplings of the cells of this rank.
    std::function<void(dealii::DynamicSparsityPattern &,
                       const dealii::AffineConstraints<double> &)>
      add_cell_couplings;
  };

  /// Unknowns whose value is a function of time: supports and grips, the same
  /// list on every rank.
  struct Supports
  {
    std::vector<dealii::types::global_dof_index> unknowns;

    /// Fills the values [mm] at time @p t [s], one per entry of `unknowns`.
    std::function<void(double t, std::vector<double> &values)> values;
  };

  /// Sizes of the parts of the residual, for convergence tests.
  struct ResidualNorms
  {
    double free     = 0.; ///< [N] unbalanced force at free unknowns
    double extra    = 0.; ///< [N] rows of the extra unknowns
    double scale    = 0.; ///< [N] largest of bulk, interface, inertia
    double unknowns = 0.; ///< norm of all unknowns
  };

  class WeakForm
  {
  public:
    WeakForm(const DisplacementSpace &space, const Supports &supports);
    ~WeakForm();

    /// Adds a term. After setup() only terms without extra unknowns.
    Term &add(std::unique_ptr<Term> term);

    /// Takes a term out again, between increments; its energies stay in the
    /// ledger.
    void remove(const Term &term);

    /// Numbers the extra unknowns, builds pattern, vectors and matrix.
    void setup();

    /// Starts an increment to @p time; the trial starts from the accepted
    /// displacements plus @p extrapolation times the last increment.
    void begin_increment(double time, double extrapolation);

    /// Moves supports, mould and loads of the trial to @p time, the free
    /// unknowns left where they are: for paths that look for their own time.
    void move_to(double time);

    /// Residual and, where asked, tangent at the trial. Returns false if the
    /// trial is inadmissible on any rank.
    bool assemble(bool with_tangent, unsigned int iteration);

    /// Adds @p factor times the correction @p du to the trial.
    void update(const Vector &du, double factor);

    /// Makes the trial the accepted state, in the vectors and in every term.
    void accept();

    /// Drops the trial; afterwards everything is bitwise as before
    /// begin_increment().
    void reject();

    /// Share of the bulk forces taken at t_{n+1}, the rest at t_n
    /// (generalised-alpha; 1 for quasi-statics).
    void set_bulk_weight(double weight);

    ResidualNorms residual_norms() const;

    /// du . R over the free unknowns [mJ].
    double work_of_residual(const Vector &du) const;

    /// Interface and material states changed by the last assembly, all ranks.
    unsigned int n_state_changes() const;

    /// Has every term settled in the last assembly, on all ranks?
    bool has_settled() const;

    /// Ledger at the trial, all ranks.
    Energies energies() const;

    bool symmetric() const;

    bool has_extra_unknowns() const
    {
      return n_extra > 0;
    }

    dealii::types::global_dof_index n_unknowns() const;

    /// Vector over the owned unknowns, zero.
    Vector new_vector() const;

    SparseMatrix matrix;
    Vector       right_hand_side;

    /// Unknowns at t_{n+1} and at the last accepted time, owned entries.
    Vector trial;
    Vector accepted;

    /// Forces [N] at t_{n+1} without inertia: at supports the reaction.
    Vector force;

    /// The same at the last accepted time.
    Vector accepted_force;

    const std::vector<std::unique_ptr<Term>> &term_list() const
    {
      return terms;
    }

    /// Prescribed entries of @p v set to zero.
    void set_supports_to_zero(Vector &v) const;

    /// Entries of @p v at the extra unknowns set to zero.
    void set_extra_to_zero(Vector &v) const;

    double time() const
    {
      return accepted_time;
    }

    /// Time [s] of the trial.
    double trial_time() const
    {
      return new_time;
    }

    /// Largest accepted time [s] so far: what the clock shows. Time passes for
    /// the material beyond it only, so that a path may go back and come again
    /// with everything that relaxes held frozen (theory D.2).
    double clock() const
    {
      return latest_time;
    }

    /// Accepted unknowns less those before.
    const Vector &last_increment() const
    {
      return previous_increment;
    }

    /// How often the pattern was built; the linear solver forgets with it.
    unsigned int pattern_number() const
    {
      return n_patterns;
    }

    void save(std::ostream &out) const;
    void load(std::istream &in);

  private:
    void          build_pattern();
    Configuration configuration(unsigned int iteration) const;
    bool          prescribe_increments();
    void          set_trial_at_supports();
    double        work_of_supports() const;

    DisplacementSpace                  space;
    Supports                           supports;
    std::vector<std::unique_ptr<Term>> terms;
    dealii::AffineConstraints<double>  constraints;
    dealii::IndexSet                   owned, relevant;
    unsigned int                       n_extra         = 0;
    unsigned int                       n_patterns      = 0;
    bool                               is_set_up       = false;
    bool                               is_extrapolated = false;
    double                             bulk_weight     = 1.;
    double                             accepted_time   = 0.;
    double                             new_time        = 0.;
    double                             latest_time     = 0.;
    Energies                           retired; // of removed terms
    double                             accepted_external = 0.;

    Vector              ghosted_trial, ghosted_accepted;
    Vector              previous_increment;
    Vector              bulk, interface, inertia, residual;
    Vector              accepted_bulk;
    std::vector<double> prescribed;
  };
} // namespace demold

#endif
