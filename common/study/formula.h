// SPDX-License-Identifier: LGPL-2.1-or-later
// A closed form in the entries a study sweeps.
#ifndef demold_study_formula_h
#define demold_study_formula_h

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace demold
{
  /// Names and numbers a formula may use.
  using Symbols = std::map<std::string, double>;

  /// May @p text be used as a name in a formula?
  bool is_symbol(const std::string &text);

  /// The value of @p formula with the functions of muParser (sin, exp, sqrt,
  /// if(a, b, c) ...), pi and @p symbols. NaN if it is not defined there.
  /// Throws ExcParameter with @p path if it cannot be understood.
  double evaluate_formula(const std::string &formula,
                          const Symbols     &symbols,
                          const std::string &path);

  /// "a = 1; b = 2*a" as (name, formula). Throws ExcParameter with @p path.
  std::vector<std::pair<std::string, std::string>>
  read_definitions(const std::string &definitions, const std::string &path);

  /// @p symbols and those of @p definitions, each of which may use all before
  /// it. Throws ExcParameter with @p path.
  Symbols with_definitions(Symbols            symbols,
                           const std::string &definitions,
                           const std::string &path);
} // namespace demold

#endif
