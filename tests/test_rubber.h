// SPDX-License-Identifier: LGPL-2.1-or-later
// The rubber most tests are made of.
#ifndef demold_tests_test_rubber_h
#define demold_tests_test_rubber_h

#include "material/rubber_law.h"

#include <utility>
#include <vector>

namespace demold
{
  /// Mooney-Rivlin rubber with the constants of theory A.1, Lambda = 50, mu1 =
  /// 0.4, mu2 = 0.1 MPa, and @p branches in parallel.
  inline RubberLaw test_rubber(std::vector<MaxwellBranch> branches = {})
  {
    MooneyRivlin elastic;
    elastic.lambda = 50.;
    elastic.mu1    = .4;
    elastic.mu2    = .1;
    RubberLaw law;
    law.elastic  = elastic;
    law.branches = std::move(branches);
    return law;
  }
} // namespace demold

#endif
