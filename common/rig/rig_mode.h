// SPDX-License-Identifier: LGPL-2.1-or-later
// The homogeneous tests a laboratory can do, as a family of F.
#ifndef demold_rig_rig_mode_h
#define demold_rig_rig_mode_h

#include <deal.II/base/tensor.h>

#include <string>

namespace demold
{
  /// What the grips prescribe and what they leave free.
  enum class RigMode
  {
    uniaxial,     ///< F = diag(x, l, l), l free
    equibiaxial,  ///< F = diag(x, x, l), l free
    pure_shear,   ///< F = diag(x, 1, l), l free: a wide, short strip
    simple_shear, ///< F = 1 + x e_1 (x) e_2
    confined      ///< F = diag(x, 1, 1)
  };

  /// All names, separated by '|', as the pattern of an entry wants them.
  constexpr const char *rig_mode_names =
    "uniaxial|equibiaxial|pure shear|simple shear|confined";

  RigMode     rig_mode_by_name(const std::string &name);
  std::string name_of(RigMode mode); ///< "pure shear"

  /// F = fixed + x driven + l lateral: the driven coordinate x is a stretch or
  /// a shear, the lateral stretch l is that of all free directions.
  struct RigKinematics
  {
    explicit RigKinematics(RigMode mode);

    dealii::Tensor<2, 3> fixed, driven, lateral;
    unsigned int         n_driven;  ///< ones in `driven`
    unsigned int         n_lateral; ///< ones in `lateral`; 0: nothing is free
    bool                 is_shear;

    dealii::Tensor<2, 3> F(const double x, const double l) const
    {
      return fixed + x * driven + l * lateral;
    }

    /// x of the strain [-]: stretch less 1, or shear.
    double coordinate(const double strain) const
    {
      return is_shear ? strain : 1. + strain;
    }

    /// The inverse of coordinate().
    double strain(const double x) const
    {
      return is_shear ? x : x - 1.;
    }

    /// The lateral stretch that keeps det F = @p J [-]; 1 if nothing is free.
    double lateral_of_volume(double x, double J) const;

    /// The entry of @p P that belongs to x.
    double component(const dealii::Tensor<2, 3> &P) const
    {
      return is_shear ? P[0][1] : P[0][0];
    }
  };
} // namespace demold

#endif
