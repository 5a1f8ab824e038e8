// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/split_at_isolines.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include "Array_surface.h"
#include "topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace split_at_isolines_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of values and coordinates of order one, and relative ones of areas, which are
// sums of thousands of triangles; measured are at most 2e-14.
constexpr double round_off = 1e-13;

// A mesh that is split along the isolines of given values.
class Split_surface
{
public:
  Split_surface(const Triangulation& surface, const std::vector<double>& given,
                const std::vector<double>& levels,
                Edge_interpolation interpolation = Edge_interpolation::linear)
      : m_surface(surface), m_values(given.size()), m_levels(levels), m_interpolation(interpolation)
  {
    for(Index i = 0; i < m_surface.size(); ++i)
      m_values[m_surface.vertex(i)] = given[i];
    m_split = split_at_isolines(t(), m_values, levels, interpolation);
    std::sort(m_levels.begin(), m_levels.end());
  }

  const Surface_arrays& t() const { return m_surface.t(); }
  const Split_mesh_at_isolines& split() const { return m_split; }
  std::size_t number_of_triangles() const { return m_split.triangles.size(); }

  Surface_location location(Index v) const
  {
    return v < m_values.size() ? vertex_location(t(), v)
                               : m_split.new_vertices[v - m_values.size()];
  }
  Vec3 point(Index v) const { return coordinates(t(), location(v)); }
  // Returns the value of a vertex, with linear interpolation.
  double value(Index v) const
  {
    const Surface_location at = location(v);
    double result = 0.;
    for(Index k = 0; k < 3; ++k)
      if(at.barycentric[k] > 0.)
        result += at.barycentric[k] * m_values[t().corner[3 * at.triangle + k]];
    return result;
  }
  Vec3 area_vector(std::size_t f) const
  {
    const auto& [a, b, c] = m_split.triangles[f];
    return 0.5 * cross(point(b) - point(a), point(c) - point(a));
  }

  // Expects that the split mesh has the topology, the area and the orientation of the mesh.
  void expect_subdivision() const
  {
    std::vector<Index> corners;
    double area = 0., expected_area = 0.;
    for(std::size_t f = 0; f < number_of_triangles(); ++f)
    {
      corners.insert(corners.end(), m_split.triangles[f].begin(), m_split.triangles[f].end());
      area += norm(area_vector(f));
    }
    for(Index f = 0; f < t().number_of_triangles(); ++f)
    {
      const Index* corner = &t().corner[3 * f];
      expected_area += 0.5 * norm(cross(point(corner[1]) - point(corner[0]),
                                        point(corner[2]) - point(corner[0])));
    }
    EXPECT_NEAR(area, expected_area, round_off * expected_area);
    const Topology expected = topology(t().corner);
    EXPECT_EQ(topology(corners), expected);
    EXPECT_TRUE(expected.is_simple);
    for(Index h = 0; h < corners.size(); ++h)
    {
      const Index twin = m_split.twins[h];
      if(twin != none)
      {
        EXPECT_EQ(m_split.twins[twin], h);
        EXPECT_EQ(corners[twin], corners[next_halfedge(h)]);
        EXPECT_EQ(corners[next_halfedge(twin)], corners[h]);
      }
    }
    // All new vertices are used, and each adds a triangle to each triangle of its edge.
    std::set<Index> used(corners.begin(), corners.end());
    std::size_t number = t().number_of_triangles();
    for(std::size_t i = 0; i < m_split.new_vertices.size(); ++i)
    {
      EXPECT_EQ(used.count(Index(m_values.size() + i)), 1u);
      const Surface_location& at = m_split.new_vertices[i];
      const auto& b = at.barycentric;
      const auto zero = std::min_element(b.begin(), b.end());
      EXPECT_EQ(*zero, 0.);
      const Index h = 3 * at.triangle + Index(zero - b.begin() + 1) % 3;
      number += t().twin[h] == none ? 1 : 2;
    }
    EXPECT_EQ(number_of_triangles(), number);
  }

