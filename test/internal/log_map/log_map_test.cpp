// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/log_map.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include "Glued_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

TEST(log_map, stencils_are_straight_and_even)
{
  const Glued_surface surface(square(10, 0.25));
  const Tangent_plane plane(surface.t(), surface.at(60));
  const double length = 0.15 / surface.scale();
  const Stencil stencil = straight_stencil(plane, length, 8);
  ASSERT_EQ(stencil.places.size(), 8u);
  for(std::size_t j = 0; j < 8; ++j)
  {
    const Planar& q = stencil.vectors[j];
    EXPECT_NEAR(norm(q), length, 1e-13);
    EXPECT_LT(norm(q + stencil.vectors[(j + 4) % 8]), 1e-13); // opposite
    const Spatial end = plane.point() + q[0] * plane.x() + q[1] * plane.y();
    EXPECT_LT(norm(scaled_coordinates(surface.t(), stencil.places[j]) - end), 1e-12);
  }
}

TEST(log_map, stencils_get_shorter_at_a_border)
{
  const Glued_surface surface(square(10));
  const Stencil stencil = straight_stencil(Tangent_plane(surface.t(), surface.at(0)), 100., 8);
  EXPECT_GE(stencil.places.size(), 3u);
  for(const Planar& q : stencil.vectors)
  {
    EXPECT_LT(norm(q), 2. / surface.scale());
    EXPECT_GT(cross(stencil.vectors.front(), q) + 1e-9, 0.); // a quarter of the plane
  }
}

TEST(log_map, stencils_of_sites_are_as_long_as_needed)
{
  const Glued_surface surface(square(10));
  const Tangent_plane plane(surface.t(), surface.at(60));
  std::vector<Index> sites(surface.t().number_of_sites());
  std::iota(sites.begin(), sites.end(), Index(0));
  std::vector<double> distances;
  for(const auto& p : surface.t().point)
    distances.push_back(norm(p - plane.point()));
  for(const double length : {0.001, 0.25})
  {
    const Stencil stencil =
        stencil_of_sites(surface.t(), plane, sites, distances, length / surface.scale(), 8);
    EXPECT_GE(stencil.places.size(), 4u);
    for(std::size_t j = 0; j < stencil.places.size(); ++j)
    {
      const Planar& q = stencil.vectors[j];
      EXPECT_GT(norm(q), 0.);
      const Spatial end = plane.point() + q[0] * plane.x() + q[1] * plane.y();
      EXPECT_LT(norm(scaled_coordinates(surface.t(), stencil.places[j]) - end), 1e-12);
    }
  }
}

TEST(log_map, the_fit_is_exact_in_the_plane)
{
  const std::vector<Planar> stencil = {{0.1, 0.}, {0., 0.2}, {-0.1, 0.1}, {0.05, -0.1}};
  const Log_fit fit(stencil);
  for(const Planar& x : {Planar{1., 2.}, Planar{-0.01, 0.03}, Planar{0., -5.}})
  {
    std::vector<double> distances;
    for(const Planar& q : stencil)
      distances.push_back(norm(x - q));
    EXPECT_LT(norm(fit(norm(x), distances.data()) - x), 1e-12 * (1. + norm(x)));
    // What no front has reached does not count.
    distances[2] = infinity;
    EXPECT_LT(norm(fit(norm(x), distances.data()) - x), 1e-12 * (1. + norm(x)));
    distances[0] = distances[3] = infinity;
    EXPECT_EQ(norm(fit(norm(x), distances.data())), 0.);
  }
}

TEST(log_map, sides_bend_by_their_angles)
{
  // Normals at vertices of a subdivided icosahedron are nearly those of the sphere: an angle is as long as
  // its side, but for what arcs are longer than chords and normals are off.
  const Glued_surface surface(icosphere(3));
  const double scale = surface.t().scale;
  for(const Index vertex : {0u, 20u, 300u})
    EXPECT_NEAR(mean_bend_around(surface.t(), surface.at(vertex)),
                scale * mean_length_around(surface.t(), surface.at(vertex)), 0.01);
  const Glued_surface flat(square(4));
  EXPECT_EQ(mean_bend_around(flat.t(), flat.at(5)), 0.);
}

TEST(log_map, steps_come_to_the_base_along_great_circles)
{
  const Glued_surface surface(icosphere(3));
  const Index base = surface.site(0);
  const Tangent_plane plane(surface.t(), surface.at(0));
  for(const double angle : {0., 1., 2., 4.})
    for(const double distance : {0., 0.5, 2., 3.1})
    {
      // The direction in which the great circle goes on, and that to its left.
      const Spatial start = plane.direction(angle), up = plane.normal();
      const Spatial normal = std::cos(distance) * up + std::sin(distance) * start,
                    on = std::cos(distance) * start + -std::sin(distance) * up;
      const Spatial left = cross(up, start);
      const Planar u = {std::cos(angle), std::sin(angle)};
      EXPECT_LT(norm(step_in_plane(plane, normal, 0.1 * on) - 0.1 * u), 1e-13);
      EXPECT_LT(norm(step_in_plane(plane, normal, 0.1 * left) - 0.1 * Planar{-u[1], u[0]}), 1e-13);
      // What leaves the plane is laid into it, at its full length.
      const Spatial slanted = 0.3 * on + 0.4 * normal;
      EXPECT_LT(norm(step_in_plane(plane, normal, slanted) - 0.5 * u), 1e-13);
    }
  EXPECT_NEAR(norm(step_in_plane(plane, -1. * plane.normal(), plane.x())), 1., 1e-13);
  EXPECT_LT(norm(plane.normal() - site_normal(surface.t(), base)), 1e-13);
}

TEST(log_map, cut_and_folded_triangles_are_counted)
{
  const Glued_surface surface(square(3)); // 18 triangles
  const Glued_triangles& t = surface.t();
  std::vector<Planar> coordinates;
  for(const auto& p : t.point)
    coordinates.push_back({p[0], p[1]});
  std::vector<Index> reached(t.number_of_sites());
  std::iota(reached.begin(), reached.end(), Index(0));
  EXPECT_TRUE(look_at_triangles(t, reached, coordinates).cut.empty());
  EXPECT_EQ(look_at_triangles(t, reached, coordinates).folded, 0u);
  for(Planar& u : coordinates)
    u[0] = -u[0];
  EXPECT_EQ(look_at_triangles(t, reached, coordinates).folded, 18u);
  // Six triangles around an inner site that has been moved far away.
  Index inner = 0;
  while(t.first[inner + 1] - t.first[inner] != 6)
    ++inner;
  coordinates[inner] = {100., 0.};
  EXPECT_EQ(look_at_triangles(t, reached, coordinates).cut.size(), 6u);
  EXPECT_EQ(look_at_triangles(t, reached, coordinates).folded, 12u);
  coordinates[inner][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(look_at_triangles(t, reached, coordinates).cut.empty());
  EXPECT_EQ(look_at_triangles(t, reached, coordinates).folded, 12u);
}

} // namespace
