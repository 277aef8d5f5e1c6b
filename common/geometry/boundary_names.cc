// SPDX-License-Identifier: LGPL-2.1-or-later
// Boundary ids and their names, in both directions.
#include "geometry/boundary_names.h"

#include "base/nearest_names.h"
#include "base/parameter_error.h"

#include <array>
#include <cstdlib>
#include <utility>

namespace demold
{
  namespace
  {
    using Entry = std::pair<Boundary::Id, const char *>;

    constexpr std::array<Entry, 21> names = {
      {{Boundary::left, "left"},
       {Boundary::right, "right"},
       {Boundary::bottom, "bottom"},
       {Boundary::top, "top"},
       {Boundary::front, "front"},
       {Boundary::back, "back"},
       {Boundary::backing, "backing"},
       {Boundary::wall, "wall"},
       {Boundary::sipe, "sipe"},
       {Boundary::groove, "groove"},
       {Boundary::free_side, "free side"},
       {Boundary::symmetry_x, "symmetry x"},
       {Boundary::symmetry_y, "symmetry y"},
       {Boundary::layer_x, "layer x"},
       {Boundary::layer_y, "layer y"},
       {Boundary::base_left, "base left"},
       {Boundary::base_right, "base right"},
       {Boundary::base_bottom, "base bottom"},
       {Boundary::base_top, "base top"},
       {Boundary::base_front, "base front"},
       {Boundary::base_back, "base back"}}};
  } // namespace

  std::vector<Boundary::Id> named_boundaries()
  {
    std::vector<Boundary::Id> ids;
    for (const Entry &entry : names)
      ids.push_back(entry.first);
    return ids;
  }

  std::string boundary_name(const Boundary::Id id)
  {
    for (const Entry &entry : names)
      if (entry.first == id)
        return entry.second;
    return "boundary " + std::to_string(id);
  }

  Boundary::Id boundary_id(const std::string &name, const std::string &path)
  {
    for (const Entry &entry : names)
      if (name == entry.second)
        return entry.first;

    const bool is_number =
      !name.empty() && name.size() < 9 &&
      name.find_first_not_of("0123456789") == std::string::npos;
    if (is_number)
      return static_cast<Boundary::Id>(std::strtoul(name.c_str(), nullptr, 10));

    std::vector<std::string> known;
    std::string              all;
    for (const Entry &entry : names)
      {
        known.push_back(entry.second);
        all += (all.empty() ? "" : ", ") + known.back();
      }
    throw ExcParameter(path,
                       "there is no boundary called '" + name +
                         "'; the nearest name is '" +
                         nearest_names(name, known, 1).front() +
                         "'. Known names: " + all +
                         ", or the number of a physical group.");
  }
} // namespace demold
