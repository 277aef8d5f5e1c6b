// SPDX-License-Identifier: LGPL-2.1-or-later
// Setting declared entries by path, with messages a user can act on.
#ifndef demold_base_parameter_entries_h
#define demold_base_parameter_entries_h

#include <string>
#include <utility>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace demold
{
  struct ParameterStatement;

  /// An entry some piece has declared.
  struct ParameterEntry
  {
    std::vector<std::string> path;          ///< sections, then the name
    std::string              value;         ///< now
    std::string              documentation; ///< "symbol meaning [unit]"
    std::string              pattern;       ///< deal.II's description
  };

  /// All entries of @p prm in the order of their declaration.
  std::vector<ParameterEntry>
  declared_entries(const dealii::ParameterHandler &prm);

  /// Sets every default by its printed text. deal.II prints numbers with six
  /// digits; a default with more would make a printed file, read again, mean
  /// something else.
  void use_printed_defaults(dealii::ParameterHandler &prm);

  /// Carries out @p statements. Throws ExcParameter for unknown names, wrong
  /// types and values out of bounds.
  void set_entries(dealii::ParameterHandler              &prm,
                   const std::vector<ParameterStatement> &statements);

  /// Carries out `--set "Section/Sub/entry=value"`, given as (path, value).
  void set_entries(
    dealii::ParameterHandler                               &prm,
    const std::vector<std::pair<std::string, std::string>> &overrides);

  /// Throws ExcParameter when an entry without default has not been given.
  void check_mandatory_entries(const dealii::ParameterHandler &prm);

  /// What deal.II's @p pattern allows, in words: "a floating point number v
  /// such that 0 <= v".
  std::string pattern_in_words(const std::string &pattern);

  /// All entries as prm text with documentation, in the order of declaration.
  /// Values given by the user appear as they wrote them.
  std::string parameter_text(const dealii::ParameterHandler &prm);
} // namespace demold

#endif
