// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/Biharmonic_metric.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

namespace Biharmonic_metric_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;

// Square roots of differences of rounded numbers of the order of the area.
constexpr double round_off = 1e-6;

template <typename Domain, typename Vertex_or_location>
void expect_consistent_metric(const Domain& domain,
                              const std::vector<Vertex_or_location>& locations)
{
  const GP::Biharmonic_metric<typename Domain::Surface> metric(domain);
  const Eigen::MatrixXd d = metric.distance_matrix(locations);
  EXPECT_EQ(d, Eigen::MatrixXd(d.transpose()));
  for(Eigen::Index i = 0; i < d.rows(); ++i)
    for(Eigen::Index j = 0; j < d.cols(); ++j)
    {
      EXPECT_EQ(i == j, d(i, j) == 0.);
      EXPECT_NEAR(metric.distance(locations[i], locations[j]), d(i, j), round_off);
      for(Eigen::Index k = 0; k < d.cols(); ++k)
        EXPECT_LE(d(i, k), d(i, j) + d(j, k) + round_off);
    }
}

TEST(Biharmonic_metric, is_consistent_on_meshes_and_clouds)
{
  const Triangulation sphere = jittered(icosphere(2), 0.03);
  const Mesh mesh = mesh_of(sphere);
  expect_consistent_metric(GP::make_domain(mesh),
                           std::vector<Vertex>{Vertex(0), Vertex(5), Vertex(100), Vertex(77)});
  expect_consistent_metric(GP::make_domain(mesh),
                           std::vector<GP::Location<Mesh>>{location_of(0, {0.2, 0.3, 0.5}),
                                                           location_of(50, {0.1, 0.9, 0.})});
  Numbered<CGAL::Polyhedron_3<Kernel>> polyhedron;
  fill(polyhedron, sphere);
  expect_consistent_metric(GP::make_domain(polyhedron.mesh),
                           std::vector{polyhedron.vertices[0], polyhedron.vertices[100]});
  Point_set cloud(true);
  for(const auto& [point, normal] : sphere_surfels(2))
    cloud.insert(point, normal);
  expect_consistent_metric(GP::make_domain(cloud),
                           std::vector<Point_set::Index>{*cloud.begin(), *(cloud.begin() + 60)});
}

TEST(Biharmonic_metric, distance_map_scales_with_mesh)
{
  for(const double scale : {1., 1e-6, 1e6})
  {
    Mesh mesh = mesh_of(scaled(torus(20, 10), scale));
    const GP::Biharmonic_metric<Mesh> metric(mesh);
    auto map = vertex_map(mesh), parallel_map = vertex_map(mesh);
    const Vertex from(Mesh::size_type(7));
    metric.write_distances(from, map);
    metric.write_distances<CGAL::Parallel_tag>(from, parallel_map,
                                               GP::parameters::number_of_threads(3));
    for(const Vertex v : mesh.vertices())
    {
      EXPECT_EQ(map[v], parallel_map[v]);
      EXPECT_NEAR(map[v], metric.distance(from, v), round_off * scale);
    }
    // The order of magnitude: the unit is that of lengths.
    EXPECT_GT(map[Vertex(100)], 0.01 * scale);
    EXPECT_LT(map[Vertex(100)], 10. * scale);
  }
}

TEST(Biharmonic_metric, crosses_triangles_without_area)
{
  const Mesh mesh = mesh_of(rectangle_with_slit(8));
  const GP::Biharmonic_metric<Mesh> metric(mesh);
  // Vertices on both sides of the slit, and at the ends of a row
  const double across = metric.distance(Vertex(40), Vertex(41)),
               along = metric.distance(Vertex(36), Vertex(44));
  EXPECT_GT(across, 0.);
  EXPECT_LT(across, 0.5 * along);
  EXPECT_LT(along, infinity);
}

TEST(Biharmonic_metric, throws_on_invalid_location)
{
  const Mesh mesh = mesh_of(icosphere(1));
  const GP::Biharmonic_metric<Mesh> metric(mesh);
  EXPECT_THROW(metric.distance(Vertex(0), Vertex(1000)), GP::Invalid_argument_error);
  const Mesh nothing;
  EXPECT_THROW(GP::Biharmonic_metric<Mesh>{nothing}, GP::Unsupported_surface_error);
}

} // namespace Biharmonic_metric_test
