// SPDX-License-Identifier: LGPL-2.1-or-later
// The state of cure that a press cycle gives the block of a scene.
#ifndef demold_scene_vulcanised_cure_h
#define demold_scene_vulcanised_cure_h

#include "cure/heat_conduction.h"
#include "scene/scene.h"

#include <deal.II/grid/tria.h>

#include <memory>
#include <string>
#include <utility>

namespace demold
{
  struct SceneParameters;

  /// f90 [-] and temperature [degC] at the opening over the quadrature points
  /// of the rubber, as computed, before any clamping.
  struct VulcanisedRange
  {
    double        smallest, mean, largest; ///< f90; the mean is over the volume
    double        coldest, hottest;        ///< [degC]
    unsigned long n_points;
    unsigned long n_clamped; ///< points whose f90 is not within the tables
  };

  /// Material/cure = vulcanised: heat from Scene::mould_side and
  /// Scene::bladder_side through the undeformed block, layers behind it
  /// included, and f90 = int dt/t90(T) (theory A11). Cure is that at
  /// the opening, when the block leaves its mould; what cooling in air adds
  /// later is for the pictures. One way: the cure changes no temperature.
  template <int dim>
  class VulcanisedCure
  {
  public:
    /// Runs the press cycle, on every rank the whole of it. Throws
    /// ExcParameter if nothing in @p scene touches a press.
    VulcanisedCure(const Scene<dim> &scene, const SceneParameters &parameters);

    /// f90 [-] at the opening at a reference position of the block, held to
    /// the range of the material's tables.
    double f90(const dealii::Point<3> &X) const;

    const VulcanisedRange &range() const
    {
      return extremes;
    }

    /// A warning if values were clamped, else nothing.
    std::string warning() const;

    /// Writes vulcanisation.vtu: `temperature_at_opening` [degC],
    /// `f90_at_opening` and `f90_at_end` [-] at the nodes; of a slice also
    /// pictures of the first two. Returns what went wrong with these.
    std::string write(const std::string &output_folder) const;

  private:
    VulcanisedRange find_range(const Scene<dim> &scene,
                               unsigned int      n_points) const;

    dealii::Triangulation<dim>           triangulation;
    std::unique_ptr<HeatConduction<dim>> heat;
    std::pair<double, double>            bounds; ///< of the tables [-]
    VulcanisedRange                      extremes;
  };
} // namespace demold

#endif
