// SPDX-License-Identifier: LGPL-2.1-or-later
// One body over a mould or over a second body: from entries to a scene.
#include "scene/body_scene.h"

#include "base/parameter_error.h"
#include "scene/simulation.h"

#include <deal.II/base/parameter_handler.h>

namespace demold
{
  namespace
  {
    template <int dim>
    void check_in(const BodyScene &p)
    {
      const Scene<dim> scene = p.make_scene<dim>();
      if (scene.supports.empty())
        throw ExcParameter("Supports/held",
                           "the body is held nowhere: at least one of held "
                           "and driven must name a boundary; got none.");
      p.bodies.check<dim>();
    }
  } // namespace

  void BodyScene::add_parameters(dealii::ParameterHandler &prm)
  {
    scene.add_parameters(prm);
    bodies.add_parameters(prm);
    mould.add_parameters(prm);
    supports.add_parameters(prm);
    process.add_parameters(prm);
  }

  void BodyScene::check() const
  {
    scene.check();
    if (scene.dim() == 3)
      check_in<3>(*this);
    else
      check_in<2>(*this);
  }

  template <int dim>
  Scene<dim> BodyScene::make_scene() const
  {
    Scene<dim> result;
    result.make_mesh = [this](dealii::Triangulation<dim, dim> &triangulation) {
      bodies.make_mesh<dim>(triangulation);
    };
    result.supports  = supports.supports<dim>();
    result.tractions = supports.tractions();
    result.laws      = bodies.laws();
    if (scene.interface.active())
      {
        result.slave = bodies.slave_boundaries();
        if (bodies.has_base)
          result.master = bodies.master_boundaries();
        else if (mould.shape != "none")
          result.mould = mould.surface(dim);
        else
          result.slave.clear();
      }
    result.height = bodies.height<dim>();
    process.set_process(result);
    return result;
  }

  std::string BodyScene::preview() const
  {
    return scene.dim() == 3 ? preview_simulation(make_scene<3>(), scene) :
                              preview_simulation(make_scene<2>(), scene);
  }

  RunStatus BodyScene::run(const RunContext &context) const
  {
    return scene.dim() == 3 ? run_simulation(make_scene<3>(), scene, context) :
                              run_simulation(make_scene<2>(), scene, context);
  }

  template Scene<2> BodyScene::make_scene<2>() const;
  template Scene<3> BodyScene::make_scene<3>() const;
} // namespace demold
