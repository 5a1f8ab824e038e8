// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/unfold_hole.h>

#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Planar_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Planar_triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Planar_kernel, CGAL::Triangulation_data_structure_2<
                       CGAL::Triangulation_vertex_base_with_info_2<Index, Planar_kernel>,
                       CGAL::Constrained_triangulation_face_base_2<Planar_kernel>>>;

// Returns the points relative to the first one, divided by the largest coordinate. Squares of
// lengths then neither overflow nor underflow for edges of typical length.
std::vector<Vec3> relative_points(const std::vector<Vec3>& points)
{
  // Differences of the largest coordinates may overflow.
  std::vector<Vec3> result;
  double largest = 0.;
  for(const Vec3& p : points)
  {
    result.push_back(0.5 * p - 0.5 * points[0]);
    for(const double x : result.back())
      largest = std::max(largest, std::abs(x));
  }
  if(largest > 0.)
    for(Vec3& p : result)
      for(double& x : p)
        x /= largest;
  return result;
}

// Returns the triangles of a triangulation on the inner side of its constraints.
Hole_triangles inner_triangles(const Planar_triangulation& triangulation)
{
  using Face_handle = Planar_triangulation::Face_handle;
  // The outer faces are those that are connected with an infinite face.
  std::vector<Face_handle> stack = {triangulation.infinite_face()};
  CGAL::Unique_hash_map<Face_handle, bool> is_outer(false);
  is_outer[stack.back()] = true;
  while(!stack.empty())
  {
    const Face_handle face = stack.back();
    stack.pop_back();
    for(int k = 0; k < 3; ++k)
      if(!face->is_constrained(k) && !is_outer[face->neighbor(k)])
      {
        is_outer[face->neighbor(k)] = true;
        stack.push_back(face->neighbor(k));
      }
  }
  Hole_triangles triangles;
  for(const Face_handle face : triangulation.finite_face_handles())
    if(!is_outer[face])
      triangles.push_back(
          {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  return triangles;
}

} // namespace

std::vector<std::array<double, 2>> unfold_boundary(const std::vector<std::array<double, 3>>& points)
{
  const std::size_t n = points.size();
  const std::vector<Vec3> p = relative_points(points);
  std::vector<Vec3> edge(n);
  std::vector<double> length(n);
  Vec3 area = {0., 0., 0.}; // twice the vector area
  double perimeter = 0.;
  for(std::size_t i = 0; i < n; ++i)
  {
    edge[i] = p[(i + 1) % n] - p[i];
    length[i] = norm(edge[i]);
    if(!(length[i] > 0.))
      return {};
    perimeter += length[i];
    area = area + cross(p[i], p[(i + 1) % n]);
  }
  // A smaller area is a round-off error.
  if(!(norm(area) > 1e-14 * perimeter * perimeter))
    return {};

  // The angle by which the boundary turns at each vertex, to the left if it is positive.
  std::vector<double> turn(n);
  double total_turn = 0.;
  for(std::size_t i = 0; i < n; ++i)
  {
    const Vec3 &before = edge[(i + n - 1) % n], &after = edge[i];
    const Vec3 axis = cross(before, after);
    turn[i] = std::copysign(std::atan2(norm(axis), dot(before, after)), dot(axis, area));
    total_turn += turn[i];
  }
  const double missing_turn = 2. * pi - total_turn;

  std::vector<Vec2> result(n);
  Vec2 position = {0., 0.};
  double direction = 0.;
  for(std::size_t i = 0; i < n; ++i)
  {
    result[i] = position;
    position = position + length[i] * Vec2{std::cos(direction), std::sin(direction)};
    const std::size_t j = (i + 1) % n;
    direction += turn[j] + missing_turn * 0.5 * (length[i] + length[j]) / perimeter;
  }
  const Vec2 gap = position;
  double passed = 0.;
  for(std::size_t i = 0; i < n; ++i)
  {
    result[i] = result[i] - (passed / perimeter) * gap;
    passed += length[i];
  }
  return result;
}

Hole_triangles triangulate_unfolded_hole(const Hole_boundary& hole)
{
  const std::size_t n = hole.points.size();
  if(n < 3)
    return {};
  std::vector<Planar_kernel::Point_2> polygon;
  for(const Vec2& p : unfold_boundary(hole.points))
    polygon.emplace_back(p[0], p[1]);
  if(polygon.empty() || !CGAL::is_simple_2(polygon.begin(), polygon.end(), Planar_kernel()) ||
     CGAL::orientation_2(polygon.begin(), polygon.end(), Planar_kernel()) != CGAL::COUNTERCLOCKWISE)
    return {};
  std::vector<std::pair<Planar_kernel::Point_2, Index>> numbered;
  for(std::size_t i = 0; i < n; ++i)
    numbered.emplace_back(polygon[i], static_cast<Index>(i));
  Planar_triangulation triangulation;
  triangulation.insert(numbered.begin(), numbered.end());
  if(triangulation.number_of_vertices() != n)
    return {};
  std::vector<Planar_triangulation::Vertex_handle> vertices(n);
  for(const auto vertex : triangulation.finite_vertex_handles())
    vertices[vertex->info()] = vertex;
  for(std::size_t i = 0; i < n; ++i)
    triangulation.insert_constraint(vertices[i], vertices[(i + 1) % n]);
  Hole_triangles triangles = inner_triangles(triangulation);
  // Otherwise a vertex is on an edge that it does not belong to, which is_simple_2() excludes.
  if(triangles.size() != n - 2)
    return {};
  return checked_triangles(hole, std::move(triangles));
}

} // namespace CGAL::Geodesic_processing::internal
