// SPDX-License-Identifier: LGPL-2.1-or-later
// Measured data: a CSV file with a header, checked while it is read.
#include "base/data_file.h"

#include "base/parameter_file.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace demold
{
  namespace
  {
    /// The fields of a line; one between double quotes may hold commas.
    std::vector<std::string> split(const std::string &line)
    {
      std::vector<std::string> fields(1);
      bool                     quoted = false;
      for (const char c : line)
        if (c == '"')
          quoted = !quoted;
        else if (c == ',' && !quoted)
          fields.emplace_back();
        else
          fields.back() += c;
      for (auto &field : fields)
        field = trimmed(field);
      return fields;
    }



    std::string in_quotes(const std::vector<std::string> &names)
    {
      std::string text;
      for (const auto &name : names)
        text += (text.empty() ? "\"" : ", \"") + name + "\"";
      return text;
    }



    std::string shown(const double number)
    {
      std::ostringstream text;
      text << number;
      return text.str();
    }



    /// Where in the header the @p required columns stand.
    std::vector<std::size_t> places(const DataFile                &data,
                                    const std::vector<DataColumn> &required,
                                    const unsigned int             line)
    {
      std::vector<std::size_t> result;
      for (const auto &column : required)
        {
          const auto place =
            std::find(data.header.begin(), data.header.end(), column.name);
          if (place == data.header.end())
            throw ExcDataFile(data.file,
                              line,
                              "the header needs the column \"" + column.name +
                                "\", unit included; it has " +
                                in_quotes(data.header) + ".");
          result.push_back(place - data.header.begin());
        }
      return result;
    }



    /// @p text as a finite number that obeys the column's rule.
    double number(const DataFile    &data,
                  const unsigned int line,
                  const DataColumn  &column,
                  const std::string &text,
                  const double      *previous)
    {
      char        *end    = nullptr;
      const double value  = std::strtod(text.c_str(), &end);
      const auto   reject = [&](const std::string &rule) {
        throw ExcDataFile(data.file,
                          line,
                          "\"" + column.name + "\" must " + rule + "; got \"" +
                            text + "\".");
      };
      if (text.empty() || *end != '\0')
        reject("be a number, with a decimal point and without a unit");
      if (!std::isfinite(value))
        reject("be a finite number");
      if (column.rule == DataColumn::positive && !(value > 0.))
        reject("be positive");
      if (column.rule == DataColumn::nonnegative && value < 0.)
        reject("not be negative");
      if (column.rule == DataColumn::increasing && value < 0.)
        reject("not be negative");
      if (column.rule == DataColumn::increasing && previous != nullptr &&
          !(value > *previous))
        reject("increase from row to row and exceed " + shown(*previous) +
               " in the row before");
      return value;
    }



    void add_row(DataFile                       &data,
                 const unsigned int              line,
                 const std::vector<std::string> &fields,
                 const std::vector<DataColumn>  &required,
                 const std::vector<std::size_t> &where)
    {
      if (fields.size() != data.header.size())
        throw ExcDataFile(data.file,
                          line,
                          "every row needs a field for each of the " +
                            std::to_string(data.header.size()) +
                            " columns; this one has " +
                            std::to_string(fields.size()) + ".");
      for (unsigned int i = 0; i < required.size(); ++i)
        {
          auto &column = data.columns[i];
          column.push_back(number(data,
                                  line,
                                  required[i],
                                  fields[where[i]],
                                  column.empty() ? nullptr : &column.back()));
        }
      data.lines.push_back(line);
    }
  } // namespace



  ExcDataFile::ExcDataFile(const std::string &file,
                           const unsigned int line,
                           const std::string &explanation)
    : ExcParameter(file + ":" + std::to_string(line), explanation)
    , file(file)
    , line(line)
  {}



  DataFile read_data_file(const std::string             &file,
                          const std::vector<DataColumn> &required,
                          const unsigned int             n_rows_min)
  {
    std::ifstream in(file);
    if (!in || std::filesystem::is_directory(file))
      throw ExcDataFile(file, 1, "cannot read this data file.");

    DataFile data;
    data.file = file;
    data.columns.resize(required.size());
    std::vector<std::size_t> where;
    std::string              line;
    unsigned int             n = 0;
    while (std::getline(in, line))
      {
        ++n;
        if (n == 1 && line.compare(0, 3, "\xEF\xBB\xBF") == 0)
          line.erase(0, 3); // the mark some spreadsheets put in front
        line = trimmed(line);
        if (line.empty())
          continue;
        if (line[0] == '#')
          data.source.push_back(trimmed(line.substr(1)));
        else if (data.header.empty())
          {
            data.header = split(line);
            where       = places(data, required, n);
          }
        else
          add_row(data, n, split(line), required, where);
      }
    if (data.header.empty())
      throw ExcDataFile(file, std::max(n, 1u), "the file holds no data.");
    if (data.n_rows() < n_rows_min)
      throw ExcDataFile(file,
                        n,
                        "needs at least " + std::to_string(n_rows_min) +
                          " rows of numbers; got " +
                          std::to_string(data.n_rows()) + ".");
    return data;
  }
} // namespace demold
