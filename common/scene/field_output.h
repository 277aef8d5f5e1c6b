// SPDX-License-Identifier: LGPL-2.1-or-later
// ParaView files of displacement and interface state.
#ifndef demold_scene_field_output_h
#define demold_scene_field_output_h

#include "contact/node_to_segment.h"
#include "weak_form/algebra.h"

#include <string>
#include <utility>
#include <vector>

namespace dealii
{
  template <int dim, int spacedim>
  class DoFHandler;
}

namespace demold
{
  /// Writes fields/NNNN.vtu (one piece per rank) and keeps fields.pvd up to
  /// date in the output folder.
  template <int dim>
  class FieldOutput
  {
  public:
    FieldOutput(const dealii::DoFHandler<dim, dim> &dof_handler,
                const std::string &                 output_folder);

    /// @p displacement owned entries; @p interface may be null.
    void write(const Vector &       displacement,
               const NodeToSegment *interface,
               const double         time);

  private:
    const dealii::DoFHandler<dim, dim> &           dof_handler;
    const std::string                              output_folder;
    std::vector<std::pair<double, std::string>>    records;
  };
} // namespace demold

#endif
