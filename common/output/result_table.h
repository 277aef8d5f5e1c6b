// SPDX-License-Identifier: LGPL-2.1-or-later
// history.csv: a row per accepted increment, on disk as soon as it is known.
#ifndef demold_output_result_table_h
#define demold_output_result_table_h

#include <fstream>
#include <string>
#include <variant>
#include <vector>

namespace demold
{
  /// A csv file that grows row by row. Columns are named `name [unit]`; numbers
  /// have 15 significant digits. With an empty file name nothing is written
  /// (all ranks but the first). A full disk throws std::runtime_error.
  class ResultTable
  {
  public:
    using Value = std::variant<double, std::string>;

    /// Starts @p file anew with a row of @p columns.
    ResultTable(const std::string              &file,
                const std::vector<std::string> &columns);

    /// Goes on from a checkpoint: starts @p file with the first @p n_rows rows
    /// of @p previous, unchanged; later rows have been computed after the
    /// checkpoint and will be computed again. The two files may be the same.
    /// Throws ExcParameter if @p previous has other columns or too few rows.
    ResultTable(const std::string              &file,
                const std::vector<std::string> &columns,
                const std::string              &previous,
                const unsigned int              n_rows);

    /// Appends a row with a value per column and flushes it.
    void add_row(const std::vector<Value> &row);

    /// Rows so far, those before the restart included.
    unsigned int n_rows() const;

  private:
    void write_line(const std::string &line);

    std::string   file;
    std::ofstream out;
    std::size_t   n_columns;
    unsigned int  rows = 0;
  };
} // namespace demold

#endif
