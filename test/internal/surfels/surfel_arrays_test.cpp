// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <tuple>

namespace CGAL::Geodesic_processing::internal {
namespace surfel_arrays_test {

struct Cloud
{
  std::vector<Vec3> points, normals;

  Surfel_arrays build_arrays(const Surfel_options& options = {}) const
  {
    return build_surfel_arrays(points, normals, {}, options);
  }
};

Cloud random_sphere(std::size_t n, unsigned seed = 1)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> coordinate;
  Cloud cloud;
  for(std::size_t i = 0; i < n; ++i)
    cloud.points.push_back(unit({coordinate(random), coordinate(random), coordinate(random)}));
  cloud.normals = cloud.points;
  return cloud;
}

Cloud fibonacci_sphere(std::size_t n)
{
  Cloud cloud;
  const double golden_angle = pi * (3. - std::sqrt(5.));
  for(std::size_t i = 0; i < n; ++i)
  {
    const double z = 1. - (2. * i + 1.) / n, r = std::sqrt(1. - z * z);
    cloud.points.push_back({r * std::cos(golden_angle * i), r * std::sin(golden_angle * i), z});
  }
  cloud.normals = cloud.points;
  return cloud;
}

// Returns random points of the unit square at the given height, with the normals (0, 0, up).
Cloud random_square(std::size_t n, unsigned seed = 1, double height = 0., double up = 1.)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate;
  Cloud cloud;
  for(std::size_t i = 0; i < n; ++i)
    cloud.points.push_back({coordinate(random), coordinate(random), height});
  cloud.normals.assign(n, {0., 0., up});
  return cloud;
}

Cloud lattice(std::size_t n)
{
  Cloud cloud;
  for(std::size_t i = 0; i <= n; ++i)
    for(std::size_t j = 0; j <= n; ++j)
      cloud.points.push_back({double(i) / n, double(j) / n, 0.});
  cloud.normals.assign(cloud.points.size(), {0., 0., 1.});
  return cloud;
}

Cloud merged(Cloud a, const Cloud& b)
{
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  a.normals.insert(a.normals.end(), b.normals.begin(), b.normals.end());
  return a;
}

double area(const Surface_arrays& t, std::size_t triangle)
{
  const Vec3& a = t.point[t.corner[3 * triangle]];
  return norm(cross(t.point[t.corner[3 * triangle + 1]] - a,
                    t.point[t.corner[3 * triangle + 2]] - a)) /
         2.;
}

double weighted_area(const Surface_arrays& t)
{
  double sum = 0.;
  for(std::size_t f = 0; f < t.number_of_triangles(); ++f)
    sum += t.weight[f] * area(t, f);
  return sum * t.scale * t.scale;
}

std::size_t number_of_components(const Surface_arrays& t)
{
  std::vector<Index> label(t.number_of_vertices(), none), stack;
  std::size_t count = 0;
  for(Index seed = 0; seed < label.size(); ++seed)
    if(label[seed] == none)
    {
      ++count;
      label[seed] = seed;
      stack.push_back(seed);
      while(!stack.empty())
      {
        const Index v = stack.back();
        stack.pop_back();
        for(Index e = t.graph.begin[v]; e < t.graph.begin[v + 1]; ++e)
          if(label[t.graph.target[e]] == none)
          {
            label[t.graph.target[e]] = seed;
            stack.push_back(t.graph.target[e]);
          }
      }
    }
  return count;
}

bool has_edge(const Surface_arrays& t, Index a, Index b)
{
  const auto begin = t.graph.target.begin();
  return std::binary_search(begin + t.graph.begin[a], begin + t.graph.begin[a + 1], b);
}

