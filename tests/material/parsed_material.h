// SPDX-License-Identifier: LGPL-2.1-or-later
// Section Material from a few lines, and what it complains of.
#ifndef demold_tests_material_parsed_material_h
#define demold_tests_material_parsed_material_h

#include "base/parameter_error.h"

#include "material/rubber_model.h"

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace demold
{
  inline RubberModel parsed(const std::string &entries)
  {
    dealii::ParameterHandler prm;
    RubberModel              model;
    model.add_parameters(prm);
    prm.parse_input_from_string("subsection Material\n" + entries + "\nend\n");
    return model;
  }

  /// The message of check(), or nothing.
  inline std::string complaint(const std::string &entries)
  {
    try
      {
        parsed(entries).check();
      }
    catch (const ExcParameter &error)
      {
        return error.what();
      }
    return "";
  }

  inline void expect_words(const std::string              &message,
                           const std::vector<std::string> &words)
  {
    for (const std::string &word : words)
      EXPECT_NE(message.find(word), std::string::npos)
        << '"' << word << "\" in \"" << message << '"';
  }

  /// Four levels of cure and two branches.
  inline const std::string tables =
    "set relaxation times = 0.1, 1\n"
    "set table f90 = 0.5, 0.6, 0.8, 1.0\n"
    "set table equilibrium modulus = 1.2, 1.5, 2.4, 3.0\n"
    "set table branch moduli = 4, 1; 3.5, .9; 3, .6; 2.8, .5\n";
} // namespace demold

#endif
