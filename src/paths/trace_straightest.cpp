// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/trace_straightest.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

namespace {

// A path that crosses an edge closer to an endpoint than this fraction of its length hits the
// vertex. Otherwise, on regular grids, round-off errors would decide on which side it passes.
constexpr double hit_tolerance = 1e-12;

// Adds a multiple of 2 pi to an angle such that it is closest to the bisector of a corner.
double wrap_to_corner(double angle, double corner)
{
  return std::remainder(angle - corner / 2., 2. * pi) + corner / 2.;
}

Vec2 unit_vector(double angle) { return {std::cos(angle), std::sin(angle)}; }

class Tracer
{
public:
  Tracer(const Surface_arrays& t, Surface_location from, double angle, double length)
      : t(t), m_remaining_length(length), m_length_tolerance(1e-13 * length)
  {
    m_path.locations.push_back(from);
    m_triangle = from.triangle;
    m_corners = unfolded(t, m_triangle);
    m_point = unfolded_point(m_corners, from.barycentric);
    m_direction = unit_vector(angle);
    if(length > 0.)
    {
      if(const Index corner = corner_of(from); corner != none)
        leave_corner(corner, angle - angle_of_halfedge(corner));
      else if(const Index h = halfedge_of(from); h != none && points_out(h))
        cross_edge(h, from.barycentric[next_halfedge(h) % 3]);
      else
        m_entry_halfedge = halfedge_of(from);
    }
  }

  Straightest_path operator()()
  {
    std::size_t number_of_steps = 0, number_of_stalled_steps = 0;
    const std::size_t max_steps = 1000000 + 10 * std::size_t(t.number_of_triangles());
    while(m_remaining_length > 0. && m_path.end == Straightest_path_end::length)
    {
      const double previous_length = m_remaining_length;
      cross_triangle();
      number_of_stalled_steps =
          m_remaining_length < previous_length ? 0 : number_of_stalled_steps + 1;
      if(number_of_stalled_steps > 10000 || ++number_of_steps > max_steps)
        m_path.end = Straightest_path_end::degenerate;
    }
    m_path.angle = std::atan2(m_direction[1], m_direction[0]);
    return std::move(m_path);
  }

private:
  const Vec2& corner_position(Index corner) const { return m_corners[corner % 3]; }
  Vec2 edge_vector(Index h) const { return corner_position(next_halfedge(h)) - corner_position(h); }
  double angle_of_halfedge(Index h) const
  {
    const Vec2 v = edge_vector(h);
    return std::atan2(v[1], v[0]);
  }
  bool points_out(Index h) const { return internal::cross(edge_vector(h), m_direction) < 0.; }

  void enter(Index triangle)
  {
    m_triangle = triangle;
    m_corners = unfolded(t, triangle);
  }

  void add(Index triangle, const std::array<double, 3>& barycentric)
  {
    Surface_location location;
    location.triangle = triangle;
    location.barycentric = barycentric;
    if(is_same_point(t, m_path.locations.back(), location))
      m_path.locations.back() = location;
    else
      m_path.locations.push_back(location);
  }

  // The point at which the path leaves a triangle.
  struct Exit
  {
    Index halfedge = none;
    double distance = infinity, fraction = 0.;
  };

  // Returns the point on an edge, other than the one of entry, that the ray from m_point meets
  // first.
  Exit find_exit() const
  {
    Exit exit;
    for(Index h = 3 * m_triangle; h < 3 * m_triangle + 3; ++h)
    {
      if(h == m_entry_halfedge || (m_from_corner != none && h != next_halfedge(m_from_corner)))
        continue;
      const Vec2 v = edge_vector(h), w = corner_position(h) - m_point;
      const double denominator = internal::cross(m_direction, v);
      // The fraction of the edge at which the ray crosses it.
      const double exit_fraction =
          -internal::cross(m_direction, w) / (denominator > 0. ? denominator : 1.);
      if(!(denominator > 0.))
        continue;
      const double distance = std::max(0., internal::cross(w, v) / denominator);
      if(distance < exit.distance)
        exit = {h, distance, std::clamp(exit_fraction, 0., 1.)};
    }
    if(exit.halfedge == none)
    {
      // In a degenerate triangle, continue to the midpoint of the next edge.
      const Index h = m_from_corner != none      ? next_halfedge(m_from_corner)
                      : m_entry_halfedge != none ? next_halfedge(m_entry_halfedge)
                                                 : 3 * m_triangle;
      exit = {h, norm(corner_position(h) + 0.5 * edge_vector(h) - m_point), 0.5};
    }
    return exit;
  }

  // Moves straight from m_point to the triangle's boundary, or to the end of the path.
  void cross_triangle()
  {
    const auto [out, exit_distance, fraction] = find_exit();
    if(m_remaining_length <= exit_distance + m_length_tolerance)
    {
      stop_in_triangle(out, exit_distance, fraction);
      return;
    }
    m_remaining_length -= exit_distance;
    m_path.length += exit_distance;
    m_from_corner = none;
    if(fraction < hit_tolerance)
      pass_vertex(out);
    else if(fraction > 1. - hit_tolerance)
      pass_vertex(next_halfedge(out));
    else
    {
      add(m_triangle, barycentric_on_halfedge(out, fraction));
      cross_edge(out, fraction);
    }
  }

