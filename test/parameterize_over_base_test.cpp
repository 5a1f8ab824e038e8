// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/Soup_domain.h>
#include <CGAL/Geodesic_processing/parameterize_over_base.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace parameterize_over_base_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

TEST(parameterize_over_base, writes_location_of_each_vertex)
{
  Mesh mesh = mesh_of(jittered(icosphere(2), 0.02));
  const Vertex isolated = mesh.add_vertex(Kernel::Point_3(5., 5., 5.));
  const auto base_locations = mesh.add_property_map<Vertex, GP::Base_location>("v:place").first;
  base_locations[isolated].face = 12345;
  const auto base = GP::parameterize_over_base(mesh, 20, base_locations);
  for(const Vertex v : mesh.vertices())
  {
    if(v == isolated)
      continue;
    EXPECT_EQ(base_locations[v].face, base(v).face);
    EXPECT_EQ(base_locations[v].barycentric, base(v).barycentric);
    const auto& b = base_locations[v].barycentric;
    EXPECT_GE(std::min({b[0], b[1], b[2]}), 0.);
    EXPECT_NEAR(b[0] + b[1] + b[2], 1., 1e-14); // two additions
  }
  EXPECT_EQ(base_locations[isolated].face, 12345u);
}

TEST(parameterize_over_base, accepts_domain)
{
  Mesh mesh = mesh_of(jittered(icosphere(2), 0.02));
  const auto of_mesh = mesh.add_property_map<Vertex, GP::Base_location>("v:of_mesh").first,
             of_domain = mesh.add_property_map<Vertex, GP::Base_location>("v:of_domain").first;
  GP::parameterize_over_base(mesh, 20, of_mesh);
  GP::parameterize_over_base(GP::make_domain(mesh), 20, of_domain);
  for(const Vertex v : mesh.vertices())
  {
    EXPECT_EQ(of_domain[v].face, of_mesh[v].face);
    EXPECT_EQ(of_domain[v].barycentric, of_mesh[v].barycentric);
  }
}

TEST(parameterize_over_base, writes_location_of_merged_points)
{
  // A tetrahedron whose first point is repeated.
  const std::vector<Kernel::Point_3> points = {
      {0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}, {0., 0., 0.}};
  const std::vector<std::array<std::size_t, 3>> triangles = {
      {0, 2, 1}, {4, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const auto domain = GP::make_domain(points, triangles, GP::parameters::merge_tolerance(0.));
  std::vector<GP::Base_location> locations(5, {12345, {}});
  const auto base = GP::parameterize_over_base(domain, 4, CGAL::make_property_map(locations));
  for(const GP::Base_location& location : locations)
    ASSERT_LT(location.face, base.number_of_base_faces());
  EXPECT_EQ(base.point(locations[4]), base.point(locations[0]));
}

} // namespace parameterize_over_base_test
