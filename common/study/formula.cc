// SPDX-License-Identifier: LGPL-2.1-or-later
// A closed form in the entries a study sweeps.
#include "study/formula.h"

#include "base/parameter_error.h"
#include "base/parameter_file.h"
#include "study/sweep.h"

#include <deal.II/base/function_parser.h>

#include <cctype>
#include <iostream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    /// deal.II prints what its parser has to say before it throws; the user is
    /// to see one message, ours.
    struct SilentErrors
    {
      SilentErrors()
        : kept(std::cerr.rdbuf(nullptr))
      {}

      ~SilentErrors()
      {
        std::cerr.rdbuf(kept);
      }

      std::streambuf *kept;
    };
  } // namespace



  bool is_symbol(const std::string &text)
  {
    if (text.empty() || std::isdigit(static_cast<unsigned char>(text[0])))
      return false;
    for (const char c : text)
      if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_')
        return false;
    return true;
  }



  double evaluate_formula(const std::string &formula,
                          const Symbols     &symbols,
                          const std::string &path)
  {
    Symbols     constants = symbols;
    std::string names;
    for (const auto &symbol : symbols)
      names += (names.empty() ? "" : ", ") + symbol.first;
    constants["pi"] = numbers::PI;
    try
      {
        const SilentErrors silent;
        // All names are constants here; the parser insists on one variable.
        FunctionParser<1> function;
        function.initialize("unused_variable", formula, constants);
        return function.value(Point<1>());
      }
    catch (const std::exception &)
      {
        throw ExcParameter(path,
                           "must be a number or a formula in " +
                             (names.empty() ? "pi" : names + " and pi") +
                             "; got \"" + formula + "\".");
      }
  }



  std::vector<std::pair<std::string, std::string>>
  read_definitions(const std::string &definitions, const std::string &path)
  {
    std::vector<std::pair<std::string, std::string>> list;
    for (const auto &definition : split_list(definitions, ';'))
      {
        const auto        equals = definition.find('=');
        const std::string name   = trimmed(definition.substr(0, equals));
        if (equals == std::string::npos || !is_symbol(name))
          throw ExcParameter(path,
                             "must be a list such as \"a = 1; b = 2*a\"; got "
                             "\"" +
                               definition + "\".");
        list.emplace_back(name, trimmed(definition.substr(equals + 1)));
      }
    return list;
  }



  Symbols with_definitions(Symbols            symbols,
                           const std::string &definitions,
                           const std::string &path)
  {
    for (const auto &[name, formula] : read_definitions(definitions, path))
      {
        const double value = evaluate_formula(formula, symbols, path);
        if (!symbols.emplace(name, value).second)
          throw ExcParameter(path,
                             "\"" + name +
                               "\" is the name of a sweep or has been defined "
                               "already. Choose another one.");
      }
    return symbols;
  }
} // namespace demold
