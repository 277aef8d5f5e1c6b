// SPDX-License-Identifier: LGPL-2.1-or-later
// slice.prm with multipliers: an independent path to the same demolding.
#include "step-demold/demolding.h"

#include <gtest/gtest.h>

namespace demold
{
  namespace
  {
    SceneRun slice(const std::vector<std::string> &entries)
    {
      std::vector<std::string> overrides = {"Contact/formulation=mortar"};
      overrides.insert(overrides.end(), entries.begin(), entries.end());
      return run_demold("slice.prm", overrides);
    }

    void expect_agreement(const SceneRun &run,
                          const SceneRun &other,
                          const double    tolerance)
    {
      for (const char *key : {"peak force [N]", "work of demolding [mJ]"})
        EXPECT_NEAR(run.number(key),
                    other.number(key),
                    tolerance * other.number(key))
          << key;
      EXPECT_NEAR(run.number("adhesion dissipation [mJ]"),
                  other.number("adhesion dissipation [mJ]"),
                  1e-6 * other.number("adhesion dissipation [mJ]"));
    }
  } // namespace

  TEST(MortarSlice, agrees_with_node_to_segment_contact)
  {
    const SceneRun nodes = slice({"Contact/formulation=node to segment"});
    for (const char *multipliers : {"standard", "dual"})
      {
        SCOPED_TRACE(multipliers);
        const SceneRun run =
          slice({std::string("Contact/multipliers=") + multipliers});
        expect_clean_release(run);
        expect_energy_of_the_bond(run, 2);
        expect_agreement(run, nodes, .03);
      }
  }

  TEST(MortarSlice, condensation_changes_nothing_but_the_size_of_the_system)
  {
    const SceneRun condensed =
      slice({"Contact/multipliers=dual", "Contact/condensed=true"});
    const SceneRun whole = slice({"Contact/multipliers=dual"});
    EXPECT_LT(condensed.number("degrees of freedom"),
              whole.number("degrees of freedom"));
    // Increments differ a little, and with them the viscous losses.
    expect_agreement(condensed, whole, .002);
  }

  TEST(MortarBlock, condensed_multipliers_leave_multigrid_its_way)
  {
    const auto block = [](std::vector<std::string> entries) {
      for (const char *entry : {"Contact/multipliers=dual",
                                "Block/element size=3",
                                "Block/length=10",
                                "Block/width=10",
                                "Block/sipes=0",
                                "Solver/linear=iterative"})
        entries.push_back(entry);
      return run_demold("tread-block-mortar.prm", entries);
    };
    const SceneRun condensed = block({"Contact/condensed=true"});
    const SceneRun whole     = block({"Contact/condensed=false"});
    expect_clean_release(condensed);
    expect_agreement(condensed, whole, .002);
    // A direct solver steps in where an increment was too long.
    EXPECT_LT(condensed.number("factorisations"),
              .1 * condensed.number("newton iterations"));
    EXPECT_LT(condensed.number("krylov iterations"),
              50. * condensed.number("newton iterations"));
    EXPECT_GT(whole.number("factorisations"), 0.);
  }
} // namespace demold
