// SPDX-License-Identifier: LGPL-2.1-or-later
// The phases of path following and how it goes from one to the other.
#include "solution/path_follower.h"

#include "solution/dissipation_constraint.h"
#include "solution/interface_constraint.h"
#include "solution/largest_opening_constraint.h"
#include "solution/quasi_static.h"
#include "solution/softening_overview.h"
#include "weak_form/weak_form.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace demold
{
  namespace
  {
    /// Iterations of a step: what needs more has met a limit or a kink.
    constexpr unsigned int few_iterations = 12;

    /// The order in which `adaptive` tries constraints where points soften: the
    /// dissipation first, because it needs no sign. After the third the body
    /// slides; the fourth is for what does not soften.
    const std::array<std::string, 4> order = {
      {"dissipation", "largest opening", "interface", "cylindrical"}};

    NewtonParameters few(NewtonParameters parameters)
    {
      parameters.max_iterations =
        std::min(parameters.max_iterations, few_iterations);
      return parameters;
    }

    std::unique_ptr<PathConstraint> make_constraint(const std::string &name)
    {
      if (name == "cylindrical")
        return std::make_unique<CylindricalConstraint>();
      if (name == "interface")
        return std::make_unique<InterfaceConstraint>();
      if (name == "largest opening")
        return std::make_unique<LargestOpeningConstraint>();
      return std::make_unique<DissipationConstraint>();
    }

    std::string at_time(const double time)
    {
      char text[40];
      std::snprintf(text, sizeof(text), "time %.6g s: ", time);
      return text;
    }
  } // namespace

  PathFollower::PathFollower(WeakForm                  &weak_form,
                             const PathTools           &tools,
                             const IncrementParameters &increments,
                             const double               end_time,
                             const OnAccept            &on_accept)
    : weak_form(weak_form)
    , tools(tools)
    , increments(increments)
    , end_time(end_time)
    , on_accept(on_accept)
    , state(increments.state != nullptr ? *increments.state : local)
    , newton(few(tools.newton_parameters), tools.linear_solver)
    , corrector(few(tools.newton_parameters), tools.linear_solver, tools.newton)
    , size(tools.path.release)
    , mode(weak_form.new_vector())
    , books(weak_form)
  {
    result.rejected          = state.rejected;
    result.newton_iterations = state.newton_iterations;
    if (state.dt <= 0.)
      state.dt = increments.first;
  }

  bool PathFollower::is_cylindrical() const
  {
    return cylindrical != nullptr;
  }

  void PathFollower::use(const std::string &name, const std::string &why)
  {
    constraint  = make_constraint(name);
    cylindrical = dynamic_cast<CylindricalConstraint *>(constraint.get());
    size        = is_cylindrical() ? 1. : tools.path.release;
    on_path     = on_path || is_cylindrical();
    if (why.empty())
      return;
    result.events.push_back(at_time(weak_form.time()) + "constraint " + name +
                            ", because " + why);
    tools.note(result.events.back());
  }

  void PathFollower::choose_first_constraint()
  {
    if (tools.path.constraint != "adaptive")
      use(tools.path.constraint, "");
    else if (max_over_ranks(weak_form, look().size()) == 0.)
      use("cylindrical", "there is nothing that softens");
    else
      use(order.front(), "what softens releases energy step by step");
  }

  bool PathFollower::choose_next_constraint(const std::string &why)
  {
    if (tools.path.constraint != "adaptive")
      return give_up(why);
    if (constraint->name() == order[2] || is_cylindrical())
      {
        if (!slide_down())
          return give_up(why);
        on_path = is_cylindrical();
        use(is_cylindrical() ? order.back() : order.front(),
            "a slide has led past what no other could follow");
        last_load = 0.;
        return true;
      }
    const auto now = std::find(order.begin(), order.end(), constraint->name());
    use(*(now + 1), constraint->name() + " failed: " + why);
    return true;
  }

  void PathFollower::begin_path(const std::string &why)
  {
    on_path    = true;
    path_steps = 0;
    result.events.push_back(at_time(weak_form.time()) + "path phase, because " +
                            why);
    tools.note(result.events.back());
  }

  void PathFollower::end_path(const std::string &why)
  {
    on_path   = false;
    last_load = 0.;
    if (why.empty())
      return;
    result.events.push_back(at_time(weak_form.time()) + "load phase, because " +
                            why);
    tools.note(result.events.back());
  }

  bool PathFollower::give_up(const std::string &why)
  {
    result.gave_up = true;
    result.reason  = at_time(weak_form.time()) +
                    "the path cannot be followed "
                    "with constraint " +
                    constraint->name() + ": " + why;
    return false;
  }

  StrategyResult PathFollower::run()
  {
    books = Books(weak_form);
    excursion.begin(weak_form);
    look();
    if (state.path.empty())
      choose_first_constraint();
    else
      load();
    const double tiny = 1e-12 * end_time;
    while (goes_on && end_time - weak_form.time() > tiny)
      if (!(on_path ? path_step() : load_step()))
        break;
    return result;
  }

  void PathFollower::save()
  {
    state.path = {on_path ? 1. : 0.,
                  size,
                  static_cast<double>(path_steps),
                  last_load,
                  is_cylindrical() ? cylindrical->length : 0.,
                  static_cast<double>(
                    std::find(order.begin(), order.end(), constraint->name()) -
                    order.begin()),
                  books.largest_entry};
    for (const double x : excursion.save())
      state.path.push_back(x);
    if (!tools.path.branch)
      return;
    state.path.push_back(stability.negative_pivots);
    state.path.push_back(stability.smallest_eigenvalue);
    for (const auto i : mode.locally_owned_elements())
      state.path.push_back(mode(i));
  }

  void PathFollower::load()
  {
    const auto &values = state.path;
    use(order.at(static_cast<unsigned int>(values.at(5))), "");
    on_path    = values.at(0) > 0.;
    size       = values.at(1);
    path_steps = static_cast<unsigned int>(values.at(2));
    last_load  = values.at(3);
    if (is_cylindrical())
      cylindrical->length = values.at(4);
    books.largest_entry = values.at(6);
    auto next           = values.begin() + 7;
    excursion.load({next, next + 4});
    if (!tools.path.branch)
      return;
    next += 4;
    stability.negative_pivots     = static_cast<int>(*next++);
    stability.smallest_eigenvalue = *next++;
    for (const auto i : mode.locally_owned_elements())
      mode(i) = *next++;
    mode.compress(dealii::VectorOperation::insert);
  }

  StrategyResult run_path_following(WeakForm                  &weak_form,
                                    const PathTools           &tools,
                                    const IncrementParameters &increments,
                                    const double               end_time,
                                    const OnAccept            &on_accept)
  {
    weak_form.set_bulk_weight(1.);
    if (tools.path.constraint == "load")
      return run_quasi_static(weak_form,
                              tools.newton,
                              increments,
                              end_time,
                              on_accept);
    return PathFollower(weak_form, tools, increments, end_time, on_accept)
      .run();
  }
} // namespace demold
