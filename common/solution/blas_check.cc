// SPDX-License-Identifier: LGPL-2.1-or-later
// Whether the slow reference BLAS is what the direct solvers run on.
#include "solution/blas_check.h"

#include <dlfcn.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <memory>

namespace demold
{
  std::string blas_library()
  {
    // The dynamic linker binds all callers to the first dgemm_ in its global
    // order; that a tuned library is loaded somewhere says nothing.
    void *const function = dlsym(RTLD_DEFAULT, "dgemm_");
    Dl_info     info;
    if (function == nullptr || dladdr(function, &info) == 0 ||
        info.dli_fname == nullptr)
      return "";
    const std::unique_ptr<char, decltype(&std::free)> path(
      realpath(info.dli_fname, nullptr),
      &std::free);
    return path ? path.get() : info.dli_fname;
  }


  bool is_reference_blas(const std::string &library)
  {
    std::string name = library;
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) {
      return static_cast<char>(std::tolower(c));
    });
    for (const char *tuned :
         {"openblas", "mkl", "blis", "atlas", "flexiblas", "armpl", "nvpl"})
      if (name.find(tuned) != std::string::npos)
        return false;
    return !name.empty();
  }


  bool on_reference_blas()
  {
    return is_reference_blas(blas_library());
  }


  std::string blas_advice()
  {
    return "This run uses the reference BLAS (" + blas_library() +
           "): direct solutions take 5 to 6 times as long as with OpenBLAS. "
           "Install it with: sudo apt-get install libopenblas0";
  }
} // namespace demold
