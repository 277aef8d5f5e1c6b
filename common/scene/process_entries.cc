// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections Process and Pull: who moves, and where the force is measured.
#include "scene/process_entries.h"

#include "geometry/boundary_names.h"
#include "scene/expression.h"
#include "scene/vector_of_time.h"

#include <deal.II/base/parameter_handler.h>

#include <memory>

namespace demold
{
  using namespace dealii;

  void ProcessEntries::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Process");
    prm.add_parameter("moved by",
                      moved_by,
                      "mould: section Pull; grip: motion of the supports",
                      Patterns::Selection("mould|grip"));
    prm.add_parameter("end time",
                      end_time,
                      "of a process moved by the grip [s]",
                      Patterns::Double(1e-12));
    prm.add_parameter("opening",
                      opening,
                      "travel reported for a grip, formula in t [mm]");
    prm.add_parameter("direction",
                      direction,
                      "in which the force is positive, for a grip [-]");
    prm.add_parameter("force on",
                      force_on,
                      "mould; the name of a driven boundary; or supports: the "
                      "force that does the work of all supports over the "
                      "opening");
    prm.leave_subsection();
    pull.add_parameters(prm);
  }

  template <int dim>
  void ProcessEntries::set_process(Scene<dim> &scene) const
  {
    using ForceOn  = typename Scene<dim>::ForceOn;
    scene.force_on = force_on == "mould"    ? ForceOn::mould :
                     force_on == "supports" ? ForceOn::supports :
                                              ForceOn::boundary;
    if (scene.force_on == ForceOn::boundary)
      scene.force_boundary = boundary_id(force_on, "Process/force on");

    if (moved_by == "mould")
      {
        scene.motion    = pull.motion(dim);
        scene.opening   = [this](const double t) { return pull.travel(t); };
        scene.direction = [this](const double t) {
          return pull.opening_direction(dim, t);
        };
        scene.end_time = pull.duration();
        return;
      }
    const auto travel =
      std::make_shared<Expression>(opening, "Process/opening");
    scene.motion  = [](double) { return RigidPlacement(); };
    scene.opening = [travel](const double t) { return (*travel)(t); };
    // A mould at rest feels the grip's force, not the one it exerts.
    const auto   along = vector_of_time(direction, "Process/direction");
    const double sign  = scene.force_on == ForceOn::mould ? -1. : 1.;
    scene.direction = [along, sign](const double t) { return sign * along(t); };
    scene.end_time  = end_time;
  }

  template void ProcessEntries::set_process(Scene<2> &) const;
  template void ProcessEntries::set_process(Scene<3> &) const;
} // namespace demold
