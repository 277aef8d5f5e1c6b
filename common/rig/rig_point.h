// SPDX-License-Identifier: LGPL-2.1-or-later
// A rubber law between the grips: strain or stress in, the rest solved for.
#ifndef demold_rig_rig_point_h
#define demold_rig_rig_point_h

#include "material/rubber_law.h"
#include "rig/rig_mode.h"

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace demold
{
  /// What the rig shows at an instant.
  struct RigState
  {
    double strain  = 0.; ///< stretch less 1, or shear [-]
    double lateral = 1.; ///< stretch of the free directions [-]
    double nominal = 0.; ///< P_11, or P_12 in shear [MPa]

    /// Power-conjugate to the strain [MPa]: the sum of the nominal stresses of
    /// all driven directions.
    double force = 0.;

    dealii::SymmetricTensor<2, 3> cauchy; ///< [MPa]

    double stored     = 0.; ///< per reference volume [mJ/mm^3]
    double dissipated = 0.; ///< over the step, per reference volume [mJ/mm^3]

    unsigned int n_iterations = 0; ///< of Newton's method
  };

  /// One point of rubber in a test of a mode. Newton's method with the law's
  /// consistent tangent finds the stretch of the directions left free (their
  /// nominal stress is 0) and, where a stress is prescribed, the strain.
  class RigPoint
  {
  public:
    RigPoint(const RubberLaw &law, RigMode mode);

    /// The rubber has been held at @p strain [-] until all has relaxed.
    void rest(double strain);

    /// A step of length @p dt [s] >= 0 to a strain [-] or to a nominal stress
    /// [MPa] in the driven directions. The history is that before the step
    /// until commit(). Throws std::runtime_error where no equilibrium is found.
    const RigState &strain_step(double strain, double dt);
    const RigState &stress_step(double nominal, double dt);

    void commit();

    const RigState &state() const
    {
      return now;
    }

    /// Corrections of the last step relative to the stretches [-], one for each
    /// iteration of Newton's method.
    const std::vector<double> &corrections() const
    {
      return newton_corrections;
    }

  private:
    /// The unknowns: driven coordinate, lateral stretch.
    struct Equations
    {
      std::array<double, 2>                residual; // [MPa]
      std::array<std::array<double, 2>, 2> tangent;  // [MPa]
    };

    void      solve(double strain, bool driven_free, double nominal, double dt);
    Equations evaluate(double x, double l, double dt, double nominal);
    std::array<double, 2> correction(const Equations &equations,
                                     bool             driven_free) const;
    void                  finish(double x, double l, double dt);

    const RubberLaw     law;
    const RigKinematics kinematics;
    std::vector<double> old_history, new_history;
    BulkResponse        response;
    RigState            committed, now;
    std::vector<double> newton_corrections;
  };
} // namespace demold

#endif