  // Ends the path between its last location and the exit from the triangle.
  void stop_in_triangle(Index out, double exit_distance, double fraction)
  {
    const auto from = *barycentric_in(t, m_triangle, m_path.locations.back());
    const auto to = barycentric_on_halfedge(out, fraction);
    const double step_fraction =
        exit_distance > m_remaining_length ? m_remaining_length / exit_distance : 1.;
    std::array<double, 3> barycentric;
    for(int k = 0; k < 3; ++k)
      barycentric[k] = from[k] + step_fraction * (to[k] - from[k]);
    m_path.length += m_remaining_length;
    m_remaining_length = 0.;
    Surface_location end;
    end.triangle = m_triangle;
    end.barycentric = barycentric;
    add(m_triangle, canonical(t, end).barycentric);
  }

  // Enters the adjacent triangle at a fraction of an edge. Ends the path if it is on the boundary.
  void cross_edge(Index h, double fraction)
  {
    const Index twin = t.twin[h];
    if(twin == none)
    {
      m_path.end = Straightest_path_end::boundary;
      return;
    }
    // Express the direction relative to the common edge, whose halfedges have opposite directions.
    const Vec2 edge = edge_vector(h);
    const double length = norm(edge);
    const Vec2 local = length > 0. ? (1. / length) * rotated_back(m_direction, edge) : m_direction;
    enter(twin / 3);
    const Vec2 twin_edge = edge_vector(twin);
    const double twin_length = norm(twin_edge);
    if(twin_length > 0.)
      m_direction = (-1. / twin_length) * rotated(local, twin_edge);
    m_direction = (1. / norm(m_direction)) * m_direction;
    m_point = corner_position(twin) + (1. - fraction) * twin_edge;
    m_entry_halfedge = twin;
    m_from_corner = none;
  }

  // Leaves a corner of this triangle at an angle counterclockwise from the corner's halfedge.
  void leave_corner(Index corner, double angle)
  {
    double full_angle = interior_angle(t, corner);
    angle = wrap_to_corner(angle, full_angle);
    // Subtract the angles of the triangles around the vertex; visit each triangle at most once.
    std::size_t max_turns = t.ring_begin[t.corner[corner] + 1] - t.ring_begin[t.corner[corner]] + 1;
    while((angle < 0. || angle > full_angle) && max_turns-- > 0)
    {
      const bool is_left = angle > 0.;
      const Index next = is_left ? next_corner_ccw(t, corner) : next_corner_cw(t, corner);
      if(next == none)
      {
        // If the angle exceeds the corner by round-off errors only, follow the boundary.
        if(std::min(std::abs(angle), std::abs(angle - full_angle)) > 1e-9)
          m_path.end = Straightest_path_end::boundary;
        break;
      }
      if(is_left)
        angle -= full_angle;
      corner = next;
      full_angle = interior_angle(t, corner);
      if(!is_left)
        angle += full_angle;
    }
    angle = std::clamp(angle, 0., full_angle);
    enter(corner / 3);
    m_from_corner = corner;
    m_entry_halfedge = none;
    m_point = this->corner_position(corner);
    const Vec2 edge = edge_vector(corner);
    const double length = norm(edge);
    m_direction =
        length > 0. ? rotated((1. / length) * edge, unit_vector(angle)) : unit_vector(angle);
    m_path.locations.back().triangle = m_triangle;
    m_path.locations.back().barycentric = barycentric_at_corner(corner);
  }

  // Continues from a corner of this triangle that the path has hit.
  void pass_vertex(Index corner)
  {
    add(m_triangle, barycentric_at_corner(corner));
    // The backward direction, counterclockwise from the corner's halfedge. It can point out of
    // this triangle if the path entered close to the corner.
    const double full_angle = interior_angle(t, corner);
    const Vec2 edge = edge_vector(corner), back = -1. * m_direction;
    const double back_angle =
        wrap_to_corner(std::atan2(internal::cross(edge, back), dot(edge, back)), full_angle);

    // The angles on the right (counterclockwise from the backward direction) and on the left.
    double right_angle = full_angle - back_angle, left_angle = back_angle;
    bool is_boundary = false;
    Index rotated_corner = next_corner_ccw(t, corner);
    for(; rotated_corner != none && rotated_corner != corner;
        rotated_corner = next_corner_ccw(t, rotated_corner))
      right_angle += interior_angle(t, rotated_corner);
    if(rotated_corner == none)
    {
      is_boundary = true;
      for(rotated_corner = next_corner_cw(t, corner); rotated_corner != none;
          rotated_corner = next_corner_cw(t, rotated_corner))
        left_angle += interior_angle(t, rotated_corner);
    }
    if(!is_boundary)
      rotate_and_leave(corner, back_angle + (right_angle + left_angle) / 2.);
    else if(right_angle > pi - 1e-9)
      rotate_and_leave(corner, back_angle + std::min(right_angle, pi));
    else if(left_angle > pi - 1e-9)
      rotate_and_leave(corner, back_angle - std::min(left_angle, pi));
    else
      m_path.end = Straightest_path_end::boundary;
  }

