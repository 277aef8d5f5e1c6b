// SPDX-License-Identifier: LGPL-2.1-or-later
// Sections Body and Base: the rubber body and a second one below it.
#include "scene/body_entries.h"

#include "base/parameter_error.h"
#include "material/elastic_rubber.h"
#include "scene/expression.h"

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <deal.II/grid/tria.h>

#include <functional>
#include <memory>

namespace demold
{
  using namespace dealii;

  namespace
  {
    void add_cylinder(HalfCylinder &cylinder, ParameterHandler &prm)
    {
      using Patterns::Double;
      prm.add_parameter("radius",
                        cylinder.radius,
                        "R of a half cylinder [mm]",
                        Double(1e-9));
      prm.add_parameter("half angle",
                        cylinder.half_angle,
                        "of the curved part [degree]",
                        Double(1., 90.));
      prm.add_parameter("fine width",
                        cylinder.fine_width,
                        "half width of the fine zone [mm]",
                        Double(1e-9));
      prm.add_parameter("fine depth",
                        cylinder.fine_depth,
                        "of the fine zone; 0: its half width [mm]",
                        Double(0.));
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
    /// Raises points by @p formula at the height @p full, less and less towards
    /// the height @p none.
    template <int dim>
    std::function<Point<dim>(const Point<dim> &)>
    raised(const std::string &formula, const double full, const double none)
    {
      const auto height =
        std::make_shared<Expression>(formula, "Base/interface");
      return [=](const Point<dim> &p) {
        Point<dim> q = p;
        q[dim - 1] += (*height)(0., Point<3>(p[0], dim == 3 ? p[1] : 0., 0.)) *
                      (p[dim - 1] - none) / (full - none);
        return q;
      };
    }

    bool is_of_base(const Boundary::Id id)
    {
      return id >= Boundary::base_offset;
    }
  } // namespace

  void BodyEntries::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Body");
    prm.add_parameter("shape",
                      shape,
                      "of the rubber body; graded box: of fine cells in a part "
                      "of its bottom, as a half cylinder, instead of a given "
                      "number",
                      Patterns::Selection("box|graded box|half cylinder"));
    body.add_parameters(prm);
    add_cylinder(cylinder, prm);
    prm.add_parameter("fine centre",
                      fine_centre,
                      "x of the middle of the fine zone of a graded box [mm]");
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
    prm.add_parameter("interface",
                      interface,
                      "height of the surface in which body and base meet over "
                      "its plane, formula in x, y [mm]");
    prm.add_parameter("modulus",
                      base_modulus,
                      "E Young's modulus of the base, elastic; 0: of the "
                      "rubber of the body [MPa]",
                      Patterns::Double(0.));
    prm.add_parameter("bulk modulus",
                      base_bulk,
                      "K of the base, if it has a modulus [MPa]",
                      Patterns::Double(1e-6));
    prm.leave_subsection();
  }

  template <int dim>
  void BodyEntries::check() const
  {
    if (shape == "box")
      upper<dim>();
    if (shape == "graded box")
      graded_box();
    if (!has_base)
      return;
    if (shape == "graded box")
      throw ExcParameter("Base/present",
                         "must be false for Body/shape = graded box; got true. "
                         "Choose box.");
    lower<dim>();
    if (shape != "box" && interface != "0")
      throw ExcParameter("Base/interface",
                         "must be 0 below a half cylinder; got " + interface +
                           ".");
    if (!(3. * base_bulk > base_modulus))
      throw ExcParameter("Base/bulk modulus",
                         "must exceed a third of Base/modulus = " +
                           std::to_string(base_modulus) + " MPa; got " +
                           std::to_string(base_bulk) +
                           " MPa. Rubber has 10 to 1000 times its modulus.");
  }

  template <int dim>
  Box<dim> BodyEntries::upper() const
  {
    Box<dim>     box   = body.box<dim>("Body", 0);
    const double level = box.lower_corner[dim - 1];
    if (has_base && interface != "0")
      box.map = raised<dim>(interface, level, level + box.size[dim - 1]);
    return box;
  }

  GradedBox BodyEntries::graded_box() const
  {
    const Box<2> box = body.box<2>("Body", 0);
    GradedBox    result;
    static_cast<FineZone &>(result) = cylinder;
    result.lower_corner             = box.lower_corner;
    result.size                     = box.size;
    result.fine_centre              = fine_centre;
    const double left = box.lower_corner[0], right = left + box.size[0];
    if (!(fine_centre + cylinder.fine_width > left &&
          fine_centre - cylinder.fine_width < right))
      throw ExcParameter("Body/fine centre",
                         "must be less than Body/fine width = " +
                           std::to_string(cylinder.fine_width) +
                           " mm away from the box, x = " +
                           std::to_string(left) + " to " +
                           std::to_string(right) + " mm; got " +
                           std::to_string(fine_centre) + " mm.");
    return result;
  }

  template <int dim>
  Box<dim> BodyEntries::lower() const
  {
    Box<dim>     box   = base.box<dim>("Base", 1);
    const double level = box.lower_corner[dim - 1];
    if (interface != "0")
      box.map = raised<dim>(interface, level + box.size[dim - 1], level);
    return box;
  }

  template <int dim>
  void BodyEntries::make_mesh(Triangulation<dim, dim> &triangulation) const
  {
    if (shape != "box")
      {
        if constexpr (dim == 2)
          {
            if (shape == "graded box")
              make_graded_box(graded_box(), triangulation);
            else if (has_base)
              make_half_cylinder_on_box(cylinder, lower<2>(), triangulation);
            else
              make_half_cylinder(cylinder, triangulation);
          }
        else
          throw ExcParameter("Body/shape",
                             shape + " needs dimension = 2 or axisymmetric; "
                                     "got 3.");
      }
    else if (has_base)
      make_two_boxes<dim>(upper<dim>(), lower<dim>(), triangulation);
    else
      make_box<dim>(upper<dim>(), triangulation);
  }

  template <int dim>
  double BodyEntries::height() const
  {
    return shape != "half cylinder" ? body.box<dim>("Body", 0).size[dim - 1] :
                                      cylinder.radius;
  }

  std::set<Boundary::Id> BodyEntries::slave_boundaries() const
  {
    std::set<Boundary::Id> result;
    for (const auto &name : Utilities::split_string_list(slave, ','))
      result.insert(boundary_id(name, "Body/slave"));
    for (const Boundary::Id id : result)
      if (is_of_base(id) != is_of_base(*result.begin()) ||
          (is_of_base(id) && !has_base))
        throw ExcParameter("Body/slave",
                           "must name boundaries of one body that is there; "
                           "got " +
                             slave + (has_base ? "." : " without a base."));
    return result;
  }

  std::set<Boundary::Id> BodyEntries::master_boundaries() const
  {
    const auto slaves = slave_boundaries();
    if (!slaves.empty() && is_of_base(*slaves.begin()))
      return {Boundary::bottom};
    return {Boundary::base_top};
  }

  std::map<types::material_id, RubberLaw> BodyEntries::laws() const
  {
    if (!has_base || base_modulus == 0.)
      return {};
    return {{1, elastic_rubber(base_modulus, base_bulk)}};
  }

  template void   BodyEntries::check<2>() const;
  template void   BodyEntries::check<3>() const;
  template void   BodyEntries::make_mesh(Triangulation<2, 2> &) const;
  template void   BodyEntries::make_mesh(Triangulation<3, 3> &) const;
  template double BodyEntries::height<2>() const;
  template double BodyEntries::height<3>() const;
} // namespace demold
