// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/planar.h>
#include <CGAL/Geodesic_processing/internal/core/spatial.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfels.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <tuple>

namespace CGAL::Geodesic_processing::internal {
namespace {

struct Cloud
{
  std::vector<Spatial> points, normals;

  Glued_surfels glued(const Surfel_options& options = {}) const
  {
    return glue_surfels(points, normals, {}, options);
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
  const double turn = pi * (3. - std::sqrt(5.));
  for(std::size_t i = 0; i < n; ++i)
  {
    const double z = 1. - (2. * i + 1.) / n, r = std::sqrt(1. - z * z);
    cloud.points.push_back({r * std::cos(turn * i), r * std::sin(turn * i), z});
  }
  cloud.normals = cloud.points;
  return cloud;
}

// Points of the unit square at a height.
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

Cloud lattice(std::size_t side)
{
  Cloud cloud;
  for(std::size_t i = 0; i <= side; ++i)
    for(std::size_t j = 0; j <= side; ++j)
      cloud.points.push_back({double(i) / side, double(j) / side, 0.});
  cloud.normals.assign(cloud.points.size(), {0., 0., 1.});
  return cloud;
}

Cloud together(Cloud a, const Cloud& b)
{
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  a.normals.insert(a.normals.end(), b.normals.begin(), b.normals.end());
  return a;
}

double area(const Glued_triangles& t, std::size_t triangle)
{
  const Spatial& a = t.point[t.corner[3 * triangle]];
  return norm(cross(t.point[t.corner[3 * triangle + 1]] - a,
                    t.point[t.corner[3 * triangle + 2]] - a)) /
         2.;
}

double weighted_area(const Glued_triangles& t)
{
  double sum = 0.;
  for(std::size_t f = 0; f < t.number_of_triangles(); ++f)
    sum += t.weight[f] * area(t, f);
  return sum * t.scale * t.scale;
}

std::size_t number_of_components(const Glued_triangles& t)
{
  std::vector<Index> label(t.number_of_sites(), none), stack;
  std::size_t count = 0;
  for(Index seed = 0; seed < label.size(); ++seed)
    if(label[seed] == none)
    {
      ++count;
      label[seed] = seed;
      stack.push_back(seed);
      while(!stack.empty())
      {
        const Index site = stack.back();
        stack.pop_back();
        for(Index arc = t.graph.first[site]; arc < t.graph.first[site + 1]; ++arc)
          if(label[t.graph.target[arc]] == none)
          {
            label[t.graph.target[arc]] = seed;
            stack.push_back(t.graph.target[arc]);
          }
      }
    }
  return count;
}

bool has_arc(const Glued_triangles& t, Index a, Index b)
{
  const auto begin = t.graph.target.begin();
  return std::binary_search(begin + t.graph.first[a], begin + t.graph.first[a + 1], b);
}

// What holds for every cloud, however bad.
void expect_consistent(const Glued_surfels& surfels, std::size_t number_of_surfels)
{
  const Glued_triangles& t = surfels.triangles;
  const std::size_t n = number_of_surfels, m = t.number_of_triangles();
  ASSERT_EQ(t.number_of_sites(), n);
  ASSERT_EQ(surfels.site_of_surfel.size(), n);
  ASSERT_EQ(surfels.surfel_of_site.size(), n);
  ASSERT_EQ(surfels.radius.size(), n);
  ASSERT_EQ(t.point.size(), n);
  ASSERT_EQ(t.normal.size(), n);
  ASSERT_EQ(t.graph.first.size(), n + 1);
  ASSERT_EQ(t.graph.first.back(), t.graph.target.size());
  ASSERT_EQ(t.graph.length.size(), t.graph.target.size());
  ASSERT_EQ(t.corner.size(), 3 * m);
  ASSERT_EQ(t.length.size(), 3 * m);
  ASSERT_EQ(t.weight.size(), m);
  ASSERT_EQ(t.star.size(), 3 * m);
  EXPECT_TRUE(t.twin.empty());
  EXPECT_TRUE(t.is_cloud());
  for(Index i = 0; i < n; ++i)
    EXPECT_EQ(surfels.site_of_surfel[surfels.surfel_of_site[i]], i);

  double longest = 0.;
  for(Index i = 0; i < n; ++i)
  {
    EXPECT_NEAR(norm(t.normal[i]), 1., 4e-16); // two roundings
    for(Index arc = t.graph.first[i]; arc < t.graph.first[i + 1]; ++arc)
    {
      const Index j = t.graph.target[arc];
      ASSERT_LT(j, n);
      EXPECT_NE(j, i);
      EXPECT_TRUE(has_arc(t, j, i));
      if(arc > t.graph.first[i])
      {
        EXPECT_LT(t.graph.target[arc - 1], j);
      }
      // Coincidence is judged at 2^-51 of the extent, copies lie exactly at their originals.
      EXPECT_DOUBLE_EQ(t.graph.length[arc], norm(t.point[i] - t.point[j]));
      longest = std::max(longest, t.graph.length[arc]);
    }
    for(Index s = t.first[i]; s < t.first[i + 1]; ++s)
      EXPECT_EQ(t.corner[t.star[s]], i);
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
      EXPECT_TRUE(has_arc(t, corners[k], corners[(k + 1) % 3]));
      EXPECT_DOUBLE_EQ(t.length[3 * f + k],
                       norm(t.point[corners[k]] - t.point[corners[(k + 1) % 3]]));
      EXPECT_GT(t.length[3 * f + k], 0.);
    }
    EXPECT_TRUE(t.weight[f] == 1.f || t.weight[f] == 1.f / 3.f || t.weight[f] == 2.f / 3.f);
    std::sort(corners.begin(), corners.end());
    EXPECT_TRUE(seen.insert(corners).second);
  }
}

TEST(Surfels, nothing_one_and_two_surfels)
{
  expect_consistent(glue_surfels({}, {}), 0);
  expect_consistent(glue_surfels({{5., 6., 7.}}, {{0., 0., 2.}}), 1);
  const Glued_surfels two =
      glue_surfels({{0., 0., 0.}, {3., 0., 0.}}, {{0., 0., 1.}, {0., 0., 1.}});
  expect_consistent(two, 2);
  EXPECT_EQ(two.triangles.graph.target.size(), 2u);
  EXPECT_EQ(two.triangles.graph.length[0] * two.triangles.scale, 3.);
}

TEST(Surfels, one_triangle)
{
  const Glued_surfels surfels = glue_surfels({{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}},
                                             std::vector<Spatial>(3, {0., 0., 1.}));
  expect_consistent(surfels, 3);
  ASSERT_EQ(surfels.triangles.number_of_triangles(), 1u);
  EXPECT_EQ(surfels.triangles.weight[0], 1.f);
  EXPECT_NEAR(weighted_area(surfels.triangles), 0.5, 1e-15);
}

TEST(Surfels, triangles_turn_counterclockwise_about_the_normals)
{
  const Glued_triangles t = random_sphere(500).glued().triangles;
  for(std::size_t f = 0; f < t.number_of_triangles(); ++f)
  {
    const Index a = t.corner[3 * f], b = t.corner[3 * f + 1], c = t.corner[3 * f + 2];
    EXPECT_GT(dot(t.normal[a], cross(t.point[b] - t.point[a], t.point[c] - t.point[a])), 0.);
  }
}

// All corners agree on which triangles a plane has, so that these tile it: each inner side has
// exactly two, and the area is that of the square but for a rim.
void expect_tiling(const Cloud& cloud, double rim)
{
  const Glued_surfels surfels = cloud.glued();
  expect_consistent(surfels, cloud.points.size());
  const Glued_triangles& t = surfels.triangles;
  std::map<std::pair<Index, Index>, int> sides;
  for(Index side = 0; side < t.corner.size(); ++side)
    ++sides[{t.corner[side], t.corner[next_side(side)]}];
  std::size_t inner = 0, full = 0;
  for(const auto& [ends, count] : sides)
  {
    EXPECT_EQ(count, 1);
    inner += sides.count({ends.second, ends.first});
  }
  for(const float weight : t.weight)
    full += weight == 1.f;
  // Along the rim, and there only, may the corners disagree.
  EXPECT_GT(full, (1. - rim) * t.number_of_triangles());
  EXPECT_GT(inner, (1. - rim) * sides.size());
  EXPECT_NEAR(weighted_area(t), 1., rim);
  EXPECT_LT(weighted_area(t), 1. + 1e-12);
}

TEST(Surfels, triangles_tile_a_random_plane) { expect_tiling(random_square(5000), 0.03); }

TEST(Surfels, triangles_tile_a_lattice_whose_squares_have_two_diagonals)
{
  const Cloud cloud = lattice(40);
  expect_tiling(cloud, 0.06);
  const Glued_triangles t = cloud.glued().triangles;
  EXPECT_EQ(t.number_of_triangles(), 2u * 40u * 40u);
}

TEST(Surfels, triangles_cover_a_sphere_once)
{
  for(const Cloud& cloud : {random_sphere(4000), fibonacci_sphere(4000)})
  {
    const Glued_surfels surfels = cloud.glued();
    expect_consistent(surfels, 4000);
    EXPECT_EQ(number_of_components(surfels.triangles), 1u);
    // The area of an inscribed triangulation with the mean side h is less by about h^2 / 4,
    // 0.05 % here; where corners disagree some triangles are counted in part or twice.
    EXPECT_NEAR(weighted_area(surfels.triangles) / (4. * pi), 1., 2e-3);
    // Closed and of genus 0: 2 (4000 - 2) triangles, and some seen from one corner only.
    EXPECT_NEAR(double(surfels.triangles.number_of_triangles()), 7996., 60.);
  }
}

TEST(Surfels, powers_of_two_change_nothing_and_large_scales_do_not_overflow)
{
  const Cloud cloud = random_sphere(1000);
  const Glued_surfels expected = cloud.glued();
  for(const int exponent : {-530, -20, 20, 530})
  {
    Cloud scaled = cloud;
    for(Spatial& p : scaled.points)
      p = std::ldexp(1., exponent) * p;
    const Glued_surfels surfels = scaled.glued();
    EXPECT_EQ(surfels.triangles.corner, expected.triangles.corner);
    EXPECT_EQ(surfels.triangles.length, expected.triangles.length);
    EXPECT_EQ(surfels.triangles.graph.length, expected.triangles.graph.length);
    EXPECT_EQ(surfels.triangles.scale, std::ldexp(expected.triangles.scale, exponent));
  }
  Cloud scaled = cloud;
  for(Spatial& p : scaled.points)
    p = 1e6 * p;
  EXPECT_EQ(scaled.glued().triangles.corner, expected.triangles.corner);
}

TEST(Surfels, far_from_the_origin_a_plane_stays_a_plane)
{
  Cloud cloud = lattice(30);
  for(Spatial& p : cloud.points)
    p = 30. * p + Spatial{494680., 5420300., 250.};
  const Glued_surfels surfels = cloud.glued();
  expect_consistent(surfels, cloud.points.size());
  EXPECT_EQ(surfels.triangles.number_of_triangles(), 2u * 30u * 30u);
  // Coordinates of 5e6 are known to 5e-10.
  for(std::size_t f = 0; f < surfels.triangles.number_of_triangles(); ++f)
    EXPECT_NEAR(area(surfels.triangles, f) * surfels.triangles.scale * surfels.triangles.scale, 0.5,
                1e-8);
}

TEST(Surfels, the_order_of_the_input_changes_nothing)
{
  Cloud cloud = random_sphere(2000);
  const Glued_surfels expected = cloud.glued();
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
  const Glued_surfels surfels = shuffled.glued();
  EXPECT_EQ(surfels.triangles.corner, expected.triangles.corner);
  EXPECT_EQ(surfels.triangles.graph.target, expected.triangles.graph.target);
  EXPECT_EQ(surfels.triangles.length, expected.triangles.length);
  for(Index site = 0; site < 2000; ++site)
    EXPECT_EQ(order[surfels.surfel_of_site[site]], expected.surfel_of_site[site]);
}

TEST(Surfels, threads_change_nothing)
{
  const Cloud cloud = together(random_sphere(10000), random_square(5000, 7, 3.));
  const Glued_surfels one = cloud.glued();
  Surfel_options options;
  options.threads = 4;
  const Glued_surfels four = cloud.glued(options);
  EXPECT_EQ(one.triangles.corner, four.triangles.corner);
  EXPECT_EQ(one.triangles.weight, four.triangles.weight);
  EXPECT_EQ(one.triangles.length, four.triangles.length);
  EXPECT_EQ(one.triangles.graph.first, four.triangles.graph.first);
  EXPECT_EQ(one.triangles.graph.target, four.triangles.graph.target);
  EXPECT_EQ(one.surfel_of_site, four.surfel_of_site);
}

TEST(Surfels, copies_hang_at_their_original)
{
  Cloud cloud = random_sphere(200);
  cloud = together(together(cloud, cloud), cloud);
  const Glued_surfels surfels = cloud.glued();
  expect_consistent(surfels, 600);
  const Glued_triangles& t = surfels.triangles;
  EXPECT_EQ(surfels.tree.size(), 200u);
  EXPECT_EQ(number_of_components(t), 1u);
  EXPECT_EQ(t.number_of_triangles(), random_sphere(200).glued().triangles.number_of_triangles());
  for(Index surfel = 200; surfel < 600; ++surfel)
  {
    const Index site = surfels.site_of_surfel[surfel];
    ASSERT_EQ(t.graph.first[site + 1] - t.graph.first[site], 1u);
    const Index arc = t.graph.first[site];
    EXPECT_EQ(t.graph.target[arc], surfels.site_of_surfel[surfel % 200]);
    EXPECT_EQ(t.graph.length[arc], 0.);
    EXPECT_EQ(surfels.radius[site], surfels.radius[surfels.site_of_surfel[surfel % 200]]);
  }
}

// 100,000 copies of a point would take minutes if each saw all the others.
TEST(Surfels, many_coincident_surfels_take_linear_time)
{
  const std::size_t n = 100000;
  const Glued_surfels surfels =
      glue_surfels(std::vector<Spatial>(n, {1.5, 1.5, 1.5}), std::vector<Spatial>(n, {0., 1., 0.}));
  EXPECT_EQ(surfels.triangles.graph.target.size(), 2 * (n - 1));
  EXPECT_EQ(number_of_components(surfels.triangles), 1u);
  EXPECT_EQ(surfels.triangles.number_of_triangles(), 0u);
}

TEST(Surfels, the_two_sides_of_a_sheet_without_thickness_do_not_meet)
{
  Cloud cloud = random_square(2000);
  const Cloud below = {cloud.points, std::vector<Spatial>(2000, {0., 0., -1.})};
  cloud = together(cloud, below);
  const Glued_surfels surfels = cloud.glued();
  expect_consistent(surfels, 4000);
  EXPECT_EQ(surfels.tree.size(), 4000u);
  EXPECT_EQ(number_of_components(surfels.triangles), 2u);
  EXPECT_NEAR(weighted_area(surfels.triangles), 2., 0.12);
}

// Two sheets closer to each other than the 8th neighbour, whose normals agree.
TEST(Surfels, parallel_sheets_one_spacing_apart_do_not_meet)
{
  const std::size_t n = 3000;
  const double gap = 1.1 / std::sqrt(double(n));
  for(const double up : {1., -1.})
  {
    const Cloud cloud = together(random_square(n, 1, 0.), random_square(n, 2, gap, up));
    const Glued_surfels surfels = cloud.glued();
    expect_consistent(surfels, 2 * n);
    for(Index i = 0; i < 2 * n; ++i)
      for(Index arc = surfels.triangles.graph.first[i]; arc < surfels.triangles.graph.first[i + 1];
          ++arc)
        EXPECT_EQ(surfels.surfel_of_site[i] < n,
                  surfels.surfel_of_site[surfels.triangles.graph.target[arc]] < n);
    EXPECT_NEAR(weighted_area(surfels.triangles), 2., 0.1);
  }
}

TEST(Surfels, a_sharp_edge_is_passed)
{
  // Two squares at a right angle, with the mean normal along their common edge.
  Cloud cloud;
  for(int i = 0; i <= 20; ++i)
    for(int j = -20; j <= 20; ++j)
    {
      cloud.points.push_back({i / 20., std::max(j, 0) / 20., std::min(j, 0) / 20.});
      cloud.normals.push_back(j > 0   ? Spatial{0., 0., 1.}
                              : j < 0 ? Spatial{0., -1., 0.}
                                      : Spatial{0., -1., 1.});
    }
  const Glued_surfels surfels = cloud.glued();
  expect_consistent(surfels, cloud.points.size());
  EXPECT_EQ(number_of_components(surfels.triangles), 1u);
  // No holes and no flaps but next to the edge, where three rows of twenty are.
  EXPECT_NEAR(weighted_area(surfels.triangles), 2., 0.1);
}

TEST(Surfels, a_hole_stays_open)
{
  Cloud cloud = lattice(40), ring;
  for(std::size_t i = 0; i < cloud.points.size(); ++i)
    if(std::hypot(cloud.points[i][0] - 0.5, cloud.points[i][1] - 0.5) > 0.2)
    {
      ring.points.push_back(cloud.points[i]);
      ring.normals.push_back(cloud.normals[i]);
    }
  const Glued_surfels surfels = ring.glued();
  expect_consistent(surfels, ring.points.size());
  for(std::size_t f = 0; f < surfels.triangles.number_of_triangles(); ++f)
  {
    const Glued_triangles& t = surfels.triangles;
    const Spatial middle =
        1. / 3. *
        (t.point[t.corner[3 * f]] + t.point[t.corner[3 * f + 1]] + t.point[t.corner[3 * f + 2]]);
    const Spatial at = t.scale * middle + t.origin;
    // Triangles reach into the hole by less than the spacing.
    EXPECT_GT(std::hypot(at[0] - 0.5, at[1] - 0.5), 0.2 - 1. / 40.);
  }
}

TEST(Surfels, an_outlier_does_not_bring_triangles)
{
  Cloud cloud = random_sphere(2000);
  cloud.points.push_back({0., 0., 0.});
  cloud.normals.push_back({0., 0., 1.});
  cloud.points.push_back({0., 3., 0.});
  cloud.normals.push_back({0., 1., 0.});
  const Glued_surfels surfels = cloud.glued();
  expect_consistent(surfels, 2002);
  for(const Index surfel : {2000, 2001})
  {
    const Index site = surfels.site_of_surfel[surfel];
    EXPECT_EQ(surfels.triangles.first[site], surfels.triangles.first[site + 1]);
  }
}

TEST(Surfels, a_line_has_arcs_and_no_triangles)
{
  Cloud cloud;
  for(int i = 0; i < 300; ++i)
    cloud.points.push_back({i / 300., 2. * i / 300., 3. * i / 300.});
  cloud.normals.assign(300, unit({3., 0., -1.}));
  const Glued_surfels surfels = cloud.glued();
  expect_consistent(surfels, 300);
  EXPECT_EQ(number_of_components(surfels.triangles), 1u);
  // Points of the line that are not quite collinear make none either: such a triangle is too long.
  EXPECT_EQ(surfels.triangles.number_of_triangles(), 0u);
}

TEST(Surfels, given_radii_decide_which_spheres_meet)
{
  const std::size_t n = 11;
  Cloud cloud;
  for(std::size_t i = 0; i < n; ++i)
    cloud.points.push_back({100. * i, 0., 0.});
  cloud.normals.assign(n, {0., 0., 1.});
  const auto degree = [&](double radius, Index surfel)
  {
    const Glued_surfels s =
        glue_surfels(cloud.points, cloud.normals, std::vector<double>(n, radius));
    const Index site = s.site_of_surfel[surfel];
    EXPECT_DOUBLE_EQ(s.radius[site] * s.triangles.scale, radius);
    return s.triangles.graph.first[site + 1] - s.triangles.graph.first[site];
  };
  EXPECT_EQ(degree(49., 5), 0u);
  EXPECT_EQ(degree(51., 5), 2u);
  EXPECT_EQ(degree(101., 5), 4u);
  EXPECT_EQ(degree(101., 0), 2u);
  EXPECT_EQ(degree(0., 3), 0u);
}

TEST(Surfels, normals_need_not_be_of_unit_length_but_need_a_direction)
{
  Cloud cloud = random_sphere(500);
  const Glued_surfels expected = cloud.glued();
  for(std::size_t i = 0; i < 500; ++i)
    cloud.normals[i] = std::ldexp(1., int(i % 41) - 20) * cloud.normals[i];
  EXPECT_EQ(cloud.glued().triangles.corner, expected.triangles.corner);
  cloud.normals[7] = {0., 0., 0.};
  EXPECT_THROW(cloud.glued(), Invalid_argument_error);
  cloud.normals[7] = {std::nan(""), 0., 1.};
  EXPECT_THROW(cloud.glued(), Invalid_argument_error);
}

TEST(Surfels, what_cannot_be_used_throws)
{
  const Cloud cloud = random_square(10);
  Cloud bad = cloud;
  bad.points[3][1] = std::nan("");
  EXPECT_THROW(bad.glued(), Invalid_argument_error);
  bad.points[3][1] = infinity;
  EXPECT_THROW(bad.glued(), Invalid_argument_error);
  bad = cloud;
  bad.normals.pop_back();
  EXPECT_THROW(bad.glued(), Invalid_argument_error);
  EXPECT_THROW(glue_surfels(cloud.points, cloud.normals, {1., 2.}), Invalid_argument_error);
  std::vector<double> radii(10, 1.);
  radii[4] = -1.;
  EXPECT_THROW(glue_surfels(cloud.points, cloud.normals, radii), Invalid_argument_error);
  radii[4] = infinity;
  EXPECT_THROW(glue_surfels(cloud.points, cloud.normals, radii), Invalid_argument_error);
  Surfel_options options;
  options.maximum_angle = 0.;
  EXPECT_THROW(cloud.glued(options), Invalid_argument_error);
  options = {};
  options.rank = 0;
  EXPECT_THROW(cloud.glued(options), Invalid_argument_error);
}

TEST(Surfels, places_are_located_on_the_tangent_plane_of_the_nearest_surfel)
{
  const Cloud cloud = fibonacci_sphere(3000);
  const Glued_surfels surfels = cloud.glued();
  const Glued_triangles& t = surfels.triangles;
  for(Index i = 0; i < 3000; i += 37)
  {
    const Tangent_location location = locate(surfels, 1.5 * cloud.points[i]);
    EXPECT_EQ(surfels.surfel_of_site[location.site], i);
    EXPECT_NEAR(std::hypot(location.offset[0], location.offset[1]), 0., 1e-13 * 1.5 / t.scale);
  }
  std::mt19937 random(9);
  std::normal_distribution<double> coordinate;
  for(int i = 0; i < 200; ++i)
  {
    const Spatial query = unit({coordinate(random), coordinate(random), coordinate(random)});
    const Tangent_location location = locate(surfels, query);
    const Spatial found = t.origin + t.scale * position(t, location);
    // A tangent plane leaves the sphere by half the squared offset; the spacing is 0.065, and no
    // place is farther than its 0.75 fold from a surfel.
    EXPECT_LT(norm(found - query), 0.0013);

    // Through a triangle and back: triangles lie below the sphere by as much, and meet the tangent
    // plane's normal elsewhere than the sphere.
    const Location in_triangle = to_triangle(t, location);
    ASSERT_NE(in_triangle.triangle, none);
    double sum = 0.;
    for(const double b : in_triangle.barycentric)
    {
      EXPECT_GE(b, 0.);
      sum += b;
    }
    EXPECT_NEAR(sum, 1., 1e-15);
    const Spatial again = t.origin + t.scale * position(t, to_surfel(t, in_triangle));
    EXPECT_LT(norm(again - query), 0.003);
  }
}

TEST(Surfels, places_beside_the_border_move_to_the_nearest_triangle)
{
  const Cloud cloud = lattice(4);
  const Glued_surfels surfels = cloud.glued();
  const Glued_triangles& t = surfels.triangles;
  for(const auto& [x, y] : {std::pair{-0.1, 0.4}, {1.1, 0.6}, {0.3, -0.05}, {-0.1, -0.1}})
  {
    const Location location = to_triangle(t, locate(surfels, {x, y, 0.2}));
    ASSERT_NE(location.triangle, none);
    Spatial at = {0., 0., 0.};
    for(int k = 0; k < 3; ++k)
      at = at + location.barycentric[k] * t.point[t.corner[3 * location.triangle + k]];
    at = t.origin + t.scale * at;
    EXPECT_NEAR(at[0], std::clamp(x, 0., 1.), 1e-14);
    EXPECT_NEAR(at[1], std::clamp(y, 0., 1.), 1e-14);
  }
}

TEST(Surfels, places_at_a_surfel_without_triangles_are_that_surfel)
{
  const Glued_surfels surfels = glue_surfels({{1., 2., 3.}}, {{0., 0., 1.}});
  const Tangent_location location = locate(surfels, {1e200, -1e300, 0.});
  EXPECT_EQ(location.site, 0u);
  const Location same = to_triangle(surfels.triangles, location);
  EXPECT_EQ(same.triangle, none);
  EXPECT_EQ(same.site, 0u);
  EXPECT_EQ(to_surfel(surfels.triangles, same).site, 0u);
  EXPECT_THROW(locate(surfels, {0., 0., infinity}), Invalid_argument_error);
}

} // namespace
} // namespace CGAL::Geodesic_processing::internal
