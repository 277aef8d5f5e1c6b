// SPDX-License-Identifier: LGPL-2.1-or-later
// A run knows whether it is on the slow BLAS.
#include "solution/blas_check.h"

#include <gtest/gtest.h>

namespace demold
{
  TEST(BlasCheck, tells_the_reference_from_tuned_libraries_by_their_paths)
  {
    const std::string debian = "/usr/lib/x86_64-linux-gnu/";
    EXPECT_TRUE(is_reference_blas(debian + "blas/libblas.so.3.11.0"));
    EXPECT_TRUE(is_reference_blas("/usr/lib64/libblas.so.3"));
    EXPECT_FALSE(is_reference_blas(debian + "openblas-pthread/libblas.so.3"));
    EXPECT_FALSE(is_reference_blas(debian + "blis-openmp/libblas.so.4"));
    EXPECT_FALSE(is_reference_blas(debian + "atlas/libblas.so.3"));
    EXPECT_FALSE(is_reference_blas("/opt/intel/oneapi/libmkl_rt.so.2"));
    EXPECT_FALSE(is_reference_blas(debian + "libOpenBLAS.so"));
  }

  TEST(BlasCheck, an_unknown_library_is_not_complained_about)
  {
    EXPECT_FALSE(is_reference_blas(""));
  }

  TEST(BlasCheck, finds_the_library_of_this_process)
  {
    const std::string library = blas_library();
    ASSERT_FALSE(library.empty());
    EXPECT_EQ(library.front(), '/');
    EXPECT_EQ(on_reference_blas(), is_reference_blas(library));
    EXPECT_NE(blas_advice().find(library), std::string::npos);
    EXPECT_NE(blas_advice().find("libopenblas0"), std::string::npos);
  }
} // namespace demold