// Expects the invariants that hold for all clouds, including degenerate ones.
void expect_consistent(const Surfel_arrays& surfels, std::size_t number_of_surfels)
{
  const Surface_arrays& t = surfels.arrays;
  const std::size_t n = number_of_surfels, m = t.number_of_triangles();
  ASSERT_EQ(t.number_of_vertices(), n);
  ASSERT_EQ(surfels.internal_vertex.size(), n);
  ASSERT_EQ(surfels.caller_vertex.size(), n);
  ASSERT_EQ(surfels.radius.size(), n);
  ASSERT_EQ(t.point.size(), n);
  ASSERT_EQ(t.normal.size(), n);
  ASSERT_EQ(t.graph.begin.size(), n + 1);
  ASSERT_EQ(t.graph.begin.back(), t.graph.target.size());
  EXPECT_TRUE(t.graph.length.empty());
  ASSERT_EQ(t.corner.size(), 3 * m);
  ASSERT_EQ(t.length.size(), 3 * m);
  ASSERT_EQ(t.weight.size(), m);
  ASSERT_EQ(t.ring.size(), 3 * m);
  EXPECT_TRUE(t.twin.empty());
  EXPECT_TRUE(t.is_cloud());
  for(Index i = 0; i < n; ++i)
    EXPECT_EQ(surfels.internal_vertex[surfels.caller_vertex[i]], i);

  double longest = 0.;
  for(Index i = 0; i < n; ++i)
  {
    EXPECT_NEAR(norm(t.normal[i]), 1., 4e-16); // two round-off errors
    for(Index e = t.graph.begin[i]; e < t.graph.begin[i + 1]; ++e)
    {
      const Index j = t.graph.target[e];
      ASSERT_LT(j, n);
      EXPECT_NE(j, i);
      EXPECT_TRUE(has_edge(t, j, i));
      if(e > t.graph.begin[i])
      {
        EXPECT_LT(t.graph.target[e - 1], j);
      }
      longest = std::max(longest, norm(t.point[i] - t.point[j]));
    }
    for(Index s = t.ring_begin[i]; s < t.ring_begin[i + 1]; ++s)
      EXPECT_EQ(t.corner[t.ring[s]], i);
  }
  if(longest > 0.)
  {
    EXPECT_GE(longest, 1.);
    EXPECT_LT(longest, 2.);
  }

  std::set<std::array<Index, 3>> seen;
  for(std::size_t f = 0; f < m; ++f)
  {
    std::array<Index, 3> corners = {t.corner[3 * f], t.corner[3 * f + 1], t.corner[3 * f + 2]};
    for(int k = 0; k < 3; ++k)
    {
      EXPECT_TRUE(has_edge(t, corners[k], corners[(k + 1) % 3]));
      EXPECT_DOUBLE_EQ(t.length[3 * f + k],
                       norm(t.point[corners[k]] - t.point[corners[(k + 1) % 3]]));
      EXPECT_GT(t.length[3 * f + k], 0.);
    }
    EXPECT_TRUE(t.weight[f] == 1.f || t.weight[f] == 1.f / 3.f || t.weight[f] == 2.f / 3.f);
    std::sort(corners.begin(), corners.end());
    EXPECT_TRUE(seen.insert(corners).second);
  }
}

TEST(Surfel_arrays, handles_fewer_than_three_surfels)
{
  expect_consistent(build_surfel_arrays({}, {}), 0);
  expect_consistent(build_surfel_arrays({{5., 6., 7.}}, {{0., 0., 2.}}), 1);
  const Surfel_arrays two =
      build_surfel_arrays({{0., 0., 0.}, {3., 0., 0.}}, {{0., 0., 1.}, {0., 0., 1.}});
  expect_consistent(two, 2);
  EXPECT_EQ(two.arrays.graph.target.size(), 2u);
  EXPECT_EQ(norm(two.arrays.point[1] - two.arrays.point[0]) * two.arrays.scale, 3.);
}

TEST(Surfel_arrays, builds_one_triangle)
{
  const Surfel_arrays surfels = build_surfel_arrays({{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}},
                                                    std::vector<Vec3>(3, {0., 0., 1.}));
  expect_consistent(surfels, 3);
  ASSERT_EQ(surfels.arrays.number_of_triangles(), 1u);
  EXPECT_EQ(surfels.arrays.weight[0], 1.f);
  EXPECT_NEAR(weighted_area(surfels.arrays), 0.5, 1e-15); // round-off error
}

