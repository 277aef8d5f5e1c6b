// SPDX-License-Identifier: LGPL-2.1-or-later
// A tread block in its mould: from entries to a scene.
#include "scene/tread_scene.h"

#include "base/parameter_error.h"
#include "geometry/boundary_names.h"
#include "scene/simulation.h"

namespace demold
{
  void TreadScene::add_parameters(dealii::ParameterHandler &prm)
  {
    block.add_parameters(prm);
    fixing.add_parameters(prm);
    files.add_parameters(prm);
  }

  /// The block on what is behind it.
  TreadBlock TreadScene::fixed_block() const
  {
    TreadBlock fixed = block;
    fixed.layers     = fixing.layers();
    return fixed;
  }

  void TreadScene::check(const SceneParameters &parameters,
                         const Pull            &pull) const
  {
    const int dim = parameters.dim();
    if (parameters.dimension == "axisymmetric")
      throw ExcParameter("dimension",
                         "must be 2 (a slice) or 3 for a tread block; got "
                         "axisymmetric.");
    parameters.check();
    pull.check(dim);
    files.check(dim);
    fixing.check();
    if (files.block.empty())
      fixed_block().check(dim);
    else if (fixing.kind != "rigid plate")
      throw ExcParameter("Block/fixing",
                         "must be rigid plate for a block from a mesh file, "
                         "which has no layer behind it; got " +
                           fixing.kind +
                           ". Leave Block/mesh file empty or change it.");
    check_symmetry(pull, dim);
  }

  /// A reduced model stays what it is only under a straight pull.
  void TreadScene::check_symmetry(const Pull &pull, const int dim) const
  {
    if (!block.reduced_x() && !block.reduced_y(dim))
      return;
    const double end   = pull.duration();
    const auto   d     = pull.opening_direction(dim, end);
    const bool   tilts = pull.tilt != "0";
    if ((block.reduced_x() && (d[0] != 0. || tilts)) ||
        (block.reduced_y(dim) && d[1] != 0.))
      throw ExcParameter("Block/symmetry",
                         "must keep the pull in its planes: " + block.symmetry +
                           " with a direction of (" + std::to_string(d[0]) +
                           ", " + std::to_string(d[1]) + ", " +
                           std::to_string(d[2]) + ")" +
                           (tilts ? " and a tilt" : "") +
                           " is not symmetric. Set it to whole" +
                           (dim == 3 ? " or half y." : "."));
  }

  /// The surfaces that were cured against metal may stick, touch and rub.
  template <int dim>
  Scene<dim> TreadScene::make_scene(const SceneParameters &parameters,
                                    const Pull            &pull) const
  {
    Scene<dim> scene;
    scene.make_mesh = [this](dealii::Triangulation<dim, dim> &triangulation) {
      if (files.block.empty())
        make_tread_block<dim>(fixed_block(), triangulation);
      else
        read_mesh_file<dim>(files.block, triangulation);
    };
    scene.supports                   = fixing.supports<dim>();
    const std::vector<double> layers = fixing.layers();
    for (unsigned int k = 0; k < layers.size(); ++k)
      scene.laws[k + 1] = fixing.law(k, dim);

    if (parameters.interface.active())
      {
        scene.slave = {Boundary::bottom, Boundary::wall, Boundary::sipe};
        scene.mould = files.mould.empty() ?
                        make_mould(block, dim) :
                        read_rigid_surface(files.mould, dim);
      }
    // In the press, heat comes through all that metal forms, and from behind.
    scene.mould_side   = {Boundary::bottom,
                          Boundary::wall,
                          Boundary::sipe,
                          Boundary::groove};
    scene.bladder_side = {Boundary::backing};

    scene.motion    = pull.motion(dim);
    scene.opening   = [&pull](const double t) { return pull.travel(t); };
    scene.direction = [&pull](const double t) {
      return pull.opening_direction(dim, t);
    };
    scene.end_time        = pull.duration();
    scene.after_release   = pull.after;
    scene.symmetry_factor = block.symmetry_factor(dim);
    scene.height          = block.height + block.base_thickness;
    if (fixing.kind == "rubber base")
      scene.height += fixing.base_thickness;
    return scene;
  }

  std::string TreadScene::preview(const SceneParameters &parameters,
                                  const Pull            &pull) const
  {
    return parameters.dim() == 3 ?
             preview_simulation(make_scene<3>(parameters, pull), parameters) :
             preview_simulation(make_scene<2>(parameters, pull), parameters);
  }

  RunStatus TreadScene::run(const SceneParameters &parameters,
                            const Pull            &pull,
                            const RunContext      &context) const
  {
    if (parameters.dim() == 3)
      return run_simulation(make_scene<3>(parameters, pull),
                            parameters,
                            context);
    return run_simulation(make_scene<2>(parameters, pull), parameters, context);
  }

  template Scene<2> TreadScene::make_scene<2>(const SceneParameters &,
                                              const Pull &) const;
  template Scene<3> TreadScene::make_scene<3>(const SceneParameters &,
                                              const Pull &) const;
} // namespace demold
