// SPDX-License-Identifier: LGPL-2.1-or-later
// A list of numbers in a parameter file.
#include "base/number_list.h"

#include "base/parameter_error.h"

#include <deal.II/base/utilities.h>

namespace demold
{
  std::vector<double> number_list(const std::string &list,
                                  const unsigned int n,
                                  const std::string &path)
  {
    std::vector<double> result;
    try
      {
        for (const auto &part : dealii::Utilities::split_string_list(list, ','))
          result.push_back(dealii::Utilities::string_to_double(part));
      }
    catch (const std::exception &)
      {
        throw ExcParameter(path,
                           "must be numbers separated by commas; got \"" +
                             list + "\".");
      }
    if (result.size() < n)
      throw ExcParameter(path,
                         "needs " + std::to_string(n) +
                           " numbers in this dimension; got " +
                           std::to_string(result.size()) + " in \"" + list +
                           "\".");
    return result;
  }
} // namespace demold
