// SPDX-License-Identifier: LGPL-2.1-or-later
// Where a path runs back behind the clock, and what a machine would miss there.
#ifndef demold_solution_excursion_h
#define demold_solution_excursion_h

#include <string>
#include <vector>

namespace demold
{
  class WeakForm;

  /// Keeps track of excursions: the path turns back at a time t*, wanders
  /// behind it and comes to it again. A machine stands at t* meanwhile and sees
  /// a jump, which releases what its force would do more than the forces along
  /// the path: nothing less the external work of the excursion, plus dead loads
  /// of t* times their displacement (theory D.2).
  class Excursion
  {
  public:
    /// At the start, or after load().
    void begin(const WeakForm &weak_form);

    /// Judges the converged trial that will be accepted. Collective.
    void look(const WeakForm &weak_form);

    std::string kind     = "envelope"; ///< of the trial, see PathPoint
    double      released = 0.;         ///< [mJ] by the excursion that ends

    bool is_inside() const
    {
      return inside;
    }

    std::vector<double> save() const;
    void                load(const std::vector<double> &values);

  private:
    bool   inside        = false;
    double work          = 0.; ///< [mJ] external, since the path turned back
    double at_turn       = 0.; ///< [mJ] potential of the dead loads there
    double last_external = 0.; ///< [mJ]
  };
} // namespace demold

#endif
