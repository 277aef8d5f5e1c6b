// SPDX-License-Identifier: LGPL-2.1-or-later
// Residual and tangent of one rubber element, on plain small arrays.
#include "solid/element_kernel.h"

#include <cmath>

namespace demold
{
  namespace
  {
    constexpr Voigt unit = {{1., 1., 1., 0., 0., 0.}};

    double trace(const Voigt &t)
    {
      return t[0] + t[1] + t[2];
    }

    /// P c P with P = identity - 1/3 (1 x 1), and P c 1.
    void take_deviator(VoigtMatrix &c, Voigt &c_unit, double &unit_c_unit)
    {
      for (unsigned int I = 0; I < 6; ++I)
        c_unit[I] = c[I][0] + c[I][1] + c[I][2];
      unit_c_unit = trace(c_unit);
      for (unsigned int I = 0; I < 6; ++I)
        for (unsigned int K = 0; K < 6; ++K)
          c[I][K] += -unit[I] * c_unit[K] / 3. - c_unit[I] * unit[K] / 3. +
                     unit[I] * unit[K] * unit_c_unit / 9.;
      for (unsigned int I = 0; I < 3; ++I)
        c_unit[I] -= unit_c_unit / 3.;
    }
  } // namespace

  template <int dim, int n_nodes>
  bool ElementKernel<dim, n_nodes>::kinematics(const std::vector<Point> &points,
                                               const double             *u)
  {
    volume_now = 0.;
    for (std::size_t q = 0; q < points.size(); ++q)
      {
        Matrix3 &F = states[q].F;
        F          = {};
        F[0][0] = F[1][1] = F[2][2] = 1.;
        for (int a = 0; a < n_nodes; ++a)
          {
            for (int i = 0; i < dim; ++i)
              for (int j = 0; j < dim; ++j)
                F[i][j] += u[a * dim + i] * points[q].gradient[a][j];
            if (dim == 2)
              F[2][2] += u[a * dim] * points[q].hoop[a];
          }
        states[q].J = determinant(F);
        if (!(states[q].J > 0.))
          return false;
        volume_now += states[q].J * points[q].weight;
      }
    return true;
  }

  template <int dim, int n_nodes>
  bool ElementKernel<dim, n_nodes>::evaluate(const std::vector<Point> &points,
                                             const double             *u,
                                             const RubberLaw          *laws,
                                             const unsigned int    law_stride,
                                             const VolumeTreatment volume,
                                             const double          dt,
                                             const double         *old_history,
                                             double               *new_history,
                                             const bool            with_tangent,
                                             Result               &result)
  {
    states.resize(points.size());
    if (!kinematics(points, u))
      return false;

    double reference_volume = 0.;
    for (const Point &point : points)
      reference_volume += point.weight;
    const double theta = volume_now / reference_volume;

    result.stored = result.dissipated = 0.;
    result.stress = result.C = {};
    mean_pressure            = 0.;
    for (std::size_t q = 0; q < points.size(); ++q)
      {
        PointState  &s = states[q];
        const double f = volume == VolumeTreatment::mean_dilatation ?
                           std::cbrt(theta / s.J) :
                           1.;
        dealii::SymmetricTensor<2, 3> C;
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            s.Fbar[i][j] = f * s.F[i][j];
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = i; j < 3; ++j)
            C[i][j] = s.Fbar[0][i] * s.Fbar[0][j] +
                      s.Fbar[1][i] * s.Fbar[1][j] + s.Fbar[2][i] * s.Fbar[2][j];
        const RubberLaw   &law       = laws[q * law_stride];
        const unsigned int n_history = law.n_history();
        law.evaluate(C,
                     dt,
                     old_history + q * n_history,
                     new_history + q * n_history,
                     with_tangent,
                     s.response);
        result.stored += s.response.stored * points[q].weight;
        result.dissipated += s.response.dissipated * points[q].weight;
        const VoigtMatrix T = push_forward_map(s.Fbar);
        const Voigt       S = to_voigt(s.response.S);
        for (unsigned int I = 0; I < 6; ++I)
          {
            s.tau[I] = 0.;
            for (unsigned int K = 0; K < 6; ++K)
              s.tau[I] += T[I][K] * S[K];
          }
        mean_pressure += trace(s.tau) / 3. * points[q].weight;
        for (unsigned int I = 0; I < 6; ++I)
          {
            // J of the volume element cancels that of sigma = tau/J.
            result.stress[I] += s.tau[I] * points[q].weight / volume_now;
            result.C[I] +=
              C.access_raw_entry(I) * points[q].weight / reference_volume;
          }
      }
    mean_pressure /= volume_now;

