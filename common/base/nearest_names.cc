// SPDX-License-Identifier: LGPL-2.1-or-later
// What the user may have meant: the known names nearest to a misspelt one.
#include "base/nearest_names.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>

namespace demold
{
  namespace
  {
    std::string lower_case(std::string text)
    {
      std::transform(text.begin(),
                     text.end(),
                     text.begin(),
                     [](const unsigned char c) { return std::tolower(c); });
      return text;
    }

    std::string last_part(const std::string &path)
    {
      return path.substr(path.rfind('/') + 1); // npos + 1 is 0
    }
  } // namespace



  unsigned int edit_distance(const std::string &a, const std::string &b)
  {
    std::vector<unsigned int> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0u);
    for (std::size_t i = 0; i < a.size(); ++i)
      {
        unsigned int diagonal = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j)
          {
            const unsigned int replaced = diagonal + (a[i] != b[j]);
            diagonal                    = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
          }
      }
    return row.back();
  }



  std::vector<std::string> nearest_names(const std::string              &name,
                                         const std::vector<std::string> &known,
                                         const unsigned int              n)
  {
    const std::string wanted = lower_case(name);

    std::vector<std::pair<unsigned int, std::string>> ranking;
    for (const auto &candidate : known)
      {
        const std::string  path  = lower_case(candidate);
        const unsigned int whole = edit_distance(wanted, path);
        const unsigned int last =
          1 + edit_distance(last_part(wanted), last_part(path));
        ranking.emplace_back(std::min(whole, last), candidate);
      }
    std::stable_sort(ranking.begin(),
                     ranking.end(),
                     [](const auto &a, const auto &b) {
                       return a.first < b.first;
                     });

    std::vector<std::string> nearest;
    for (std::size_t i = 0; i < ranking.size() && i < n; ++i)
      nearest.push_back(ranking[i].second);
    return nearest;
  }



  std::string nearest_names_sentence(const std::string              &name,
                                     const std::vector<std::string> &known)
  {
    std::string sentence = "Nearest:";
    for (const auto &candidate : nearest_names(name, known))
      sentence += (sentence.back() == ':' ? " \"" : ", \"") + candidate + "\"";
    return known.empty() ? "There is none at all." : sentence + ".";
  }
} // namespace demold
