// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/polygon_soup.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace polygon_soup_test {

using CGAL::Geodesic_processing::Invalid_argument_error;
using CGAL::Geodesic_processing::Unsupported_surface_error;
using namespace CGAL::Geodesic_processing::internal;

Polygon_soup soup(std::vector<Vec3> points, const std::vector<std::vector<Index>>& polygons)
{
  Polygon_soup result;
  result.points = std::move(points);
  for(const auto& polygon : polygons)
  {
    result.corners.insert(result.corners.end(), polygon.begin(), polygon.end());
    result.polygon_begin.push_back(result.corners.size());
  }
  return result;
}

const std::vector<Vec3> tetrahedron = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

TEST(Repair_soup, keeps_triangles)
{
  const Repaired_soup result = repair_soup(soup(tetrahedron, {{2, 0, 1}, {0, 3, 1}}), {});
  EXPECT_EQ(result.corners, (std::vector<Index>{2, 0, 1, 0, 3, 1}));
  EXPECT_EQ(result.twins, (std::vector<Index>{none, 5, none, none, none, 1}));
  EXPECT_EQ(result.polygon, (std::vector<Index>{0, 1}));
  EXPECT_TRUE(result.replacement.empty());
  EXPECT_FALSE(result.report.is_changed());
  EXPECT_TRUE(result.report.is_manifold());
}

TEST(Repair_soup, removes_degenerate_polygons_and_duplicates)
{
  const Repaired_soup result =
      repair_soup(soup(tetrahedron,
                       {{0, 1, 1}, {0, 1}, {2}, {}, {0, 1, 2}, {1, 2, 0}, {2, 1, 0}, {3, 3, 1, 2}}),
                  {});
  EXPECT_EQ(result.report.number_of_degenerate_faces, 4u);
  EXPECT_EQ(result.report.number_of_duplicate_triangles, 1u);
  EXPECT_EQ(result.report.number_of_triangulated_polygons, 1u); // that with four corners
  EXPECT_EQ(result.polygon, (std::vector<Index>{4, 6, 7}));
  EXPECT_EQ(result.report.number_of_split_edges, 1u); // three triangles have edge 1-2
}

TEST(Repair_soup, keeps_the_first_of_equal_triangles)
{
  // Few points, so that many triangles are equal and edges have many triangles.
  std::mt19937 random(1);
  std::uniform_int_distribution<Index> draw(0, 4);
  std::vector<Vec3> points;
  for(int i = 0; i < 5; ++i)
    points.push_back({1. * i, 1. * i * i, 1. * i * i * i});
  for(int trial = 0; trial < 100; ++trial)
  {
    std::vector<std::vector<Index>> polygons;
    std::set<std::vector<Index>> triangles; // each rotated so that its smallest corner is the first
    std::map<std::pair<Index, Index>, std::size_t> number_of_triangles; // at each edge
    std::vector<Index> kept;
    while(polygons.size() < 30)
    {
      std::vector<Index> triangle = {draw(random), draw(random), draw(random)};
      if(std::set<Index>(triangle.begin(), triangle.end()).size() < 3)
        continue;
      polygons.push_back(triangle);
      std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                  triangle.end());
      if(!triangles.insert(triangle).second)
        continue;
      kept.push_back(static_cast<Index>(polygons.size() - 1));
      for(std::size_t k = 0; k < 3; ++k)
        ++number_of_triangles[std::minmax({triangle[k], triangle[(k + 1) % 3]})];
    }
    const Repaired_soup result = repair_soup(soup(points, polygons), {});
    EXPECT_EQ(result.polygon, kept);
    EXPECT_EQ(result.report.number_of_duplicate_triangles, polygons.size() - kept.size());
    for(Index h = 0; h < result.corners.size(); ++h)
    {
      const auto edge = std::minmax({result.corners[h], result.corners[next_halfedge(h)]});
      const Index twin = result.twins[h];
      if(twin == none) // also at some edges of a nonorientable surface
        continue;
      EXPECT_EQ(number_of_triangles[edge], 2u);
      EXPECT_EQ(edge, std::minmax({result.corners[twin], result.corners[next_halfedge(twin)]}));
    }
  }
}

TEST(Repair_soup, triangulates_polygons_in_order)
{
  const Repaired_soup result =
      repair_soup(soup({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}},
                       {{0, 1, 2, 3}, {1, 4, 5, 2}}),
                  {});
  EXPECT_EQ(result.polygon, (std::vector<Index>{0, 0, 1, 1}));
  EXPECT_EQ(result.report.number_of_triangulated_polygons, 2u);
  EXPECT_EQ(result.report.number_of_components, 1u);
  EXPECT_EQ(result.report.number_of_boundary_cycles, 1u);
}

