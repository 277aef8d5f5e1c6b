// SPDX-License-Identifier: LGPL-2.1-or-later
// Columns of a csv table that a run has left behind.
#ifndef demold_study_csv_columns_h
#define demold_study_csv_columns_h

#include <string>
#include <vector>

namespace demold
{
  /// Names of the columns and all cells as text, row by row.
  struct CsvText
  {
    std::vector<std::string>              header;
    std::vector<std::vector<std::string>> rows; ///< as long as the header

    /// Reads @p file; empty if there is none. A row cut off is left out.
    explicit CsvText(const std::string &file);

    bool has(const std::string &column) const;

    /// Numbers of a column that exists; NaN for words.
    std::vector<double> numbers(const std::string &column) const;
  };

  /// Value of @p y where @p x first reaches @p place, linear between rows; NaN
  /// if it never does.
  double value_at(const std::vector<double> &x,
                  const std::vector<double> &y,
                  const double               place);
} // namespace demold

#endif