TEST(Surfel_arrays, triangles_are_oriented_by_normals)
{
  const Surface_arrays t = random_sphere(500).build_arrays().arrays;
  for(std::size_t f = 0; f < t.number_of_triangles(); ++f)
  {
    const Index a = t.corner[3 * f], b = t.corner[3 * f + 1], c = t.corner[3 * f + 2];
    EXPECT_GT(dot(t.normal[a], cross(t.point[b] - t.point[a], t.point[c] - t.point[a])), 0.);
  }
}

// Expects that the triangles tile the unit square: all corners find the same triangles, and each
// interior edge has two of them. Their area is that of the square except along the boundary.
void expect_tiling(const Cloud& cloud, double tolerance)
{
  const Surfel_arrays surfels = cloud.build_arrays();
  expect_consistent(surfels, cloud.points.size());
  const Surface_arrays& t = surfels.arrays;
  std::map<std::pair<Index, Index>, int> halfedges;
  for(Index h = 0; h < t.corner.size(); ++h)
    ++halfedges[{t.corner[h], t.corner[next_halfedge(h)]}];
  std::size_t interior = 0, fully_weighted = 0;
  for(const auto& [ends, count] : halfedges)
  {
    EXPECT_EQ(count, 1);
    interior += halfedges.count({ends.second, ends.first});
  }
  for(const float weight : t.weight)
    fully_weighted += weight == 1.f;
  // Only along the boundary, some triangles are not found by all of their corners.
  EXPECT_GT(fully_weighted, (1. - tolerance) * t.number_of_triangles());
  EXPECT_GT(interior, (1. - tolerance) * halfedges.size());
  EXPECT_NEAR(weighted_area(t), 1., tolerance);
  EXPECT_LT(weighted_area(t), 1. + 1e-12); // round-off errors of a sum of weighted areas
}

TEST(Surfel_arrays, triangles_tile_random_samples_of_a_plane)
{
  expect_tiling(random_square(5000), 0.03);
}

TEST(Surfel_arrays, triangles_tile_a_square_lattice)
{
  const Cloud cloud = lattice(40);
  expect_tiling(cloud, 0.06);
  const Surface_arrays t = cloud.build_arrays().arrays;
  EXPECT_EQ(t.number_of_triangles(), 2u * 40u * 40u);
}

TEST(Surfel_arrays, triangles_cover_a_sphere)
{
  for(const Cloud& cloud : {random_sphere(4000), fibonacci_sphere(4000)})
  {
    const Surfel_arrays surfels = cloud.build_arrays();
    expect_consistent(surfels, 4000);
    EXPECT_EQ(number_of_components(surfels.arrays), 1u);
    // The area of an inscribed triangulation with the mean edge length h is smaller by about
    // h^2 / 4, which is 0.05 % here. If the corners of a triangle find different triangles, areas
    // are counted partially or twice.
    EXPECT_NEAR(weighted_area(surfels.arrays) / (4. * pi), 1., 2e-3);
    // A closed mesh of genus 0 has 2 (4000 - 2) triangles. Some more are found by one corner only.
    EXPECT_NEAR(double(surfels.arrays.number_of_triangles()), 7996., 60.);
  }
}

TEST(Surfel_arrays, is_scale_invariant)
{
  const Cloud cloud = random_sphere(1000);
  const Surfel_arrays expected = cloud.build_arrays();
  for(const int exponent : {-530, -20, 20, 530})
  {
    Cloud scaled = cloud;
    for(Vec3& p : scaled.points)
      p = std::ldexp(1., exponent) * p;
    const Surfel_arrays surfels = scaled.build_arrays();
    EXPECT_EQ(surfels.arrays.corner, expected.arrays.corner);
    EXPECT_EQ(surfels.arrays.length, expected.arrays.length);
    EXPECT_EQ(surfels.arrays.scale, std::ldexp(expected.arrays.scale, exponent));
  }
  Cloud scaled = cloud;
  for(Vec3& p : scaled.points)
    p = 1e6 * p;
  EXPECT_EQ(scaled.build_arrays().arrays.corner, expected.arrays.corner);
}

