// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/follow_line.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"
#include "distances/directions.h"

#include <algorithm>
#include <array>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The end of a segment is found if it is closer than this fraction of an edge. Also the angle
// within which a segment touches a vertex.
constexpr double location_tolerance = 1e-6;
// A crossing closer to an end of the edge than this fraction is moved to that end.
constexpr double edge_end_tolerance = 1e-9;

// Returns whether a point is to the left of a line, seen from its begin, by more than this angle.
bool is_left(const Line& line, const Vec2& point, double angle_tolerance)
{
  const Vec2 direction = line.target - line.from, to_point = point - line.from;
  return cross(direction, to_point) > angle_tolerance * norm(direction) * norm(to_point);
}

// Returns the halfedge through which a line leaves its first triangle.
Index first_halfedge(const std::array<Vec2, 3>& corners, const Line& line, double angle_tolerance)
{
  for(const Index begin : {0, 1, 2})
  {
    const Index end = (begin + 1) % 3;
    if((corners[begin] == line.from || !is_left(line, corners[begin], angle_tolerance)) &&
       (corners[end] == line.from || is_left(line, corners[end], angle_tolerance)))
      return 3 * line.triangle + begin;
  }
  return 3 * line.triangle;
}

// Follows a line as follow_line() does. If the third corner of a triangle is to the left of the
// line by more than the angle, the line leaves to the right of that corner, otherwise to the left
// of it.
std::optional<Line> follow_line(const Surface_arrays& t, Line line, const Surface_location& end,
                                double angle_tolerance, std::vector<Surface_location>* crossings)
{
  const std::vector<Index> target_triangles = triangles_at(t, end);
  auto corners = unfolded(t, line.triangle);
  Index h = first_halfedge(corners, line, angle_tolerance);
  // A shortest path crosses each triangle at most once.
  for(std::size_t i = 0; i < t.number_of_triangles(); ++i)
  {
    if(std::find(target_triangles.begin(), target_triangles.end(), line.triangle) !=
       target_triangles.end())
    {
      const Vec2 end_point = unfolded_point(corners, *barycentric_in(t, line.triangle, end));
      if(norm(end_point - line.target) < location_tolerance * t.length[h])
        return Line{line.triangle, line.from, end_point};
    }
    const Vec2 line_direction = line.target - line.from, begin = corners[h % 3],
               edge = corners[next_halfedge(h) % 3] - begin;
    const bool is_before = dot(begin - line.target, line_direction) < 0. ||
                           dot(begin + edge - line.target, line_direction) < 0.;
    if(!is_before || t.twin[h] == none)
      return std::nullopt;
    if(crossings != nullptr)
    {
      const double across = cross(line_direction, edge);
      const double fraction = across > 0. ? cross(line_direction, line.from - begin) / across : 0.;
      crossings->push_back(canonical(
          t, {line.triangle, none,
              barycentric_on_halfedge(h, fraction < edge_end_tolerance        ? 0.
                                         : fraction > 1. - edge_end_tolerance ? 1.
                                                                              : fraction)}));
    }
    // Changes to the layout of the adjacent triangle.
    const Vec2 direction = edge_direction(corners, h);
    h = t.twin[h];
    line.triangle = h / 3;
    corners = unfolded(t, line.triangle);
    const Vec2 rotation = rotated_back(-1. * edge_direction(corners, h), direction);
    line.from = corners[next_halfedge(h) % 3] + rotated(line.from - begin, rotation);
    line.target = corners[next_halfedge(h) % 3] + rotated(line.target - begin, rotation);
    h = is_left(line, corners[previous_halfedge(h) % 3], angle_tolerance) ? next_halfedge(h)
                                                                          : previous_halfedge(h);
  }
  return std::nullopt;
}

} // namespace

std::optional<Line> follow_line(const Surface_arrays& t, const Line& line,
                                const Surface_location& end,
                                std::vector<Surface_location>* crossings)
{
  for(const double angle_tolerance : {0., location_tolerance, -location_tolerance})
  {
    if(crossings != nullptr)
      crossings->clear();
    if(const auto line_found = follow_line(t, line, end, angle_tolerance, crossings))
      return line_found;
  }
  return std::nullopt;
}

} // namespace CGAL::Geodesic_processing::internal
