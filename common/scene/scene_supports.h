// SPDX-License-Identifier: LGPL-2.1-or-later
// From support rules to prescribed unknowns and their reactions.
#ifndef demold_scene_scene_supports_h
#define demold_scene_scene_supports_h

#include "scene/scene.h"
#include "weak_form/weak_form.h"

#include <map>
#include <memory>

namespace dealii
{
  template <int dim, int spacedim>
  class DoFHandler;
}

namespace demold
{
  /// The prescribed unknowns of a scene. Where several rules name an unknown
  /// the first one holds.
  class SceneSupports
  {
  public:
    struct Entry
    {
      dealii::types::global_dof_index unknown;
      unsigned int                    rule;
      dealii::Point<3>                X;
    };

    SceneSupports(std::vector<SupportRule> rules, std::vector<Entry> entries);

    Supports supports() const;

    /// Tells of an unknown whether it is prescribed.
    std::function<bool(dealii::types::global_dof_index)> is_held() const;

    /// Sum of the reactions [N] at one boundary, from the force vector of the
    /// weak form, all ranks.
    dealii::Tensor<1, 3> reaction(const dealii::types::boundary_id boundary,
                                  const Vector                    &force) const;

    /// Power [mJ/s] of all reactions at time @p t: with the rate of the
    /// opening it gives the force that does the same work. @p dt is the
    /// distance of the central differences of the prescribed motion.
    double power(const double t, const double dt, const Vector &force) const;

  private:
    std::vector<SupportRule> rules;
    std::vector<Entry>       entries;
  };

  template <int dim>
  SceneSupports
  collect_supports(const dealii::DoFHandler<dim, dim> &dof_handler,
                   const std::vector<SupportRule>     &rules);
} // namespace demold

#endif
