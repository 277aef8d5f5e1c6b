// SPDX-License-Identifier: LGPL-2.1-or-later
// summary.json: what came out, as one flat list of names and values.
#ifndef demold_output_summary_h
#define demold_output_summary_h

#include <iosfwd>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace demold
{
  /// An ordered list of keys, which carry their units (`peak force [N]`), and
  /// values.
  class Summary
  {
  public:
    using Value = std::variant<double, long long, std::string>;

    /// Adds @p key at the end, or replaces its value where it stands.
    void set(const std::string &key, const double value);
    void set(const std::string &key, const int value);
    void set(const std::string &key, const unsigned int value);
    void set(const std::string &key, const long long value);
    void set(const std::string &key, const unsigned long value);
    void set(const std::string &key, const char *value);
    void set(const std::string &key, const std::string &value);

    const std::vector<std::pair<std::string, Value>> &entries() const;

    /// Writes @p file in one go: a reader finds the old file or the new one,
    /// never half of one. Numbers keep all their digits; NaN and infinity,
    /// which json does not know, become null. Throws std::runtime_error when
    /// the disk is full.
    void write(const std::string &file) const;

    /// The list as a table for the console, six digits.
    void print(std::ostream &out) const;

  private:
    void put(const std::string &key, Value value);

    std::vector<std::pair<std::string, Value>> list;
  };
} // namespace demold

#endif