  // Expects that labels are the number of levels at most the values in the interior of triangles.
  void expect_labels() const
  {
    ASSERT_EQ(m_split.labels.size(), number_of_triangles());
    for(std::size_t f = 0; f < number_of_triangles(); ++f)
    {
      const auto& [a, b, c] = m_split.triangles[f];
      const auto [low, high] = std::minmax({value(a), value(b), value(c)});
      const double sum = value(a) + value(b) + value(c);
      const Index label = m_split.labels[f];
      if(!std::isfinite(sum))
      {
        EXPECT_EQ(label, none);
        continue;
      }
      if(m_interpolation == Edge_interpolation::linear)
      {
        ASSERT_LE(label, m_levels.size());
        EXPECT_TRUE(label == 0 || low >= m_levels[label - 1] - round_off);
        EXPECT_TRUE(label == m_levels.size() || high <= m_levels[label] + round_off);
        // The mean differs from the next level by at least a third of the largest difference.
        if(high - low > 10. * round_off || low == high)
        {
          EXPECT_EQ(label, std::upper_bound(m_levels.begin(), m_levels.end(), sum / 3.) -
                               m_levels.begin());
        }
      }
    }
  }

  // Expects that the isolines of find_isolines() consist of the edges that are marked as isolines,
  // and that edges between different labels are among them.
  void expect_isolines() const
  {
    std::multiset<std::pair<Key, Key>> expected, found;
    std::vector<double> different = m_levels;
    different.erase(std::unique(different.begin(), different.end()), different.end());
    for(const Isoline& line : find_isolines(t(), m_values, different, m_interpolation))
      for(std::size_t i = 1; i < line.polyline.size(); ++i)
        expected.insert(std::minmax(key(line.polyline[i - 1]), key(line.polyline[i])));
    std::set<std::pair<Index, Index>> marked;
    for(const Index h : m_split.isoline_halfedges)
    {
      const Index p = m_split.triangles[h / 3][h % 3], q = m_split.triangles[h / 3][(h + 1) % 3];
      found.insert(std::minmax(key(location(p)), key(location(q))));
      marked.insert(std::minmax(p, q));
    }
    EXPECT_EQ(found, expected);
    std::map<std::pair<Index, Index>, Index> label;
    for(std::size_t f = 0; f < number_of_triangles(); ++f)
      for(int k = 0; k < 3; ++k)
        label[{m_split.triangles[f][k], m_split.triangles[f][(k + 1) % 3]}] = m_split.labels[f];
    for(const auto& [edge, left] : label)
    {
      const auto right = label.find({edge.second, edge.first});
      if(left != none && right != label.end() && right->second != none && left != right->second)
      {
        EXPECT_EQ(marked.count(std::minmax(edge.first, edge.second)), 1u);
      }
    }
  }

  void expect_all() const
  {
    expect_subdivision();
    expect_labels();
    expect_isolines();
  }

private:
  // A vertex, or a halfedge and the position on it in units of 1e-9.
  using Key = std::pair<Index, long long>;
  Key key(const Surface_location& at) const
  {
    const Surface_location location = canonical(t(), at);
    const Index vertex = vertex_of(t(), location);
    if(vertex != none)
      return {Index(3 * t().number_of_triangles()) + vertex, 0};
    const Index h = halfedge_of(location), twin = t().twin[h];
    const bool is_first = twin == none || h < twin;
    return {is_first ? h : twin,
            std::llround(1e9 * location.barycentric[is_first ? h % 3 : next_halfedge(h) % 3])};
  }

  Array_surface m_surface;
  std::vector<double> m_values;
  std::vector<double> m_levels; // sorted
  Edge_interpolation m_interpolation;
  Split_mesh_at_isolines m_split;
};

std::vector<double> heights_of(const Triangulation& surface, int coordinate)
{
  std::vector<double> result;
  for(const Point& p : surface.points)
    result.push_back(p[coordinate]);
  return result;
}

TEST(split_at_isolines, subdivides_surfaces_with_random_values)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0., 1.);
  for(const Triangulation& surface :
      {icosphere(2), square(8, 0.2), annulus(12, 5, 1., 2.), torus(8, 6), tetrahedron(),
       one_triangle(), disjoint_union(square(3), icosphere(1))})
    for(int run = 0; run < 4; ++run)
    {
      std::vector<double> values(surface.points.size()), levels;
      for(double& value : values)
      {
        value = unit(random);
        // In half of the runs, some vertices have no value.
        if(run % 2 == 1 && random() % 10 == 0)
          value = random() % 2 == 0 ? infinity : std::nan("");
      }
      for(int i = 0; i < (run < 2 ? 2 : 15); ++i)
        levels.push_back(unit(random));
      levels.push_back(levels.front());
      Split_surface(surface, values, levels).expect_all();
      Split_surface(surface, values, levels, Edge_interpolation::circular).expect_all();
    }
}

