// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/distance_derivatives.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include "core/unfold.h"
#include "distances/Second_path_search.h"
#include "distances/Window_propagator.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns the corner of a vertex in a triangle that contains a location, and the angle from its
// halfedge to the location.
std::pair<Index, double> corner_and_angle(const Surface_arrays& t, Index vertex,
                                          const Surface_location& location)
{
  const Index triangle = common_triangle(t, vertex_location(t, vertex), location);
  Index corner = 3 * triangle;
  while(t.corner[corner] != vertex)
    ++corner;
  const auto corners = unfolded(t, triangle);
  const Vec2 from = corners[corner % 3],
             direction = rotated_back(
                 unfolded_point(corners, *barycentric_in(t, triangle, location)) - from,
                 corners[next_halfedge(corner) % 3] - from);
  return {corner, std::atan2(std::max(0., direction[1]), direction[0])};
}

// Returns the angle at a vertex from one location to another one, counterclockwise. It is infinite
// if the boundary is between them, or if they are in different fans.
double angle_ccw(const Surface_arrays& t, Index vertex, const Surface_location& from,
                 const Surface_location& to)
{
  const auto [first, begin] = corner_and_angle(t, vertex, from);
  const auto [last, end] = corner_and_angle(t, vertex, to);
  if(first == last && begin <= end)
    return end - begin;
  double angle = interior_angle(t, first) - begin;
  for(Index corner = next_corner_ccw(t, first); corner != none; corner = next_corner_ccw(t, corner))
  {
    if(corner == last)
      return angle + end;
    if(corner == first)
      break;
    angle += interior_angle(t, corner);
  }
  return infinity;
}

// Returns whether a path passes a vertex so closely, or bends at it by so little, that small
// motions can change the edges that it crosses.
bool is_near_vertex(const Surface_arrays& t, const std::vector<Surface_location>& path,
                    double tolerance)
{
  for(std::size_t i = 1; i + 1 < path.size(); ++i)
  {
    // In degenerate triangles.
    if(!(straight_distance(t, path[i - 1], path[i]) > 0. &&
         straight_distance(t, path[i], path[i + 1]) > 0.))
      return true;
    if(const Index vertex = vertex_of(t, path[i]); vertex != none)
    {
      if(std::min(angle_ccw(t, vertex, path[i - 1], path[i + 1]),
                  angle_ccw(t, vertex, path[i + 1], path[i - 1])) < pi + tolerance)
        return true;
    }
    else if(const Index h = halfedge_of(path[i]); h != none)
    {
      const double fraction = path[i].barycentric[h % 3];
      if(std::min(fraction, 1. - fraction) < tolerance)
        return true;
    }
  }
  return false;
}

// Returns the unit vectors along the segments of a path. A segment of length zero, in a degenerate
// triangle, has the direction of the previous one, or of the next one if there is none. The vectors
// are zero if all segments have length zero.
std::vector<Vec3> directions_along(const Surface_arrays& t,
                                   const std::vector<Surface_location>& path)
{
  std::vector<Vec3> result;
  std::size_t number_of_leading = 0; // segments of length zero
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
    if(straight_distance(t, path[i], path[i + 1]) > 0.)
      result.push_back(unit(scaled_coordinates(t, path[i + 1]) - scaled_coordinates(t, path[i])));
    else if(number_of_leading == i)
    {
      ++number_of_leading;
      result.push_back({0., 0., 0.});
    }
    else
      result.push_back(result.back());
  if(number_of_leading < result.size())
    std::fill_n(result.begin(), number_of_leading, result[number_of_leading]);
  return result;
}

// Sets the derivatives of the length of a polyline with constant barycentric coordinates, which
// begins at the source.
//
// directions  #path - 1, those of the segments
void differentiate(const Surface_arrays& t, const std::vector<Surface_location>& path,
                   const std::vector<Vec3>& directions, Distance_derivatives& result)
{
  std::map<Index, std::size_t> position; // of a vertex in the list of gradients
  for(std::size_t i = 0; i < path.size(); ++i)
  {
    const Vec3 zero = {0., 0., 0.};
    const Vec3 gradient =
        (i > 0 ? directions[i - 1] : zero) - (i < directions.size() ? directions[i] : zero);
    for(Index k = 0; k < 3; ++k)
      if(const double weight = path[i].barycentric[k]; weight > 0.)
      {
        const Index vertex = t.corner[3 * path[i].triangle + k];
        const auto [found, is_new] = position.emplace(vertex, result.vertex_gradients.size());
        if(is_new)
          result.vertex_gradients.push_back({vertex, zero});
        Vec3& sum = result.vertex_gradients[found->second].second;
        sum = sum + weight * gradient;
      }
    if(i == 0)
      result.source_gradient = gradient;
    result.target_gradient = gradient;
  }
}

} // namespace

Distance_derivatives distance_derivatives(const std::shared_ptr<const Surface_arrays>& triangles,
                                          const Surface_location& source,
                                          const Surface_location& target,
                                          const Derivative_tolerances& tolerances)
{
  const Surface_arrays& t = *triangles;
  Distance_derivatives result;
  Window_propagation windows(triangles);
  Front_limits limits;
  limits.targets = {source};
  windows.run({{{target}, 0., 0}}, limits); // so that paths begin at the source
  const double distance = windows.distance(source);
  result.distance = distance;
  if(distance == infinity)
    return result;
  result.differentiability = Differentiability::coincident;
  if(!(distance > 0.))
    return result;
  const std::vector<Surface_location> path = windows.path(source).locations;
  if(path.empty())
    throw Unsupported_surface_error("Degenerate faces prevent the construction of a path.");
  const std::vector<Vec3> directions = directions_along(t, path);
  if(directions.empty() || norm(directions[0]) == 0.)
    return result;
  differentiate(t, path, directions, result);
  if(is_near_vertex(t, path, tolerances.vertex))
  {
    result.differentiability = Differentiability::near_vertex;
    return result;
  }
  // Farther vertices may have distances that are not final.
  const auto lower_bound = [&](Index vertex)
  { return (1. - round_off_tolerance) * std::min(windows.distance(vertex), distance); };
  Second_path_search search(triangles, find_pseudo_sources(t), source, target, lower_bound,
                            distance * (1. + tolerances.second_path));
  result.differentiability = search.has_path_other_than(path) ? Differentiability::second_path
                                                              : Differentiability::differentiable;
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
