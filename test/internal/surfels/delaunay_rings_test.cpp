// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surfels/delaunay_rings.h"

#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace delaunay_rings_test {

using namespace CGAL::Geodesic_processing::internal;

// The surfels of a plane and their rings.
struct Plane
{
  explicit Plane(const std::vector<Vec3>& points)
      : sorted(sort_surfels(points, std::vector<Vec3>(points.size(), {0., 0., 1.}), test.cosine, 1))
  {
    Neighbor_distances distances;
    Ragged_rows neighbors = find_neighbors(sorted, &test, number_of_ring_neighbors, 1, distances);
    const std::vector<double> radius = surfel_radii(sorted, {}, neighbors, 8, 1);
    rings = find_delaunay_rings({sorted.point, sorted.normal, sorted.tree, test, 1}, neighbors,
                                distances.search_radius, radius);
  }

  std::vector<Index> ring_of_point(std::size_t i) const
  {
    std::vector<Index> result;
    const Index v = sorted.internal_vertex[i];
    for(const Index* it = rings.begin(v); it != rings.end(v); ++it)
      result.push_back(*it == none ? none : sorted.caller_vertex[*it]);
    return result;
  }

  Compatibility_test test = {0.5};
  Sorted_surfels sorted;
  Ragged_rows rings{0};
};

TEST(delaunay_rings, ring_of_hexagonal_lattice_is_closed_and_counterclockwise)
{
  std::vector<Vec3> points = {{0., 0., 0.}};
  for(const double radius : {1., 2.})
    for(int k = 0; k < 6; ++k)
      points.push_back({radius * std::cos(k * pi / 3.), radius * std::sin(k * pi / 3.), 0.});
  for(int k = 0; k < 6; ++k)
    points.push_back({std::sqrt(3.) * std::cos((k + 0.5) * pi / 3.),
                      std::sqrt(3.) * std::sin((k + 0.5) * pi / 3.), 0.});
  const Plane plane(points);
  std::vector<Index> ring = plane.ring_of_point(0);
  ASSERT_EQ(ring.size(), 6u);
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  EXPECT_EQ(ring, (std::vector<Index>{1, 2, 3, 4, 5, 6}));
  // A corner of the hexagon: two triangles, which do not surround it.
  EXPECT_EQ(plane.ring_of_point(7), (std::vector<Index>{13, 1, 18, none}));
}

TEST(delaunay_rings, circumcircles_of_random_points_are_empty)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1., 1.);
  std::vector<Vec3> points;
  for(int i = 0; i < 500; ++i)
    points.push_back({coordinate(random), coordinate(random), 0.});
  const Plane plane(points);
  std::size_t number_of_triangles = 0;
  for(Index i = 0; i < points.size(); ++i)
  {
    const std::vector<Index> ring = plane.ring_of_point(i);
    for(std::size_t k = 0; k < ring.size(); ++k)
    {
      const Index a = ring[k], b = ring[(k + 1) % ring.size()];
      if(a == none || b == none)
        continue;
      ++number_of_triangles;
      const Vec3 p = points[a] - points[i], q = points[b] - points[i];
      const double doubled_area = p[0] * q[1] - p[1] * q[0];
      ASSERT_GT(doubled_area, 0.);
      const Vec3 center = points[i] + 0.5 / doubled_area *
                                          Vec3{q[1] * dot(p, p) - p[1] * dot(q, q),
                                               p[0] * dot(q, q) - q[0] * dot(p, p), 0.};
      const double radius = norm(center - points[i]);
      // Round-off errors, which are large for circumcircles of obtuse triangles.
      for(const Vec3& other : points)
        EXPECT_GT(norm(other - center), radius * (1. - 1e-9));
    }
  }
  // The triangulation has nearly 2 n triangles, each of which belongs to three rings.
  EXPECT_GT(number_of_triangles, 2700u);
}

} // namespace delaunay_rings_test
