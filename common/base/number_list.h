// SPDX-License-Identifier: LGPL-2.1-or-later
// A list of numbers in a parameter file.
#ifndef demold_base_number_list_h
#define demold_base_number_list_h

#include <string>
#include <vector>

namespace demold
{
  /// The numbers of @p list, separated by commas. Throws ExcParameter with
  /// @p path if there are others than numbers or fewer than @p n.
  std::vector<double> number_list(const std::string &list,
                                  unsigned int       n,
                                  const std::string &path);
} // namespace demold

#endif
