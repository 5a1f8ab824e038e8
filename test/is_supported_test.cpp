// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// supported_surfaces.cpp contains the calls that is_supported_v admits.
#include <CGAL/Geodesic_processing/is_supported.h>

#include <CGAL/Geodesic_processing/Soup_domain.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <CGAL/Point_set_3.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <string>
#include <type_traits>
#include <vector>

namespace is_supported_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using GP::Function;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;

TEST(is_supported, domain_is_supported_as_its_surface)
{
  static_assert(GP::is_supported_v<Function::bake_atlas, Mesh>);
  static_assert(GP::is_supported_v<Function::bake_atlas, GP::Mesh_domain<Mesh>>);
  static_assert(!GP::is_supported_v<Function::bake_atlas, Point_set>);
  static_assert(!GP::is_supported_v<Function::bake_atlas, Surfels>);
  static_assert(!GP::is_supported_v<Function::bake_atlas, GP::Surfel_domain<Surfels>>);
  static_assert(!GP::is_supported_v<Function::Surfel_path_finder, Mesh>);
  static_assert(GP::is_supported_v<Function::Surfel_path_finder, Point_set>);
  EXPECT_TRUE((GP::is_supported_v<Function::geodesic_path, Surfels>));
}

// The type of a variable can be const.
static_assert(std::is_same_v<GP::Surface_of<const GP::Mesh_domain<Mesh>>, Mesh>);
static_assert(std::is_same_v<GP::Surface_of<const GP::Surfel_domain<Surfels>>, Surfels>);
static_assert(std::is_same_v<GP::Surface_of<const GP::Soup_domain<Kernel::Point_3>>, Mesh>);
static_assert(std::is_same_v<GP::Surface_of<const Mesh>, Mesh>);

// Returns the row of a function in the table of the manual.
std::string row(const std::string& name, const std::string& on_meshes, const std::string& on_clouds)
{
  const bool is_class = std::isupper(static_cast<unsigned char>(name[0])) != 0;
  return "| `" + name + (is_class ? "` | " : "()` | ") + on_meshes + " | " + on_clouds + " |";
}

TEST(is_supported, manual_lists_all_functions)
{
  std::vector<std::string> expected;
#define BOTH(name) expected.push_back(row(#name, "yes", "yes"));
#define MESHES(name, reason) expected.push_back(row(#name, "yes", reason));
#define CLOUDS(name, reason) expected.push_back(row(#name, reason, "yes"));
  CGAL_GEODESIC_PROCESSING_FUNCTIONS(BOTH, MESHES, CLOUDS)
#undef CLOUDS
#undef MESHES
#undef BOTH

  std::ifstream manual(GEODESIC_PROCESSING_SOURCE "/doc/manual/surfaces.txt");
  std::vector<std::string> found;
  bool is_in_table = false;
  for(std::string line; std::getline(manual, line);)
  {
    if(line == "| function or class | meshes | clouds |")
      is_in_table = true;
    else if(is_in_table && line.empty())
      break;
    else if(is_in_table && line.find("---") == std::string::npos)
      found.push_back(line);
  }
  ASSERT_EQ(found.size(), expected.size());
  for(std::size_t i = 0; i < found.size(); ++i)
    EXPECT_EQ(found[i], expected[i]);
}

} // namespace is_supported_test
