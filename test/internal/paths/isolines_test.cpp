// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/isolines.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <random>
#include <set>

namespace isolines_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

using Isolines = std::vector<Isoline>;

// Round-off errors of coordinates of order one; measured are at most 4e-16.
constexpr double round_off = 1e-14;

// Returns the values of a function at the vertices, in the order of the arrays.
template <typename Function>
std::vector<double> values_of(const Array_surface& surface, const Function& function)
{
  std::vector<double> values(surface.size());
  for(Index i = 0; i < surface.size(); ++i)
    values[surface.vertex(i)] = function(surface.point(i));
  return values;
}

std::vector<double> values_in_order(const Array_surface& surface, const std::vector<double>& given)
{
  std::vector<double> values(surface.size());
  for(Index i = 0; i < surface.size(); ++i)
    values[surface.vertex(i)] = given[i];
  return values;
}

Point point_at(const Array_surface& surface, const Surface_location& location)
{
  return coordinates(surface.t(), location);
}

double length_of(const Array_surface& surface, const Isoline& line)
{
  return surface.scale() * path_length(surface.t(), line.polyline);
}

double x_of(const Point& p) { return p[0]; }

// Expects the guarantees of find_isolines() for a level that is not the value of a vertex.
void expect_isolines(const Array_surface& surface, const std::vector<double>& values, double level,
                     const Isolines& lines)
{
  const Surface_arrays& t = surface.t();
  std::set<Index> crossed;
  for(const Isoline& line : lines)
  {
    const auto& path = line.polyline;
    ASSERT_GE(path.size(), 2u);
    for(std::size_t i = 0; i + 1 < path.size(); ++i)
    {
      const Index f = common_triangle(t, path[i], path[i + 1]);
      ASSERT_NE(f, none);
      EXPECT_TRUE(crossed.insert(f).second) << "a triangle is crossed twice";
      // Corners above the level are on the left.
      const Vec3 p = scaled_coordinates(t, path[i]), q = scaled_coordinates(t, path[i + 1]);
      const Index* corner = &t.corner[3 * f];
      const Vec3 normal =
          cross(t.point[corner[1]] - t.point[corner[0]], t.point[corner[2]] - t.point[corner[0]]);
      for(int k = 0; k < 3; ++k)
      {
        const double side = dot(normal, cross(q - p, t.point[corner[k]] - p));
        EXPECT_EQ(side > 0., values[corner[k]] > level);
      }
    }
    if(line.is_closed)
    {
      EXPECT_TRUE(is_same_point(t, path.front(), path.back()));
    }
    else
      for(const Surface_location& end : {path.front(), path.back()})
      {
        // The end is on the boundary or next to a triangle without values.
        const Index h = halfedge_of(end);
        ASSERT_NE(h, none);
        const Index twin = t.twin[h];
        EXPECT_TRUE(twin == none || !std::isfinite(values[t.corner[previous_halfedge(twin)]]));
      }
    for(const Surface_location& location : path)
    {
      const Index* corner = &t.corner[3 * location.triangle];
      double value = 0.;
      for(int k = 0; k < 3; ++k)
        if(location.barycentric[k] > 0.)
          value += location.barycentric[k] * values[corner[k]];
      EXPECT_NEAR(value, level, round_off);
    }
  }
  std::set<Index> expected;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    std::size_t above = 0, below = 0;
    for(Index k = 0; k < 3; ++k)
    {
      const double value = values[t.corner[3 * f + k]];
      above += std::isfinite(value) && value > level;
      below += std::isfinite(value) && value < level;
    }
    if(above + below == 3 && above > 0 && below > 0)
      expected.insert(f);
  }
  EXPECT_EQ(crossed, expected);
}

TEST(isolines, crosses_each_face_with_the_level_once)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0., 1.);
  for(const Triangulation& triangulation : {icosphere(3), square(15, 0.2), annulus(12, 5, 1., 2.),
                                            cylinder(9, 4, 1., 2.), tetrahedron(), one_triangle()})
  {
    const Array_surface surface(triangulation);
    for(int run = 0; run < 4; ++run)
    {
      std::vector<double> values(surface.size());
      for(double& value : values)
      {
        value = unit(random);
        // In half of the runs, some vertices have no value.
        if(run % 2 == 1 && random() % 10 == 0)
          value = random() % 2 == 0 ? infinity : std::nan("");
      }
      for(const double level : {0.25, 0.5, 0.75})
        expect_isolines(surface, values, level, find_isolines(surface.t(), values, {level}));
    }
  }
}

