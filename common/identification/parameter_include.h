// SPDX-License-Identifier: LGPL-2.1-or-later
// Fitted constants as a piece of a parameter file that a scene includes.
#ifndef demold_identification_parameter_include_h
#define demold_identification_parameter_include_h

#include <string>
#include <utility>
#include <vector>

namespace demold
{
  /// A section of a parameter file.
  struct ParameterInclude
  {
    std::string              section = "Material";
    std::vector<std::string> comments; ///< lines without `#`, above

    /// (entry, value) in the order in which they are written.
    std::vector<std::pair<std::string, std::string>> entries;

    std::vector<ParameterInclude> inner; ///< sections within

    void set(const std::string &entry, const std::string &value);
    void set(const std::string &entry, double value);

    /// Numbers separated by commas.
    void set(const std::string &entry, const std::vector<double> &values);

    /// The same, rows separated by semicolons.
    void set(const std::string                      &entry,
             const std::vector<std::vector<double>> &rows);

    /// All lines begin with @p indent.
    std::string text(const std::string &indent = "") const;
    void        write(const std::string &file) const;
  };

  /// @p value with twelve digits, more than any measurement has.
  std::string prm_number(double value);
} // namespace demold

#endif
