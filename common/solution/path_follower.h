// SPDX-License-Identifier: LGPL-2.1-or-later
// The phases of path following and how it goes from one to the other.
#ifndef demold_solution_path_follower_h
#define demold_solution_path_follower_h

#include "solution/books.h"
#include "solution/cylindrical_constraint.h"
#include "solution/excursion.h"
#include "solution/newton.h"
#include "solution/path_corrector.h"
#include "solution/path_following.h"
#include "weak_form/softening_sites.h"

#include <memory>

namespace demold
{
  /// Where a run stands, see run_path_following().
  class PathFollower
  {
  public:
    PathFollower(WeakForm                  &weak_form,
                 const PathTools           &tools,
                 const IncrementParameters &increments,
                 const double               end_time,
                 const OnAccept            &on_accept);

    StrategyResult run();

  private:
    using Points = std::vector<SofteningSite>;
    using Chosen = std::function<bool(const SofteningSite &)>;

    // Choice of constraint and phase (path_follower.cc).
    void choose_first_constraint();
    bool choose_next_constraint(const std::string &why);
    void use(const std::string &name, const std::string &why);
    void begin_path(const std::string &why);
    void end_path(const std::string &why);
    bool give_up(const std::string &why);
    bool is_cylindrical() const;

    // Steps forward in time (load_steps.cc); false: the run is over.
    bool   load_step();
    bool   try_load(const double dt);
    bool   meet_limit(const double step);
    double onset_within(const double step);

    // Steps along the path (path_steps.cc), likewise.
    bool path_step();
    bool try_path(const Chosen &chosen, const bool may_pass);
    bool try_single_points(const Points &points);
    bool shorten_path_step();
    bool jump();
    void adapt_path_step(const NewtonReport &report, const double dt);

    // Where paths cross (path_branch.cc).
    bool try_branch(const Points &points);

    // Where neither goes on (path_slide.cc).
    bool slide_down();

    // What steps have in common (load_steps.cc).
    Points look();
    double next_mark() const;
    bool   releases_too_much(const double points) const;
    bool   leaves_the_books_open();
    void   accept(const NewtonReport &report,
                  const std::string  &constraint,
                  const std::string  &strategy,
                  const double        damped = 0.);
    void   reject(const NewtonReport &report, const std::string &why);
    void   report_stability(const StabilityReading &reading);
    void   save();
    void   load();

    WeakForm                  &weak_form;
    const PathTools           &tools;
    const IncrementParameters &increments;
    const double               end_time;
    const OnAccept            &on_accept;

    IncrementState                  local;
    IncrementState                 &state;
    Newton                          newton; ///< of load steps
    PathCorrector                   corrector;
    std::unique_ptr<PathConstraint> constraint;
    CylindricalConstraint          *cylindrical = nullptr; ///< if it is that
    Excursion                       excursion;
    StrategyResult                  result;

    bool             goes_on    = true;
    bool             on_path    = false;
    double           size       = 0.;  ///< of path steps, of a full one
    unsigned int     path_steps = 0;   ///< since the last try of a load step
    double           nudged     = -1.; ///< [s] clock of the last step back
    double           last_load  = 0.;  ///< [s] to extrapolate from, 0: nothing
    double           whole      = 0.;  ///< [mJ] of the largest point
    Vector           mode;             ///< eigenvector of the last reading
    StabilityReading stability;        ///< of the last point, if anybody asks
    Books            books;
    std::string      last_problem;
  };
} // namespace demold

#endif
