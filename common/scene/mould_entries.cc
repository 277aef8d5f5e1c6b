// SPDX-License-Identifier: LGPL-2.1-or-later
// Section Mould: a rigid plane or a polyline drawn by its corners.
#include "scene/mould_entries.h"

#include "base/number_list.h"
#include "base/parameter_error.h"
#include "geometry/test_bodies.h"

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

namespace demold
{
  using namespace dealii;

  namespace
  {
    std::vector<Point<2>> corner_points(const std::string &corners)
    {
      std::vector<Point<2>> result;
      for (const auto &point : Utilities::split_string_list(corners, ';'))
        {
          const auto x = number_list(point, 2, "Mould/corners");
          result.emplace_back(x[0], x[1]);
        }
      if (result.size() < 2)
        throw ExcParameter("Mould/corners",
                           "needs at least 2 points; got " +
                             std::to_string(result.size()) + ".");
      return result;
    }
  } // namespace

  void MouldEntries::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Mould");
    prm.add_parameter("shape",
                      shape,
                      "of the rigid mould; polyline: drawn by its corners",
                      Patterns::Selection("none|plane|polyline"));
    prm.add_parameter("from", from, "smallest x (and y) of a plane [mm]");
    prm.add_parameter("to", to, "largest x (and y) of a plane [mm]");
    prm.add_parameter("level", level, "height of a plane [mm]");
    prm.add_parameter("facets",
                      facets,
                      "of a plane along x (and y), or of each piece of a "
                      "polyline [-]");
    prm.add_parameter("corners",
                      corners,
                      "x, y of a polyline, points separated by ';', metal on "
                      "the left [mm]");
    prm.leave_subsection();
  }

  RigidSurface MouldEntries::surface(const int dim) const
  {
    const bool is_plane = shape == "plane";
    const auto n = number_list(facets, is_plane ? dim - 1 : 1, "Mould/facets");
    if (is_plane)
      {
        const auto low  = number_list(from, dim - 1, "Mould/from");
        const auto high = number_list(to, dim - 1, "Mould/to");
        return make_rigid_plane(Point<2>(low[0], dim == 3 ? low[1] : 0.),
                                Point<2>(high[0], dim == 3 ? high[1] : 1.),
                                level,
                                {{static_cast<unsigned int>(n[0]),
                                  dim == 3 ? static_cast<unsigned int>(n[1]) :
                                             1u}},
                                dim);
      }
    RigidPolyline polyline;
    polyline.corners = corner_points(corners);
    polyline.n_facets.assign(polyline.corners.size() - 1,
                             static_cast<unsigned int>(n[0]));
    const auto low  = number_list(from, dim - 1, "Mould/from");
    const auto high = number_list(to, dim - 1, "Mould/to");
    if (dim == 3)
      {
        polyline.y_begin    = low[1];
        polyline.y_end      = high[1];
        polyline.n_facets_y = static_cast<unsigned int>(n.back());
      }
    return make_rigid_polyline(polyline, dim);
  }
} // namespace demold