TEST(Surfel_arrays, handles_large_offset_from_origin)
{
  Cloud cloud = lattice(30);
  for(Vec3& p : cloud.points)
    p = 30. * p + Vec3{494680., 5420300., 250.};
  const Surfel_arrays surfels = cloud.build_arrays();
  expect_consistent(surfels, cloud.points.size());
  EXPECT_EQ(surfels.arrays.number_of_triangles(), 2u * 30u * 30u);
  // The round-off error of coordinates of 5e6 is 5e-10.
  for(std::size_t f = 0; f < surfels.arrays.number_of_triangles(); ++f)
    EXPECT_NEAR(area(surfels.arrays, f) * surfels.arrays.scale * surfels.arrays.scale, 0.5, 1e-8);
}

TEST(Surfel_arrays, does_not_depend_on_input_order)
{
  Cloud cloud = random_sphere(2000);
  const Surfel_arrays expected = cloud.build_arrays();
  std::vector<Index> order(2000);
  for(Index i = 0; i < 2000; ++i)
    order[i] = i;
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  Cloud shuffled = cloud;
  for(Index i = 0; i < 2000; ++i)
  {
    shuffled.points[i] = cloud.points[order[i]];
    shuffled.normals[i] = cloud.normals[order[i]];
  }
  const Surfel_arrays surfels = shuffled.build_arrays();
  EXPECT_EQ(surfels.arrays.corner, expected.arrays.corner);
  EXPECT_EQ(surfels.arrays.graph.target, expected.arrays.graph.target);
  EXPECT_EQ(surfels.arrays.length, expected.arrays.length);
  for(Index v = 0; v < 2000; ++v)
    EXPECT_EQ(order[surfels.caller_vertex[v]], expected.caller_vertex[v]);
}

TEST(Surfel_arrays, does_not_depend_on_number_of_threads)
{
  const Cloud cloud = merged(random_sphere(10000), random_square(5000, 7, 3.));
  const Surfel_arrays one = cloud.build_arrays();
  Surfel_options options;
  options.number_of_threads = 4;
  const Surfel_arrays four = cloud.build_arrays(options);
  EXPECT_EQ(one.arrays.corner, four.arrays.corner);
  EXPECT_EQ(one.arrays.weight, four.arrays.weight);
  EXPECT_EQ(one.arrays.length, four.arrays.length);
  EXPECT_EQ(one.arrays.graph.begin, four.arrays.graph.begin);
  EXPECT_EQ(one.arrays.graph.target, four.arrays.graph.target);
  EXPECT_EQ(one.caller_vertex, four.caller_vertex);
}

TEST(Surfel_arrays, connects_copies_to_their_original)
{
  Cloud cloud = random_sphere(200);
  cloud = merged(merged(cloud, cloud), cloud);
  const Surfel_arrays surfels = cloud.build_arrays();
  expect_consistent(surfels, 600);
  const Surface_arrays& t = surfels.arrays;
  EXPECT_EQ(surfels.tree.size(), 200u);
  EXPECT_EQ(number_of_components(t), 1u);
  EXPECT_EQ(t.number_of_triangles(),
            random_sphere(200).build_arrays().arrays.number_of_triangles());
  for(Index surfel = 200; surfel < 600; ++surfel)
  {
    const Index v = surfels.internal_vertex[surfel];
    ASSERT_EQ(t.graph.begin[v + 1] - t.graph.begin[v], 1u);
    const Index e = t.graph.begin[v];
    EXPECT_EQ(t.graph.target[e], surfels.internal_vertex[surfel % 200]);
    // Copies lie exactly at their originals, although points within 2^-51 of the extent are merged.
    EXPECT_EQ(t.point[t.graph.target[e]], t.point[v]);
    EXPECT_EQ(surfels.radius[v], surfels.radius[surfels.internal_vertex[surfel % 200]]);
  }
}

// If each of 100,000 copies of a point had all others as neighbors, this would take minutes.
TEST(Surfel_arrays, coincident_surfels_take_linear_time)
{
  const std::size_t n = 100000;
  const Surfel_arrays surfels = build_surfel_arrays(std::vector<Vec3>(n, {1.5, 1.5, 1.5}),
                                                    std::vector<Vec3>(n, {0., 1., 0.}));
  EXPECT_EQ(surfels.arrays.graph.target.size(), 2 * (n - 1));
  EXPECT_EQ(number_of_components(surfels.arrays), 1u);
  EXPECT_EQ(surfels.arrays.number_of_triangles(), 0u);
}