TEST(isolines, of_coordinate_are_straight_lines)
{
  const Array_surface surface(square(10));
  const std::vector<double> levels = {0.55, 0.11, 0.3, 0.999, -1., 2.};
  const Isolines lines = find_isolines(surface.t(), values_of(surface, x_of), levels);
  ASSERT_EQ(lines.size(), 4u);
  for(std::size_t i = 0; i < 4; ++i)
  {
    // The result is in the order of the levels. Larger values are on the left: y decreases.
    EXPECT_EQ(lines[i].level, i);
    EXPECT_FALSE(lines[i].is_closed);
    EXPECT_NEAR(length_of(surface, lines[i]), 1., round_off);
    EXPECT_NEAR(point_at(surface, lines[i].polyline.front())[1], 1., round_off);
    for(const Surface_location& location : lines[i].polyline)
      EXPECT_NEAR(point_at(surface, location)[0], levels[i], round_off);
  }
}

TEST(isolines, around_an_annulus_are_closed)
{
  const Array_surface surface(annulus(24, 4, 1., 2.));
  const auto radius = [](const Point& p) { return std::hypot(p[0], p[1]); };
  const Isolines lines =
      find_isolines(surface.t(), values_of(surface, radius), {1.1, 1.6, 1.6, 0.9});
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[2].level, 2u);
  EXPECT_EQ(lines[1].polyline.size(), lines[2].polyline.size());
  for(const Isoline& line : lines)
    EXPECT_TRUE(line.is_closed);
}

TEST(isolines, run_along_edges_whose_vertices_have_the_level)
{
  const Array_surface surface(square(4));
  const std::vector<double> x = values_of(surface, x_of);
  // The vertices at 0 are not below 0: there is no line. Those at 1 are above all others.
  EXPECT_TRUE(find_isolines(surface.t(), x, {0.}).empty());
  for(const double level : {0.25, 0.5, 1.})
  {
    const Isolines lines = find_isolines(surface.t(), x, {level});
    ASSERT_EQ(lines.size(), 1u);
    ASSERT_EQ(lines[0].polyline.size(), 5u);
    EXPECT_NEAR(length_of(surface, lines[0]), 1., round_off);
    for(const Surface_location& location : lines[0].polyline)
    {
      EXPECT_NE(vertex_of(surface.t(), location), none);
      EXPECT_NEAR(point_at(surface, location)[0], level, round_off);
    }
  }
}

TEST(isolines, treat_vertices_with_the_level_as_above)
{
  const Array_surface surface(square(4));
  const Index n = surface.size(), center = 12;
  const auto lines_of = [&](const std::vector<double>& given)
  { return find_isolines(surface.t(), values_in_order(surface, given), {1.}); };
  EXPECT_TRUE(lines_of(std::vector<double>(n, 1.)).empty());
  EXPECT_TRUE(lines_of(std::vector<double>(n, 0.)).empty());

  // A maximum at a vertex is a point. A minimum is surrounded by a line through its neighbors.
  std::vector<double> peak(n, 0.);
  peak[center] = 1.;
  EXPECT_TRUE(lines_of(peak).empty());
  std::vector<double> pit(n, 1.);
  pit[center] = 0.;
  const Isolines around = lines_of(pit);
  ASSERT_EQ(around.size(), 1u);
  EXPECT_TRUE(around[0].is_closed);
  EXPECT_EQ(around[0].polyline.size(), 7u); // six neighbors
  EXPECT_NEAR(length_of(surface, around[0]), 1. + std::sqrt(0.5), round_off);

  // The line around a ridge runs along both of its sides.
  std::vector<double> ridge(n, 0.);
  for(const Index i : {11, 12, 13})
    ridge[i] = 1.;
  const Isolines along = lines_of(ridge);
  ASSERT_EQ(along.size(), 1u);
  EXPECT_TRUE(along[0].is_closed);
  EXPECT_NEAR(length_of(surface, along[0]), 1., round_off);

  // The line around a face with three equal values is its boundary.
  std::vector<double> face(n, 0.);
  for(Index k = 0; k < 3; ++k)
    face[square(4).corners[3 * 10 + k]] = 1.;
  const Isolines boundary = lines_of(face);
  ASSERT_EQ(boundary.size(), 1u);
  EXPECT_TRUE(boundary[0].is_closed);
  EXPECT_EQ(boundary[0].polyline.size(), 4u);
  EXPECT_NEAR(length_of(surface, boundary[0]), 0.5 + std::sqrt(0.125), round_off);
}

