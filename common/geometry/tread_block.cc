// SPDX-License-Identifier: LGPL-2.1-or-later
// Parameters of the tread block and the rules they obey.
#include "geometry/tread_block.h"

#include "base/parameter_error.h"
#include "geometry/tread_block_shape.h"

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    // "must be above 3 mm; got 2 mm. Hint"
    template <typename Limit, typename Value>
    std::string rule(const std::string &must,
                     const Limit       &limit,
                     const Value       &value,
                     const std::string &unit,
                     const std::string &hint)
    {
      std::ostringstream text;
      text << must << ' ' << limit << unit << "; got " << value << unit << ". "
           << hint;
      return text.str();
    }

    void check_outline(const TreadBlock &block,
                       const BlockShape &shape,
                       int               dim)
    {
      const double narrowest =
        2 * std::min({shape.half_length(0),
                      shape.half_length(block.height),
                      dim == 3 ? shape.half_width(0) : 1e300,
                      dim == 3 ? shape.half_width(block.height) : 1e300});
      if (narrowest <= 0)
        throw ExcParameter("Block/draft angle",
                           rule("closes the block: its narrowest length or "
                                "width must be above",
                                0.,
                                narrowest,
                                " mm",
                                "Raise the draft angle or lower the height."));
      const double limit =
        std::min({block.length / 2,
                  dim == 3 ? block.width / 2 : block.length / 2,
                  block.sipes > 0 ? block.sipe_depth : block.height});
      if (block.corner_radius >= limit)
        throw ExcParameter("Block/corner radius",
                           rule("must stay below half the length and width, "
                                "the height and the sipe depth, that is below",
                                limit,
                                block.corner_radius,
                                " mm",
                                "Lower it."));
    }

    void check_sipes(const TreadBlock &block, const BlockShape &shape)
    {
      if (block.sipes == 0)
        return;
      if (block.sipe_depth >= block.height)
        throw ExcParameter("Block/sipe depth",
                           rule("must be less than the height =",
                                block.height,
                                block.sipe_depth,
                                " mm",
                                "Lower it or raise the height."));
      const double end = 2 * shape.half_slot(block.sipe_depth);
      if (end <= 0)
        throw ExcParameter("Block/sipe draft angle",
                           rule("makes the blade end before its depth: its "
                                "thickness there must be above",
                                0.,
                                end,
                                " mm",
                                "Lower the sipe draft angle or the sipe depth, "
                                "or raise the sipe thickness."));
      const double thickest = std::max(block.sipe_thickness, end);
      if (block.sipes > 1 && block.sipe_spacing <= thickest)
        throw ExcParameter("Block/sipe spacing",
                           rule("must exceed the largest thickness of a "
                                "blade =",
                                thickest,
                                block.sipe_spacing,
                                " mm",
                                "Raise it or use thinner sipes."));
      for (const double z : {0., block.sipe_depth})
        {
          const double needed =
            (block.sipes - 1) * block.sipe_spacing + 2 * shape.half_slot(z);
          const double offered =
            2 * (shape.half_length(z) - block.corner_radius);
          if (needed < offered)
            continue;
          std::ostringstream text;
          text << "must fit into the block: " << block.sipes << " sipes every "
               << block.sipe_spacing << " mm need " << needed
               << " mm, and rubber beside them, at z = " << z
               << " mm; the length there less twice the corner radius is "
               << offered
               << " mm. Take fewer sipes, less spacing or a longer block.";
          throw ExcParameter("Block/sipes", text.str());
        }
    }

    void check_sizes(const TreadBlock &block, const int dim)
    {
      if (block.wall_element_size > block.element_size)
        throw ExcParameter("Block/wall element size",
                           rule("must be at most the element size =",
                                block.element_size,
                                block.wall_element_size,
                                " mm",
                                "Lower it."));
      const double longest = std::max(
        {block.length, block.height, dim == 3 ? block.width : block.length});
      const double floor = longest / 2000;
      for (const auto &[path, size] :
           {std::make_pair("Block/wall element size", block.wall_element_size),
            std::make_pair("Mould/facet size", block.facet_size)})
        if (size < floor)
          throw ExcParameter(path,
                             rule("must be at least a 2000th of the longest "
                                  "side =",
                                  floor,
                                  size,
                                  " mm",
                                  "Raise it."));

      constexpr double most = 5e6;
      const double n_cells  = dim == 3 ? n_grid_cells(rubber_axes<3>(block)) :
                                         n_grid_cells(rubber_axes<2>(block));
      if (n_cells > most)
        throw ExcParameter("Block/element size",
                           rule("makes too many elements: at most",
                                most,
                                n_cells,
                                "",
                                "Raise the element size or the wall element "
                                "size."));
      const double n_facet_cells = dim == 3 ?
                                     n_grid_cells(mould_axes<3>(block)) :
                                     n_grid_cells(mould_axes<2>(block));
      if (n_facet_cells > 20 * most)
        throw ExcParameter("Mould/facet size",
                           rule("makes too fine a grid behind the facets: at "
                                "most",
                                20 * most,
                                n_facet_cells,
                                "",
                                "Raise it."));
    }

    void add_outline(ParameterHandler &prm, TreadBlock &block)
    {
      const Patterns::Double positive(1e-6, 1e6), not_negative(0, 1e6),
        angle(-60, 60);
      prm.add_parameter("length",
                        block.length,
                        "L length (x) of the tread surface z = 0 [mm]",
                        positive);
      prm.add_parameter("width",
                        block.width,
                        "B width (y) of the tread surface, 3-D only [mm]",
                        positive);
      prm.add_parameter("height",
                        block.height,
                        "H height of the block in the mould, without base [mm]",
                        positive);
      prm.add_parameter("draft angle",
                        block.draft_angle,
                        "inclination of the outer walls; positive: the block "
                        "widens towards the backing [degree]",
                        angle);
      prm.add_parameter("corner radius",
                        block.corner_radius,
                        "r rounding of the outer edges in the mould [mm]",
                        not_negative);
    }

    void add_sipes(ParameterHandler &prm, TreadBlock &block)
    {
      const Patterns::Double positive(1e-6, 1e6), angle(-60, 60);
      prm.add_parameter("sipes",
                        block.sipes,
                        "n number of slots cut by blades of the mould [-]",
                        Patterns::Integer(0, 100));
      prm.add_parameter("sipe thickness",
                        block.sipe_thickness,
                        "width of a slot at the tread surface [mm]",
                        positive);
      prm.add_parameter("sipe depth",
                        block.sipe_depth,
                        "depth of the slots from the tread surface [mm]",
                        positive);
      prm.add_parameter("sipe spacing",
                        block.sipe_spacing,
                        "distance between the middles of slots [mm]",
                        positive);
      prm.add_parameter("sipe draft angle",
                        block.sipe_draft_angle,
                        "inclination of the blade flanks; positive: blades get "
                        "thinner towards their end [degree]",
                        angle);
    }

    void add_base_and_mesh(ParameterHandler &prm, TreadBlock &block)
    {
      const Patterns::Double positive(1e-6, 1e6), not_negative(0, 1e6);
      prm.add_parameter("base thickness",
                        block.base_thickness,
                        "base rubber between block and backing [mm]",
                        not_negative);
      prm.add_parameter("base overhang",
                        block.base_overhang,
                        "how far the base stands out beside the block [mm]",
                        not_negative);
      prm.add_parameter("element size",
                        block.element_size,
                        "h largest element edge aimed at [mm]",
                        positive);
      prm.add_parameter("wall element size",
                        block.wall_element_size,
                        "element edge at walls, blades and blade ends [mm]",
                        positive);
      prm.add_parameter("growth",
                        block.growth,
                        "q ratio of neighbouring elements away from walls [-]",
                        Patterns::Double(1.01, 10));
      prm.add_parameter(
        "elements across",
        block.min_elements,
        "least number of elements across a lamella, a blade end "
        "and between blade end and base [-]",
        Patterns::Integer(1, 1000));
      prm.add_parameter(
        "symmetry",
        block.symmetry,
        "modelled part: half is x > 0, half y is y > 0; results "
        "are of the whole block [-]",
        Patterns::Selection("whole|half|half y|quarter"));
    }
  } // namespace

  void TreadBlock::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Block");
    add_outline(prm, *this);
    add_sipes(prm, *this);
    add_base_and_mesh(prm, *this);
    prm.leave_subsection();

    prm.enter_subsection("Mould");
    prm.add_parameter("facet size",
                      facet_size,
                      "edge of the rigid facets [mm]",
                      Patterns::Double(1e-6, 1e6));
    prm.leave_subsection();
  }

  void TreadBlock::check(const int dim) const
  {
    const BlockShape shape(*this);
    if (base_overhang > 0 && !(base_thickness > 0))
      throw ExcParameter("Block/base overhang",
                         rule("needs a base: the base thickness must be above",
                              0.,
                              base_thickness,
                              " mm",
                              "Raise the base thickness or leave the overhang "
                              "0."));
    check_outline(*this, shape, dim);
    check_sipes(*this, shape);
    check_sizes(*this, dim);
  }

  bool TreadBlock::reduced_x() const
  {
    return symmetry == "half" || symmetry == "quarter";
  }

  bool TreadBlock::reduced_y(const int dim) const
  {
    return dim == 3 && (symmetry == "half y" || symmetry == "quarter");
  }

  unsigned int TreadBlock::symmetry_factor(const int dim) const
  {
    return (reduced_x() ? 2 : 1) * (reduced_y(dim) ? 2 : 1);
  }
} // namespace demold
