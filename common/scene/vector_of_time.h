// SPDX-License-Identifier: LGPL-2.1-or-later
// A vector in a parameter file, each component a formula in t.
#ifndef demold_scene_vector_of_time_h
#define demold_scene_vector_of_time_h

#include <deal.II/base/tensor.h>

#include <functional>
#include <string>

namespace demold
{
  /// @p list: three formulas in t [s], separated by commas. Throws
  /// ExcParameter with @p path if they are not.
  std::function<dealii::Tensor<1, 3>(double)>
  vector_of_time(const std::string &list, const std::string &path);
} // namespace demold

#endif
