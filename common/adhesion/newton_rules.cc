// SPDX-License-Identifier: LGPL-2.1-or-later
// Which branches a point may take from one Newton iteration to the next.
#include "adhesion/newton_rules.h"

namespace demold
{
  NewtonMemory NewtonMemory::after(const ResolventResponse &response) const
  {
    return {iteration + 1, response.bond, response.contact, response.slide};
  }



  std::optional<ForcedBranch> newton_rule(const ResolventResponse &free,
                                          const NewtonMemory      &last)
  {
    const bool slips = free.contact == ContactStatus::slip;
    if (slips && last.iteration == 0)
      return ForcedBranch::hold;
    if (slips && free.slide * last.slide < 0.)
      return ForcedBranch::hold;
    const bool held = last.bond == AdhesionStatus::adhering ||
                      last.bond == AdhesionStatus::unloading;
    if (held && free.bond == AdhesionStatus::separated)
      return ForcedBranch::decohesion;
    return {};
  }



  ResolventResponse evaluate_by_rules(const TractionResolvent &law,
                                      const AugmentedTraction &traction,
                                      const ResolventState    &old,
                                      const NewtonMemory      &last)
  {
    const ResolventResponse free = law.evaluate(traction, old);
    const auto              rule = newton_rule(free, last);
    return rule ? law.evaluate(traction, old, rule) : free;
  }
} // namespace demold
