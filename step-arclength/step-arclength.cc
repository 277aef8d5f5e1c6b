// SPDX-License-Identifier: LGPL-2.1-or-later
//
// # step-arclength: where does the equilibrium go when it cannot go on?
//
// Sample runs:
//   step-arclength prm/step-arclength/spring.prm
//   step-arclength prm/step-arclength/truss.prm
//   step-arclength prm/step-arclength/column.prm
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

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

using namespace demold;

namespace
{
  // ## The program
  //
  // A scene is either a body as in step-nts-adhesion, or a network of springs,
  // bars and bonds that has a closed form: a handful of unknowns show what a
  // strategy does. Both end as a list of terms, and whoever solves the list
  // does not know which of the two it was. What is new is one strategy,
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
                        "body: rubber on a mould or a base; network: springs, "
                        "bars and bonds of section Network",
                        dealii::Patterns::Selection("body|network"));
      body.add_parameters(prm);
      network.add_parameters(prm);
    }

    void check() const
    {
      if (is_network())
        {
          body.scene.check();
          network.check(body.scene);
        }
      else
        body.check();
    }

    std::string preview() const
    {
      return is_network() ? network.preview() : body.preview();
    }

    RunStatus run(const RunContext &context) const
    {
      return is_network() ? network.run(body.scene, context) :
                            body.run(context);
    }

  private:
    bool is_network() const
    {
      return model == "network";
    }

    std::string  model = "body";
    BodyScene    body;
    NetworkScene network;
  };
} // namespace

int main(int argc, char **argv)
{
  return run_step<StepArclength>(argc, argv);
}
