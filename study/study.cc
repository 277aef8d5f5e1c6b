// SPDX-License-Identifier: LGPL-2.1-or-later
//
// # study: what does accuracy cost?
//
// Sample run:
//   study prm/studies/hertz.prm
//
// Sweeps entries of a scene, runs its step once for each combination, compares
// a number each run leaves behind with a closed form, a value or the finest
// run, and writes study.csv, study.md and a picture of error over CPU time.

#include "study/study.h"

#include <deal.II/base/exceptions.h>

#include <filesystem>

int main(int argc, char **argv)
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  dealii::deal_II_exceptions::suppress_stacktrace_in_exceptions();

  // The steps stand beside this program: build/study/study,
  // build/step-x/step-x.
  const auto build =
    std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path();
  return demold::run_study({argv + 1, argv + argc}, build.string());
}
