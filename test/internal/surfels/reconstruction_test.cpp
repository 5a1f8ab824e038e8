// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/reconstruction.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/spatial.h>

#include "Glued_surface.h"
#include "topology.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// The points of a triangulation with the means of its triangles' normals.
Glued_surfels surfels_of(const Triangulation& surface)
{
  std::vector<Spatial> normals(surface.points.size(), Spatial{0., 0., 0.});
  for(std::size_t f = 0; f < surface.corners.size(); f += 3)
  {
    const Spatial &p = surface.points[surface.corners[f]],
                  &q = surface.points[surface.corners[f + 1]],
                  &r = surface.points[surface.corners[f + 2]];
    for(int k = 0; k < 3; ++k)
    {
      Spatial& normal = normals[surface.corners[f + k]];
      normal = normal + cross(q - p, r - p);
    }
  }
  return glue_surfels(surface.points, normals);
}

TEST(Reconstruction, finds_the_surface_of_a_clean_cloud)
{
  Triangulation ball = icosphere(3);
  for(Point& p : ball.points)
    p[2] += 2.;
  for(const Triangulation& surface :
      {icosphere(4), torus(80, 40), square(20, 0.2), cylinder(60, 20, 1., 2.),
       apart(ball, torus(60, 30)), annulus(60, 10, 0.5, 1.)})
    for(const double scale : {1e-6, 1., 1e6})
    {
      const Glued_surfels surfels = surfels_of(scaled(surface, scale));
      const Glued_mesh found = reconstruction(surfels);
      EXPECT_EQ(topology(found.triangles.corner), topology(surface.corners));
      ASSERT_EQ(found.site_of_vertex.size(), surface.points.size());
      // As the normals are, and at the surfels.
      for(Index f = 0; f < found.triangles.number_of_triangles(); ++f)
      {
        const auto corner = [&](Index k)
        { return found.vertex_of_site[found.triangles.corner[3 * f + k]]; };
        const auto& t = surfels.triangles;
        const Spatial normal =
            cross(t.point[corner(1)] - t.point[corner(0)], t.point[corner(2)] - t.point[corner(0)]);
        EXPECT_GT(dot(normal, t.normal[corner(0)]), 0.);
        EXPECT_LT(
            distance(coordinates(t, {none, corner(0), {}}),
                     coordinates(found.triangles, {none, found.site_of_vertex[corner(0)], {}})),
            1e-12 * scale); // roundings of coordinates up to four
      }
    }
}

// Random places of a torus, as many for each area, with its normals.
Glued_surfels random_torus(std::size_t number, unsigned seed)
{
  std::mt19937 random(seed);
  const auto part = [&] { return double(random()) / 0x1p32; };
  std::vector<Spatial> points, normals;
  while(points.size() < number)
  {
    const double u = 2. * pi * part(), v = 2. * pi * part();
    if(1.4 * part() > 1. + 0.4 * std::cos(v))
      continue;
    const Spatial out = {std::cos(u), std::sin(u), 0.};
    normals.push_back(std::cos(v) * out + std::sin(v) * Spatial{0., 0., 1.});
    points.push_back(out + 0.4 * normals.back());
  }
  return glue_surfels(points, normals);
}

TEST(Reconstruction, has_no_holes_where_samples_are_random)
{
  // Two of the first 24 seeds, where a ring of four surfels is left that no small triangles fill.
  for(const unsigned seed : {5u, 23u})
    EXPECT_EQ(topology(reconstruction(random_torus(10000, seed)).triangles.corner),
              (Topology{true, {{0, 0}}}));
}

TEST(Reconstruction, leaves_gaps_open_and_sheets_apart)
{
  // A disc is missing, some twelve times as wide as triangles are.
  Triangulation sheet = square(30, 0.2);
  sheet.corners.clear();
  const auto is_in_gap = [](const Point& p) { return std::hypot(p[0] - 0.5, p[1] - 0.5) < 0.2; };
  sheet.points.erase(std::remove_if(sheet.points.begin(), sheet.points.end(), is_in_gap),
                     sheet.points.end());
  std::vector<Spatial> points = sheet.points, normals(points.size(), {0., 0., 1.});
  EXPECT_EQ(topology(reconstruction(glue_surfels(points, normals)).triangles.corner),
            (Topology{true, {{0, 2}}}));
  // The other side of a thin plate, one and a half times as far as surfels from each other.
  for(const Point& p : sheet.points)
  {
    points.push_back({p[0], p[1], -0.05});
    normals.push_back({0., 0., -1.});
  }
  EXPECT_EQ(topology(reconstruction(glue_surfels(points, normals)).triangles.corner),
            (Topology{true, {{0, 2}, {0, 2}}}));
}

TEST(Reconstruction, of_what_is_no_surface_is_empty)
{
  for(const std::size_t number : {0u, 1u, 2u, 5u, 100u})
  {
    std::vector<Spatial> line, place(number, {1., 2., 3.}), normals(number, {0., 0., 1.});
    for(std::size_t i = 0; i < number; ++i)
      line.push_back({double(i), 0., 0.});
    for(const auto& points : {line, place})
    {
      const Glued_mesh found = reconstruction(glue_surfels(points, normals));
      EXPECT_EQ(found.triangles.number_of_triangles(), 0u);
      EXPECT_EQ(found.triangles.number_of_sites(), number);
    }
  }
}

std::pair<std::vector<Spatial>, std::vector<Spatial>> noise(std::size_t number)
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<Spatial> points, normals;
  for(std::size_t i = 0; i < number; ++i)
  {
    points.push_back({normal(random), normal(random), normal(random)});
    normals.push_back({normal(random), normal(random), normal(random)});
  }
  return {points, normals};
}

TEST(Reconstruction, of_a_little_noise_is_a_surface)
{
  const auto [points, normals] = noise(500);
  const Glued_mesh found = reconstruction(glue_surfels(points, normals));
  for(Index side = 0; side < found.triangles.corner.size(); ++side)
    if(const Index twin = found.triangles.twin[side]; twin != none)
    {
      EXPECT_EQ(found.triangles.corner[twin], found.triangles.corner[next_side(side)]);
      EXPECT_EQ(found.triangles.corner[next_side(twin)], found.triangles.corner[side]);
    }
  EXPECT_GT(found.triangles.number_of_triangles(), 0u);
}

TEST(Reconstruction, refuses_much_noise)
{
  const auto [points, normals] = noise(6000);
  EXPECT_THROW(reconstruction(glue_surfels(points, normals)),
               CGAL::Geodesic_processing::Unsupported_surface_error);
}

} // namespace
