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

#include "base/parameter_error.h"
#include "base/run_step.h"
#include "geometry/boundary_names.h"
#include "geometry/mesh_file.h"
#include "geometry/tread_block.h"
#include "material/elastic_rubber.h"
#include "material/ply_parameters.h"
#include "scene/pull.h"
#include "scene/simulation.h"

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <sstream>
#include <string>
#include <vector>

using namespace demold;
using dealii::ParameterHandler;

namespace
{
  // ## Fixing: what is behind the block
  //
  // * rigid plate: the backing is held in all directions.
  // * belt plies: cord-rubber plies, a layer each. While the mould opens, the
  //   grip holds the back of the belt along the opening only; in its plane the
  //   cords hold it, and the belt goes on beyond the block: its sides stay in
  //   their planes, as in a row of equal blocks.
  // * rubber base: elastic rubber of its own modulus, held at its back.
  struct Fixing
  {
    std::string    kind = "rigid plate";
    BeltParameters belt;
    double         base_thickness = 2.;  // [mm]
    double         base_modulus   = 3.;  // E [MPa]
    double         base_bulk      = 50.; // K [MPa]

    void add_parameters(ParameterHandler &prm);
    void check() const;

    // Thicknesses [mm] from the block outwards; layer k has material id k + 1.
    std::vector<double> layers() const;
    RubberLaw           law(unsigned int layer, int dim) const;
    template <int dim>
    std::vector<SupportRule> supports() const;
  };

  void Fixing::add_parameters(ParameterHandler &prm)
  {
    const dealii::Patterns::Double positive(1e-6, 1e6);
    prm.enter_subsection("Block");
    prm.add_parameter("fixing",
                      kind,
                      "what holds the back of block and base: rigid plate, or "
                      "a layer made by section Belt or Rubber base",
                      dealii::Patterns::Selection(
                        "rigid plate|belt plies|rubber base"));
    prm.leave_subsection();
    belt.add_parameters(prm);
    prm.enter_subsection("Rubber base");
    prm.add_parameter("thickness",
                      base_thickness,
                      "of the layer [mm]",
                      positive);
    prm.add_parameter("modulus",
                      base_modulus,
                      "E Young's modulus of the layer, elastic [MPa]",
                      positive);
    prm.add_parameter("bulk modulus",
                      base_bulk,
                      "K of the layer [MPa]",
                      positive);
    prm.leave_subsection();
  }

  void Fixing::check() const
  {
    if (kind == "belt plies")
      belt.check();
    if (kind == "rubber base" && !(3. * base_bulk > base_modulus))
      {
        std::ostringstream text;
        text << "must exceed a third of Rubber base/modulus = " << base_modulus
             << " MPa; got " << base_bulk
             << " MPa. Rubber has 10 to 1000 times "
             << "its modulus.";
        throw ExcParameter("Rubber base/bulk modulus", text.str());
      }
  }

  std::vector<double> Fixing::layers() const
  {
    if (kind == "belt plies")
      return std::vector<double>(belt.angles.size(), belt.ply.thickness);
    if (kind == "rubber base")
      return {base_thickness};
    return {};
  }

  RubberLaw Fixing::law(const unsigned int layer, const int dim) const
  {
    if (kind == "belt plies")
      return belt.law(layer, dim);
    return elastic_rubber(base_modulus, base_bulk);
  }

  template <int dim>
  std::vector<SupportRule> Fixing::supports() const
  {
    std::vector<SupportRule> rules;
    const auto hold = [&](const Boundary::Id id, const unsigned int component) {
      SupportRule rule;
      rule.boundary  = id;
      rule.component = component;
      rules.push_back(rule);
    };
    hold(Boundary::backing, dim - 1);
    for (unsigned int d = 0; d + 1 < dim; ++d)
      if (kind == "belt plies")
        hold(d == 0 ? Boundary::layer_x : Boundary::layer_y, d);
      else
        hold(Boundary::backing, d);
    hold(Boundary::symmetry_x, 0);
    if (dim == 3)
      hold(Boundary::symmetry_y, 1);
    return rules;
  }

  // ## Parameters: the prm file from top to bottom
  struct Parameters
  {
    SceneParameters scene;
    TreadBlock      block;
    Fixing          fixing;
    MeshFiles       files;
    Pull            pull;

    void add_parameters(ParameterHandler &prm)
    {
      scene.add_parameters(prm);
      block.add_parameters(prm);
      fixing.add_parameters(prm);
      files.add_parameters(prm);
      pull.add_parameters(prm);
    }

    // The block on what is behind it.
    TreadBlock fixed_block() const
    {
      TreadBlock fixed = block;
      fixed.layers     = fixing.layers();
      return fixed;
    }
  };

  // ## The scene
  //
  // The fixing holds the back; what stands on a symmetry plane stays on it.
  // The surfaces that were cured against metal may stick, touch and rub.
  template <int dim>
  Scene<dim> make_scene(const Parameters &p)
  {
    Scene<dim> scene;
    scene.make_mesh = [&p](dealii::Triangulation<dim, dim> &triangulation) {
      if (p.files.block.empty())
        make_tread_block<dim>(p.fixed_block(), triangulation);
      else
        read_mesh_file<dim>(p.files.block, triangulation);
    };
    scene.supports                   = p.fixing.supports<dim>();
    const std::vector<double> layers = p.fixing.layers();
    for (unsigned int k = 0; k < layers.size(); ++k)
      scene.laws[k + 1] = p.fixing.law(k, dim);

    if (p.scene.interface.active())
      {
        scene.slave = {Boundary::bottom, Boundary::wall, Boundary::sipe};
        scene.mould = p.files.mould.empty() ?
                        make_mould(p.block, dim) :
                        read_rigid_surface(p.files.mould, dim);
      }
    // In the press, heat comes through all that metal forms, and from behind.
    scene.mould_side   = {Boundary::bottom,
                          Boundary::wall,
                          Boundary::sipe,
                          Boundary::groove};
    scene.bladder_side = {Boundary::backing};

    scene.motion    = p.pull.motion(dim);
    scene.opening   = [&p](const double t) { return p.pull.travel(t); };
    scene.direction = [&p](const double t) {
      return p.pull.opening_direction(dim, t);
    };
    scene.end_time        = p.pull.duration();
    scene.after_release   = p.pull.after;
    scene.symmetry_factor = p.block.symmetry_factor(dim);
    scene.height          = p.block.height + p.block.base_thickness;
    if (p.fixing.kind == "rubber base")
      scene.height += p.fixing.base_thickness;
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
      parameters.fixing.check();
      if (parameters.files.block.empty())
        parameters.fixed_block().check(dim);
      else if (parameters.fixing.kind != "rigid plate")
        throw ExcParameter("Block/fixing",
                           "must be rigid plate for a block from a mesh file, "
                           "which has no layer behind it; got " +
                             parameters.fixing.kind +
                             ". Leave Block/mesh file empty or change it.");
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
      const double end   = parameters.pull.duration();
      const auto   d     = parameters.pull.opening_direction(dim, end);
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
