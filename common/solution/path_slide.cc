// SPDX-License-Identifier: LGPL-2.1-or-later
// Where no path can be followed: down the slope of the energy.
#include "solution/overdamping.h"
#include "solution/path_follower.h"
#include "weak_form/weak_form.h"

#include <algorithm>

namespace demold
{
  namespace
  {
    /// Time a slide goes forward, share of the largest increment.
    constexpr double step_forward = 1e-3;

    /// Factors of the dashpots: after a step that was accepted and one that was
    /// not, the last one but zero, and where nothing helps any more.
    constexpr double easier = .25, harder = 8., lightest = 1e-4, heaviest = 1e6;

    constexpr unsigned int most_steps = 400;

    /// Takes the dashpots out again, however the slide ends.
    class Slide
    {
    public:
      explicit Slide(WeakForm &weak_form)
        : weak_form(weak_form)
        , dashpots(static_cast<Overdamping &>(
            weak_form.add(std::make_unique<Overdamping>(weak_form))))
      {}

      ~Slide()
      {
        weak_form.remove(dashpots);
      }

      bool is_free() const
      {
        return dashpots.factor == 0.;
      }

      void lighten()
      {
        dashpots.factor =
          dashpots.factor <= lightest ? 0. : easier * dashpots.factor;
      }

      bool stiffen()
      {
        dashpots.factor = is_free() ? lightest : harder * dashpots.factor;
        return dashpots.factor <= heaviest;
      }

      WeakForm    &weak_form;
      Overdamping &dashpots;
    };
  } // namespace

  /// Dashpots hold the body while it slides to the nearest equilibrium a little
  /// later, in steps whose energy the ledger explains; what they take is booked
  /// as regularisation. A machine would see a jump.
  bool PathFollower::slide_down()
  {
    look();
    weak_form.assemble(true, 0);
    const double before = weak_form.energies().regularisation;
    const double to =
      weak_form.time() + std::min(step_forward * increments.largest,
                                  next_mark() - weak_form.time());
    NewtonReport report;
    bool         arrived = false;
    {
      Slide slide(weak_form);
      for (unsigned int n = 0; n < most_steps && !arrived; ++n)
        {
          weak_form.begin_increment(to, 0.);
          report = tools.newton.solve(weak_form);
          slide.dashpots.account(weak_form);
          if (!report.converged || leaves_the_books_open())
            {
              reject(report, "a step of the slide loses energy");
              if (!slide.stiffen())
                break;
              continue;
            }
          arrived = slide.is_free();
          if (arrived)
            break; // accepted without the dashpots
          weak_form.accept();
          tools.newton.accept(report);
          books.accept();
          state.newton_iterations = result.newton_iterations +=
            report.iterations;
          slide.lighten();
        }
    }
    if (arrived)
      accept(report,
             "load",
             "overdamped",
             weak_form.energies().regularisation - before);
    return arrived;
  }
} // namespace demold
