// SPDX-License-Identifier: LGPL-2.1-or-later
//
// # step-demold: which force, when the block leaves its mould?
//
// Sample runs:
//   step-demold prm/step-demold/tread-block.prm
//   step-demold prm/step-demold/slice.prm --set "Pull/velocity=200"
//
//      backing: held, or on a rubber base
//     +-----------------------------+
//      \     +--+       +--+       /
//  wall \    |  | sipe  |  |      /      rubber, bonded to the mould where it
//        \   |  |       |  |     /       touches; the mould moves down
//         +--+  +-------+  +----+
//                bottom
//
// Builds on: step-nts-adhesion. The lesson of thesis chapter 7; intro.md has
// the scene and its equations, results.md what comes out.

#include "base/parameter_error.h"
#include "base/run_step.h"
#include "geometry/boundary_names.h"
#include "geometry/mesh_file.h"
#include "geometry/tread_block.h"
#include "scene/pull.h"
#include "scene/simulation.h"

#include <deal.II/base/parameter_handler.h>

using namespace demold;
using dealii::ParameterHandler;

namespace
{
  // ## Parameters: the prm file from top to bottom
  struct Parameters
  {
    SceneParameters scene;
    TreadBlock      block;
    MeshFiles       files;
    Pull            pull;

    void add_parameters(ParameterHandler &prm)
    {
      scene.add_parameters(prm);
      block.add_parameters(prm);
      files.add_parameters(prm);
      pull.add_parameters(prm);
    }
  };

  // ## The scene
  //
  // The backing is held; what stands on a symmetry plane stays on it. The
  // surfaces that were cured against metal may stick, touch and rub.
  template <int dim>
  Scene<dim> make_scene(const Parameters &p)
  {
    Scene<dim> scene;
    scene.make_mesh = [&p](dealii::Triangulation<dim, dim> &triangulation) {
      if (p.files.block.empty())
        make_tread_block<dim>(p.block, triangulation);
      else
        read_mesh_file<dim>(p.files.block, triangulation);
    };
    for (unsigned int d = 0; d < dim; ++d)
      {
        SupportRule rule;
        rule.boundary  = Boundary::backing;
        rule.component = d;
        scene.supports.push_back(rule);
      }
    SupportRule plane;
    plane.boundary  = Boundary::symmetry_x;
    plane.component = 0;
    scene.supports.push_back(plane);
    if (dim == 3)
      {
        plane.boundary  = Boundary::symmetry_y;
        plane.component = 1;
        scene.supports.push_back(plane);
      }

    if (p.scene.interface.active())
      {
        scene.slave = {Boundary::bottom, Boundary::wall, Boundary::sipe};
        scene.mould = p.files.mould.empty() ?
                        make_mould(p.block, dim) :
                        read_rigid_surface(p.files.mould, dim);
      }
    scene.motion    = p.pull.motion(dim);
    scene.opening   = [&p](const double t) { return p.pull.travel(t); };
    scene.direction = [&p](const double t) {
      return p.pull.opening_direction(dim, t);
    };
    scene.end_time        = p.pull.duration();
    scene.after_release   = p.pull.after;
    scene.symmetry_factor = p.block.symmetry_factor(dim);
    scene.height          = p.block.height + p.block.base_thickness;
    return scene;
  }

  // ## The program
  class StepDemold
  {
  public:
    void add_parameters(ParameterHandler &prm)
    {
      parameters.add_parameters(prm);
    }

    void check() const
    {
      const int dim = parameters.scene.dim();
      if (parameters.scene.dimension == "axisymmetric")
        throw ExcParameter("dimension",
                           "must be 2 (a slice) or 3 for a tread block; got "
                           "axisymmetric.");
      parameters.scene.check();
      parameters.pull.check(dim);
      parameters.files.check(dim);
      if (parameters.files.block.empty())
        parameters.block.check(dim);
      check_symmetry(dim);
    }

    std::string preview() const
    {
      return parameters.scene.dim() == 3 ?
               preview_simulation(make_scene<3>(parameters), parameters.scene) :
               preview_simulation(make_scene<2>(parameters), parameters.scene);
    }

    RunStatus run(const RunContext &context) const
    {
      if (parameters.scene.dim() == 3)
        return run_simulation(make_scene<3>(parameters),
                              parameters.scene,
                              context);
      return run_simulation(make_scene<2>(parameters),
                            parameters.scene,
                            context);
    }

  private:
    // A reduced model stays what it is only under a straight pull.
    void check_symmetry(const int dim) const
    {
      const TreadBlock &block = parameters.block;
      if (!block.reduced_x() && !block.reduced_y(dim))
        return;
      const double end = parameters.pull.duration();
      const auto   d   = parameters.pull.opening_direction(dim, end);
      const bool   tilts = parameters.pull.tilt != "0";
      if ((block.reduced_x() && (d[0] != 0. || tilts)) ||
          (block.reduced_y(dim) && d[1] != 0.))
        throw ExcParameter("Block/symmetry",
                           "must keep the pull in its planes: " +
                             block.symmetry + " with a direction of (" +
                             std::to_string(d[0]) + ", " +
                             std::to_string(d[1]) + ", " +
                             std::to_string(d[2]) + ")" +
                             (tilts ? " and a tilt" : "") +
                             " is not symmetric. Set it to whole" +
                             (dim == 3 ? " or half y." : "."));
    }

    Parameters parameters;
  };
} // namespace

int main(int argc, char **argv)
{
  return run_step<StepDemold>(argc, argv);
}
