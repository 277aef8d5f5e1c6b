// SPDX-License-Identifier: LGPL-2.1-or-later
// What holds the block's back: plate, belt plies, rubber base.
#include "step-demold/demolding.h"

namespace demold
{
  TEST(Fixing, on_belt_plies_is_nearly_a_rigid_plate_and_on_rubber_softer)
  {
    const SceneRun plate = run_demold("slice.prm");
    const SceneRun belt  = run_demold("slice-belt-plies.prm");
    const SceneRun base  = run_demold("slice-rubber-base.prm");
    for (const SceneRun *run : {&plate, &belt, &base})
      {
        expect_clean_release(*run);
        expect_energy_of_the_bond(*run, 2);
      }

    // Theory F: the stiffer the fixing the higher the force and the smaller
    // the opening at it. Plies of 2.4 mm, held in their plane by cords, yield
    // by the shear of their rubber alone, stiffer than that of the block.
    const double peak = plate.number("peak force [N]"),
                 at   = plate.number("opening at peak [mm]");
    EXPECT_NEAR(belt.number("peak force [N]"), peak, .01 * peak);
    EXPECT_NEAR(belt.number("opening at peak [mm]"), at, .1 * at);
    EXPECT_LT(base.number("peak force [N]"), .97 * peak);
    EXPECT_GT(base.number("opening at peak [mm]"), 1.3 * at);
  }

  // The same rubber, held at the same place: a base of the block's own rubber,
  // or a layer of it behind the block.
  TEST(Fixing, on_a_base_of_the_blocks_own_rubber_is_a_thicker_block)
  {
    // elastic, Lambda = 50 MPa and mu1 = E_inf/3 of f90 = 0.8
    const double                   mu = 2.2727 / 3., K = 50. + 2. / 3. * mu;
    const std::vector<std::string> elastic = {"Material/viscosity=false",
                                              "Material/table mu2 over mu1=0"};
    auto                           thicker = elastic, layered = elastic;
    thicker.push_back("Block/base thickness=2");
    layered.push_back("Block/fixing=rubber base");
    layered.push_back("Rubber base/thickness=2");
    layered.push_back("Rubber base/modulus=" +
                      std::to_string(9. * K * mu / (3. * K + mu)));
    layered.push_back("Rubber base/bulk modulus=" + std::to_string(K));
    const SceneRun a = run_demold("slice.prm", thicker),
                   b = run_demold("slice.prm", layered);
    // Round-off chooses other increments, and the work is a sum over them.
    EXPECT_NEAR(a.number("peak force [N]"),
                b.number("peak force [N]"),
                1e-4 * a.number("peak force [N]"));
    EXPECT_NEAR(a.number("work of demolding [mJ]"),
                b.number("work of demolding [mJ]"),
                1e-3 * a.number("work of demolding [mJ]"));
  }

  // Cords are 10^4 times as stiff as rubber and a hundredth of that when they
  // are pushed: neither may open the ledger when the block pulls and turns.
  TEST(Fixing, on_belt_plies_carries_an_inclined_pull)
  {
    const SceneRun run = run_demold("slice-belt-plies.prm",
                                    {"Block/symmetry=whole",
                                     "Pull/inclination=2",
                                     "Solution/accuracy=0.1"});
    expect_clean_release(run);
    expect_energy_of_the_bond(run, 2);
  }
} // namespace demold