// With few different values, many vertices have a level, and many triangles are flat.
TEST(split_at_isolines, does_not_duplicate_vertices_with_a_level)
{
  std::mt19937 random(2);
  for(int run = 0; run < 6; ++run)
  {
    const Triangulation surface = run % 2 == 0 ? icosphere(2) : square(8, 0.2);
    std::vector<double> values(surface.points.size());
    for(double& value : values)
      value = double(random() % 5);
    Split_surface(surface, values, {0., 1., 2., 4.}).expect_all();
    Split_surface(surface, values, {1., 1.5, 3.}).expect_all();
  }
  // All crossings are at vertices.
  const Triangulation surface = square(4);
  const Split_surface split(surface, heights_of(surface, 0), {0., 0.25, 0.5, 0.75, 1.});
  split.expect_all();
  EXPECT_TRUE(split.split().new_vertices.empty());
  EXPECT_EQ(split.number_of_triangles(), 32u);
  EXPECT_EQ(*std::min_element(split.split().labels.begin(), split.split().labels.end()), 1u);
  EXPECT_EQ(*std::max_element(split.split().labels.begin(), split.split().labels.end()), 4u);
}

TEST(split_at_isolines, labels_uncut_triangles)
{
  const Triangulation surface = square(4);
  for(const auto& [levels, label] : std::vector<std::pair<std::vector<double>, Index>>{
          {{}, 0}, {{3.}, 0}, {{2.}, 1}, {{2., 2.}, 2}, {{5., -1., 1.}, 2}})
  {
    const Split_surface split(surface, std::vector<double>(25, 2.), levels);
    split.expect_all();
    EXPECT_EQ(split.split().labels, std::vector<Index>(32, label));
    EXPECT_TRUE(split.split().isoline_halfedges.empty());
  }
  const Split_surface without_values(surface, std::vector<double>(25, infinity), {1.});
  without_values.expect_subdivision();
  EXPECT_EQ(without_values.split().labels, std::vector<Index>(32, none));
}

TEST(split_at_isolines, areas_of_strips_are_exact)
{
  const Triangulation surface = square(10, 0.2);
  const std::vector<double> levels = {0.55, 0.1, 0.3, 0.999, -1., 2.};
  const Split_surface split(surface, heights_of(surface, 0), levels);
  split.expect_all();
  std::vector<double> areas(7, 0.);
  for(std::size_t f = 0; f < split.number_of_triangles(); ++f)
  {
    // The normal keeps its direction.
    EXPECT_GT(split.area_vector(f)[2], 0.);
    areas[split.split().labels[f]] += split.area_vector(f)[2];
  }
  const double expected[7] = {0., 0.1, 0.2, 0.25, 0.449, 0.001, 0.};
  for(std::size_t i = 0; i < 7; ++i)
    EXPECT_NEAR(areas[i], expected[i], round_off);
}

TEST(split_at_isolines, accepts_many_levels_on_one_edge)
{
  std::vector<double> levels;
  for(int i = 0; i < 1000; ++i)
    levels.push_back(i / 1000.);
  for(const std::vector<double>& values :
      {std::vector<double>{0., 0.4123, 1.}, {1., 0., 0.}, {0.5, 1., 1.}, {0.5, 0., 0.5}})
    Split_surface(one_triangle(), values, levels).expect_all();
  const Split_surface split(one_triangle(), {0., 1., 1.}, levels);
  // The levels above zero add two vertices each.
  EXPECT_EQ(split.split().new_vertices.size(), 2u * 999u);
}

