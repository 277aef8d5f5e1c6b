// SPDX-License-Identifier: LGPL-2.1-or-later
// The values one entry of a scene takes, and all runs several entries make.
#include "study/sweep.h"

#include "base/parameter_error.h"
#include "base/parameter_file.h"

#include <deal.II/base/parameter_handler.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <sstream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    std::string number_text(const double value)
    {
      std::ostringstream text;
      text << value; // six digits, as in a printed parameter file
      return text.str();
    }



    /// Values of some sweeps: position of the sweep, value.
    using Row = std::map<std::size_t, std::string>;

    /// What an unpaired sweep and those paired with it take, one after another.
    std::vector<Row> rows_of(const std::vector<Sweep> &sweeps,
                             const std::size_t         lead)
    {
      const auto       values = sweeps[lead].values();
      std::vector<Row> rows(values.size());
      for (std::size_t v = 0; v < values.size(); ++v)
        rows[v][lead] = values[v];

      std::string companions;
      for (std::size_t p = 0; p < sweeps.size(); ++p)
        if (sweeps[p].paired_with > 0 &&
            sweeps[lead].section ==
              "Sweep " + std::to_string(sweeps[p].paired_with))
          {
            const auto partners = sweeps[p].values();
            if (partners.size() != values.size())
              throw ExcParameter(sweeps[p].section + "/values",
                                 "must be as many as those of " +
                                   sweeps[lead].section + ", which are " +
                                   std::to_string(values.size()) + "; got " +
                                   std::to_string(partners.size()) + ".");
            for (std::size_t v = 0; v < values.size(); ++v)
              rows[v][p] = partners[v];
            companions +=
              (companions.empty() ? ", each time with the same of " : " and ") +
              sweeps[p].section;
          }

      std::set<Row> seen;
      for (const Row &row : rows)
        if (!seen.insert(row).second)
          throw ExcParameter(sweeps[lead].section + "/values",
                             "must make runs that differ; got \"" +
                               row.at(lead) + "\" twice" + companions + ".");
      return rows;
    }
  } // namespace



  std::vector<std::string> split_list(const std::string &list,
                                      const char         separator)
  {
    std::vector<std::string> parts;
    std::istringstream       in(list);
    for (std::string part; std::getline(in, part, separator);)
      if (!trimmed(part).empty())
        parts.push_back(trimmed(part));
    return parts;
  }



  double first_number(const std::string &text)
  {
    const char  *begin = text.c_str();
    char        *end   = nullptr;
    const double value = std::strtod(begin, &end);
    const bool   ends  = *end == '\0' || *end == ',' || *end == ' ';
    return end != begin && ends ? value :
                                  std::numeric_limits<double>::quiet_NaN();
  }



  void Sweep::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("entry",
                      entry,
                      "full path of the entry of the scene, such as Body/fine "
                      "size; empty: this sweep is not used");
    prm.add_parameter("values",
                      list,
                      "its values, separated by commas; by semicolons where a "
                      "value contains commas, as in 2, 8; 4, 16. Empty: from, "
                      "to, number and scale make them");
    prm.add_parameter("from", from, "first value of a range");
    prm.add_parameter("to", to, "last value of a range");
    prm.add_parameter("number",
                      number,
                      "of values in a range",
                      Patterns::Integer(0, 1000));
    prm.add_parameter("scale",
                      scale,
                      "steps of a range: equal differences or equal ratios",
                      Patterns::Selection("linear|logarithmic"));
    prm.add_parameter("label",
                      label,
                      "heading of the column; empty: the name of the entry");
    prm.add_parameter("symbol",
                      symbol,
                      "name in formulas, where a value such as 2, 8 counts by "
                      "its first number; empty: the label with _ for blanks");
    prm.add_parameter("paired with",
                      paired_with,
                      "number of the sweep whose values these accompany one by "
                      "one; 0: all combinations are run",
                      Patterns::Integer(0, 4));
  }



  void Sweep::check() const
  {
    if (list.empty() && number == 0)
      throw ExcParameter(section + "/values",
                         "needs at least one value for \"" + entry +
                           "\". Give a list, or from, to and number.");
    if (!list.empty() && number > 0)
      throw ExcParameter(section + "/number",
                         "must be 0 beside a list of values; got " +
                           std::to_string(number) + ". Take one of the two.");
    if (list.empty() && number > 1 && from == to)
      throw ExcParameter(section + "/to",
                         "must differ from " + section +
                           "/from = " + number_text(from) + " for " +
                           std::to_string(number) + " values; got " +
                           number_text(to) + ".");
    if (list.empty() && scale == "logarithmic" && (from <= 0. || to <= 0.))
      throw ExcParameter(section + "/scale",
                         "logarithmic needs from and to greater than 0; got " +
                           number_text(from) + " and " + number_text(to) +
                           ". Take linear.");
    if (list.find('#') != std::string::npos)
      throw ExcParameter(section + "/values", "cannot contain \"#\".");

    if (values().empty())
      throw ExcParameter(section + "/values",
                         "needs at least one value; got \"" + list + "\".");
  }



  bool Sweep::is_used() const
  {
    return !entry.empty();
  }



  std::string Sweep::heading() const
  {
    if (!label.empty())
      return label;
    const auto slash = entry.rfind('/');
    return slash == std::string::npos ? entry : entry.substr(slash + 1);
  }



  std::string Sweep::name_in_formulas() const
  {
    if (!symbol.empty())
      return symbol;
    std::string name = trimmed(heading().substr(0, heading().find('[')));
    for (char &c : name)
      if (!std::isalnum(static_cast<unsigned char>(c)))
        c = '_';
    return name;
  }



  std::vector<std::string> Sweep::values() const
  {
    if (!list.empty())
      return split_list(list, list.find(';') == std::string::npos ? ',' : ';');
    std::vector<std::string> range;
    for (unsigned int i = 0; i < number; ++i)
      {
        const double share = number > 1 ? i / (number - 1.) : 0.;
        range.push_back(number_text(scale == "linear" ?
                                      from + share * (to - from) :
                                      from * std::pow(to / from, share)));
      }
    return range;
  }



  std::vector<Combination> combinations(const std::vector<Sweep> &sweeps)
  {
    std::vector<Combination> list = {Combination(sweeps.size())};
    for (std::size_t s = 0; s < sweeps.size(); ++s)
      if (sweeps[s].paired_with == 0)
        {
          std::vector<Combination> longer;
          const auto               rows = rows_of(sweeps, s);
          for (auto combination : list)
            for (const Row &row : rows)
              {
                for (const auto &[position, value] : row)
                  combination[position] = value;
                longer.push_back(combination);
              }
          list = longer;
        }
    return list;
  }



  std::string combination_text(const std::vector<Sweep> &sweeps,
                               const Combination        &values)
  {
    std::string text;
    for (std::size_t s = 0; s < sweeps.size(); ++s)
      text += (s == 0 ? "" : ", ") + sweeps[s].heading() + " = " + values[s];
    return text;
  }
} // namespace demold