  // Leaves a corner at an angle that may point out of it by several triangles.
  void rotate_and_leave(Index corner, double angle)
  {
    std::size_t max_turns = t.ring_begin[t.corner[corner] + 1] - t.ring_begin[t.corner[corner]] + 1;
    for(double full_angle = interior_angle(t, corner); max_turns-- > 0 && angle > full_angle;)
    {
      const Index next = next_corner_ccw(t, corner);
      if(next == none)
        break;
      angle -= full_angle;
      corner = next;
      full_angle = interior_angle(t, corner);
    }
    while(max_turns-- > 0 && angle < 0.)
    {
      const Index next = next_corner_cw(t, corner);
      if(next == none)
        break;
      corner = next;
      angle += interior_angle(t, corner);
    }
    leave_corner(corner, std::clamp(angle, 0., interior_angle(t, corner)));
  }

  const Surface_arrays& t;
  Straightest_path m_path;
  double m_remaining_length;
  // The path ends in a triangle if the remaining length exceeds the distance to the exit by at most
  // this. A path that reaches the boundary with such a remainder has its full length.
  const double m_length_tolerance;

  Index m_triangle;
  std::array<Vec2, 3> m_corners;
  Vec2 m_point, m_direction;
  Index m_entry_halfedge = none; // the edge on which m_point lies, or `none`
  Index m_from_corner = none;    // the corner at which m_point lies, or `none`
};

} // namespace

Straightest_path trace_straightest(const Surface_arrays& t, const Surface_location& from,
                                   double angle, double length)
{
  if(!std::isfinite(angle) || !std::isfinite(length) || length < 0.)
    throw Invalid_argument_error("The direction or the length of a straightest geodesic is not "
                                 "finite, or the length is negative.");
  if(t.is_cloud())
    throw Unsupported_surface_error("Straightest geodesics require a mesh, because the triangles "
                                    "of a cloud are not connected.");
  const Surface_location start = canonical(t, from);
  if(start.triangle == none)
  {
    Straightest_path result;
    result.locations.push_back(start);
    result.end = length > 0. ? Straightest_path_end::boundary : Straightest_path_end::length;
    return result;
  }
  return Tracer(t, start, angle, length)();
}

namespace {

// Projects a direction to the plane of a triangle; the corner's halfedge is the first axis.
Vec2 project_to_triangle(const Surface_arrays& t, Index corner, const Vec3& direction)
{
  const Vec3& origin = t.point[t.corner[corner]];
  const Vec3 axis_1 = unit(t.point[t.corner[next_halfedge(corner)]] - origin);
  const Vec3 third = t.point[t.corner[previous_halfedge(corner)]] - origin;
  const Vec3 axis_2 = unit(third - dot(third, axis_1) * axis_1);
  return {dot(direction, axis_1), dot(direction, axis_2)};
}

} // namespace

Straightest_path trace_straightest_in_space(const Surface_arrays& t, const Surface_location& from,
                                            const std::array<double, 3>& direction, double length)
{
  const double norm_of_direction = norm(direction);
  if(!(norm_of_direction > 0.) || !std::isfinite(norm_of_direction))
    throw Invalid_argument_error("The direction of a straightest geodesic is zero or not finite.");
  const Vec3 unit_direction = (1. / norm_of_direction) * direction;
  Surface_location start = canonical(t, from);
  if(start.triangle == none)
    throw Invalid_argument_error("A straightest geodesic cannot start at an isolated vertex.");
  Vec2 planar_direction = project_to_triangle(t, 3 * start.triangle, unit_direction);
  if(const Index vertex = vertex_of(t, start); vertex != none)
  {
    // Prefer triangles that contain the projection, then those with the longest projection.
    std::pair<bool, double> best_fit = {false, -1.};
    for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
    {
      const Index corner = t.ring[i];
      const Vec2 candidate = project_to_triangle(t, corner, unit_direction);
      const Vec2 opening = corner_angle(t, corner);
      const bool is_inside = candidate[1] >= 0. && cross(candidate, opening) >= 0.;
      if(std::make_pair(is_inside, norm(candidate)) > best_fit)
      {
        best_fit = {is_inside, norm(candidate)};
        start = {corner / 3, none, barycentric_at_corner(corner)};
        planar_direction = project_to_triangle(t, 3 * start.triangle, unit_direction);
      }
    }
  }
  // The projection of a unit normal vector consists of round-off errors.
  if(!(norm(planar_direction) > 1e-14))
    throw Invalid_argument_error(
        "The direction of a straightest geodesic is normal to the surface.");
  return trace_straightest(t, start, std::atan2(planar_direction[1], planar_direction[0]), length);
}

} // namespace CGAL::Geodesic_processing::internal
