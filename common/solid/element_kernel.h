// SPDX-License-Identifier: LGPL-2.1-or-later
// Residual and tangent of one rubber element, on plain small arrays.
#ifndef demold_solid_element_kernel_h
#define demold_solid_element_kernel_h

#include "material/rubber_law.h"
#include "solid/voigt.h"

#include <vector>

namespace demold
{
  /// How the volume change of an element is computed.
  enum class VolumeTreatment
  {
    pointwise,      ///< J of each quadrature point (q1, q2)
    mean_dilatation ///< one volume ratio per element (q1p0)
  };

  /// Geometry of one quadrature point in the reference configuration.
  /// In two dimensions the third row of the displacement gradient is zero
  /// (plane strain) or u_r / R (axisymmetric).
  template <int dim, int n_nodes>
  struct ElementPoint
  {
    double gradient[n_nodes][dim]; ///< dN/dX [1/mm]
    double hoop[n_nodes];          ///< N/R [1/mm], zero unless axisymmetric
    double weight;                 ///< reference volume [mm^3]
  };

  /// Sums over one element.
  template <int dim, int n_nodes>
  struct ElementResult
  {
    static constexpr int n = dim * n_nodes; ///< unknown a*dim + i

    double residual[n];   ///< [N]
    double tangent[n][n]; ///< [N/mm], symmetric
    double stored;        ///< [mJ] at t_{n+1}
    double dissipated;    ///< [mJ] over the step
    Voigt  stress;        ///< Cauchy, mean over the current volume [MPa]
    Voigt  C;             ///< F^T F seen by the law, mean over the volume [-]
  };

  /// What the passes over the points share.
  struct PointState
  {
    Matrix3      F;
    double       J;
    BulkResponse response;
    Voigt        tau;  ///< Kirchhoff stress of the law [MPa]
    Matrix3      Fbar; ///< deformation gradient seen by the law
  };

  /// Element residual and tangent in total-Lagrangian quadrature with spatial
  /// gradients. With mean dilatation the law sees (theta/J)^(1/3) F, where
  /// theta = v/V is the volume ratio of the element, and stress and tangent
  /// are the exact variations of the stored energy (theory A.1, element
  /// technology): with e the spatial strain and d its volumetric mean,
  ///   effective stress  tau + (p J - tr tau / 3) 1,  p = sum(tr tau dV)/(3 v).
  template <int dim, int n_nodes>
  class ElementKernel
  {
  public:
    using Point  = ElementPoint<dim, n_nodes>;
    using Result = ElementResult<dim, n_nodes>;

    /// @param u displacements [mm], unknown a*dim + i.
    /// @param laws one law, or one per point.
    /// @param old_history,new_history n_history doubles per point.
    /// @return false if a point has J <= 0; the result is then unusable.
    bool evaluate(const std::vector<Point> &points,
                  const double             *u,
                  const RubberLaw          *laws,
                  const unsigned int        law_stride,
                  const VolumeTreatment     volume,
                  const double              dt,
                  const double             *old_history,
                  double                   *new_history,
                  const bool                with_tangent,
                  Result                   &result);

  private:
    bool kinematics(const std::vector<Point> &points, const double *u);
    void add_point(const Point          &point,
                   const PointState     &state,
                   const VolumeTreatment volume,
                   const bool            with_tangent,
                   Result               &result);
    void add_mean_dilatation_coupling(Result &result) const;

    std::vector<PointState> states;
    double                  volume_now;    ///< v [mm^3]
    double                  mean_pressure; ///< p = sum(tr tau dV)/(3 v) [MPa]
    double                  mean_divergence[dim * n_nodes]; ///< of each unknown
    double                  coupling[dim * n_nodes];
    double                  coupling_mean;
  };
} // namespace demold

#endif
