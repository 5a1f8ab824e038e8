// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/geodesic_barycenter.h>

#include <CGAL/Geodesic_processing/geodesic_distances.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace geodesic_barycenter_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

// Relative round-off error of sums of some hundred terms.
constexpr double round_off = 1e-9;

// Returns a vertex of the unit square with 12 by 12 cells. Its index is 13 * row + column.
Vertex at(Mesh::size_type column, Mesh::size_type row) { return Vertex(13 * row + column); }

// In the plane, the barycenter is the centroid if that is a vertex.
TEST(Geodesic_barycenter, matches_centroid_in_plane)
{
  const Mesh mesh = mesh_of(square(12));
  const std::vector<Vertex> corners = {at(0, 0), at(12, 0), at(0, 12), at(12, 12)};
  const auto center = GP::geodesic_barycenter(mesh, corners);
  EXPECT_EQ(center.vertex, at(6, 6));
  EXPECT_NEAR(center.value, 4. * 0.5, round_off);
  const std::vector<double> weights = {3., 1., 1., 1.};
  const auto pulled =
      GP::geodesic_barycenter<GP::Exact>(mesh, corners, GP::parameters::weights(weights));
  EXPECT_EQ(pulled.vertex, at(4, 4));
  EXPECT_NEAR(pulled.value, (3. * 32. + 2. * 80. + 128.) / 144., round_off);
  EXPECT_EQ(GP::geodesic_barycenter(mesh, std::vector<Vertex>{at(3, 4)}).vertex, at(3, 4));
  // A location counts as much as a vertex. A location of weight zero has no influence.
  const std::vector<std::pair<Face, std::array<double, 3>>> locations = {
      location_of(0, {1., 0., 0.}), location_of(100, {0.2, 0.3, 0.5})};
  const auto all =
      GP::geodesic_barycenter(mesh, locations, GP::parameters::weights(std::array<int, 2>{1, 0}));
  EXPECT_NEAR(all.value, 0., round_off);
}

template <typename AnyMesh>
GP::Geodesic_barycenter<std::size_t> on_sphere(double scale = 1.)
{
  Numbered<AnyMesh> sphere;
  fill(sphere, scaled(icosphere(3), scale));
  const auto& v = sphere.vertices;
  const std::vector<typename boost::graph_traits<AnyMesh>::vertex_descriptor> points = {
      v[0], v[50], v[101], v[300]};
  const auto found = GP::geodesic_barycenter(sphere.mesh, points);
  return {std::size_t(std::find(v.begin(), v.end(), found.vertex) - v.begin()), found.value};
}

TEST(Geodesic_barycenter, accepts_all_mesh_types_and_scales)
{
  const auto found = on_sphere<Mesh>();
  EXPECT_EQ(on_sphere<CGAL::Polyhedron_3<Kernel>>().vertex, found.vertex);
  for(const double scale : {1e-6, 1e6})
  {
    EXPECT_EQ(on_sphere<Mesh>(scale).vertex, found.vertex);
    EXPECT_NEAR(on_sphere<Mesh>(scale).value / scale / scale, found.value, round_off);
  }
}

TEST(Geodesic_barycenter, minimizes_objective_map)
{
  const Surfels surfels = sphere_surfels(4);
  CGAL::Point_set_3<Kernel::Point_3> cloud(true);
  for(const auto& [point, normal] : surfels)
    cloud.insert(point, normal);
  using Index = CGAL::Point_set_3<Kernel::Point_3>::Index;
  auto sum = cloud.add_property_map<double>("sum").first;
  auto distance = cloud.add_property_map<double>("distance").first;
  const std::vector<Index> points = {Index(0), Index(500), Index(900)};
  const auto found = GP::geodesic_barycenter(cloud, points, GP::parameters::objective_map(sum));
  std::vector<double> expected(cloud.size(), 0.);
  for(const Index& point : points)
  {
    GP::geodesic_distances(cloud, point, distance);
    for(const Index& i : cloud)
      expected[i] += distance[i] * distance[i];
  }
  for(const Index& i : cloud)
  {
    EXPECT_EQ(sum[i], expected[i]);
    EXPECT_GE(sum[i], found.value);
  }
  EXPECT_EQ(sum[found.vertex], found.value);
}

TEST(Geodesic_barycenter, throws_if_no_barycenter_exists)
{
  const Mesh one = mesh_of(icosphere(1)),
             two = mesh_of(disjoint_union(icosphere(1), scaled(icosphere(1), 3.)));
  using Error = GP::Invalid_argument_error;
  EXPECT_THROW(GP::geodesic_barycenter(one, std::vector<Vertex>{}), Error);
  const std::vector<Vertex> points = {Vertex(0), Vertex(42)};
  EXPECT_THROW(GP::geodesic_barycenter(one, points), Error);
  EXPECT_THROW(GP::geodesic_barycenter(two, points), Error);
  for(const std::vector<double>& weights :
      std::vector<std::vector<double>>{{1.}, {1., -1.}, {0., 0.}, {1., std::nan("")}})
    EXPECT_THROW(GP::geodesic_barycenter(two, points, GP::parameters::weights(weights)), Error);
  EXPECT_EQ(
      GP::geodesic_barycenter(two, points, GP::parameters::weights(std::vector<double>{1., 0.}))
          .vertex,
      Vertex(0));
}

} // namespace geodesic_barycenter_test
