// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/isolines.h>

#include <CGAL/Geodesic_processing/Soup_domain.h>
#include <CGAL/Geodesic_processing/geodesic_distances.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>

#include "Array_surface.h"
#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>

namespace isolines_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Lines = std::vector<GP::Isoline<Mesh>>;

// Round-off errors of coordinates of order one; measured are at most 2e-15.
constexpr double round_off = 1e-13;

// Returns the area that closed polylines in the plane enclose on their left.
double area_on_the_left(const Lines& lines)
{
  double area = 0.;
  for(const auto& line : lines)
    for(std::size_t i = 0; i + 1 < line.points.size(); ++i)
    {
      const auto &p = line.points[i], &q = line.points[i + 1];
      area += 0.5 * (p.x() * q.y() - q.x() * p.y());
    }
  return area;
}

double max_segment_length(const Lines& lines)
{
  double result = 0.;
  for(const auto& line : lines)
    for(std::size_t i = 0; i + 1 < line.points.size(); ++i)
      result =
          std::max(result, std::sqrt(CGAL::squared_distance(line.points[i], line.points[i + 1])));
  return result;
}

// Returns the largest difference between the value of a line and the distance of its vertices from
// a source.
template <typename Distance>
double largest_error(const Lines& lines, const Distance& distance_to_source)
{
  double result = 0.;
  for(const auto& line : lines)
    for(const auto& p : line.points)
      result = std::max(result, std::abs(distance_to_source(to_array(p)) - line.value));
  return result;
}

// Returns the isolines of the geodesic distance from a vertex.
Lines offset_curves(Mesh& mesh, Vertex source, const std::vector<double>& values,
                    bool do_fit_circles)
{
  auto distance_map = vertex_map(mesh);
  GP::geodesic_distances(mesh, source, distance_map);
  Lines lines;
  GP::isolines(mesh, distance_map, values, std::back_inserter(lines),
               GP::parameters::do_fit_circles(do_fit_circles));
  return lines;
}

TEST(isolines, offset_curves_of_point_in_plane_are_circles)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    Mesh mesh = mesh_of(scaled(square(40, 0.2), scale));
    const Vertex center(20 * 41 + 20);
    const Point source = to_array(mesh.point(center));
    const Lines inner = offset_curves(mesh, center, {0.15 * scale}, true),
                outer = offset_curves(mesh, center, {0.35 * scale}, true);
    for(const auto& [lines, radius] : {std::pair(inner, 0.15 * scale), {outer, 0.35 * scale}})
    {
      ASSERT_EQ(lines.size(), 1u);
      EXPECT_TRUE(lines[0].is_closed);
      EXPECT_EQ(lines[0].points.front(), lines[0].points.back());
      EXPECT_EQ(lines[0].locations.size(), lines[0].points.size());
      EXPECT_LT(largest_error(lines, [&](const Point& p) { return distance(p, source); }),
                round_off * scale);
      // An inscribed polygon with edges of length c is shorter by at most c^2 / (24 r^2).
      const double segment = max_segment_length(lines) / radius;
      EXPECT_LE(lines[0].length, 2. * pi * radius * (1. + round_off));
      EXPECT_GE(lines[0].length, 2. * pi * radius * (1. - segment * segment / 23.));
    }
    // The region between the lines is on the left of the inner and on the right of the outer line.
    // Segments of length c cut off at most a fraction of c^2 / (6 r^2) of a disk.
    const double area = area_on_the_left(inner) - area_on_the_left(outer);
    const double expected = pi * (0.35 * 0.35 - 0.15 * 0.15) * scale * scale;
    const double tolerance =
        pi / 5.9 *
        (std::pow(max_segment_length(inner), 2.) + std::pow(max_segment_length(outer), 2.));
    EXPECT_NEAR(area, expected, tolerance);
    EXPECT_LT(tolerance, 0.01 * expected);
  }
}

TEST(isolines, linear_interpolation_is_of_second_order)
{
  for(const std::size_t n : {16, 32, 64})
  {
    Mesh mesh = mesh_of(square(n));
    const Vertex center(Mesh::size_type(n / 2 * (n + 1) + n / 2));
    const double error = largest_error(offset_curves(mesh, center, {0.2, 0.3, 0.4}, false),
                                       [](const Point& p) {
                                         return distance(p, {0.5, 0.5, 0.});
                                       });
    // The distance bends by at most 1 / r in a direction. The error on an edge of length c is at
    // most c^2 / (8 r'), where r' = r - c is the smallest distance on the edge.
    const double c = std::sqrt(2.) / double(n);
    EXPECT_LE(error, c * c / (8. * (0.2 - c)));
  }
}

TEST(isolines, offset_curves_on_sphere_are_circles_of_latitude)
{
  const std::vector<double> values = {0.3, 0.8, 1.5, 2.5};
  for(const unsigned level : {3u, 4u, 5u})
  {
    Mesh mesh = mesh_of(icosphere(level));
    const Point source = to_array(mesh.point(Vertex(0)));
    const auto latitude = [&](const Point& p)
    { return great_circle(source, GP::internal::unit(p)); };
    const double h = 1.33 / double(1u << level); // more than the longest edge
    for(const bool do_fit_circles : {false, true})
    {
      const Lines lines = offset_curves(mesh, Vertex(0), values, do_fit_circles);
      ASSERT_EQ(lines.size(), values.size());
      for(std::size_t i = 0; i < values.size(); ++i)
      {
        EXPECT_TRUE(lines[i].is_closed);
        // Measured relative errors of the length are at most 0.47 h^2.
        EXPECT_NEAR(lines[i].length / (2. * pi * std::sin(values[i])), 1., 0.6 * h * h);
      }
      // Measured errors are at most 0.41 h^2. They are those of distances on the inscribed
      // polyhedron, which is shorter than the sphere.
      EXPECT_LT(largest_error(lines, latitude), 0.5 * h * h);
      // Close to the source, the error of the interpolation is larger: 0.34 h^2 if it is linear.
      // If it is circular, 0.035 h^2 remain.
      if(do_fit_circles)
      {
        EXPECT_LT(largest_error({lines[0]}, latitude), 0.05 * h * h);
      }
    }
  }
}

