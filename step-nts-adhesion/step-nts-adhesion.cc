// SPDX-License-Identifier: LGPL-2.1-or-later
//
// # step-nts-adhesion: how does a stuck node let go?
//
// Sample runs:
//   step-nts-adhesion prm/step-nts-adhesion/pull-off.prm
//   step-nts-adhesion prm/step-nts-adhesion/peel.prm --set "Body/cells=160,8"
//
//            top                    A body of rubber, here a box, over a rigid
//        +----------+               plane (or over a second body, the base).
//   left |   body   | right         Its bottom carries bonds and may touch and
//        +----------+               rub. Either the mould moves away (Pull) or
//   ======= bottom =======          the body is driven (Supports/motion).
//        rigid mould
//
// Builds on: nothing. The lesson of thesis chapters 3.1 and 5.2; intro.md has
// the equations, results.md what comes out.

#include "base/parameter_error.h"
#include "base/run_step.h"
#include "geometry/boundary_names.h"
#include "geometry/test_bodies.h"
#include "scene/expression.h"
#include "scene/pull.h"
#include "scene/simulation.h"

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <memory>
#include <sstream>

using namespace demold;
using dealii::ParameterHandler;
using dealii::Point;
using dealii::Tensor;

namespace
{
  // ## Geometry
  //
  // A list of numbers in the parameter file, with as many entries as asked.
  template <typename Number>
  std::vector<Number> numbers(const std::string &list,
                              const unsigned int n,
                              const std::string &path)
  {
    std::vector<Number> result;
    try
      {
        for (const auto &part : dealii::Utilities::split_string_list(list, ','))
          result.push_back(
            static_cast<Number>(dealii::Utilities::string_to_double(part)));
      }
    catch (const std::exception &)
      {
        throw ExcParameter(path,
                           "must be numbers separated by commas; got \"" +
                             list + "\".");
      }
    if (result.size() < n)
      throw ExcParameter(path,
                         "needs " + std::to_string(n) +
                           " numbers in this dimension; got " +
                           std::to_string(result.size()) + " in \"" + list +
                           "\".");
    return result;
  }

  // A box, as the body or as the base below it.
  struct BoxEntries
  {
    std::string corner, size, cells, grading = "1, 1, 1";

    void add_parameters(ParameterHandler &prm)
    {
      prm.add_parameter("lower corner", corner, "smallest coordinates [mm]");
      prm.add_parameter("size", size, "extents [mm]");
      prm.add_parameter("cells", cells, "elements per direction [-]");
      prm.add_parameter("grading",
                        grading,
                        "last over first element size per direction [-]");
    }

    template <int dim>
    Box<dim> box(const std::string &section, const unsigned int material) const
    {
      Box<dim>   result;
      const auto x = numbers<double>(corner, dim, section + "/lower corner");
      const auto l = numbers<double>(size, dim, section + "/size");
      const auto n = numbers<double>(cells, dim, section + "/cells");
      const auto g = numbers<double>(grading, dim, section + "/grading");
      for (unsigned int d = 0; d < dim; ++d)
        {
          if (!(l[d] > 0.) || !(n[d] >= 1.) || !(g[d] > 0.))
            throw ExcParameter(section,
                               "size, cells and grading must be positive; got "
                               "size " +
                                 std::to_string(l[d]) + " mm, " +
                                 std::to_string(n[d]) + " cells, grading " +
                                 std::to_string(g[d]) + ".");
          result.lower_corner[d] = x[d];
          result.size[d]         = l[d];
          result.cells[d]        = static_cast<unsigned int>(n[d]);
          result.grading[d]      = g[d];
        }
      result.material_id = material;
      return result;
    }
  };

  // ## Parameters: the prm file from top to bottom
  struct Parameters
  {
    SceneParameters scene;

    std::string  shape = "box";
    BoxEntries   body{"0, 0, 0", "10, 10, 10", "8, 8, 8"};
    HalfCylinder cylinder;
    bool         has_base = false;
    BoxEntries   base{"-2, -4, -4", "14, 4, 4", "11, 3, 3"};

    std::string mould_shape  = "plane";
    std::string mould_from   = "-100, -100";
    std::string mould_to     = "100, 100";
    double      mould_level  = 0.;
    std::string mould_facets = "20, 20";
    std::string corners; // of a polyline

    std::string held = "auto";
    std::string driven;
    std::string motion[3] = {"0", "0", "0"};
    std::string traction_boundary;
    std::string traction = "0, 0, 0";

    std::string moved_by  = "mould";
    double      end_time  = 1.;
    std::string opening   = "0";
    std::string direction = "0, 1, 0";
    std::string force_on  = "mould";
    std::string slave     = "bottom";
    Pull        pull;

    void add_parameters(ParameterHandler &prm);
  };

