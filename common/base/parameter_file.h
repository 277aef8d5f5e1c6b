// SPDX-License-Identifier: LGPL-2.1-or-later
// A parameter file as a list of statements, each with file and line.
#ifndef demold_base_parameter_file_h
#define demold_base_parameter_file_h

#include <string>
#include <vector>

namespace demold
{
  /// One `set` or `subsection` line.
  struct ParameterStatement
  {
    enum Kind
    {
      entry,
      section
    };

    Kind                     kind = entry;
    std::vector<std::string> path;   ///< sections, then the name
    std::string              value;  ///< as written, entries only
    std::string              origin; ///< "file:line", for messages
  };

  /// "Section/Sub/entry".
  std::string joined_path(const std::vector<std::string> &path);

  /// @p text without white space at both ends.
  std::string trimmed(const std::string &text);

  /// Reads @p file in deal.II's prm syntax: `set name = value`, `subsection
  /// name`, `end`, `include FILE`, comments from `#` on, and `\` at the end of
  /// a line that goes on in the next. deal.II itself looks for included files
  /// in the working directory only; here FILE is sought beside the including
  /// file first, and so is the value of an entry whose name ends in "file".
  /// Statements come in the order in which they take effect.
  /// Throws ExcParameter with file and line for what cannot be understood.
  std::vector<ParameterStatement> read_parameter_file(const std::string &file);
} // namespace demold

#endif
