// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include "core/unfold.h"

#include <cmath>

namespace CGAL::Geodesic_processing::internal {

Surface_location vertex_location(const Surface_arrays& t, Index vertex)
{
  Surface_location result;
  if(t.ring_begin[vertex] == t.ring_begin[vertex + 1])
    result.vertex = vertex;
  else
  {
    const Index corner = t.ring[t.ring_begin[vertex]];
    result.triangle = corner / 3;
    result.barycentric = barycentric_at_corner(corner);
  }
  return result;
}

Surface_location canonical(const Surface_arrays& t, const Surface_location& location)
{
  if(location.triangle == none)
    return vertex_location(t, location.vertex);
  Surface_location result = location;
  result.vertex = none;
  double sum = 0.;
  for(double& b : result.barycentric)
  {
    if(!(b > 1e-14))
      b = 0.;
    sum += b;
  }
  // Coordinates that differ from one only by round-off errors stay: the function is idempotent.
  if(const Index corner = corner_of(result); corner != none)
    result.barycentric[corner % 3] = 1.;
  else if(std::abs(sum - 1.) > 4e-16)
    for(double& b : result.barycentric)
      b /= sum;
  return result;
}

Surface_location checked(const Surface_arrays& t, const Surface_location& location)
{
  double sum = 0.;
  for(const double b : location.barycentric)
  {
    if(!(b >= -1e-6))
      throw Invalid_argument_error("A location is outside its face.");
    sum += b;
  }
  if(!(std::abs(sum - 1.) <= 1e-6))
    throw Invalid_argument_error("The barycentric coordinates of a location do not sum to one.");
  return canonical(t, location);
}

Vec3 scaled_coordinates(const Surface_arrays& t, const Surface_location& location)
{
  if(location.triangle == none)
    return t.point[location.vertex];
  const Index* corner = &t.corner[3 * std::size_t(location.triangle)];
  return location.barycentric[0] * t.point[corner[0]] +
         location.barycentric[1] * t.point[corner[1]] +
         location.barycentric[2] * t.point[corner[2]];
}

std::array<double, 3> coordinates(const Surface_arrays& t, const Surface_location& location)
{
  return t.origin + t.scale * scaled_coordinates(t, location);
}

double straight_distance(const Surface_arrays& t, const Surface_location& p,
                         const Surface_location& q)
{
  return straight_distance(scaled_coordinates(t, p), scaled_coordinates(t, q));
}

double polyline_length(const Surface_arrays& t, const std::vector<Surface_location>& path)
{
  double length = 0.;
  for(std::size_t i = 1; i < path.size(); ++i)
    length += norm(scaled_coordinates(t, path[i]) - scaled_coordinates(t, path[i - 1]));
  return length;
}

Index corner_of(const Surface_location& location)
{
  if(location.triangle != none)
    for(Index k = 0; k < 3; ++k)
      if(location.barycentric[(k + 1) % 3] == 0. && location.barycentric[(k + 2) % 3] == 0.)
        return 3 * location.triangle + k;
  return none;
}

Index vertex_of(const Surface_arrays& t, const Surface_location& location)
{
  const Index corner = corner_of(location);
  return corner == none ? location.vertex : t.corner[corner];
}

Index halfedge_of(const Surface_location& location)
{
  if(location.triangle != none && corner_of(location) == none)
    for(Index k = 0; k < 3; ++k)
      if(location.barycentric[(k + 2) % 3] == 0.)
        return 3 * location.triangle + k;
  return none;
}

std::optional<std::array<double, 3>> barycentric_in(const Surface_arrays& t, Index triangle,
                                                    const Surface_location& location)
{
  if(location.triangle == triangle)
    return location.barycentric;
  const Index vertex = vertex_of(t, location);
  if(vertex != none)
  {
    for(Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
      if(t.corner[corner] == vertex)
        return barycentric_at_corner(corner);
    return std::nullopt;
  }
  const Index h = halfedge_of(location);
  if(h != none && !t.twin.empty() && t.twin[h] != none && t.twin[h] / 3 == triangle)
    return barycentric_on_halfedge(t.twin[h], location.barycentric[h % 3]);
  return std::nullopt;
}

namespace {

std::size_t number_of_incident_triangles(const Surface_arrays& t, const Surface_location& location)
{
  const Index vertex = vertex_of(t, location);
  if(vertex != none)
    return t.ring_begin[vertex + 1] - t.ring_begin[vertex];
  return halfedge_of(location) == none ? 1 : 2;
}

} // namespace

std::vector<Index> triangles_at(const Surface_arrays& t, const Surface_location& location)
{
  std::vector<Index> result;
  result.reserve(number_of_incident_triangles(t, location));
  if(const Index vertex = vertex_of(t, location); vertex != none)
  {
    for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
      result.push_back(t.ring[i] / 3);
    return result;
  }
  result.push_back(location.triangle);
  if(const Index h = halfedge_of(location); h != none && !t.twin.empty() && t.twin[h] != none)
    result.push_back(t.twin[h] / 3);
  return result;
}

Index triangle_at(const Surface_arrays& t, const Surface_location& location)
{
  if(location.triangle != none)
    return location.triangle;
  const Index first = t.ring_begin[location.vertex];
  return first < t.ring_begin[location.vertex + 1] ? t.ring[first] / 3 : none;
}

Index common_triangle(const Surface_arrays& t, const Surface_location& p, const Surface_location& q)
{
  if(number_of_incident_triangles(t, p) > number_of_incident_triangles(t, q))
    return common_triangle(t, q, p);
  const Index vertex = vertex_of(t, p);
  if(vertex != none)
  {
    for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
      if(barycentric_in(t, t.ring[i] / 3, q))
        return t.ring[i] / 3;
    return none;
  }
  if(barycentric_in(t, p.triangle, q))
    return p.triangle;
  const Index h = halfedge_of(p), twin = h == none || t.twin.empty() ? none : t.twin[h];
  return twin != none && barycentric_in(t, twin / 3, q) ? twin / 3 : none;
}

bool is_same_point(const Surface_arrays& t, const Surface_location& p, const Surface_location& q)
{
  const Index vertex = vertex_of(t, p);
  if(vertex != none || vertex_of(t, q) != none)
    return vertex == vertex_of(t, q);
  const auto barycentric = barycentric_in(t, q.triangle, p);
  return barycentric && *barycentric == q.barycentric;
}

double path_length(const Surface_arrays& t, const std::vector<Surface_location>& path)
{
  double length = 0.;
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    const Surface_location p = canonical(t, path[i]), q = canonical(t, path[i + 1]);
    if(is_same_point(t, p, q))
      continue;
    const Index triangle = common_triangle(t, p, q);
    if(triangle == none)
      throw Invalid_argument_error("Two consecutive locations of a path have no common triangle.");
    length += distance_in_triangle(t, triangle, *barycentric_in(t, triangle, p),
                                   *barycentric_in(t, triangle, q));
  }
  return length;
}

} // namespace CGAL::Geodesic_processing::internal
