// SPDX-License-Identifier: LGPL-2.1-or-later
// A vector in a parameter file, each component a formula in t.
#include "scene/vector_of_time.h"

#include "base/parameter_error.h"
#include "scene/expression.h"

#include <deal.II/base/utilities.h>

#include <array>
#include <memory>

namespace demold
{
  using namespace dealii;

  std::function<Tensor<1, 3>(double)> vector_of_time(const std::string &list,
                                                     const std::string &path)
  {
    const auto parts = Utilities::split_string_list(list, ',');
    if (parts.size() != 3)
      throw ExcParameter(path,
                         "needs three formulas separated by commas; got " +
                           std::to_string(parts.size()) + ".");
    std::array<std::shared_ptr<Expression>, 3> formulas;
    for (unsigned int d = 0; d < 3; ++d)
      formulas[d] = std::make_shared<Expression>(parts[d], path);
    return [formulas](const double t) {
      Tensor<1, 3> v;
      for (unsigned int d = 0; d < 3; ++d)
        v[d] = (*formulas[d])(t);
      return v;
    };
  }
} // namespace demold