TEST(Surfel_arrays, separates_sides_of_a_sheet)
{
  Cloud cloud = random_square(2000);
  const Cloud below = {cloud.points, std::vector<Vec3>(2000, {0., 0., -1.})};
  cloud = merged(cloud, below);
  const Surfel_arrays surfels = cloud.build_arrays();
  expect_consistent(surfels, 4000);
  EXPECT_EQ(surfels.tree.size(), 4000u);
  EXPECT_EQ(number_of_components(surfels.arrays), 2u);
  // The squares have no surfels along their sides: 0.06 of the area is missing.
  EXPECT_NEAR(weighted_area(surfels.arrays), 2., 0.12);
}

// Two parallel sheets, with equal or opposite normals, whose distance is less than that of the 8th
// neighbor.
TEST(Surfel_arrays, separates_parallel_sheets)
{
  const std::size_t n = 3000;
  const double gap = 1.1 / std::sqrt(double(n));
  for(const double up : {1., -1.})
  {
    const Cloud cloud = merged(random_square(n, 1, 0.), random_square(n, 2, gap, up));
    const Surfel_arrays surfels = cloud.build_arrays();
    expect_consistent(surfels, 2 * n);
    for(Index i = 0; i < 2 * n; ++i)
      for(Index e = surfels.arrays.graph.begin[i]; e < surfels.arrays.graph.begin[i + 1]; ++e)
        EXPECT_EQ(surfels.caller_vertex[i] < n,
                  surfels.caller_vertex[surfels.arrays.graph.target[e]] < n);
    // The squares have no surfels along their sides: 0.06 of the area is missing.
    EXPECT_NEAR(weighted_area(surfels.arrays), 2., 0.1);
  }
}

TEST(Surfel_arrays, connects_across_sharp_edges)
{
  // Two perpendicular squares; the normals along their common edge are the means of both.
  Cloud cloud;
  for(int i = 0; i <= 20; ++i)
    for(int j = -20; j <= 20; ++j)
    {
      cloud.points.push_back({i / 20., std::max(j, 0) / 20., std::min(j, 0) / 20.});
      cloud.normals.push_back(j > 0   ? Vec3{0., 0., 1.}
                              : j < 0 ? Vec3{0., -1., 0.}
                                      : Vec3{0., -1., 1.});
    }
  const Surfel_arrays surfels = cloud.build_arrays();
  expect_consistent(surfels, cloud.points.size());
  EXPECT_EQ(number_of_components(surfels.arrays), 1u);
  // The area is only wrong next to the edge, in 3 of 20 rows.
  EXPECT_NEAR(weighted_area(surfels.arrays), 2., 0.1);
}

TEST(Surfel_arrays, keeps_holes_open)
{
  Cloud cloud = lattice(40), ring;
  for(std::size_t i = 0; i < cloud.points.size(); ++i)
    if(std::hypot(cloud.points[i][0] - 0.5, cloud.points[i][1] - 0.5) > 0.2)
    {
      ring.points.push_back(cloud.points[i]);
      ring.normals.push_back(cloud.normals[i]);
    }
  const Surfel_arrays surfels = ring.build_arrays();
  expect_consistent(surfels, ring.points.size());
  for(std::size_t f = 0; f < surfels.arrays.number_of_triangles(); ++f)
  {
    const Surface_arrays& t = surfels.arrays;
    const Vec3 centroid =
        1. / 3. *
        (t.point[t.corner[3 * f]] + t.point[t.corner[3 * f + 1]] + t.point[t.corner[3 * f + 2]]);
    const Vec3 at = t.scale * centroid + t.origin;
    // Triangles extend into the hole by less than the spacing.
    EXPECT_GT(std::hypot(at[0] - 0.5, at[1] - 0.5), 0.2 - 1. / 40.);
  }
}