// With few different values, many vertices have the level. Then the total length of the isolines
// is the limit of the lengths just below the level.
TEST(isolines, are_limits_of_isolines_below)
{
  std::mt19937 random(2);
  for(int run = 0; run < 10; ++run)
  {
    const Array_surface surface(run % 2 == 0 ? icosphere(2) : square(8, 0.2));
    std::vector<double> values(surface.size());
    for(double& value : values)
      value = double(random() % 4);
    for(const double level : {1., 2., 3.})
    {
      // Differences of values are at least one. Displacements of 1e-9 change each of the 1,000
      // segments by at most 2e-9 times the length of an edge.
      double lengths[2] = {0., 0.};
      for(const int i : {0, 1})
        for(const Isoline& line :
            find_isolines(surface.t(), values, {level - (i == 0 ? 0. : 1e-9)}))
          lengths[i] += length_of(surface, line);
      EXPECT_NEAR(lengths[0], lengths[1], 2e-6);
    }
  }
}

TEST(isolines, circular_interpolation_is_exact_in_the_plane)
{
  const Point source = {0.3, 0.45, 0.};
  for(const Triangulation& triangulation : {square(6, 0.2), graded_square(9)})
  {
    const Array_surface surface(triangulation);
    const std::vector<double> values =
        values_of(surface, [&](const Point& p) { return distance(p, source); });
    const std::vector<double> levels = {0.02, 0.1, 0.2, 0.35, 0.5};
    const Isolines linear = find_isolines(surface.t(), values, levels),
                   circular =
                       find_isolines(surface.t(), values, levels, Edge_interpolation::circular);
    // Both cross the same triangles.
    ASSERT_EQ(linear.size(), circular.size());
    for(std::size_t i = 0; i < linear.size(); ++i)
    {
      EXPECT_EQ(linear[i].polyline.size(), circular[i].polyline.size());
      for(const Surface_location& location : circular[i].polyline)
        EXPECT_NEAR(distance(point_at(surface, location), source), levels[circular[i].level],
                    round_off);
    }
  }
}

TEST(isolines, circular_interpolation_accepts_any_values)
{
  const Array_surface surface(square(8, 0.2));
  std::mt19937 random(3);
  for(const double size : {1e-300, 1., 1e307})
  {
    std::vector<double> values(surface.size());
    for(double& value : values)
      value = size * (double(random() % 1000) / 500. - 1.);
    for(const Isoline& line :
        find_isolines(surface.t(), values, {0.1234 * size}, Edge_interpolation::circular))
      for(const Surface_location& location : line.polyline)
      {
        double sum = 0.;
        for(const double b : location.barycentric)
        {
          EXPECT_GE(b, 0.);
          sum += b;
        }
        EXPECT_NEAR(sum, 1., round_off);
      }
  }
}

TEST(isolines, accepts_the_largest_and_smallest_values)
{
  const Array_surface surface(square(4));
  for(const double size : {std::numeric_limits<double>::max(), 1e-307})
  {
    const std::vector<double> values =
        values_of(surface, [&](const Point& p) { return size * (2. * p[0] - 1.); });
    const Isolines lines = find_isolines(surface.t(), values, {0.25 * size});
    ASSERT_EQ(lines.size(), 1u);
    for(const Surface_location& location : lines[0].polyline)
      EXPECT_NEAR(point_at(surface, location)[0], 0.625, round_off);
  }
}

TEST(isolines, of_nothing_are_empty)
{
  const Array_surface surface(square(4));
  EXPECT_TRUE(find_isolines(surface.t(), values_of(surface, x_of), {}).empty());
  EXPECT_TRUE(
      find_isolines(surface.t(), std::vector<double>(surface.size(), infinity), {1.}).empty());
  EXPECT_TRUE(find_isolines(Surface_arrays(), {}, {1.}).empty());
}

} // namespace isolines_test
