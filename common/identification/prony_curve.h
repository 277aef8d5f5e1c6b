// SPDX-License-Identifier: LGPL-2.1-or-later
// What a Prony series answers in a test, and the data of such a test.
#ifndef demold_identification_prony_curve_h
#define demold_identification_prony_curve_h

#include <vector>

namespace demold
{
  /// Relaxed modulus and Maxwell branches in parallel (theory A.2, the linear
  /// limit): E(t) = E_inf + sum E_j exp(-t/tau_j).
  struct PronySeries
  {
    double              equilibrium = 0.; ///< E_inf [MPa]
    std::vector<double> times;            ///< tau_j [s]
    std::vector<double> moduli;           ///< E_j [MPa]

    double relaxation_modulus(double time) const;   ///< E(t) [MPa]
    double storage_modulus(double frequency) const; ///< E' at omega [rad/s]
    double loss_modulus(double frequency) const;    ///< E'' at omega [rad/s]
  };

  /// What is measured at a point.
  enum class PronyQuantity
  {
    storage,   ///< E' over omega [rad/s]
    loss,      ///< E'' over omega [rad/s]
    relaxation ///< stress over strain at the time [s] since the ramp began
  };

  /// The share of a branch of unit modulus in a quantity [-], and its
  /// derivative by ln tau.
  struct PronyKernel
  {
    double value;
    double by_log_time;
  };

  /// @p x: omega [rad/s] or time [s]; @p ramp: duration [s] over which the
  /// strain has grown linearly before it was held, relaxation only:
  ///   storage     (omega tau)^2/(1 + (omega tau)^2)
  ///   loss        omega tau/(1 + (omega tau)^2)
  ///   relaxation  exp(-t/tau), the mean over the start of the ramp's pieces
  PronyKernel
  prony_kernel(PronyQuantity quantity, double x, double time, double ramp);

  /// Measured points of one compound in one state of cure.
  struct PronyCurve
  {
    struct Point
    {
      PronyQuantity quantity;
      double        x;      ///< omega [rad/s] or time [s]
      double        value;  ///< [MPa]
      double        weight; ///< of the residual [1/MPa]
    };

    std::vector<Point> points;
    double             ramp = 0.; ///< [s], relaxation only

    /// The model's answer at point @p i [MPa].
    double model(const PronySeries &series, unsigned int i) const;

    /// Shortest and longest time the points resolve [s]: 1/omega, or t.
    double shortest_time() const;
    double longest_time() const;
  };
} // namespace demold

#endif