TEST(Repair_soup, removes_triangles_without_area_on_request)
{
  // Point 3 is on edge 0-1; triangle 0 3 1 fills the gap between the two others.
  const Polygon_soup input = soup({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 0}, {1, -1, 0}},
                                  {{0, 1, 2}, {0, 3, 1}, {3, 0, 4}, {1, 3, 4}});
  EXPECT_EQ(repair_soup(input, {}).report.number_of_degenerate_faces, 0u);
  EXPECT_EQ(repair_soup(input, {}).report.number_of_components, 1u);
  Soup_options options;
  options.do_remove_degenerate_faces = true;
  const Repaired_soup result = repair_soup(input, options);
  EXPECT_EQ(result.report.number_of_degenerate_faces, 1u);
  EXPECT_EQ(result.polygon, (std::vector<Index>{0, 2, 3}));
  EXPECT_EQ(result.report.number_of_components, 2u); // they meet at points only
}

TEST(Repair_soup, splits_nonmanifold_edge)
{
  const Repaired_soup result =
      repair_soup(soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                       {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}),
                  {});
  EXPECT_EQ(result.twins, std::vector<Index>(9, none));
  EXPECT_EQ(result.report.number_of_split_edges, 1u);
  EXPECT_EQ(result.report.number_of_components, 3u);
  EXPECT_EQ(result.report.number_of_nonmanifold_points, 2u);
  EXPECT_FALSE(result.report.is_manifold());
}

