// SPDX-License-Identifier: LGPL-2.1-or-later
//
// # step-nts-adhesion: how does a stuck node let go?
//
// Sample runs:
//   step-nts-adhesion prm/step-nts-adhesion/pull-off.prm
//   step-nts-adhesion prm/step-nts-adhesion/peel.prm --set "Body/cells=160,8"
//
//            top                    A body of rubber, here a box, over a rigid
//        +----------+               plane (or over a second body, the base).
//   left |   body   | right         Its bottom carries bonds and may touch and
//        +----------+               rub. Either the mould moves away (Pull) or
//   ======= bottom =======          the body is driven (Supports/motion).
//        rigid mould
//
// Builds on: nothing. The lesson of thesis chapters 3.1 and 5.2; intro.md has
// the equations, results.md what comes out.

#include "base/run_step.h"
#include "scene/body_scene.h"

using namespace demold;

namespace
{
  // ## The program
  //
  // There is little to see here, because a scene is data: BodyScene holds the
  // parameter file from top to bottom, section by section, and turns it into
  // what the picture shows,
  //
  // * a mesh of the body, and of the base                 (BodyEntries),
  // * the rigid surface it stands on                      (MouldEntries),
  // * nodes that are held or driven, dead loads           (SupportEntries),
  // * who moves, and where the force is measured          (ProcessEntries),
  // * rubber, contact, friction, bond, and the solution   (SceneParameters).
  //
  // run_simulation() makes of these a list of terms, the sum that the weak form
  // of intro.md is: the rubber; what contact, friction and bonds do at the
  // slave points, the lesson of this step, NodeToSegment; the dead loads. A
  // strategy solves the list for one increment after the other.
  class StepNtsAdhesion
  {
  public:
    void add_parameters(dealii::ParameterHandler &prm)
    {
      scene.add_parameters(prm);
    }

    void check() const
    {
      scene.check();
    }

    std::string preview() const
    {
      return scene.preview();
    }

    RunStatus run(const RunContext &context) const
    {
      return scene.run(context);
    }

  private:
    BodyScene scene;
  };
} // namespace

int main(int argc, char **argv)
{
  return run_step<StepNtsAdhesion>(argc, argv);
}
