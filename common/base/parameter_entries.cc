// SPDX-License-Identifier: LGPL-2.1-or-later
// Setting declared entries by path, with messages a user can act on.
#include "base/parameter_entries.h"

#include "base/nearest_names.h"
#include "base/parameter_error.h"
#include "base/parameter_file.h"

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace demold
{
  using namespace dealii;

  namespace
  {
    void collect(const nlohmann::ordered_json &node,
                 std::vector<std::string>     &path,
                 std::vector<ParameterEntry>  &entries)
    {
      for (const auto &[name, child] : node.items())
        if (child.is_object())
          {
            path.push_back(name);
            const auto pattern = child.find("pattern_description");
            if (pattern != child.end() && pattern->is_string())
              entries.push_back({path,
                                 child.at("value").get<std::string>(),
                                 child.at("documentation").get<std::string>(),
                                 pattern->get<std::string>()});
            else
              collect(child, path, entries);
            path.pop_back();
          }
    }



    std::vector<std::string> paths(const std::vector<ParameterEntry> &entries)
    {
      std::vector<std::string> all;
      for (const auto &entry : entries)
        all.push_back(joined_path(entry.path));
      return all;
    }



    std::vector<std::string>
    section_paths(const std::vector<ParameterEntry> &entries)
    {
      std::vector<std::string> all;
      for (const auto &entry : entries)
        for (std::size_t n = 1; n < entry.path.size(); ++n)
          {
            const std::string section =
              joined_path({entry.path.begin(), entry.path.begin() + n});
            if (std::find(all.begin(), all.end(), section) == all.end())
              all.push_back(section);
          }
      return all;
    }



    void set_value(ParameterHandler               &prm,
                   const std::vector<std::string> &path,
                   const std::string              &value)
    {
      for (std::size_t i = 0; i + 1 < path.size(); ++i)
        prm.enter_subsection(path[i]);
      const auto leave = [&]() {
        for (std::size_t i = 0; i + 1 < path.size(); ++i)
          prm.leave_subsection();
      };
      try
        {
          prm.set(path.back(), value);
        }
      catch (...)
        {
          leave();
          throw;
        }
      leave();
    }



    void set_entry(ParameterHandler                  &prm,
                   const std::vector<ParameterEntry> &entries,
                   const std::string                 &path,
                   const std::string                 &value,
                   const std::string                 &origin)
    {
      const auto entry =
        std::find_if(entries.begin(), entries.end(), [&](const auto &e) {
          return joined_path(e.path) == path;
        });
      if (entry == entries.end())
        throw ExcParameter(origin,
                           "there is no entry \"" + path + "\". " +
                             nearest_names_sentence(path, paths(entries)));
      const std::string got = ", got \"" + value + "\".";
      try
        {
          set_value(prm, entry->path, value);
        }
      catch (const ParameterHandler::ExcValueDoesNotMatchPattern &)
        {
          throw ExcParameter(origin + ": " + path,
                             "must be " + pattern_in_words(entry->pattern) +
                               got +
                               (entry->documentation.empty() ?
                                  "" :
                                  " Meaning: " + entry->documentation + "."));
        }
      catch (const ExcParameter &)
        {
          throw;
        }
      catch (const ExceptionBase &error)
        {
          std::ostringstream info;
          error.print_info(info);
          throw ExcParameter(origin + ": " + path,
                             "cannot be used" + got + " " +
                               trimmed(info.str()));
        }
    }



    /// deal.II writes "Adhesion_20law.rupture_20gap" for "Adhesion law/rupture
    /// gap".
    std::string demangled(const std::string &name)
    {
      std::string result;
      for (std::size_t i = 0; i < name.size(); ++i)
        if (name[i] == '.')
          result += '/';
        else if (name[i] == '_' && i + 2 < name.size())
          {
            result +=
              static_cast<char>(std::stoi(name.substr(i + 1, 2), nullptr, 16));
            i += 2;
          }
        else
          result += name[i];
      return result;
    }



    void erase_all(std::string &text, const std::string &part)
    {
      for (auto at = text.find(part); at != std::string::npos;
           at      = text.find(part))
        text.erase(at, part.size());
    }
  } // namespace



  std::vector<ParameterEntry> declared_entries(const ParameterHandler &prm)
  {
    std::ostringstream out;
    prm.print_parameters(out,
                         ParameterHandler::JSON |
                           ParameterHandler::KeepDeclarationOrder);
    std::vector<ParameterEntry> entries;
    std::vector<std::string>    path;
    collect(nlohmann::ordered_json::parse(out.str()), path, entries);
    return entries;
  }



  void use_printed_defaults(ParameterHandler &prm)
  {
    for (const auto &entry : declared_entries(prm))
      if (!entry.value.empty()) // an empty one may be waiting to be set
        set_value(prm, entry.path, entry.value);
  }



  void set_entries(ParameterHandler                      &prm,
                   const std::vector<ParameterStatement> &statements)
  {
    const auto entries  = declared_entries(prm);
    const auto sections = section_paths(entries);
    for (const auto &statement : statements)
      {
        const std::string path = joined_path(statement.path);
        if (statement.kind == ParameterStatement::entry)
          set_entry(prm, entries, path, statement.value, statement.origin);
        else if (std::find(sections.begin(), sections.end(), path) ==
                 sections.end())
          throw ExcParameter(statement.origin,
                             "there is no section \"" + path + "\". " +
                               nearest_names_sentence(path, sections));
      }
  }



  void
  set_entries(ParameterHandler                                       &prm,
              const std::vector<std::pair<std::string, std::string>> &overrides)
  {
    const auto entries = declared_entries(prm);
    for (const auto &[path, value] : overrides)
      set_entry(prm, entries, path, value, "--set");
  }



  void check_mandatory_entries(const ParameterHandler &prm)
  {
    for (const auto &name : prm.get_entries_wrongly_not_set())
      throw ExcParameter(demangled(name),
                         "has no default and must be set in the parameter "
                         "file or with --set.");
  }



  std::string pattern_in_words(const std::string &pattern)
  {
    std::string words;
    try
      {
        words = Patterns::pattern_factory(pattern)->description(
          Patterns::PatternBase::Text);
      }
    catch (const std::exception &)
      {
        return pattern; // a pattern of our own that deal.II cannot rebuild
      }
    erase_all(words, " v such that -MAX_DOUBLE <= v <= MAX_DOUBLE");
    erase_all(words, " n such that -2147483648 <= n <= 2147483647");
    for (const char *const bound : {"-MAX_DOUBLE <= ",
                                    " <= MAX_DOUBLE",
                                    "-2147483648 <= ",
                                    " <= 2147483647",
                                    " of length 0...4294967295 (inclusive)"})
      erase_all(words, bound);
    if (words.size() > 1 && !std::isupper(words[1]))
      words[0] = std::tolower(words[0]);
    return words;
  }



  std::string parameter_text(const ParameterHandler &prm)
  {
    std::ostringstream out;
    prm.print_parameters(out,
                         ParameterHandler::PRM |
                           ParameterHandler::KeepDeclarationOrder);
    return out.str();
  }
} // namespace demold
