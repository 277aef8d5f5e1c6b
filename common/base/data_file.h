// SPDX-License-Identifier: LGPL-2.1-or-later
// Measured data: a CSV file with a header, checked while it is read.
#ifndef demold_base_data_file_h
#define demold_base_data_file_h

#include "base/parameter_error.h"

#include <string>
#include <utility>
#include <vector>

namespace demold
{
  /// A data file that cannot be used; bad input, as a wrong entry is (exit code
  /// 2, one message). The message begins with "file:line".
  struct ExcDataFile : ExcParameter
  {
    ExcDataFile(const std::string &file,
                unsigned int       line,
                const std::string &explanation);

    std::string  file;
    unsigned int line; ///< first line: 1
  };

  /// A column a reader needs, and what its numbers must obey.
  struct DataColumn
  {
    enum Rule
    {
      any,         ///< finite
      nonnegative, ///< >= 0
      positive,    ///< > 0
      increasing   ///< >= 0 and larger than in the row before: a time
    };

    std::string name; ///< with its unit, as in the header: "time [s]"
    Rule        rule = any;
  };

  /// What a file says. Lines that begin with `#` are kept as its source; the
  /// first other line is the header; numbers are separated by commas.
  struct DataFile
  {
    std::string                      file;
    std::vector<std::string>         source;  ///< comments, without `#`
    std::vector<std::string>         header;  ///< names of all columns
    std::vector<std::vector<double>> columns; ///< those asked for, in order
    std::vector<unsigned int>        lines;   ///< where each row stands

    unsigned int n_rows() const
    {
      return lines.size();
    }
  };

  /// Reads the columns @p required of @p file; the others may hold anything.
  /// Throws ExcDataFile with file and line for a missing column, a row of the
  /// wrong length, what is no finite number, a number against its rule, and
  /// fewer than @p n_rows_min rows.
  DataFile read_data_file(const std::string             &file,
                          const std::vector<DataColumn> &required,
                          unsigned int                   n_rows_min = 2);
} // namespace demold

#endif
