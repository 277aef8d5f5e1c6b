// SPDX-License-Identifier: LGPL-2.1-or-later
// history.csv: a row per accepted increment, on disk as soon as it is known.
#include "output/result_table.h"

#include "base/parameter_error.h"

#include <deal.II/base/exceptions.h>

#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace demold
{
  namespace
  {
    /// Quoted when a comma, quote or line break would be misread.
    std::string csv_text(const std::string &text)
    {
      if (text.find_first_of(",\"\r\n") == std::string::npos)
        return text;
      std::string quoted = "\"";
      for (const char c : text)
        quoted += (c == '"' ? std::string("\"\"") : std::string(1, c));
      return quoted + "\"";
    }



    std::string csv_line(const std::vector<ResultTable::Value> &row)
    {
      std::ostringstream line;
      line.precision(15);
      for (std::size_t i = 0; i < row.size(); ++i)
        {
          line << (i == 0 ? "" : ",");
          if (const double *number = std::get_if<double>(&row[i]))
            line << *number;
          else
            line << csv_text(std::get<std::string>(row[i]));
        }
      return line.str();
    }



    std::string csv_header(const std::vector<std::string> &columns)
    {
      return csv_line({columns.begin(), columns.end()});
    }



    /// The header and the first @p n_rows rows. A last line without its line
    /// break was cut off while being written and does not count.
    std::vector<std::string> first_lines(const std::string &file,
                                         const std::string &header,
                                         const unsigned int n_rows)
    {
      std::ifstream            in(file);
      std::vector<std::string> lines;
      std::string              line;
      while (lines.size() <= n_rows && std::getline(in, line) && !in.eof())
        lines.push_back(line);
      if (lines.empty() || lines[0] != header)
        throw ExcParameter("--restart",
                           "\"" + file +
                             "\" is missing or has other columns than this "
                             "run would write.");
      if (lines.size() <= n_rows)
        throw ExcParameter("--restart",
                           "the checkpoint belongs to row " +
                             std::to_string(n_rows) + " of \"" + file +
                             "\", which has only " +
                             std::to_string(lines.size() - 1) + ".");
      return lines;
    }
  } // namespace



  ResultTable::ResultTable(const std::string              &file,
                           const std::vector<std::string> &columns)
    : file(file)
    , n_columns(columns.size())
  {
    if (!file.empty())
      {
        out.open(file);
        write_line(csv_header(columns));
      }
  }



  ResultTable::ResultTable(const std::string              &file,
                           const std::vector<std::string> &columns,
                           const std::string              &previous,
                           const unsigned int              n_rows)
    : file(file)
    , n_columns(columns.size())
    , rows(n_rows)
  {
    if (file.empty())
      return;
    const auto lines = first_lines(previous, csv_header(columns), n_rows);

    // Beside the old file first: a crash here must not lose the history.
    const std::string fresh = file + ".new";
    out.open(fresh);
    for (const auto &line : lines)
      write_line(line);
    out.close();
    std::filesystem::rename(fresh, file);
    out.open(file, std::ios::app);
  }



  void ResultTable::write_line(const std::string &line)
  {
    out << line << '\n' << std::flush;
    if (!out)
      throw std::runtime_error("cannot write to \"" + file +
                               "\". Is the disk full?");
  }



  void ResultTable::add_row(const std::vector<Value> &row)
  {
    AssertThrow(row.size() == n_columns,
                dealii::ExcDimensionMismatch(row.size(), n_columns));
    if (!file.empty())
      write_line(csv_line(row));
    ++rows;
  }



  unsigned int ResultTable::n_rows() const
  {
    return rows;
  }
} // namespace demold
