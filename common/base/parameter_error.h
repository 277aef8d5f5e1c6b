// SPDX-License-Identifier: LGPL-2.1-or-later
// The one exception for what a user wrote: prm path, rule, both numbers.
#ifndef demold_base_parameter_error_h
#define demold_base_parameter_error_h

#include <stdexcept>
#include <string>

namespace demold
{
  /// Bad input. The front of every program turns it into one message and exit
  /// code 2; nothing is written. @p path is the full path of the entry, such
  /// as "Adhesion/rupture gap"; @p explanation names the rule, both numbers
  /// and what to try.
  struct ExcParameter : std::runtime_error
  {
    ExcParameter(const std::string &path, const std::string &explanation)
      : std::runtime_error(path + ": " + explanation)
    {}
  };
} // namespace demold

#endif
