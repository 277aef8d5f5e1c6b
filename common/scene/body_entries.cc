// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections Body and Base: the rubber body and a second one below it.
#include "scene/body_entries.h"

#include "base/parameter_error.h"

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <deal.II/grid/tria.h>

namespace demold
{
  using namespace dealii;

  namespace
  {
    void add_cylinder(HalfCylinder &cylinder, ParameterHandler &prm)
    {
      using Patterns::Double;
      prm.add_parameter("radius", cylinder.radius, "R [mm]", Double(1e-9));
      prm.add_parameter("half angle",
                        cylinder.half_angle,
                        "of the curved part [degree]",
                        Double(1., 90.));
      prm.add_parameter("fine width",
                        cylinder.fine_width,
                        "half width and depth of the fine zone [mm]",
                        Double(1e-9));
      prm.add_parameter("fine size",
                        cylinder.fine_size,
                        "element size there [mm]",
                        Double(1e-9));
      prm.add_parameter("far size",
                        cylinder.far_size,
                        "largest element size [mm]",
                        Double(1e-9));
      prm.add_parameter("right half",
                        cylinder.right_half,
                        "only x >= 0 is meshed");
    }
  } // namespace

  void BodyEntries::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Body");
    prm.add_parameter("shape",
                      shape,
                      "of the rubber body",
                      Patterns::Selection("box|half cylinder"));
    body.add_parameters(prm);
    add_cylinder(cylinder, prm);
    prm.add_parameter("slave",
                      slave,
                      "boundaries that may touch, separated by commas; empty: "
                      "none");
    prm.leave_subsection();
    prm.enter_subsection("Base");
    prm.add_parameter("present",
                      has_base,
                      "a second, deformable body below, touched at its top");
    base.add_parameters(prm);
    prm.leave_subsection();
  }

  template <int dim>
  void BodyEntries::check() const
  {
    if (shape == "box")
      body.box<dim>("Body", 0);
    if (has_base)
      base.box<dim>("Base", 1);
  }

  template <int dim>
  void BodyEntries::make_mesh(Triangulation<dim, dim> &triangulation) const
  {
    if (shape == "half cylinder")
      {
        if constexpr (dim == 2)
          make_half_cylinder(cylinder, triangulation);
        else
          throw ExcParameter("Body/shape",
                             "half cylinder needs dimension = 2 or "
                             "axisymmetric; got 3.");
      }
    else if (has_base)
      make_two_boxes<dim>(body.box<dim>("Body", 0),
                          base.box<dim>("Base", 1),
                          triangulation);
    else
      make_box<dim>(body.box<dim>("Body", 0), triangulation);
  }

  template <int dim>
  double BodyEntries::height() const
  {
    return shape == "box" ? body.box<dim>("Body", 0).size[dim - 1] :
                            cylinder.radius;
  }

  std::set<Boundary::Id> BodyEntries::slave_boundaries() const
  {
    std::set<Boundary::Id> result;
    for (const auto &name : Utilities::split_string_list(slave, ','))
      result.insert(boundary_id(name, "Body/slave"));
    return result;
  }

  template void   BodyEntries::check<2>() const;
  template void   BodyEntries::check<3>() const;
  template void   BodyEntries::make_mesh(Triangulation<2, 2> &) const;
  template void   BodyEntries::make_mesh(Triangulation<3, 3> &) const;
  template double BodyEntries::height<2>() const;
  template double BodyEntries::height<3>() const;
} // namespace demold
