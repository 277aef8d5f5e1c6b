// SPDX-License-Identifier: LGPL-2.1-or-later
// Columns of a csv table that a run has left behind.
#include "study/csv_columns.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>

namespace demold
{
  namespace
  {
    std::vector<std::string> cells(const std::string &line)
    {
      std::vector<std::string> list(1);
      bool                     quoted = false;
      for (const char c : line)
        if (c == '"')
          quoted = !quoted;
        else if (c == ',' && !quoted)
          list.emplace_back();
        else if (c != '\r')
          list.back() += c;
      return list;
    }



    double number_in(const std::string &cell)
    {
      char        *end   = nullptr;
      const double value = std::strtod(cell.c_str(), &end);
      return end != cell.c_str() && *end == '\0' ?
               value :
               std::numeric_limits<double>::quiet_NaN();
    }
  } // namespace



  CsvText::CsvText(const std::string &file)
  {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
      if (line.empty() || line[0] == '#')
        continue;
      else if (header.empty())
        header = cells(line);
      else if (const auto row = cells(line); row.size() == header.size())
        rows.push_back(row);
  }



  bool CsvText::has(const std::string &column) const
  {
    return std::find(header.begin(), header.end(), column) != header.end();
  }



  std::vector<double> CsvText::numbers(const std::string &column) const
  {
    const auto place =
      std::find(header.begin(), header.end(), column) - header.begin();
    std::vector<double> list;
    for (const auto &row : rows)
      list.push_back(number_in(row[place]));
    return list;
  }



  double value_at(const std::vector<double> &x,
                  const std::vector<double> &y,
                  const double               place)
  {
    for (std::size_t i = 0; i < x.size(); ++i)
      {
        if (x[i] == place)
          return y[i];
        if (i > 0 && (x[i - 1] - place) * (x[i] - place) < 0.)
          return y[i - 1] +
                 (y[i] - y[i - 1]) * (place - x[i - 1]) / (x[i] - x[i - 1]);
      }
    return std::numeric_limits<double>::quiet_NaN();
  }
} // namespace demold
