// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/window_chains.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/paths/trace_straightest.h>
#include "core/unfold.h"
#include "distances/directions.h"
#include "distances/follow_line.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

void append_if_new(const Surface_arrays& t, const Surface_location& location,
                   std::vector<Surface_location>& path)
{
  if(!is_same_point(t, path.back(), location))
    path.push_back(location);
}

// Returns the point of an origin that is closest to a location.
Surface_location closest_point_of_origin(const Window_state& windows, Index origin,
                                         const Surface_location& location)
{
  const Surface_arrays& t = *windows.triangles;
  if(origin < windows.vertices.size())
    return vertex_location(t, origin);
  const Source_piece& piece = windows.source_pieces[origin - windows.vertices.size()];
  Surface_location result = {piece.triangle, none, piece.begin};
  if(const auto barycentric = barycentric_in(t, piece.triangle, location);
     barycentric && piece.begin != piece.end)
  {
    const auto corners = unfolded(t, piece.triangle);
    const Vec2 p = unfolded_point(corners, piece.begin), q = unfolded_point(corners, piece.end);
    bool is_inside = false;
    const double fraction =
        norm(closest_point_on_segment(unfolded_point(corners, *barycentric), p, q, is_inside) - p) /
        norm(q - p);
    for(int k = 0; k < 3; ++k)
      result.barycentric[k] = (1. - fraction) * piece.begin[k] + fraction * piece.end[k];
  }
  return canonical(t, result);
}

} // namespace

std::optional<Surface_location> source_point(const Window_state& windows, Index origin)
{
  if(origin < windows.vertices.size())
    return vertex_location(*windows.triangles, origin);
  const Source_piece& piece = windows.source_pieces[origin - windows.vertices.size()];
  if(piece.begin != piece.end)
    return std::nullopt;
  return canonical(*windows.triangles, {piece.triangle, none, piece.begin});
}

double line_length(const Window_state& windows, const Window_arrival& arrival)
{
  return arrival.distance - windows.distance_of(arrival.origin);
}

double append_chain(const Window_state& windows, Index vertex, std::vector<Surface_location>& path)
{
  double length = 0.;
  for(; vertex < windows.vertices.size() && windows.vertices[vertex].corner != none;
      vertex = windows.vertices[vertex].origin)
    length += append_arrival(windows, windows.vertices[vertex], path);
  return length;
}

double append_arrival(const Window_state& windows, const Window_arrival& arrival,
                      std::vector<Surface_location>& path)
{
  const auto corners = unfolded(*windows.triangles, arrival.corner / 3);
  return append_line(windows,
                     {{arrival.corner / 3, none, barycentric_at_corner(arrival.corner)},
                      rotated(arrival.direction, edge_direction(corners, arrival.corner)),
                      line_length(windows, arrival),
                      arrival.origin},
                     path);
}

double append_line(const Window_state& windows, const Line_to_origin& line,
                   std::vector<Surface_location>& path)
{
  const Surface_arrays& t = *windows.triangles;
  const Surface_location line_start = path.back();
  if(const auto end = source_point(windows, line.origin))
  {
    const Vec2 line_begin = unfolded_point(unfolded(t, line.from.triangle), line.from.barycentric);
    const double size = norm(line.direction);
    const Vec2 line_end =
        line_begin + (size > 0. ? std::max(line.length, 0.) / size : 0.) * line.direction;
    std::vector<Surface_location> crossings;
    if(follow_line(t, {line.from.triangle, line_begin, line_end}, *end, &crossings))
    {
      crossings.push_back(*end);
      for(const Surface_location& location : crossings)
        append_if_new(t, location, path);
      return line.length;
    }
  }
  const double angle = std::atan2(line.direction[1], line.direction[0]);
  for(const Surface_location& location :
      trace_straightest(t, line.from, angle, std::max(line.length, 0.)).locations)
    append_if_new(t, canonical(t, location), path);
  const Surface_location end = closest_point_of_origin(windows, line.origin, path.back());
  // Round-off errors may have led the line past its end by a triangle or two.
  while(path.size() > 1 && common_triangle(t, path.back(), end) == none &&
        !is_same_point(t, path.back(), line_start))
    path.pop_back();
  append_if_new(t, end, path);
  return line.length;
}

} // namespace CGAL::Geodesic_processing::internal
