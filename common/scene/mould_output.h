// SPDX-License-Identifier: LGPL-2.1-or-later
// ParaView files of the rigid mould where it is.
#ifndef demold_scene_mould_output_h
#define demold_scene_mould_output_h

#include "base/rigid_motion.h"
#include "geometry/rigid_surface.h"
#include "scene/file_series.h"

#include <string>

namespace demold
{
  /// Writes fields/mould-NNNN.vtu, the facets of the mould at a time, and
  /// mould.pvd. Cell colour: the number of the smooth patch.
  template <int dim>
  class MouldOutput
  {
  public:
    /// Both references must live as long as this.
    MouldOutput(const RigidSurface &surface,
                const RigidMotion  &motion,
                const std::string  &output_folder);

    /// Collective; the first rank writes. @p time [s]. Throws
    /// std::runtime_error when the disk is full.
    void write(double time);

    FileSeries series;

  private:
    const RigidSurface &surface;
    const RigidMotion  &motion;
  };
} // namespace demold

#endif
