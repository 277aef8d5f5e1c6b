// SPDX-License-Identifier: LGPL-2.1-or-later
// What the user may have meant: the known names nearest to a misspelt one.
#ifndef demold_base_nearest_names_h
#define demold_base_nearest_names_h

#include <string>
#include <vector>

namespace demold
{
  /// Levenshtein distance [-]: the smallest number of insertions, deletions
  /// and replacements of one character that turns @p a into @p b.
  unsigned int edit_distance(const std::string &a, const std::string &b);

  /// The @p n names of @p known most like @p name, nearest first. Case does
  /// not count. Names are paths with '/': the right last part in the wrong
  /// section counts as near, so that "strength" finds "Adhesion/strength".
  std::vector<std::string> nearest_names(const std::string              &name,
                                         const std::vector<std::string> &known,
                                         const unsigned int              n = 3);

  /// The same as a sentence: `Nearest: "a", "b", "c".`
  std::string nearest_names_sentence(const std::string              &name,
                                     const std::vector<std::string> &known);
} // namespace demold

#endif