TEST(isolines, locations_and_points_agree)
{
  Mesh mesh = mesh_of(icosphere(3));
  auto height = vertex_map(mesh);
  for(const Vertex v : mesh.vertices())
    height[v] = mesh.point(v).z();
  Lines lines;
  GP::isolines(mesh, height, std::vector<double>{-0.5, 0., 0.5}, std::back_inserter(lines));
  ASSERT_EQ(lines.size(), 3u);
  for(const auto& line : lines)
  {
    double length = 0.;
    for(std::size_t i = 0; i < line.points.size(); ++i)
    {
      EXPECT_LT(distance(to_array(line.points[i]), point_of(mesh, line.locations[i])), round_off);
      EXPECT_NEAR(line.points[i].z(), line.value, round_off);
      if(i > 0)
        length += std::sqrt(CGAL::squared_distance(line.points[i - 1], line.points[i]));
    }
    EXPECT_NEAR(line.length, length, round_off);
  }
}

TEST(isolines, end_at_unreached_vertices_and_boundaries)
{
  // Two components. The distance reaches only a part of the first one.
  Mesh mesh = mesh_of(disjoint_union(square(20, 0.2), tetrahedron()));
  auto distance_map = vertex_map(mesh);
  GP::geodesic_distances(mesh, Vertex(0), distance_map, GP::parameters::maximum_distance(0.5));
  Lines lines;
  GP::isolines(mesh, distance_map, std::vector<double>{0.2, 0.4, 0.9}, std::back_inserter(lines));
  ASSERT_EQ(lines.size(), 2u);
  for(const auto& line : lines)
  {
    EXPECT_FALSE(line.is_closed);
    // A quarter of a circle from one edge of the square to the other. Larger values on the left.
    EXPECT_EQ(line.points.front().x(), 0.);
    EXPECT_EQ(line.points.back().y(), 0.);
  }
}

template <typename TriangleMesh>
std::vector<double> lengths_on(const Triangulation& surface)
{
  Numbered<TriangleMesh> numbered;
  fill(numbered, surface);
  using Vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  std::map<Vertex_descriptor, double> heights;
  for(std::size_t i = 0; i < surface.points.size(); ++i)
    heights[numbered.vertices[i]] = surface.points[i][2];
  std::vector<GP::Isoline<TriangleMesh>> lines;
  GP::isolines(numbered.mesh, boost::make_assoc_property_map(heights),
               std::array<double, 2>{0.1, 0.7}, std::back_inserter(lines));
  std::vector<double> lengths;
  for(const auto& line : lines)
    lengths.push_back(line.length);
  return lengths;
}

TEST(isolines, are_the_same_on_all_mesh_types)
{
  const Triangulation surface = icosphere(2);
  using Exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const std::vector<double> lengths = lengths_on<Mesh>(surface);
  EXPECT_EQ(lengths.size(), 2u);
  EXPECT_EQ(lengths_on<CGAL::Polyhedron_3<Exact_kernel>>(surface), lengths);

  // A soup of single triangles
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> polygons;
  for(std::size_t c = 0; c < surface.corners.size(); ++c)
  {
    const Point& p = surface.points[surface.corners[c]];
    points.emplace_back(p[0], p[1], p[2]);
    if(c % 3 == 2)
      polygons.push_back({c - 2, c - 1, c});
  }
  const auto domain = GP::make_domain(points, polygons, GP::parameters::merge_tolerance(0.));
  std::map<Vertex, double> heights;
  for(const Vertex v : domain.mesh().vertices())
    heights[v] = domain.mesh().point(v).z();
  Lines lines;
  GP::isolines(domain, boost::make_assoc_property_map(heights), std::vector<float>{0.1f, 0.7f},
               std::back_inserter(lines));
  ASSERT_EQ(lines.size(), 2u);
  // 0.1f and 0.7f differ from 0.1 and 0.7 by 3e-8.
  for(const std::size_t i : {0, 1})
    EXPECT_NEAR(lines[i].length, lengths[i], 1e-6);
}

TEST(isolines, throws_on_invalid_isovalues)
{
  Mesh mesh = mesh_of(square(2));
  Lines lines;
  for(const double value : {double(infinity), std::nan("")})
    EXPECT_THROW(GP::isolines(mesh, vertex_map(mesh), std::vector<double>{0., value},
                              std::back_inserter(lines)),
                 GP::Invalid_argument_error);
  EXPECT_TRUE(lines.empty());
  GP::isolines(mesh, vertex_map(mesh), std::vector<double>{}, std::back_inserter(lines));
  EXPECT_TRUE(lines.empty());
  GP::isolines(Mesh(), vertex_map(mesh), std::vector<double>{1.}, std::back_inserter(lines));
  EXPECT_TRUE(lines.empty());
}

} // namespace isolines_test
