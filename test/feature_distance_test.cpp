// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/feature_distance.h>

#include <CGAL/Geodesic_processing/Geodesic_path_finder.h>
#include <CGAL/Geodesic_processing/geodesic_distances.h>

#include <CGAL/Point_set_3.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

namespace feature_distance_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

// Checks that the result never exceeds the exact distance. Its mean error is at most 1 % of the
// largest distance. Point features add an error of a fraction of the incident edge lengths.
template <typename Feature>
void expect_lower_bound_of_exact(Mesh& mesh, const Feature& feature,
                                 double tolerance_at_points = 0.)
{
  auto found = vertex_map(mesh), exact = mesh.add_property_map<Vertex, double>("v:exact").first;
  const GP::Earth_movers_cost cost = GP::feature_distance(mesh, feature, found);
  EXPECT_TRUE(cost.is_converged);
  GP::geodesic_distances<GP::Exact>(mesh, feature, exact);
  double largest = 0., mean_difference = 0.;
  for(const Vertex v : vertices(mesh))
  {
    EXPECT_LE(found[v], exact[v] * (1. + 1e-9)); // round-off errors
    EXPECT_GE(found[v], 0.);
    largest = std::max(largest, exact[v]);
    mean_difference += (exact[v] - found[v]) / double(num_vertices(mesh));
  }
  EXPECT_LT(mean_difference, 0.01 * largest + tolerance_at_points);
}

TEST(Feature_distance, is_accurate_for_curves_and_boundary)
{
  Mesh plane = mesh_of(square(20, 0.24));
  std::vector<GP::Source<Mesh>> boundary_sources;
  GP::border_sources(plane, std::back_inserter(boundary_sources));
  expect_lower_bound_of_exact(plane, boundary_sources);

  Mesh ring = mesh_of(torus(60, 30)); // rings of 30 vertices
  std::vector<Vertex> curve;
  for(Mesh::size_type i = 0; i < 30; ++i)
    curve.push_back(Vertex(i));
  expect_lower_bound_of_exact(ring, curve);
}

// An interval with features at 0 and 0.3. If the masses at the features were fixed, the error
// would be 0.3.
TEST(Feature_distance, is_zero_on_every_feature)
{
  Mesh mesh = mesh_of(square(20));
  std::vector<Vertex> lines;
  for(Mesh::size_type row = 0; row <= 20; ++row)
    for(const Mesh::size_type column : {0, 6})
      lines.push_back(Vertex(21 * row + column));
  auto found = vertex_map(mesh);
  GP::feature_distance(mesh, lines, found, GP::parameters::tolerance(1e-5));
  for(const Vertex v : vertices(mesh))
  {
    const double x = mesh.point(v).x();
    EXPECT_NEAR(found[v], std::min(x, std::abs(x - 0.3)),
                2e-3); // the duality gap allows this error; the mean distance is 0.19
  }
}

using Location = GP::Source<Mesh>::Location;

// Returns the zero set of a function that is linear in each face, as one source per face.
template <typename Function>
std::vector<GP::Source<Mesh>> zero_set(const Mesh& mesh, const Function& function)
{
  std::vector<GP::Source<Mesh>> result;
  for(const Face f : faces(mesh))
  {
    std::vector<Location> piece;
    auto h = mesh.halfedge(f);
    for(std::size_t k = 0; k < 3; ++k, h = mesh.next(h))
    {
      const double a = function(mesh.point(mesh.source(h))),
                   b = function(mesh.point(mesh.target(h)));
      if(a * b < 0.)
      {
        std::array<double, 3> coordinates = {0., 0., 0.};
        coordinates[k] = b / (b - a);
        coordinates[(k + 1) % 3] = a / (a - b);
        piece.emplace_back(f, coordinates);
      }
    }
    if(piece.size() == 2)
      result.emplace_back(piece);
  }
  return result;
}

// In the plane, for faces of any orientation: the distance is linear on both sides of the line.
TEST(Feature_distance, is_exact_for_straight_lines)
{
  for(const double scale : {1., 1e-6, 1e6})
    for(const double angle : {0.2, 1.1, 1.9, 2.8})
    {
      Mesh mesh = mesh_of(scaled(square(12, 0.24), scale));
      const double c = std::cos(angle), s = std::sin(angle);
      const auto height = [&](const Kernel::Point_3& p)
      { return c * (p.x() - 0.52 * scale) + s * (p.y() - 0.47 * scale); };
      auto found = vertex_map(mesh);
      const GP::Earth_movers_cost cost =
          GP::feature_distance(mesh, zero_set(mesh, height), found,
                               GP::parameters::tolerance(1e-8).number_of_refinements(0u));
      EXPECT_TRUE(cost.is_converged);
      for(const Vertex v : vertices(mesh))
        EXPECT_NEAR(found[v], std::abs(height(mesh.point(v))), 1e-5 * scale);
    }
}

