// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/log_map.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace log_map_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of directions and of coordinates near 1.
constexpr double round_off = 1e-12;

TEST(log_map, straightest_stencil_is_exact_on_a_plane)
{
  const Array_surface surface(square(10, 0.25));
  const Tangent_plane plane(surface.t(), surface.at(60));
  const double length = 0.15 / surface.scale();
  const Stencil stencil = straightest_stencil(plane, length, 8);
  ASSERT_EQ(stencil.locations.size(), 8u);
  for(std::size_t j = 0; j < 8; ++j)
  {
    const Vec2& q = stencil.vectors[j];
    EXPECT_NEAR(norm(q), length, 1e-13);                      // round-off error
    EXPECT_LT(norm(q + stencil.vectors[(j + 4) % 8]), 1e-13); // opposite
    const Vec3 end = plane.point() + q[0] * plane.x() + q[1] * plane.y();
    EXPECT_LT(norm(scaled_coordinates(surface.t(), stencil.locations[j]) - end), round_off);
  }
}

TEST(log_map, straightest_stencil_shrinks_at_boundary)
{
  const Array_surface surface(square(10));
  const Stencil stencil = straightest_stencil(Tangent_plane(surface.t(), surface.at(0)), 100., 8);
  EXPECT_GE(stencil.locations.size(), 3u);
  for(const Vec2& q : stencil.vectors)
  {
    EXPECT_LT(norm(q), 2. / surface.scale());
    EXPECT_GT(cross(stencil.vectors.front(), q) + 1e-9, 0.); // a quarter of the plane
  }
}

TEST(log_map, vertex_stencil_grows_until_regular)
{
  const Array_surface surface(square(10));
  const Tangent_plane plane(surface.t(), surface.at(60));
  std::vector<Index> vertices(surface.t().number_of_vertices());
  std::iota(vertices.begin(), vertices.end(), Index(0));
  std::vector<double> distances;
  for(const auto& p : surface.t().point)
    distances.push_back(norm(p - plane.point()));
  for(const double length : {0.001, 0.25})
  {
    const Stencil stencil =
        vertex_stencil(surface.t(), plane, vertices, distances, length / surface.scale(), 8);
    EXPECT_GE(stencil.locations.size(), 4u);
    for(std::size_t j = 0; j < stencil.locations.size(); ++j)
    {
      const Vec2& q = stencil.vectors[j];
      EXPECT_GT(norm(q), 0.);
      const Vec3 end = plane.point() + q[0] * plane.x() + q[1] * plane.y();
      EXPECT_LT(norm(scaled_coordinates(surface.t(), stencil.locations[j]) - end), round_off);
    }
  }
}

TEST(log_map, fit_is_exact_in_the_plane)
{
  const std::vector<Vec2> stencil = {{0.1, 0.}, {0., 0.2}, {-0.1, 0.1}, {0.05, -0.1}};
  const Log_map_fit fit(stencil);
  for(const Vec2& x : {Vec2{1., 2.}, Vec2{-0.01, 0.03}, Vec2{0., -5.}})
  {
    std::vector<double> distances;
    for(const Vec2& q : stencil)
      distances.push_back(norm(x - q));
    EXPECT_LT(norm(fit(norm(x), distances.data()) - x), round_off * (1. + norm(x)));
    // Without the known length, errors are divided by the length of the stencil.
    EXPECT_LT(norm(fit.gradient(norm(x), distances.data()) - x), 100. * round_off * (1. + norm(x)));
    // Infinite distances are ignored.
    distances[2] = infinity;
    EXPECT_LT(norm(fit(norm(x), distances.data()) - x), round_off * (1. + norm(x)));
    distances[0] = distances[3] = infinity;
    EXPECT_EQ(norm(fit(norm(x), distances.data())), 0.);
  }
}

TEST(log_map, mean_normal_angle_matches_sphere)
{
  // The vertex normals of a subdivided icosahedron approximate those of the sphere. So the angle
  // between two of them is approximately the length of the edge.
  const Array_surface surface(icosphere(3));
  const double scale = surface.t().scale;
  // The angles are measured to be up to 0.009 smaller than the edge length.
  for(const Index vertex : {0u, 20u, 300u})
    EXPECT_NEAR(mean_normal_angle(surface.t(), surface.at(vertex)),
                scale * mean_edge_length(surface.t(), surface.at(vertex)), 0.01);
  const Array_surface flat(square(4));
  EXPECT_EQ(mean_normal_angle(flat.t(), flat.at(5)), 0.);
}

TEST(log_map, steps_are_transported_along_great_circles)
{
  const Array_surface surface(icosphere(3));
  const Index base = surface.vertex(0);
  const Tangent_plane plane(surface.t(), surface.at(0));
  // Round-off errors of a rotation.
  const double rotation_error = 1e-13;
  for(const double angle : {0., 1., 2., 4.})
    for(const double distance : {0., 0.5, 2., 3.1})
    {
      // The direction of the great circle, and the direction to its left.
      const Vec3 outward = plane.direction(angle), up = plane.normal();
      const Vec3 normal = std::cos(distance) * up + std::sin(distance) * outward,
                 forward = std::cos(distance) * outward + -std::sin(distance) * up;
      const Vec3 left = cross(up, outward);
      const Vec2 u = {std::cos(angle), std::sin(angle)};
      EXPECT_LT(norm(transported_step(plane, normal, 0.1 * forward) - 0.1 * u), rotation_error);
      EXPECT_LT(norm(transported_step(plane, normal, 0.1 * left) - 0.1 * Vec2{-u[1], u[0]}),
                rotation_error);
      // A step out of the tangent plane is projected to it and keeps its length.
      const Vec3 tilted = 0.3 * forward + 0.4 * normal;
      EXPECT_LT(norm(transported_step(plane, normal, tilted) - 0.5 * u), rotation_error);
    }
  EXPECT_NEAR(norm(transported_step(plane, -1. * plane.normal(), plane.x())), 1., rotation_error);
  EXPECT_LT(norm(plane.normal() - vertex_normal(surface.t(), base)), rotation_error);
}

TEST(log_map, counts_cut_and_folded_triangles)
{
  const Array_surface surface(square(3)); // 18 triangles
  const Surface_arrays& t = surface.t();
  std::vector<Vec2> coordinates;
  for(const auto& p : t.point)
    coordinates.push_back({p[0], p[1]});
  std::vector<Index> reached(t.number_of_vertices());
  std::iota(reached.begin(), reached.end(), Index(0));
  EXPECT_TRUE(find_map_defects(t, reached, coordinates).cut_triangles.empty());
  EXPECT_EQ(find_map_defects(t, reached, coordinates).number_of_flips, 0u);
  for(Vec2& u : coordinates)
    u[0] = -u[0];
  EXPECT_EQ(find_map_defects(t, reached, coordinates).number_of_flips, 18u);
  // Cut the six triangles at an interior vertex by moving its image far away.
  Index inner = 0;
  while(t.ring_begin[inner + 1] - t.ring_begin[inner] != 6)
    ++inner;
  coordinates[inner] = {100., 0.};
  EXPECT_EQ(find_map_defects(t, reached, coordinates).cut_triangles.size(), 6u);
  EXPECT_EQ(find_map_defects(t, reached, coordinates).number_of_flips, 12u);
  coordinates[inner][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(find_map_defects(t, reached, coordinates).cut_triangles.empty());
  EXPECT_EQ(find_map_defects(t, reached, coordinates).number_of_flips, 12u);
}

} // namespace log_map_test
