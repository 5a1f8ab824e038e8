// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

// The local triangles of surfels in a plane equal the Delaunay triangles of all points. Only
// triangles near the boundary with large circumradii are missing.

namespace CGAL::Geodesic_processing::internal {
namespace local_triangles_vs_delaunay {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;
using Triangles = std::set<std::array<Index, 3>>;

std::array<Index, 3> sorted(std::array<Index, 3> corners)
{
  std::sort(corners.begin(), corners.end());
  return corners;
}

// Places points in the plane with axes (2, 1, 2) / 3 and (-2, 2, 1) / 3 and compares the
// triangles.
void expect_agreement(const std::vector<std::array<double, 2>>& points_in_plane)
{
  const std::array<double, 3> normal = {-1. / 3., -2. / 3., 2. / 3.};
  std::vector<std::array<double, 3>> points;
  std::vector<std::pair<Kernel::Point_2, Index>> points_with_index;
  for(Index i = 0; i < points_in_plane.size(); ++i)
  {
    const auto [x, y] = points_in_plane[i];
    points.push_back({(2. * x - 2. * y) / 3., (x + 2. * y) / 3., (2. * x + y) / 3.});
    points_with_index.emplace_back(Kernel::Point_2(x, y), i);
  }
  const Delaunay delaunay(points_with_index.begin(), points_with_index.end());

  const Surfel_arrays surfels =
      build_surfel_arrays(points, std::vector<std::array<double, 3>>(points.size(), normal));
  const Surface_arrays& t = surfels.arrays;
  Triangles local_triangles;
  for(std::size_t f = 0; f < t.number_of_triangles(); ++f)
  {
    std::array<Index, 3> corners;
    for(int k = 0; k < 3; ++k)
      corners[k] = surfels.caller_vertex[t.corner[3 * f + k]];
    if(t.weight[f] == 1.f)
      local_triangles.insert(sorted(corners));
  }

  std::size_t number_of_rejected = 0;
  Triangles delaunay_triangles;
  for(const auto face : delaunay.finite_face_handles())
  {
    const std::array<Index, 3> corners = {face->vertex(0)->info(), face->vertex(1)->info(),
                                          face->vertex(2)->info()};
    delaunay_triangles.insert(sorted(corners));
    const double circumradius = std::sqrt(CGAL::squared_radius(
        face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point()));
    double radius = infinity;
    for(const Index corner : corners)
      radius = std::min(radius, t.scale * surfels.radius[surfels.internal_vertex[corner]]);
    // The limit is 2.5 radii. A factor of 2.499 allows for round-off errors of the radii.
    if(circumradius < 2.499 * radius)
    {
      EXPECT_TRUE(local_triangles.count(sorted(corners)));
    }
    else
      ++number_of_rejected;
  }
  for(const auto& corners : local_triangles)
    EXPECT_TRUE(delaunay_triangles.count(corners));
  // Only the boundary, with about 4 sqrt(n) surfels, has such triangles.
  EXPECT_LT(number_of_rejected, 4. * std::sqrt(double(points_in_plane.size())));
}

TEST(Local_triangles_vs_delaunay, agree_on_uniform_samples)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate;
  std::vector<std::array<double, 2>> points_in_plane(20000);
  for(auto& point_in_plane : points_in_plane)
    point_in_plane = {coordinate(random), coordinate(random)};
  expect_agreement(points_in_plane);
}

TEST(Local_triangles_vs_delaunay, agree_on_varying_density)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate;
  std::vector<std::array<double, 2>> points_in_plane(20000);
  for(auto& point_in_plane : points_in_plane)
  {
    // Four times as dense on the left as on the right.
    const double x = coordinate(random);
    point_in_plane = {x * (x + 2. / 3.), coordinate(random)};
  }
  expect_agreement(points_in_plane);
}

} // namespace local_triangles_vs_delaunay
} // namespace CGAL::Geodesic_processing::internal
