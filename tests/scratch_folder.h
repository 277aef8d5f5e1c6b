// SPDX-License-Identifier: LGPL-2.1-or-later
// A folder for one test, gone with it.
#ifndef demold_tests_scratch_folder_h
#define demold_tests_scratch_folder_h

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace demold
{
  struct ScratchFolder
  {
    /// A name with blanks, which every file name of ours must survive.
    ScratchFolder()
    {
      std::string name =
        (std::filesystem::temp_directory_path() / "demold test XXXXXX")
          .string();
      if (mkdtemp(name.data()) == nullptr)
        throw std::runtime_error("no temporary folder");
      path = name;
    }

    ScratchFolder(const ScratchFolder &)            = delete;
    ScratchFolder &operator=(const ScratchFolder &) = delete;

    ~ScratchFolder()
    {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }

    std::string operator/(const std::string &name) const
    {
      return (path / name).string();
    }

    /// Writes a file, with the folders it needs, and returns its full name.
    std::string write(const std::string &name, const std::string &text) const
    {
      std::filesystem::create_directories((path / name).parent_path());
      std::ofstream(path / name) << text;
      return *this / name;
    }

    std::string read(const std::string &name) const
    {
      std::ostringstream text;
      text << std::ifstream(path / name).rdbuf();
      return text.str();
    }

    std::filesystem::path path;
  };



  /// The message of the exception @p Exception that @p action throws; empty if
  /// it throws none.
  template <class Exception, class Action>
  std::string message_of(const Action &action)
  {
    try
      {
        action();
      }
    catch (const Exception &error)
      {
        return error.what();
      }
    return "";
  }



  inline bool contains(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }
} // namespace demold

#endif
