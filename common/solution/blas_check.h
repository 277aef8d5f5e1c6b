// SPDX-License-Identifier: LGPL-2.1-or-later
// Whether the slow reference BLAS is what the direct solvers run on.
#ifndef demold_solution_blas_check_h
#define demold_solution_blas_check_h

#include <string>

namespace demold
{
  /// Path of the library that matrix products (dgemm) of this process come
  /// from, symbolic links resolved; empty if it cannot be found.
  std::string blas_library();

  /// Whether @p library (as from blas_library()) is a plain reference BLAS,
  /// that is, named after none of the tuned ones. False if empty.
  bool is_reference_blas(const std::string &library);

  /// The two above together. A direct solution takes 5 to 6 times as long on
  /// the reference BLAS.
  bool on_reference_blas();

  /// What a user should know and install then; one line for the console.
  std::string blas_advice();
} // namespace demold

#endif
