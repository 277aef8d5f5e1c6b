// SPDX-License-Identifier: LGPL-2.1-or-later
// A box in a parameter file, as the body or as the base below it.
#include "scene/box_entries.h"

#include "base/number_list.h"
#include "base/parameter_error.h"

#include <deal.II/base/parameter_handler.h>

namespace demold
{
  void BoxEntries::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("lower corner", corner, "smallest coordinates [mm]");
    prm.add_parameter("size", size, "extents [mm]");
    prm.add_parameter("cells", cells, "elements per direction [-]");
    prm.add_parameter("grading",
                      grading,
                      "last over first element size per direction [-]");
    prm.add_parameter("irregularity",
                      irregularity,
                      "largest shift of nodes inside over element size, at "
                      "random but the same in every run [-]",
                      dealii::Patterns::Double(0., .45));
  }

  template <int dim>
  Box<dim> BoxEntries::box(const std::string &section,
                           const unsigned int material) const
  {
    Box<dim>   result;
    const auto x = number_list(corner, dim, section + "/lower corner");
    const auto l = number_list(size, dim, section + "/size");
    const auto n = number_list(cells, dim, section + "/cells");
    const auto g = number_list(grading, dim, section + "/grading");
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
    result.material_id  = material;
    result.irregularity = irregularity;
    return result;
  }

  template Box<2> BoxEntries::box(const std::string &, unsigned int) const;
  template Box<3> BoxEntries::box(const std::string &, unsigned int) const;
} // namespace demold
