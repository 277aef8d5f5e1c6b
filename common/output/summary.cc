// SPDX-License-Identifier: LGPL-2.1-or-later
// summary.json: what came out, as one flat list of names and values.
#include "output/summary.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <stdexcept>

namespace demold
{
  void Summary::put(const std::string &key, Value value)
  {
    for (auto &entry : list)
      if (entry.first == key)
        {
          entry.second = std::move(value);
          return;
        }
    list.emplace_back(key, std::move(value));
  }



  void Summary::set(const std::string &key, const double value)
  {
    put(key, value);
  }



  void Summary::set(const std::string &key, const int value)
  {
    put(key, static_cast<long long>(value));
  }



  void Summary::set(const std::string &key, const unsigned int value)
  {
    put(key, static_cast<long long>(value));
  }



  void Summary::set(const std::string &key, const long long value)
  {
    put(key, value);
  }



  void Summary::set(const std::string &key, const unsigned long value)
  {
    put(key, static_cast<long long>(value));
  }



  void Summary::set(const std::string &key, const char *value)
  {
    put(key, std::string(value));
  }



  void Summary::set(const std::string &key, const std::string &value)
  {
    put(key, value);
  }



  const std::vector<std::pair<std::string, Summary::Value>> &
  Summary::entries() const
  {
    return list;
  }



  void Summary::write(const std::string &file) const
  {
    using json  = nlohmann::ordered_json;
    json object = json::object();
    for (const auto &[key, value] : list)
      std::visit([&object, &name = key](const auto &v) { object[name] = v; },
                 value);

    const std::string fresh = file + ".new";
    std::ofstream     out(fresh);
    out << object.dump(2, ' ', false, json::error_handler_t::replace) << '\n'
        << std::flush;
    if (!out)
      throw std::runtime_error("cannot write \"" + fresh +
                               "\". Is the disk full?");
    out.close();
    std::filesystem::rename(fresh, file);
  }



  void Summary::print(std::ostream &out) const
  {
    std::size_t width = 0;
    for (const auto &entry : list)
      width = std::max(width, entry.first.size());
    std::ostringstream text; // leaves the precision of `out` alone
    for (const auto &[key, value] : list)
      {
        text << "  " << std::left << std::setw(width + 2) << key;
        std::visit([&text](const auto &v) { text << v; }, value);
        text << '\n';
      }
    out << text.str() << std::flush;
  }
} // namespace demold
