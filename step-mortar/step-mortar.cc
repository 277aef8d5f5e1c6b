// SPDX-License-Identifier: LGPL-2.1-or-later
//
// # step-mortar: how is the traction made independent of how the meshes meet?
//
// Sample runs:
//   step-mortar prm/step-mortar/contact-patch.prm
//   step-mortar prm/step-mortar/hertz.prm --set "Contact/multipliers=dual"
//
//          slave: body                A node of the slave no longer looks for
//     o------o------o------o          one point of the master. Each face of
//     |  A   |  B   |      |          the slave is cut along the faces it
//     +---+--+--+---+--+---+  <-      meets, and everything is integrated over
//       |     |      |     |          the pieces, the segments. The traction
//       o-----o------o-----o          is an unknown of its own at each slave
//          master: base or mould      node, lambda, that keeps the gap shut.
//
// Builds on: step-nts-adhesion, whose scenes it runs again. The lesson of
// thesis chapters 3.2 and 5.3; intro.md has the equations.

#include "base/run_step.h"
#include "scene/body_scene.h"

using namespace demold;

namespace
{
  // ## The program
  //
  // A scene is data, and the data are those of step-nts-adhesion: BodyScene.
  // What is new is one word. `Contact/formulation = mortar` puts another term
  // into the list that the weak form is, MortarTerm in place of NodeToSegment,
  // and with it unknowns behind the displacements: the tractions. The rubber,
  // the bond's law, the strategies and the ledger do not notice.
  //
  // The same word does the same in the scenes of step-demold; here it is the
  // default.
  class StepMortar
  {
  public:
    StepMortar()
    {
      scene.scene.interface.formulation = "mortar";
    }

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
  return run_step<StepMortar>(argc, argv);
}