  void Parameters::add_parameters(ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    scene.add_parameters(prm);
    prm.enter_subsection("Body");
    prm.add_parameter("shape",
                      shape,
                      "of the rubber body",
                      Selection("box|half cylinder"));
    body.add_parameters(prm);
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
    prm.enter_subsection("Mould");
    prm.add_parameter("shape",
                      mould_shape,
                      "of the rigid mould; polyline: drawn by its corners",
                      Selection("none|plane|polyline"));
    prm.add_parameter("from", mould_from, "smallest x (and y) of a plane [mm]");
    prm.add_parameter("to", mould_to, "largest x (and y) of a plane [mm]");
    prm.add_parameter("level", mould_level, "height of a plane [mm]");
    prm.add_parameter("facets",
                      mould_facets,
                      "of a plane along x (and y), or of each piece of a "
                      "polyline [-]");
    prm.add_parameter("corners",
                      corners,
                      "x, y of a polyline, points separated by ';', metal on "
                      "the left [mm]");
    prm.leave_subsection();
    prm.enter_subsection("Supports");
    prm.add_parameter("held",
                      held,
                      "boundary and components at rest, such as top xy, left "
                      "x; body: every node; auto: the top, unless something "
                      "is driven");
    prm.add_parameter("driven",
                      driven,
                      "boundary and components that follow the motion");
    for (const int d : {0, 1, 2})
      prm.add_parameter(std::string("motion ") + "xyz"[d],
                        motion[d],
                        "displacement of driven nodes, formula in t and x, y, "
                        "z [mm]");
    prm.add_parameter("traction boundary",
                      traction_boundary,
                      "boundary with a dead load; empty: none");
    prm.add_parameter(
      "traction",
      traction,
      "dead load per reference area, three formulas in t [MPa]");
    prm.leave_subsection();
    prm.enter_subsection("Process");
    prm.add_parameter("moved by",
                      moved_by,
                      "mould: section Pull; grip: motion of the supports",
                      Selection("mould|grip"));
    prm.add_parameter("end time",
                      end_time,
                      "of a process moved by the grip [s]",
                      Double(1e-12));
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

  // ## From entries to a scene
  //
  // Holds the top of the body if the file says nothing about supports.
  std::string held(const Parameters &p)
  {
    if (p.held != "auto")
      return p.held;
    return !p.driven.empty() ? "" : p.scene.dim() == 3 ? "top xyz" : "top xy";
  }

  // "top xy, left x" becomes one rule per component.
  template <int dim>
  void add_supports(const std::string        &list,
                    const std::string        &path,
                    const Parameters         *motion,
                    std::vector<SupportRule> &rules)
  {
    for (const auto &item : dealii::Utilities::split_string_list(list, ','))
      {
        const auto space = item.rfind(' ');
        if (space == std::string::npos)
          throw ExcParameter(path,
                             "needs a boundary and components, such as top "
                             "xy; got \"" +
                               item + "\".");
        const std::string name       = item.substr(0, space);
        const std::string components = item.substr(space + 1);
        for (const char c : components)
          {
            const unsigned int d = c - 'x';
            if (d >= dim)
              throw ExcParameter(path,
                                 std::string("knows the components ") +
                                   (dim == 2 ? "x, y" : "x, y, z") +
                                   " in this dimension; got \"" + c +
                                   "\" in \"" + item + "\".");
            SupportRule rule;
            rule.component = d;
            if (name != "body")
              rule.boundary = boundary_id(name, path);
            if (motion != nullptr)
              {
                const auto formula =
                  std::make_shared<Expression>(motion->motion[d],
                                               std::string("Supports/motion ") +
                                                 c);
                rule.value = [formula](const double t, const Point<3> &X) {
                  return (*formula)(t, X);
                };
              }
            rules.push_back(rule);
          }
      }
  }

  std::array<std::shared_ptr<Expression>, 3> three(const std::string &list,
                                                   const std::string &path)
  {
    const auto parts = dealii::Utilities::split_string_list(list, ',');
    if (parts.size() != 3)
      throw ExcParameter(path,
                         "needs three formulas separated by commas; got " +
                           std::to_string(parts.size()) + ".");
    std::array<std::shared_ptr<Expression>, 3> result;
    for (unsigned int d = 0; d < 3; ++d)
      result[d] = std::make_shared<Expression>(parts[d], path);
    return result;
  }

  std::function<Tensor<1, 3>(double)> vector_of_time(const std::string &list,
                                                     const std::string &path)
  {
    const auto parts = three(list, path);
    return [parts](const double t) {
      Tensor<1, 3> v;
      for (unsigned int d = 0; d < 3; ++d)
        v[d] = (*parts[d])(t);
      return v;
    };
  }

  template <int dim>
  RigidSurface make_mould(const Parameters &p)
  {
    const auto facets = numbers<double>(p.mould_facets,
                                        p.mould_shape == "plane" ? dim - 1 : 1,
                                        "Mould/facets");
    if (p.mould_shape == "plane")
      {
        const auto from = numbers<double>(p.mould_from, dim - 1, "Mould/from");
        const auto to   = numbers<double>(p.mould_to, dim - 1, "Mould/to");
        return make_rigid_plane(
          Point<2>(from[0], dim == 3 ? from[1] : 0.),
          Point<2>(to[0], dim == 3 ? to[1] : 1.),
          p.mould_level,
          {{static_cast<unsigned int>(facets[0]),
            dim == 3 ? static_cast<unsigned int>(facets[1]) : 1u}},
          dim);
      }
    RigidPolyline polyline;
    for (const auto &point :
         dealii::Utilities::split_string_list(p.corners, ';'))
      {
        const auto x = numbers<double>(point, 2, "Mould/corners");
        polyline.corners.emplace_back(x[0], x[1]);
      }
    if (polyline.corners.size() < 2)
      throw ExcParameter("Mould/corners",
                         "needs at least 2 points; got " +
                           std::to_string(polyline.corners.size()) + ".");
    polyline.n_facets.assign(polyline.corners.size() - 1,
                             static_cast<unsigned int>(facets[0]));
    const auto from = numbers<double>(p.mould_from, dim - 1, "Mould/from");
    const auto to   = numbers<double>(p.mould_to, dim - 1, "Mould/to");
    if (dim == 3)
      {
        polyline.y_begin    = from[1];
        polyline.y_end      = to[1];
        polyline.n_facets_y = static_cast<unsigned int>(facets.back());
      }
    return make_rigid_polyline(polyline, dim);
  }

  template <int dim>
  void make_mesh(const Parameters                &p,
                 dealii::Triangulation<dim, dim> &triangulation)
  {
    if (p.shape == "half cylinder")
      {
        if constexpr (dim == 2)
          make_half_cylinder(p.cylinder, triangulation);
        else
          throw ExcParameter("Body/shape",
                             "half cylinder needs dimension = 2 or "
                             "axisymmetric; got 3.");
      }
    else if (p.has_base)
      make_two_boxes<dim>(p.body.box<dim>("Body", 0),
                          p.base.box<dim>("Base", 1),
                          triangulation);
    else
      make_box<dim>(p.body.box<dim>("Body", 0), triangulation);
  }

  template <int dim>
  Scene<dim> make_scene(const Parameters &p)
  {
    Scene<dim> scene;
    scene.make_mesh = [&p](dealii::Triangulation<dim, dim> &triangulation) {
      make_mesh<dim>(p, triangulation);
    };
    add_supports<dim>(p.driven, "Supports/driven", &p, scene.supports);
    add_supports<dim>(held(p), "Supports/held", nullptr, scene.supports);
    if (!p.traction_boundary.empty())
      scene.tractions.push_back(
        {boundary_id(p.traction_boundary, "Supports/traction boundary"),
         vector_of_time(p.traction, "Supports/traction")});

    if (p.scene.interface.active())
      {
        for (const auto &name :
             dealii::Utilities::split_string_list(p.slave, ','))
          scene.slave.insert(boundary_id(name, "Body/slave"));
        if (p.has_base)
          scene.master = {Boundary::base_top};
        else if (p.mould_shape != "none")
          scene.mould = make_mould<dim>(p);
        else
          scene.slave.clear();
      }
    scene.height = p.shape == "box" ? p.body.box<dim>("Body", 0).size[dim - 1] :
                                      p.cylinder.radius;
    using ForceOn  = typename Scene<dim>::ForceOn;
    scene.force_on = p.force_on == "mould"    ? ForceOn::mould :
                     p.force_on == "supports" ? ForceOn::supports :
                                                ForceOn::boundary;
    if (scene.force_on == ForceOn::boundary)
      scene.force_boundary = boundary_id(p.force_on, "Process/force on");

    if (p.moved_by == "mould")
      {
        scene.motion    = p.pull.motion(dim);
        scene.opening   = [&p](const double t) { return p.pull.travel(t); };
        scene.direction = [&p](const double t) {
          return p.pull.opening_direction(dim, t);
        };
        scene.end_time = p.pull.duration();
      }
    else
      {
        const auto travel =
          std::make_shared<Expression>(p.opening, "Process/opening");
        scene.motion  = [](double) { return RigidPlacement(); };
        scene.opening = [travel](const double t) { return (*travel)(t); };
        // A mould at rest feels the grip's force, not the one it exerts.
        const auto   along = vector_of_time(p.direction, "Process/direction");
        const double sign  = scene.force_on == ForceOn::mould ? -1. : 1.;
        scene.direction    = [along, sign](const double t) {
          return sign * along(t);
        };
        scene.end_time = p.end_time;
      }
    return scene;
  }

  // ## The program
  class StepNtsAdhesion
  {
  public:
    void add_parameters(ParameterHandler &prm)
    {
      parameters.add_parameters(prm);
    }

    void check() const
    {
      parameters.scene.check();
      if (parameters.scene.dim() == 3)
        check_scene<3>();
      else
        check_scene<2>();
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
    template <int dim>
    void check_scene() const
    {
      const Scene<dim> scene = make_scene<dim>(parameters);
      if (scene.supports.empty())
        throw ExcParameter("Supports/held",
                           "the body is held nowhere: at least one of held "
                           "and driven must name a boundary; got none.");
      if (parameters.shape == "box")
        parameters.body.box<dim>("Body", 0);
      if (parameters.has_base)
        parameters.base.box<dim>("Base", 1);
    }

    Parameters parameters;
  };
} // namespace

int main(int argc, char **argv)
{
  return run_step<StepNtsAdhesion>(argc, argv);
}