    for (int r = 0; r < Result::n; ++r)
      {
        result.residual[r] = mean_divergence[r] = coupling[r] = 0.;
        if (with_tangent)
          for (int c = 0; c < Result::n; ++c)
            result.tangent[r][c] = 0.;
      }
    coupling_mean = 0.;
    for (std::size_t q = 0; q < points.size(); ++q)
      add_point(points[q], states[q], volume, with_tangent, result);
    if (with_tangent && volume == VolumeTreatment::mean_dilatation)
      add_mean_dilatation_coupling(result);
    if (with_tangent) // blocks below the diagonal by symmetry
      for (int r = 0; r < Result::n; ++r)
        for (int c = 0; c < r - r % dim; ++c)
          result.tangent[r][c] = result.tangent[c][r];
    return true;
  }

  template <int dim, int n_nodes>
  void ElementKernel<dim, n_nodes>::add_point(const Point          &point,
                                              const PointState     &s,
                                              const VolumeTreatment volume,
                                              const bool with_tangent,
                                              Result    &result)
  {
    const bool    mean = volume == VolumeTreatment::mean_dilatation;
    const double  w    = point.weight;
    const Matrix3 G    = inverse(s.F, s.J);

    double g[n_nodes][dim], h[n_nodes]; // spatial gradients, hoop rows
    for (int a = 0; a < n_nodes; ++a)
      {
        for (int i = 0; i < dim; ++i)
          {
            g[a][i] = 0.;
            for (int j = 0; j < dim; ++j)
              g[a][i] += point.gradient[a][j] * G[j][i];
          }
        h[a] = dim == 2 ? point.hoop[a] * G[2][2] : 0.;
      }

    const double mean_tau = trace(s.tau) / 3.;
    const double shift    = mean ? mean_tau - s.J * mean_pressure : 0.;
    Voigt        tau      = s.tau; // effective: shift changes the pressure
    for (unsigned int I = 0; I < 3; ++I)
      tau[I] -= shift;

    for (int a = 0; a < n_nodes; ++a)
      for (int i = 0; i < dim; ++i)
        {
          double r = 0.;
          for (int j = 0; j < dim; ++j)
            r += tau[voigt_index[i][j]] * g[a][j];
          if (dim == 2 && i == 0)
            r += tau[2] * h[a];
          result.residual[a * dim + i] += r * w;
          if (mean)
            mean_divergence[a * dim + i] +=
              (g[a][i] + (i == 0 ? h[a] : 0.)) * s.J * w / volume_now;
        }
    if (!with_tangent)
      return;

    VoigtMatrix c = push_forward(push_forward_map(s.Fbar), s.response.dS_dE);
    Voigt       y = {};
    if (mean)
      {
        double unit_c_unit;
        take_deviator(c, y, unit_c_unit);
        coupling_mean += (unit_c_unit / 9. - mean_tau / 3.) * w;
        for (unsigned int I = 0; I < 6; ++I)
          {
            for (unsigned int K = 0; K < 6; ++K)
              c[I][K] +=
                -2. / 3. * (s.tau[I] * unit[K] + unit[I] * s.tau[K]) +
                (2. / 3. * mean_tau + s.J * mean_pressure) * unit[I] * unit[K];
            c[I][I] += (I < 3 ? 2. : 1.) * shift;
            y[I] = y[I] / 3. + 2. / 3. * (s.tau[I] - mean_tau * unit[I]);
          }
      }

    for (int b = 0; b < n_nodes; ++b)
      {
        double cB[6][dim]; // c B_b, columns: unknowns of node b
        for (unsigned int I = 0; I < 6; ++I)
          for (int k = 0; k < dim; ++k)
            {
              double sum = 0.;
              for (int l = 0; l < dim; ++l)
                sum += c[I][voigt_index[k][l]] * g[b][l];
              if (dim == 2 && k == 0)
                sum += c[I][2] * h[b];
              cB[I][k] = sum * w;
            }
        if (mean)
          for (int k = 0; k < dim; ++k)
            {
              double sum = 0.;
              for (int l = 0; l < dim; ++l)
                sum += y[voigt_index[k][l]] * g[b][l];
              if (dim == 2 && k == 0)
                sum += y[2] * h[b];
              coupling[b * dim + k] += sum * w;
            }
        double tau_g[dim]; // geometric part
        for (int j = 0; j < dim; ++j)
          {
            tau_g[j] = 0.;
            for (int l = 0; l < dim; ++l)
              tau_g[j] += tau[voigt_index[j][l]] * g[b][l] * w;
          }
        for (int a = 0; a <= b; ++a)
          {
            double geometric = 0.;
            for (int j = 0; j < dim; ++j)
              geometric += g[a][j] * tau_g[j];
            for (int i = 0; i < dim; ++i)
              {
                double *row = result.tangent[a * dim + i] + b * dim;
                for (int k = 0; k < dim; ++k)
                  {
                    double sum = 0.;
                    for (int j = 0; j < dim; ++j)
                      sum += g[a][j] * cB[voigt_index[i][j]][k];
                    if (dim == 2 && i == 0)
                      sum += h[a] * cB[2][k];
                    row[k] += sum;
                  }
                row[i] += geometric;
              }
            if (dim == 2)
              result.tangent[a * dim][b * dim] += h[a] * tau[2] * h[b] * w;
          }
      }
  }

  template <int dim, int n_nodes>
  void ElementKernel<dim, n_nodes>::add_mean_dilatation_coupling(
    Result &result) const
  {
    for (int r = 0; r < Result::n; ++r)
      for (int c = r - r % dim; c < Result::n; ++c)
        result.tangent[r][c] +=
          coupling[r] * mean_divergence[c] + mean_divergence[r] * coupling[c] +
          coupling_mean * mean_divergence[r] * mean_divergence[c];
  }

  template class ElementKernel<2, 4>;
  template class ElementKernel<2, 9>;
  template class ElementKernel<3, 8>;
  template class ElementKernel<3, 27>;
} // namespace demold