TEST(Surfel_arrays, outliers_have_no_triangles)
{
  Cloud cloud = random_sphere(2000);
  cloud.points.push_back({0., 0., 0.});
  cloud.normals.push_back({0., 0., 1.});
  cloud.points.push_back({0., 3., 0.});
  cloud.normals.push_back({0., 1., 0.});
  const Surfel_arrays surfels = cloud.build_arrays();
  expect_consistent(surfels, 2002);
  for(const Index surfel : {2000, 2001})
  {
    const Index v = surfels.internal_vertex[surfel];
    EXPECT_EQ(surfels.arrays.ring_begin[v], surfels.arrays.ring_begin[v + 1]);
  }
}

TEST(Surfel_arrays, collinear_surfels_have_edges_but_no_triangles)
{
  Cloud cloud;
  for(int i = 0; i < 300; ++i)
    cloud.points.push_back({i / 300., 2. * i / 300., 3. * i / 300.});
  cloud.normals.assign(300, unit({3., 0., -1.}));
  const Surfel_arrays surfels = cloud.build_arrays();
  expect_consistent(surfels, 300);
  EXPECT_EQ(number_of_components(surfels.arrays), 1u);
  // The circumradius of nearly collinear points is too large for a triangle.
  EXPECT_EQ(surfels.arrays.number_of_triangles(), 0u);
}

TEST(Surfel_arrays, connects_surfels_whose_spheres_intersect)
{
  const std::size_t n = 11;
  Cloud cloud;
  for(std::size_t i = 0; i < n; ++i)
    cloud.points.push_back({100. * i, 0., 0.});
  cloud.normals.assign(n, {0., 0., 1.});
  const auto degree = [&](double radius, Index surfel)
  {
    const Surfel_arrays s =
        build_surfel_arrays(cloud.points, cloud.normals, std::vector<double>(n, radius));
    const Index v = s.internal_vertex[surfel];
    EXPECT_DOUBLE_EQ(s.radius[v] * s.arrays.scale, radius);
    return s.arrays.graph.begin[v + 1] - s.arrays.graph.begin[v];
  };
  EXPECT_EQ(degree(49., 5), 0u);
  EXPECT_EQ(degree(51., 5), 2u);
  EXPECT_EQ(degree(101., 5), 4u);
  EXPECT_EQ(degree(101., 0), 2u);
  EXPECT_EQ(degree(0., 3), 0u);
}

TEST(Surfel_arrays, normalizes_normals_and_throws_on_zero_normal)
{
  Cloud cloud = random_sphere(500);
  const Surfel_arrays expected = cloud.build_arrays();
  for(std::size_t i = 0; i < 500; ++i)
    cloud.normals[i] = std::ldexp(1., int(i % 41) - 20) * cloud.normals[i];
  EXPECT_EQ(cloud.build_arrays().arrays.corner, expected.arrays.corner);
  cloud.normals[7] = {0., 0., 0.};
  EXPECT_THROW(cloud.build_arrays(), Invalid_argument_error);
  cloud.normals[7] = {std::nan(""), 0., 1.};
  EXPECT_THROW(cloud.build_arrays(), Invalid_argument_error);
}

TEST(Surfel_arrays, throws_on_invalid_input)
{
  const Cloud cloud = random_square(10);
  Cloud bad = cloud;
  bad.points[3][1] = std::nan("");
  EXPECT_THROW(bad.build_arrays(), Invalid_argument_error);
  bad.points[3][1] = infinity;
  EXPECT_THROW(bad.build_arrays(), Invalid_argument_error);
  bad = cloud;
  bad.normals.pop_back();
  EXPECT_THROW(bad.build_arrays(), Invalid_argument_error);
  EXPECT_THROW(build_surfel_arrays(cloud.points, cloud.normals, {1., 2.}), Invalid_argument_error);
  std::vector<double> radii(10, 1.);
  radii[4] = -1.;
  EXPECT_THROW(build_surfel_arrays(cloud.points, cloud.normals, radii), Invalid_argument_error);
  radii[4] = infinity;
  EXPECT_THROW(build_surfel_arrays(cloud.points, cloud.normals, radii), Invalid_argument_error);
  Surfel_options options;
  options.maximum_angle = 0.;
  EXPECT_THROW(cloud.build_arrays(options), Invalid_argument_error);
  options = {};
  options.rank = 0;
  EXPECT_THROW(cloud.build_arrays(options), Invalid_argument_error);
}