TEST(Repair_soup, merges_equal_points_at_any_scale)
{
  for(const double scale : {1., 1e-300, 1e-6, 1e6, 1e300})
  {
    // Four triangles without common points.
    std::vector<Vec3> points;
    std::vector<std::vector<Index>> polygons;
    for(const auto& triangle : {std::array<Index, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
    {
      const Index first = Index(points.size());
      polygons.push_back({first, first + 1, first + 2});
      for(const Index corner : triangle)
        points.push_back(scale * tetrahedron[corner]);
    }
    EXPECT_EQ(repair_soup(soup(points, polygons), {}).report.number_of_components, 4u);
    Soup_options options;
    options.merge_tolerance = 0.;
    const Repaired_soup result = repair_soup(soup(points, polygons), options);
    EXPECT_EQ(result.replacement, (std::vector<Index>{0, 1, 2, 0, 2, 5, 2, 1, 5, 1, 0, 5}));
    EXPECT_EQ(result.report.number_of_merged_points, 8u);
    EXPECT_EQ(result.report.number_of_components, 1u);
    EXPECT_EQ(result.report.number_of_boundary_cycles, 0u);
    EXPECT_EQ(result.report.number_of_reversed_triangles, 0u);
  }
}

TEST(Repair_soup, merges_as_search_over_all_pairs)
{
  std::mt19937 random(5);
  for(const double tolerance : {0., 0.05, 0.3, 5.})
  {
    std::vector<Vec3> points(200);
    for(Vec3& p : points)
      for(double& x : p)
        x = (random() % 21) / 10. - 1.; // multiples of 0.1, so that some points are equal
    std::vector<Index> expected(points.size());
    for(Index i = 0; i < points.size(); ++i)
    {
      expected[i] = i;
      for(Index j = 0; j < i && expected[i] == i; ++j)
        if(expected[j] == j && std::hypot(points[i][0] - points[j][0], points[i][1] - points[j][1],
                                          points[i][2] - points[j][2]) <= tolerance)
          expected[i] = j;
    }
    Soup_options options;
    options.merge_tolerance = tolerance;
    const Repaired_soup result = repair_soup(soup(points, {}), options);
    std::vector<Index> all(points.size());
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(result.replacement.empty() ? all : result.replacement, expected);
  }
}

TEST(Repair_soup, of_random_polygons_satisfies_invariants)
{
  std::mt19937 random(3);
  for(int round = 0; round < 200; ++round)
  {
    std::vector<Vec3> points(8);
    for(Vec3& p : points)
      for(double& x : p)
        x = random() % 4;
    std::vector<std::vector<Index>> polygons(1 + round / 8);
    for(auto& polygon : polygons)
      for(std::size_t k = random() % 6; k > 0; --k)
        polygon.push_back(random() % 8);
    Soup_options options;
    if(round % 2 == 1)
      options.merge_tolerance = 0.;
    options.do_remove_degenerate_faces = round % 3 == 0;
    const Repaired_soup result = repair_soup(soup(points, polygons), options);
    ASSERT_EQ(result.corners.size(), 3 * result.polygon.size());
    ASSERT_EQ(result.twins.size(), result.corners.size());
    EXPECT_TRUE(std::is_sorted(result.polygon.begin(), result.polygon.end()));
    for(Index h = 0; h < result.twins.size(); ++h)
    {
      EXPECT_NE(result.corners[h], result.corners[next_halfedge(h)]);
      const Index twin = result.twins[h];
      if(twin == none)
        continue;
      EXPECT_EQ(result.twins[twin], h);
      EXPECT_EQ(result.corners[h], result.corners[next_halfedge(twin)]);
      EXPECT_EQ(result.corners[twin], result.corners[next_halfedge(h)]);
    }
    EXPECT_LE(result.report.genus, result.polygon.size()); // not negative
  }
}

// The arrays of a soup that needs no repair are built in another way than those of other soups.
TEST(Build_soup_arrays, has_the_twins_of_repaired_soup)
{
  std::mt19937 random(7);
  const auto random_below = [&](Index n) { return static_cast<Index>(random() % n); };
  std::size_t number_of_clean_soups = 0;
  for(int repetition = 0; repetition < 400; ++repetition)
  {
    // A grid of triangles with a few changes.
    constexpr Index size = 6;
    std::vector<Vec3> points;
    std::vector<std::vector<Index>> polygons;
    for(Index i = 0; i < size * size; ++i)
      points.push_back({double(i % size), double(i / size), 0.1 * random_below(10)});
    for(Index i = 0; i + 1 < size; ++i)
      for(Index j = 0; j + 1 < size; ++j)
      {
        const Index a = i * size + j, b = a + 1, c = a + size, d = c + 1;
        polygons.insert(polygons.end(), {{a, b, d}, {a, d, c}});
      }
    std::shuffle(polygons.begin(), polygons.end(), random);
    for(int change = repetition % 4; change > 0; --change)
    {
      auto& polygon = polygons[random_below(Index(polygons.size()))];
      switch(random_below(5))
      {
      case 0:
        polygon.clear();
        break;
      case 1:
        std::reverse(polygon.begin(), polygon.end());
        break;
      case 2:
        polygons.push_back(polygon);
        break;
      case 3:
        polygons.push_back({random_below(36), random_below(36), random_below(36)});
        break;
      default:
        points[random_below(36)] = points[random_below(36)];
      }
    }
    Soup_options options;
    if(repetition % 3 == 0)
      options.merge_tolerance = 0.;
    const Polygon_soup input = soup(points, polygons);
    const Repaired_soup repaired = repair_soup(input, options);
    for(const unsigned number_of_threads : {1u, 2u, 5u})
    {
      options.number_of_threads = number_of_threads;
      const Soup_arrays arrays = build_soup_arrays(input, options);
      EXPECT_EQ(arrays.replacement, repaired.replacement);
      const auto& mesh = arrays.mesh;
      ASSERT_EQ(mesh.arrays.corner.size(), repaired.corners.size());
      std::vector<Index> point_of_vertex;
      for(Index i = 0; i < points.size(); ++i)
        if(repaired.replacement.empty() || repaired.replacement[i] == i)
          point_of_vertex.push_back(i);
      ASSERT_EQ(mesh.caller_vertex.size(), point_of_vertex.size());
      for(Index h = 0; h < repaired.corners.size(); ++h)
      {
        const Index sorted = 3 * mesh.triangle_of_face[h / 3] + h % 3,
                    twin = mesh.arrays.twin[sorted];
        EXPECT_EQ(point_of_vertex[mesh.caller_vertex[mesh.arrays.corner[sorted]]],
                  repaired.corners[h]);
        EXPECT_EQ(twin == none ? none : 3 * mesh.face_of_triangle[twin / 3] + twin % 3,
                  repaired.twins[h]);
      }
      for(Index f = 0; f < repaired.polygon.size(); ++f)
        EXPECT_EQ(arrays.polygon.empty() ? f : arrays.polygon[f], repaired.polygon[f]);
      const auto &report = arrays.report, &expected = repaired.report;
      EXPECT_EQ(report.number_of_merged_points, expected.number_of_merged_points);
      EXPECT_EQ(report.number_of_degenerate_faces, expected.number_of_degenerate_faces);
      EXPECT_EQ(report.number_of_duplicate_triangles, expected.number_of_duplicate_triangles);
      EXPECT_EQ(report.number_of_reversed_triangles, expected.number_of_reversed_triangles);
      EXPECT_EQ(report.number_of_split_edges, expected.number_of_split_edges);
      EXPECT_EQ(report.number_of_nonmanifold_points, expected.number_of_nonmanifold_points);
      EXPECT_EQ(report.number_of_components, expected.number_of_components);
      EXPECT_EQ(report.number_of_boundary_cycles, expected.number_of_boundary_cycles);
      EXPECT_EQ(report.genus, expected.genus);
      EXPECT_EQ(report.number_of_triangles_without_area, mesh.number_of_degenerate_triangles);
      number_of_clean_soups += arrays.report.is_changed() ? 0 : 1;
    }
  }
  EXPECT_GT(number_of_clean_soups, 100u);
  EXPECT_LT(number_of_clean_soups, 1000u);
}

TEST(Repair_soup, rejects_invalid_input)
{
  const double nan = std::nan("");
  EXPECT_THROW(repair_soup(soup(tetrahedron, {{0, 1, 4}}), {}), Invalid_argument_error);
  EXPECT_THROW(repair_soup(soup({{0, nan, 0}}, {}), {}), Invalid_argument_error);
  Soup_options options;
  for(const double tolerance : {-1., nan, infinity})
  {
    options.merge_tolerance = tolerance;
    EXPECT_THROW(repair_soup(soup(tetrahedron, {{0, 1, 2}}), options), Invalid_argument_error);
  }
  std::vector<Index> polygon(10001);
  std::iota(polygon.begin(), polygon.end(), 0);
  const std::vector<Vec3> points(10001, Vec3{1., 2., 3.});
  EXPECT_THROW(repair_soup(soup(points, {polygon}), {}), Unsupported_surface_error);
}

} // namespace polygon_soup_test
