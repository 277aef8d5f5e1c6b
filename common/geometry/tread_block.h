// SPDX-License-Identifier: LGPL-2.1-or-later
// A tread block with draft and sipes: rubber mesh and mould from one shape.
#ifndef demold_geometry_tread_block_h
#define demold_geometry_tread_block_h

#include <string>
#include <vector>

#include "geometry/rigid_surface.h"

namespace dealii
{
  class ParameterHandler;
  template <int dim, int spacedim>
  class Triangulation;
} // namespace dealii

namespace demold
{
  /// Dimensions of the block, prm section "Block", and the facet size of its
  /// mould, "Mould/facet size". Lengths in mm, angles in degree.
  ///
  ///         z (3-D) or y (2-D)
  ///         ^        backing
  ///     +-------------------------+          base layer, sides "free side"
  ///   --+ groove             groove +--  H
  ///      \     +--+     +--+     /
  ///  wall \    |  |sipe |  |    / wall       L(z) = length + 2 z tan(draft)
  ///        \   |  |     |  |   /
  ///         +--+  +-----+  +--+   0 --> x
  ///               bottom
  ///
  /// The mould moves to -z (3-D) or -y (2-D). Length (x) and width (y) are
  /// those of the tread surface z = 0; with positive draft the block widens
  /// towards the backing and leaves the mould freely. Sipes are slots
  /// parallel to y through the whole width, centred on x = 0; their thickness
  /// is that at z = 0 and shrinks towards the end by their own draft. A 2-D
  /// block is the slice y = 0. The corner radius rounds the edges of the tread
  /// surface and, in 3-D, those between the outer walls (the shape of a cube
  /// corner mapped to a ball, sheared by the draft).
  struct TreadBlock
  {
    double       length            = 20;
    double       width             = 20;
    double       height            = 8;
    double       draft_angle       = 3;
    double       corner_radius     = 0;
    unsigned int sipes             = 0;
    double       sipe_thickness    = 0.6;
    double       sipe_depth        = 6;
    double       sipe_spacing      = 5;
    double       sipe_draft_angle  = 0.5;
    double       base_thickness    = 2;
    double       base_overhang     = 0;
    double       element_size      = 1;
    double       wall_element_size = 0.5;
    double       growth            = 1.4;
    unsigned int min_elements      = 2;
    /// whole | half (x >= 0) | half y (y >= 0) | quarter; a 2-D block knows
    /// x only.
    std::string symmetry   = "whole";
    double      facet_size = 0.8;

    /// Thicknesses of layers between base and backing, from the block outwards;
    /// no entries of their own: what holds the block makes them.
    std::vector<double> layers;

    void add_parameters(dealii::ParameterHandler &prm);

    /// Throw ExcParameter for dimensions that make no block or no mesh.
    /// @param dim 2 or 3.
    void check(int dim) const;

    /// Is only x >= 0 (y >= 0) modelled?
    bool reduced_x() const;
    bool reduced_y(int dim) const;

    /// Whole block over modelled part: 1, 2 or 4 [-].
    unsigned int symmetry_factor(int dim) const;
  };

  /// Mesh of the rubber; @p triangulation is empty before, serial or
  /// parallel::shared. Boundary ids: backing, bottom, wall, sipe, groove,
  /// free_side, symmetry_x, symmetry_y, layer_x, layer_y (boundary_names.h).
  /// The material id is 0 for block and base, 1 and up for the layers. Calls
  /// check().
  template <int dim>
  void make_tread_block(const TreadBlock                &block,
                        dealii::Triangulation<dim, dim> &triangulation);

  /// The cavity: bottom between the blades, outer walls up to the height of
  /// the block, flanks and ends of the blades, and the land under an
  /// overhanging base. Own facet size; curved edges are divided at least
  /// eight times per radius and half edge. At symmetry planes it goes on by
  /// one facet. Patches as in MouldPatch. Calls check().
  RigidSurface make_mould(const TreadBlock &block, int dim);

  /// Patch numbers of make_mould. With a corner radius, bottom and walls are
  /// one smooth patch and carry `bottom`. Blade j (from small x, all blades of
  /// the whole block counted) has three patches from first_blade + 3 j.
  struct MouldPatch
  {
    static constexpr unsigned int bottom      = 0;
    static constexpr unsigned int wall        = 1; // -x, then +x, -y, +y
    static constexpr unsigned int land        = 5;
    static constexpr unsigned int first_blade = 6;
    static constexpr unsigned int low_flank   = 0; // the side at smaller x
    static constexpr unsigned int high_flank  = 1;
    static constexpr unsigned int blade_end   = 2;
  };

  /// Area of rubber in contact with the closed mould, of the whole block
  /// [mm^2]; in 2-D the length [mm], per mm of thickness. Exact without a
  /// corner radius.
  double contact_area(const TreadBlock &block, int dim);
} // namespace demold

#endif