TEST(Feature_distance, is_accurate_for_locations_and_paths_in_faces)
{
  Mesh plane = mesh_of(square(16, 0.24)), ball = mesh_of(jittered(icosphere(3), 0.02));
  const Location inside(Face(100), {0.2, 0.5, 0.3}), other(Face(300), {0.6, 0.1, 0.3});
  for(Mesh* mesh : {&plane, &ball})
  {
    const double tolerance_at_points = mesh == &plane ? 0.02 : 0.04; // a third of an edge length
    expect_lower_bound_of_exact(*mesh, inside, tolerance_at_points);
    expect_lower_bound_of_exact(*mesh,
                                std::vector<Location>{inside, other, {Face(100), {0.7, 0.1, 0.2}}},
                                tolerance_at_points);
    const auto path = GP::Geodesic_path_finder<Mesh>(*mesh)(inside, other);
    expect_lower_bound_of_exact(*mesh, GP::Source<Mesh>(path.locations), tolerance_at_points);
    // Locations close to vertices.
    expect_lower_bound_of_exact(*mesh,
                                std::vector<GP::Source<Mesh>>{GP::Source<Mesh>(path.locations),
                                                              GP::Source<Mesh>(Vertex(11))},
                                tolerance_at_points);
  }
}

TEST(Feature_distance, is_accurate_for_circle_of_latitude)
{
  Mesh mesh = mesh_of(icosphere(4));
  const double height = 0.3;
  const auto circle = zero_set(mesh, [&](const Kernel::Point_3& p) { return p.z() - height; });
  expect_lower_bound_of_exact(mesh, circle);
  auto found = vertex_map(mesh);
  GP::feature_distance(mesh, circle, found);
  for(const Vertex v : vertices(mesh))
  {
    const double exact = std::abs(std::asin(mesh.point(v).z()) - std::asin(height));
    EXPECT_NEAR(found[v], exact,
                0.01 * (1. + exact)); // a fifth of an edge length, reached near the poles
  }
}

// Faces that the feature crosses are split. Their pieces inherit the speed of the face.
TEST(Feature_distance, accepts_speeds)
{
  Mesh mesh = mesh_of(square(12, 0.24));
  const auto speed = mesh.add_property_map<Face, double>("speed", 2.).first;
  auto found = vertex_map(mesh);
  GP::feature_distance(
      mesh, zero_set(mesh, [](const Kernel::Point_3& p) { return p.x() + 0.3 * p.y() - 0.61; }),
      found, GP::parameters::face_speed_map(speed).tolerance(1e-8));
  for(const Vertex v : vertices(mesh))
    EXPECT_NEAR(found[v],
                0.5 * std::abs(mesh.point(v).x() + 0.3 * mesh.point(v).y() - 0.61) /
                    std::hypot(1., 0.3),
                1e-5);
}

TEST(Feature_distance, accepts_point_sets)
{
  const Surfels surfels = sphere_surfels(4);
  CGAL::Point_set_3<Kernel::Point_3> cloud(true);
  for(const auto& [point, normal] : surfels)
    cloud.insert(point, normal);
  auto found = cloud.add_property_map<double>("distance", 0.).first;
  GP::feature_distance(cloud, *cloud.begin(), found);
  double mean_difference = 0.;
  for(const auto& i : cloud)
    mean_difference += (2. * std::asin(0.5 * std::sqrt(CGAL::squared_distance(
                                                 cloud.point(*cloud.begin()), cloud.point(i)))) -
                        found[i]) /
                       double(cloud.size());
  // A fraction of the edge length 0.06 around the point.
  EXPECT_LT(std::abs(mean_difference), 0.03);
  // A location next to a surfel lies in no triangle.
  const GP::Surfel_location<decltype(cloud)::Index> next_to_surfel{*cloud.begin(), {0.01, 0.}};
  EXPECT_THROW(GP::feature_distance(cloud, next_to_surfel, found), GP::Invalid_argument_error);
}

TEST(Feature_distance, is_infinite_if_unreachable)
{
  Mesh mesh = mesh_of(disjoint_union(square(4), square(4)));
  const Vertex isolated = mesh.add_vertex(Kernel::Point_3(0., 0., 9.));
  auto found = vertex_map(mesh);
  EXPECT_TRUE(GP::feature_distance(mesh, Vertex(0), found).is_converged);
  EXPECT_NEAR(found[Vertex(4)], 1., 0.05); // a fraction of an edge length
  EXPECT_EQ(found[Vertex(30)], infinity);
  EXPECT_EQ(found[isolated], infinity);
  GP::feature_distance(mesh, std::vector<Vertex>{Vertex(0), Vertex(25), isolated}, found);
  EXPECT_NEAR(found[Vertex(29)], 1., 0.05);
  EXPECT_EQ(found[isolated], 0.);
  // Vertices behind a wall of speed zero.
  Mesh plane = mesh_of(square(4));
  const auto speed = plane.add_property_map<Vertex, double>("speed", 1.).first;
  for(Mesh::size_type row = 0; row < 5; ++row)
    for(const Mesh::size_type column : {1, 2})
      speed[Vertex(5 * row + column)] = 0.;
  auto behind_obstacle = vertex_map(plane);
  GP::feature_distance(plane, Vertex(0), behind_obstacle, GP::parameters::speed_map(speed));
  EXPECT_EQ(behind_obstacle[Vertex(4)], infinity);
}

} // namespace feature_distance_test