TEST(Surfel_arrays, locates_points_on_nearest_tangent_plane)
{
  const Cloud cloud = fibonacci_sphere(3000);
  const Surfel_arrays surfels = cloud.build_arrays();
  const Surface_arrays& t = surfels.arrays;
  for(Index i = 0; i < 3000; i += 37)
  {
    const Tangent_location location = locate(surfels, 1.5 * cloud.points[i]);
    EXPECT_EQ(surfels.caller_vertex[location.vertex], i);
    // The round-off errors of a projection; measured are 2e-15.
    EXPECT_NEAR(std::hypot(location.offset[0], location.offset[1]), 0., 1e-14 * 1.5 / t.scale);
  }
  std::mt19937 random(9);
  std::normal_distribution<double> coordinate;
  for(int i = 0; i < 200; ++i)
  {
    const Vec3 query = unit({coordinate(random), coordinate(random), coordinate(random)});
    const Tangent_location location = locate(surfels, query);
    const Vec3 found = t.origin + t.scale * position(t, location);
    // The distance of a tangent plane from the sphere is half of the squared offset. The spacing
    // is 0.065, and the nearest surfel is within 0.75 spacings.
    EXPECT_LT(norm(found - query), 0.0013);

    // Convert to a triangle and back. The triangle is below the sphere by the same distance. The
    // direction of the projection is the normal at the surfel.
    const Surface_location in_triangle = to_surface_location(t, location);
    ASSERT_NE(in_triangle.triangle, none);
    double sum = 0.;
    for(const double b : in_triangle.barycentric)
    {
      EXPECT_GE(b, 0.);
      sum += b;
    }
    EXPECT_NEAR(sum, 1., 1e-15); // the round-off errors of two additions
    const Vec3 again = t.origin + t.scale * position(t, to_tangent_location(t, in_triangle));
    EXPECT_LT(norm(again - query), 0.003);
  }
}

TEST(Surfel_arrays, projects_points_beyond_boundary_to_nearest_triangle)
{
  const Cloud cloud = lattice(4);
  const Surfel_arrays surfels = cloud.build_arrays();
  const Surface_arrays& t = surfels.arrays;
  for(const auto& [x, y] : {std::pair{-0.1, 0.4}, {1.1, 0.6}, {0.3, -0.05}, {-0.1, -0.1}})
  {
    const Surface_location location = to_surface_location(t, locate(surfels, {x, y, 0.2}));
    ASSERT_NE(location.triangle, none);
    Vec3 at = {0., 0., 0.};
    for(int k = 0; k < 3; ++k)
      at = at + location.barycentric[k] * t.point[t.corner[3 * location.triangle + k]];
    at = t.origin + t.scale * at;
    // Round-off errors of the barycentric coordinates and of their sum.
    EXPECT_NEAR(at[0], std::clamp(x, 0., 1.), 1e-14);
    EXPECT_NEAR(at[1], std::clamp(y, 0., 1.), 1e-14);
  }
}

TEST(Surfel_arrays, locates_points_at_isolated_surfel)
{
  const Surfel_arrays surfels = build_surfel_arrays({{1., 2., 3.}}, {{0., 0., 1.}});
  const Tangent_location location = locate(surfels, {1e200, -1e300, 0.});
  EXPECT_EQ(location.vertex, 0u);
  const Surface_location same = to_surface_location(surfels.arrays, location);
  EXPECT_EQ(same.triangle, none);
  EXPECT_EQ(same.vertex, 0u);
  EXPECT_EQ(to_tangent_location(surfels.arrays, same).vertex, 0u);
  EXPECT_THROW(locate(surfels, {0., 0., infinity}), Invalid_argument_error);
}

} // namespace surfel_arrays_test
} // namespace CGAL::Geodesic_processing::internal
