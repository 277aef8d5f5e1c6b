// SPDX-License-Identifier: LGPL-2.1-or-later
// Constants of a belt ply by three rules, over cord content and angle.
#ifndef demold_rig_ply_task_h
#define demold_rig_ply_task_h

#include "base/run_step.h"
#include "material/ply_parameters.h"

#include <string>

namespace demold
{
  /// Section Ply (theory A.5). Writes
  /// * constants.csv: E1, E2, G12, nu12 by every PlyRule over the volume
  ///   fraction of the cords,
  /// * pair.csv: E_x, E_y, G_xy, nu_xy of two plies at +-theta over theta, by
  ///   every rule and by Akasaka's closed form,
  /// * summary.json: all of them for the ply and the angle of the section,
  /// * pictures of both tables.
  class PlyTask
  {
  public:
    void        add_parameters(dealii::ParameterHandler &prm);
    void        check() const;
    std::string preview() const;
    RunStatus   run(const RunContext &context) const;

  private:
    PlyParameters ply;
    double        angle           = 20.; // [degree]
    double        largest_content = .6;  // V_c [-]
    unsigned int  n_points        = 61;
  };
} // namespace demold

#endif
