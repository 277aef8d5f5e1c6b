// SPDX-License-Identifier: LGPL-2.1-or-later
// Simple bodies and rigid planes for patch, Hertz, peel and sliding tests.
#ifndef demold_geometry_test_bodies_h
#define demold_geometry_test_bodies_h

#include <deal.II/base/point.h>

#include <array>
#include <functional>
#include <vector>

#include "geometry/rigid_surface.h"

namespace dealii
{
  template <int dim, int spacedim>
  class Triangulation;
}

namespace demold
{
  /// A box of rectangular cells. Boundary ids: left, right (x), bottom, top
  /// (y in 2-D, z in 3-D), front, back (y in 3-D).
  template <int dim>
  struct Box
  {
    /// Corner of smallest coordinates [mm].
    dealii::Point<dim> lower_corner;
    /// Extents [mm], > 0.
    std::array<double, dim> size;
    /// Cells per direction, >= 1.
    std::array<unsigned int, dim> cells;
    /// Size of the last over the first cell per direction [-], > 0; sizes
    /// between grow geometrically.
    std::array<double, dim> grading     = ones();
    unsigned int            material_id = 0;
    /// Largest shift of a node inside the box per direction, over the smaller
    /// element beside it [-], < 0.5. At random, but the same every time.
    double irregularity = 0.;
    /// Where a point of the box goes in the end; empty: it stays.
    std::function<dealii::Point<dim>(const dealii::Point<dim> &)> map;

    static std::array<double, dim> ones()
    {
      std::array<double, dim> values;
      values.fill(1.);
      return values;
    }
  };

  /// Mesh of one box; @p triangulation is empty before.
  template <int dim>
  void make_box(const Box<dim>                  &box,
                dealii::Triangulation<dim, dim> &triangulation);

  /// Two boxes that share no vertex in one triangulation: @p upper (slave)
  /// gets material id 0 and the ids of a box, @p lower (master) material id 1
  /// and the ids base_left ... base_back.
  template <int dim>
  void make_two_boxes(const Box<dim>                  &upper,
                      const Box<dim>                  &lower,
                      dealii::Triangulation<dim, dim> &triangulation);

  /// Fine cells around one point of the bottom: half width and depth [mm], 0:
  /// as deep as wide, and the cell size there [mm]; outside cells grow by
  /// @p growth up to far_size.
  struct FineZone
  {
    double fine_width = 2;
    double fine_depth = 0;
    double fine_size  = 0.2;
    double far_size   = 1;
    double growth     = 1.2;
  };

  /// Lower part of a cylinder across the x-y plane (2-D), or of a ball when
  /// read as axisymmetric. Boundary ids: bottom (curved), top (flat, at the
  /// height of the centre), left and right (upright sides, for half angles
  /// below 90), symmetry_x (for right_half).
  struct HalfCylinder : FineZone
  {
    double           radius = 10; // [mm]
    dealii::Point<2> lowest;      // position of the lowest point [mm]
    /// Half opening angle of the curved part [degree]: 90 gives the half
    /// disc, (0, 75] a bar with a curved bottom and upright sides.
    double half_angle = 90;
    /// Only x >= lowest[0].
    bool right_half = false;
  };

  void make_half_cylinder(const HalfCylinder          &body,
                          dealii::Triangulation<2, 2> &triangulation);

  /// The same above a box; ids of both as in make_two_boxes().
  void make_half_cylinder_on_box(const HalfCylinder          &upper,
                                 const Box<2>                &lower,
                                 dealii::Triangulation<2, 2> &triangulation);

  /// A rectangle with a fine zone at its bottom; boundary ids of a box.
  struct GradedBox : FineZone
  {
    dealii::Point<2>      lower_corner;    // [mm]
    std::array<double, 2> size{{10, 10}};  // [mm]
    double                fine_centre = 0; ///< x of the fine zone [mm]
  };

  void make_graded_box(const GradedBox             &box,
                       dealii::Triangulation<2, 2> &triangulation);

  /// A rigid ground or indenter: a polyline in the x-y plane; in 3-D it is
  /// drawn in x-z and extruded along y. Walking along the polyline the metal
  /// is on the left and the normal points to the right: a ground runs from
  /// large to small x. Pieces that meet at more than 40 degree (theory B.11)
  /// belong to different patches.
  struct RigidPolyline
  {
    /// Corners [mm], at least two.
    std::vector<dealii::Point<2>> corners;
    /// Number of facets per piece.
    std::vector<unsigned int> n_facets;
    /// Extent and number of facets along y, 3-D only.
    double       y_begin    = 0;
    double       y_end      = 1;
    unsigned int n_facets_y = 1;
  };

  /// @param dim 2 or 3
  RigidSurface make_rigid_polyline(const RigidPolyline &polyline, int dim);

  /// A level rectangle with metal below and the normal upwards.
  /// @param from, to  smallest and largest coordinates; [0] is x; [1] is y,
  ///                  ignored in 2-D [mm]
  /// @param level     its y (2-D) or z (3-D) [mm]
  /// @param n_facets  along x and y
  RigidSurface make_rigid_plane(const dealii::Point<2>            &from,
                                const dealii::Point<2>            &to,
                                double                             level,
                                const std::array<unsigned int, 2> &n_facets,
                                int                                dim);
} // namespace demold

#endif
