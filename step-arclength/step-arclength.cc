// SPDX-License-Identifier: LGPL-2.1-or-later
//
// # step-arclength: where does the equilibrium go when it cannot go on?
//
// Sample runs:
//   step-arclength prm/step-arclength/spring.prm
//   step-arclength prm/step-arclength/truss.prm
//   step-arclength prm/step-arclength/column.prm
//   step-arclength prm/step-arclength/tread-slice.prm
//
//     force
//       |        x  limit: the machine sees a jump,
//       |      / |
//       |    /  /    the path turns back
//       |  /  /
//       +------------- opening
//
// Builds on: step-nts-adhesion. The lesson of thesis chapter 6; intro.md has
// the equations, results.md what comes out.

#include "base/run_step.h"
#include "scene/body_scene.h"
#include "scene/network_scene.h"
#include "scene/tread_scene.h"

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

using namespace demold;

namespace
{
  // ## The program
  //
  // A scene is a body as in step-nts-adhesion, a tread block as in step-demold,
  // or a network of springs, bars and bonds that has a closed form: a handful
  // of unknowns show what a strategy does. All end as a list of terms, and
  // whoever solves the list does not know which of them it was. What is new is
  // one strategy,
  //
  // * strategy = arc length: run_path_following() in solution/, where phases
  //   and steps are (PathFollower), the linear algebra of an equation more
  //   (BorderedSystem) and the equations one may add (PathConstraint);
  //
  // and what it asks of a term whose points soften (SofteningTerm).
  class StepArclength
  {
  public:
    void add_parameters(dealii::ParameterHandler &prm)
    {
      prm.add_parameter("model",
                        model,
                        "body: rubber on a mould or a base; tread block: the "
                        "scene of step-demold; network: springs, bars and "
                        "bonds of section Network",
                        dealii::Patterns::Selection(
                          "body|tread block|network"));
      body.add_parameters(prm);
      tread.add_parameters(prm);
      network.add_parameters(prm);
    }

    void check() const
    {
      if (model == "body")
        body.check();
      else if (model == "tread block")
        tread.check(parameters(), pull());
      else
        {
          parameters().check();
          network.check(parameters());
        }
    }

    std::string preview() const
    {
      return model == "body"        ? body.preview() :
             model == "tread block" ? tread.preview(parameters(), pull()) :
                                      network.preview();
    }

    RunStatus run(const RunContext &context) const
    {
      return model == "body"        ? body.run(context) :
             model == "tread block" ? tread.run(parameters(), pull(), context) :
                                      network.run(parameters(), context);
    }

  private:
    // The sections all three share.
    const SceneParameters &parameters() const
    {
      return body.scene;
    }

    const Pull &pull() const
    {
      return body.process.pull;
    }

    std::string  model = "body";
    BodyScene    body;
    TreadScene   tread;
    NetworkScene network;
  };
} // namespace

int main(int argc, char **argv)
{
  return run_step<StepArclength>(argc, argv);
}
