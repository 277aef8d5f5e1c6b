// SPDX-License-Identifier: LGPL-2.1-or-later
// Volume and areas of a tread block with sharp edges, from its dimensions.
#ifndef demold_tests_geometry_tread_block_closed_form_h
#define demold_tests_geometry_tread_block_closed_form_h

#include <cmath>

#include "geometry/tread_block.h"

namespace demold
{
  inline double tan_degree(const double angle)
  {
    return std::tan(angle * std::acos(-1.) / 180);
  }

  inline TreadBlock sharp_block(const unsigned int sipes)
  {
    TreadBlock block;
    block.sipes             = sipes;
    block.base_thickness    = 1.5;
    block.element_size      = 2;
    block.wall_element_size = 1;
    return block;
  }

  // Closed forms of the whole block with sharp edges. t is tan(draft), s that
  // of the sipes; lengths grow as L + 2 z t, slots shrink as T - 2 z s.
  struct ClosedForm
  {
    explicit ClosedForm(const TreadBlock &block)
      : b(block)
      , t(tan_degree(b.draft_angle))
      , s(tan_degree(b.sipe_draft_angle))
    {}

    // Integral of (a + 2 z p)(c + 2 z q) over [0, h].
    static double integral(double a, double p, double c, double q, double h)
    {
      return a * c * h + (a * q + c * p) * h * h + 4 * p * q * h * h * h / 3;
    }

    double volume() const
    {
      const double top_x = b.length + 2 * b.height * t + 2 * b.base_overhang;
      const double top_y = b.width + 2 * b.height * t + 2 * b.base_overhang;
      return integral(b.length, t, b.width, t, b.height) +
             top_x * top_y * b.base_thickness -
             b.sipes * integral(b.sipe_thickness, -s, b.width, t, b.sipe_depth);
    }

    double bottom() const
    {
      return (b.length - b.sipes * b.sipe_thickness) * b.width;
    }

    // Trapezoids of slant height H / cos(draft), less the mouths of slots.
    double walls() const
    {
      const double slant = std::sqrt(1 + t * t);
      const double mouth =
        b.sipe_depth * (b.sipe_thickness - b.sipe_depth * s) * slant;
      return 2 * slant * b.height * (b.length + b.width + 2 * b.height * t) -
             2 * b.sipes * mouth;
    }

    double sipe_surfaces() const
    {
      const double flank =
        b.sipe_depth * (b.width + b.sipe_depth * t) * std::sqrt(1 + s * s);
      const double end = (b.sipe_thickness - 2 * b.sipe_depth * s) *
                         (b.width + 2 * b.sipe_depth * t);
      return b.sipes * (2 * flank + end);
    }

    double contact() const
    {
      return bottom() + walls() + sipe_surfaces() + land();
    }

    double land() const
    {
      const double top_x = b.length + 2 * b.height * t;
      const double top_y = b.width + 2 * b.height * t;
      return (top_x + 2 * b.base_overhang) * (top_y + 2 * b.base_overhang) -
             top_x * top_y;
    }

    TreadBlock b;
    double     t, s;
  };
} // namespace demold

#endif
