// SPDX-License-Identifier: LGPL-2.1-or-later
// What a rheometer curve says: degree of cure, t90, reversion, modulus.
#ifndef demold_cure_rheometer_curve_h
#define demold_cure_rheometer_curve_h

#include <functional>
#include <string>
#include <vector>

namespace demold
{
  /// The storage torque S'(t) of a moving-die rheometer at one temperature,
  /// between its points by PCHIP, so without overshoot. Minimum and maximum
  /// are those of the points.
  class RheometerCurve
  {
  public:
    /// Why these points are no cure curve; empty if they are one. For callers
    /// that report it under file and line.
    static std::string problem(const std::vector<double> &times,
                               const std::vector<double> &torques);

    /// @p temperature [degC], @p times [s], @p torques [dNm]; throws
    /// std::invalid_argument with problem() otherwise.
    RheometerCurve(const double               temperature,
                   const std::vector<double> &times,
                   const std::vector<double> &torques);

    double              temperature;     ///< [degC]
    std::vector<double> times;           ///< of the points [s]
    std::vector<double> torques;         ///< at the points [dNm]
    double              minimum;         ///< S'_min [dNm], before the maximum
    double              maximum;         ///< S'_max [dNm]
    double              time_of_minimum; ///< [s]
    double              time_of_maximum; ///< [s]

    /// S'(t) [dNm] for a t [s] within the curve.
    double torque(const double time) const;

    /// alpha(t) = (S' - S'_min)/(S'_max - S'_min) (ISO 6502; theory A.3). 0
    /// before the minimum, where the sample only warms up.
    double degree_of_cure(const double time) const;

    /// The degree of cure at the points, in their order.
    std::vector<double> degrees_of_cure() const;

    /// t_x [s]: when alpha first reaches @p degree in (0, 1]; t90 is
    /// time_of(0.9).
    double time_of(const double degree) const;

    /// The part of the torque lost from the maximum to the end of the curve,
    /// over S'_max - S'_min [-].
    double reversion() const;

  private:
    std::function<double(double)> curve;
  };

  /// The cone-plate cell of a moving-die rheometer.
  struct RheometerCell
  {
    double radius       = 20.6;   ///< R [mm]
    double shear_strain = 0.0698; ///< gamma_0, of an arc of 0.5 degree [-]
  };

  /// An estimate of the shear modulus [MPa] from the torque [dNm],
  /// G = 3 S/(2 pi R^3 gamma_0) (theory A.3): 0.078 MPa per dNm for the usual
  /// cell.
  double shear_modulus_from_torque(const double         torque,
                                   const RheometerCell &cell);
} // namespace demold

#endif
