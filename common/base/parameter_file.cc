// SPDX-License-Identifier: LGPL-2.1-or-later
// A parameter file as a list of statements, each with file and line.
#include "base/parameter_file.h"

#include "base/parameter_error.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace demold
{
  namespace
  {
    namespace fs = std::filesystem;

    /// What the readers of a file and of the files it includes share.
    struct Reading
    {
      std::vector<ParameterStatement> statements;
      std::vector<std::string>        sections;
      std::vector<fs::path>           open_files; // to find circles
    };

    void read(const fs::path    &file,
              const std::string &origin,
              Reading           &reading);



    std::string single_spaced(const std::string &text)
    {
      std::string result;
      for (const char c : trimmed(text))
        if (c != ' ' && c != '\t')
          result += c;
        else if (result.back() != ' ')
          result += ' ';
      return result;
    }



    fs::path included_file(std::string        name,
                           const fs::path    &including,
                           const std::string &origin)
    {
      if (name.size() >= 2 && name.front() == '"' && name.back() == '"')
        name = name.substr(1, name.size() - 2);
      if (name.empty())
        throw ExcParameter(origin, "\"include\" needs the name of a file.");

      const fs::path beside = including.parent_path() / name;
      if (fs::exists(beside))
        return beside;
      if (fs::exists(name))
        return name;
      throw ExcParameter(origin,
                         "the file \"" + name + "\" to include is neither at " +
                           beside.string() + " nor in the working directory.");
    }



    /// The value of an entry whose name ends in "file": a name found beside the
    /// parameter file becomes its path from the working directory.
    std::string file_value(const std::string &name,
                           const std::string &value,
                           const fs::path    &parameter_file)
    {
      const std::string ending = "file";
      const bool        names_file =
        name.size() >= ending.size() &&
        name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
      if (!names_file || value.empty() || fs::path(value).is_absolute())
        return value;
      const fs::path beside = parameter_file.parent_path() / value;
      return fs::exists(beside) ? beside.string() : value;
    }



    /// @p word is the first word of the line, @p rest what follows it.
    void interpret(const std::string &word,
                   const std::string &rest,
                   const fs::path    &file,
                   const std::string &origin,
                   Reading           &reading)
    {
      using Statement = ParameterStatement;
      if (word == "set" || word == "SET")
        {
          const auto equals = rest.find('=');
          if (equals == std::string::npos)
            throw ExcParameter(origin,
                               "\"set " + rest +
                                 "\" lacks \"=\". Write: set name = value");
          auto path = reading.sections;
          path.push_back(single_spaced(rest.substr(0, equals)));
          const std::string value =
            file_value(path.back(), trimmed(rest.substr(equals + 1)), file);
          reading.statements.push_back({Statement::entry, path, value, origin});
        }
      else if (word == "subsection" || word == "SUBSECTION")
        {
          reading.sections.push_back(single_spaced(rest));
          reading.statements.push_back(
            {Statement::section, reading.sections, "", origin});
        }
      else if ((word == "end" || word == "END") && rest.empty())
        {
          if (reading.sections.empty())
            throw ExcParameter(origin, "\"end\" without a \"subsection\".");
          reading.sections.pop_back();
        }
      else if (word == "include" || word == "INCLUDE")
        read(included_file(rest, file, origin), origin, reading);
      else
        throw ExcParameter(origin,
                           "cannot understand \"" + word +
                             (rest.empty() ? "" : " " + rest) +
                             "\". A line starts with set, subsection, end, "
                             "include or #.");
    }



    /// Next line without comment; joins lines that end in '\'. @p number counts
    /// the lines of the file.
    bool next_line(std::istream &in, std::string &line, unsigned int &number)
    {
      line.clear();
      std::string part;
      while (std::getline(in, part))
        {
          if (++number == 1 && part.rfind("\xEF\xBB\xBF", 0) == 0)
            part.erase(0, 3); // byte order mark of some editors
          part = trimmed(part.substr(0, part.find('#')));
          if (part.empty() || part.back() != '\\')
            {
              line += part;
              return true;
            }
          part.pop_back();
          line += part;
        }
      return !line.empty();
    }



    void read(const fs::path &file, const std::string &origin, Reading &reading)
    {
      std::ifstream in(file);
      if (fs::is_directory(file) || !in)
        throw ExcParameter(origin.empty() ? file.string() : origin,
                           "cannot read the parameter file \"" + file.string() +
                             "\"" +
                             (fs::is_directory(file) ? ": it is a folder." :
                              fs::exists(file)       ? "." :
                                                       ": there is none."));

      const fs::path self  = fs::weakly_canonical(file);
      auto          &files = reading.open_files;
      if (std::find(files.begin(), files.end(), self) != files.end())
        throw ExcParameter(origin,
                           "the files include each other in a circle, back to "
                           "\"" +
                             file.string() + "\".");
      files.push_back(self);
      const auto n_sections = reading.sections.size();

      std::string  line;
      unsigned int number = 0;
      std::string  here;
      while (next_line(in, line, number))
        if (!line.empty())
          {
            here             = file.string() + ":" + std::to_string(number);
            const auto space = std::min(line.find_first_of(" \t"), line.size());
            interpret(line.substr(0, space),
                      trimmed(line.substr(space)),
                      file,
                      here,
                      reading);
            if (reading.sections.size() < n_sections)
              throw ExcParameter(here, "\"end\" without a \"subsection\".");
          }

      if (reading.sections.size() != n_sections)
        throw ExcParameter(file.string(),
                           "the subsection \"" + joined_path(reading.sections) +
                             "\" lacks its \"end\".");
      files.pop_back();
    }
  } // namespace



  std::string joined_path(const std::vector<std::string> &path)
  {
    std::string joined;
    for (const auto &part : path)
      joined += (joined.empty() ? "" : "/") + part;
    return joined;
  }



  std::string trimmed(const std::string &text)
  {
    const char *const white = " \t\r\n";
    const auto        first = text.find_first_not_of(white);
    if (first == std::string::npos)
      return "";
    return text.substr(first, text.find_last_not_of(white) - first + 1);
  }



  std::vector<ParameterStatement> read_parameter_file(const std::string &file)
  {
    Reading reading;
    read(file, "", reading);
    return reading.statements;
  }
} // namespace demold
