// SPDX-License-Identifier: LGPL-2.1-or-later
// main() of unit tests that use meshes or Trilinos: MPI, then GoogleTest.
#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

int main(int argc, char **argv)
{
  // Listing the tests, as the build does, needs no MPI.
  testing::InitGoogleTest(&argc, argv);
  if (testing::GTEST_FLAG(list_tests))
    return RUN_ALL_TESTS();

  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  return RUN_ALL_TESTS();
}
