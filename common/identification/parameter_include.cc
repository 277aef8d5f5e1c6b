// SPDX-License-Identifier: LGPL-2.1-or-later
// Fitted constants as a piece of a parameter file that a scene includes.
#include "identification/parameter_include.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace demold
{
  namespace
  {
    std::string list(const std::vector<double> &values)
    {
      std::string text;
      for (const double value : values)
        text += (text.empty() ? "" : ", ") + prm_number(value);
      return text;
    }
  } // namespace



  std::string prm_number(const double value)
  {
    std::ostringstream text;
    text.precision(12);
    text << value;
    return text.str();
  }



  void ParameterInclude::set(const std::string &entry, const std::string &value)
  {
    entries.emplace_back(entry, value);
  }



  void ParameterInclude::set(const std::string &entry, const double value)
  {
    set(entry, prm_number(value));
  }



  void ParameterInclude::set(const std::string         &entry,
                             const std::vector<double> &values)
  {
    set(entry, list(values));
  }



  void ParameterInclude::set(const std::string                      &entry,
                             const std::vector<std::vector<double>> &rows)
  {
    std::string text = "\\\n";
    for (std::size_t i = 0; i < rows.size(); ++i)
      text += "    " + list(rows[i]) + (i + 1 < rows.size() ? "; \\\n" : "");
    set(entry, text);
  }



  std::string ParameterInclude::text(const std::string &indent) const
  {
    std::string result;
    for (const auto &line : comments)
      result += indent + "# " + line + "\n";
    result += indent + "subsection " + section + "\n";
    for (const auto &[entry, value] : entries)
      result += indent + "  set " + entry + " = " + value + "\n";
    for (const auto &piece : inner)
      result += piece.text(indent + "  ");
    return result + indent + "end\n";
  }



  void ParameterInclude::write(const std::string &file) const
  {
    std::ofstream out(file);
    out << text() << std::flush;
    if (!out)
      throw std::runtime_error("cannot write \"" + file +
                               "\". Is the disk full?");
  }
} // namespace demold
