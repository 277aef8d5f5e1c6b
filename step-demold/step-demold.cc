// SPDX-License-Identifier: LGPL-2.1-or-later
//
// # step-demold: which force, when the block leaves its mould?
//
// Sample runs:
//   step-demold prm/step-demold/tread-block.prm
//   step-demold prm/step-demold/slice.prm --set "Pull/velocity=200"
//
//      backing: on a rigid plate, belt plies or a rubber base
//     +-----------------------------+
//      \     +--+       +--+       /
//  wall \    |  | sipe  |  |      /      rubber, bonded to the mould where it
//        \   |  |       |  |     /       touches; the mould moves down
//         +--+  +-------+  +----+
//                bottom
//
// Builds on: step-nts-adhesion. The lesson of thesis chapter 7; intro.md has
// the scene and its equations, results.md what comes out.

#include "base/run_step.h"
#include "scene/tread_scene.h"

#include <deal.II/base/parameter_handler.h>

using namespace demold;

namespace
{
  // ## The program
  //
  // TreadScene turns sections of the parameter file into what the picture
  // shows,
  //
  // * the block and the mould around it, both from the same numbers
  //                                                  (TreadBlock, make_mould),
  // * or from Gmsh files                             (MeshFiles),
  // * what holds the back: a rigid plate, belt plies, a rubber base  (Fixing),
  // * the surfaces cured against metal, which may stick, touch and rub: bottom,
  //   walls and sipes                                (TreadScene::make_scene);
  //
  // and is given what is no matter of tread blocks,
  //
  // * how the mould travels and turns                (Pull),
  // * rubber, contact, friction, bond, the solution  (SceneParameters).
  class StepDemold
  {
  public:
    void add_parameters(dealii::ParameterHandler &prm)
    {
      parameters.add_parameters(prm);
      tread.add_parameters(prm);
      pull.add_parameters(prm);
    }

    void check() const
    {
      tread.check(parameters, pull);
    }

    std::string preview() const
    {
      return tread.preview(parameters, pull);
    }

    RunStatus run(const RunContext &context) const
    {
      return tread.run(parameters, pull, context);
    }

  private:
    SceneParameters parameters;
    TreadScene      tread;
    Pull            pull;
  };
} // namespace

int main(int argc, char **argv)
{
  return run_step<StepDemold>(argc, argv);
}