TEST(split_at_isolines, keeps_new_vertices_of_close_levels_apart)
{
  const double level = 0.3, next = std::nextafter(level, 1.);
  for(const Triangulation& surface : {one_triangle(), square(3), icosphere(1)})
  {
    std::vector<double> values = heights_of(surface, 0);
    Split_surface(surface, values, {level, next}).expect_subdivision();
    // Vertices just below, at and just above a level.
    values[0] = std::nextafter(level, 0.);
    values[1] = level;
    values[2] = next;
    Split_surface(surface, values, {level}).expect_subdivision();
    Split_surface(surface, values, {level, next}).expect_subdivision();
    // A value that is much larger than the others
    values[1] = 1e30;
    const Split_surface split(surface, values, {0.1, 0.2, level, 1e10, 1e29});
    split.expect_subdivision();
    split.expect_labels();
  }
}

TEST(split_at_isolines, subdivides_needles)
{
  for(const double width : {1e-6, 1e-9})
  {
    Triangulation surface = square(6, 0.2);
    for(Point& p : surface.points)
      p[1] *= width;
    std::vector<double> values = heights_of(surface, 0);
    const Split_surface split(surface, values, {0.11, 0.25, 0.77});
    split.expect_all();
    double areas[4] = {0., 0., 0., 0.};
    for(std::size_t f = 0; f < split.number_of_triangles(); ++f)
    {
      EXPECT_GT(split.area_vector(f)[2], 0.);
      areas[split.split().labels[f]] += split.area_vector(f)[2] / width;
    }
    const double expected[4] = {0.11, 0.14, 0.52, 0.23};
    for(std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(areas[i], expected[i], round_off);
    for(double& value : values)
      value = std::sin(100. * value);
    Split_surface(surface, values, {-0.5, 0.1, 0.7}).expect_all();
  }
}

TEST(split_at_isolines, accepts_the_largest_and_smallest_values)
{
  const Triangulation surface = square(4);
  for(const double size : {std::numeric_limits<double>::max(), 1e-307})
  {
    std::vector<double> values = heights_of(surface, 0);
    for(double& value : values)
      value = size * (2. * value - 1.);
    const Split_surface split(surface, values, {0.25 * size});
    split.expect_subdivision();
    split.expect_isolines();
    double area = 0.;
    for(std::size_t f = 0; f < split.number_of_triangles(); ++f)
      if(split.split().labels[f] == 0)
        area += split.area_vector(f)[2];
    EXPECT_NEAR(area, 0.625, round_off);
  }
}

TEST(split_at_isolines, of_nothing_is_empty)
{
  const Split_mesh_at_isolines split = split_at_isolines(Surface_arrays(), {}, {1.});
  EXPECT_TRUE(split.triangles.empty());
  EXPECT_TRUE(split.new_vertices.empty());
}

TEST(split_at_isolines, throws_if_the_result_is_too_large)
{
  const Array_surface surface(icosphere(4));
  std::vector<double> values(surface.size()), levels;
  for(Index v = 0; v < values.size(); ++v)
    values[v] = double(v % 7);
  // 15,360 halfedges, with 300,000 new vertices each on average
  for(int i = 0; i < 1000000; ++i)
    levels.push_back(7e-6 * i);
  EXPECT_THROW(split_at_isolines(surface.t(), values, levels),
               CGAL::Geodesic_processing::Invalid_argument_error);
}

// Two triangles with the same vertices. Both parts of the isoline have the same ends.
TEST(split_at_isolines, admits_two_edges_between_the_same_vertices)
{
  const Triangulation pillow = {{{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}}, {0, 1, 2, 0, 2, 1}};
  const Array_surface surface(pillow);
  ASSERT_NE(surface.t().twin[0], none);
  std::vector<double> values(3);
  for(Index i = 0; i < 3; ++i)
    values[surface.vertex(i)] = double(i);
  const Split_mesh_at_isolines split = split_at_isolines(surface.t(), values, {1.5});
  // Two triangles above and two quadrilaterals below the level
  EXPECT_EQ(split.triangles.size(), 6u);
  EXPECT_EQ(split.isoline_halfedges.size(), 2u);
  for(const Index h : split.isoline_halfedges)
    EXPECT_NE(split.labels[h / 3], split.labels[split.twins[h] / 3]);
  for(Index h = 0; h < split.twins.size(); ++h)
  {
    ASSERT_NE(split.twins[h], none);
    EXPECT_EQ(split.twins[split.twins[h]], h);
  }
}

} // namespace split_at_isolines_test
