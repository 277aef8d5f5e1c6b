// SPDX-License-Identifier: LGPL-2.1-or-later
// Boundary ids and names are one to one; a wrong name leads to the right one.
#include "geometry/boundary_names.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "base/parameter_error.h"

using namespace demold;

TEST(BoundaryNames, every_named_id_survives_the_way_to_its_name_and_back)
{
  std::set<std::string> names;
  for (const Boundary::Id id : named_boundaries())
    {
      EXPECT_EQ(boundary_id(boundary_name(id), "Block/held"), id);
      names.insert(boundary_name(id));
    }
  EXPECT_EQ(names.size(), named_boundaries().size());
  EXPECT_EQ(names.count(boundary_name(Boundary::unnamed)), 0u);
}

TEST(BoundaryNames, an_unknown_name_is_refused_with_path_and_nearest_name)
{
  try
    {
      boundary_id("simmetry x", "Pull/held boundary");
      FAIL();
    }
  catch (const ExcParameter &error)
    {
      const std::string text = error.what();
      EXPECT_EQ(text.rfind("Pull/held boundary: ", 0), 0u);
      EXPECT_NE(text.find("nearest name is 'symmetry x'"), std::string::npos);
    }
}

TEST(BoundaryNames, a_number_stands_for_a_physical_group)
{
  EXPECT_EQ(boundary_id("17", "Block/held"), 17u);
  EXPECT_EQ(boundary_name(17), "boundary 17");
  EXPECT_THROW(boundary_id("", "Block/held"), ExcParameter);
  EXPECT_THROW(boundary_id("-3", "Block/held"), ExcParameter);
}
