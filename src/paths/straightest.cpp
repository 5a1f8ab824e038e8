// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/straightest.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/spatial.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

namespace {

// A path nearer than this fraction of a side to its end hits the site: on lattices it would
// otherwise pass it on the side that rounding chooses.
constexpr double hit_tolerance = 1e-12;

// The same direction as an angle as near as can be to the middle of a corner.
double near_middle(double angle, double corner)
{
  return std::remainder(angle - corner / 2., 2. * pi) + corner / 2.;
}

Planar unit_vector(double angle) { return {std::cos(angle), std::sin(angle)}; }

class Walk
{
public:
  Walk(const Glued_triangles& t, Location from, double angle, double length)
      : t(t), m_left(length), m_rounding(1e-13 * length)
  {
    m_path.locations.push_back(from);
    m_triangle = from.triangle;
    m_corners = unfolded(t, m_triangle);
    m_point = unfolded_point(m_corners, from.barycentric);
    m_direction = unit_vector(angle);
    if(length > 0.)
    {
      if(const Index corner = corner_of(from); corner != none)
        leave_corner(corner, angle - angle_of_side(corner));
      else if(const Index side = side_of(from); side != none && points_out(side))
        cross(side, from.barycentric[next_side(side) % 3]);
      else
        m_entered = side_of(from);
    }
  }

  Straightest_path operator()()
  {
    std::size_t idle = 0;
    while(m_left > 0. && m_path.end == Straightest_end::length)
    {
      const double before = m_left;
      pass_triangle();
      idle = m_left < before ? 0 : idle + 1;
      if(idle > 10000)
        m_path.end = Straightest_end::degenerate;
    }
    m_path.angle = std::atan2(m_direction[1], m_direction[0]);
    return std::move(m_path);
  }

private:
  const Planar& corner(Index corner) const { return m_corners[corner % 3]; }
  Planar vector(Index side) const { return corner(next_side(side)) - corner(side); }
  double angle_of_side(Index side) const
  {
    const Planar v = vector(side);
    return std::atan2(v[1], v[0]);
  }
  bool points_out(Index side) const { return internal::cross(vector(side), m_direction) < 0.; }

  void enter(Index triangle)
  {
    m_triangle = triangle;
    m_corners = unfolded(t, triangle);
  }

  void add(Index triangle, const std::array<double, 3>& barycentric)
  {
    Location location;
    location.triangle = triangle;
    location.barycentric = barycentric;
    if(is_same_point(t, m_path.locations.back(), location))
      m_path.locations.back() = location;
    else
      m_path.locations.push_back(location);
  }

  // Goes straight from m_point to the triangle's boundary, or as far as the length allows.
  void pass_triangle()
  {
    // The side left through: of those not entered by, the one that the direction meets first.
    Index out = none;
    double reach = infinity, share = 0.;
    for(Index side = 3 * m_triangle; side < 3 * m_triangle + 3; ++side)
    {
      if(side == m_entered || (m_from_corner != none && side != next_side(m_from_corner)))
        continue;
      const Planar v = vector(side), w = corner(side) - m_point;
      const double turn = internal::cross(m_direction, v);
      // Both ends seen from the point: the share at which the ray passes between them.
      const double at = -internal::cross(m_direction, w) / (turn > 0. ? turn : 1.);
      if(!(turn > 0.))
        continue;
      const double distance = std::max(0., internal::cross(w, v) / turn);
      if(distance < reach)
      {
        reach = distance;
        out = side;
        share = std::clamp(at, 0., 1.);
      }
    }
    if(out == none)
    {
      // Without area: straight on to the far end of the longest side there is.
      out = m_from_corner != none ? next_side(m_from_corner)
            : m_entered != none   ? next_side(m_entered)
                                  : 3 * m_triangle;
      share = 0.5;
      reach = norm(corner(out) + 0.5 * vector(out) - m_point);
    }
    if(m_left <= reach + m_rounding)
    {
      stop_inside(out, reach, share);
      return;
    }
    m_left -= reach;
    m_path.length += reach;
    m_from_corner = none;
    if(share < hit_tolerance)
      pass_corner(out);
    else if(share > 1. - hit_tolerance)
      pass_corner(next_side(out));
    else
    {
      add(m_triangle, on_side(out, share));
      cross(out, share);
    }
  }

  void stop_inside(Index out, double reach, double share)
  {
    const auto from = *seen_from(t, m_triangle, m_path.locations.back());
    const auto to = on_side(out, share);
    const double part = reach > m_left ? m_left / reach : 1.;
    std::array<double, 3> b;
    for(int k = 0; k < 3; ++k)
      b[k] = from[k] + part * (to[k] - from[k]);
    m_path.length += m_left;
    m_left = 0.;
    Location end;
    end.triangle = m_triangle;
    end.barycentric = b;
    add(m_triangle, cleaned(t, end).barycentric);
  }

  void cross(Index side, double share)
  {
    const Index twin = t.twin[side];
    if(twin == none)
    {
      m_path.end = Straightest_end::border;
      return;
    }
    // The direction in terms of the common side, which turns by pi from one triangle to the other.
    const Planar along = vector(side);
    const double length = norm(along);
    const Planar local =
        length > 0. ? (1. / length) * turned_back(m_direction, along) : m_direction;
    enter(twin / 3);
    const Planar back = vector(twin);
    const double back_length = norm(back);
    if(back_length > 0.)
      m_direction = (-1. / back_length) * turned(local, back);
    m_direction = (1. / norm(m_direction)) * m_direction;
    m_point = corner(twin) + (1. - share) * back;
    m_entered = twin;
    m_from_corner = none;
  }

  // Leaves a corner of this triangle at an angle counterclockwise from the side that leaves it.
  void leave_corner(Index corner, double angle)
  {
    double whole = interior_angle(t, corner);
    angle = near_middle(angle, whole);
    // Every triangle around the site takes its share of the angle, once around at most.
    std::size_t turns = t.first[t.corner[corner] + 1] - t.first[t.corner[corner]] + 1;
    while((angle < 0. || angle > whole) && turns-- > 0)
    {
      const bool is_left = angle > 0.;
      const Index next = is_left ? turn_left(t, corner) : turn_right(t, corner);
      if(next == none)
      {
        // Along the border, when the angle leaves it by rounding only.
        if(std::min(std::abs(angle), std::abs(angle - whole)) > 1e-9)
          m_path.end = Straightest_end::border;
        break;
      }
      if(is_left)
        angle -= whole;
      corner = next;
      whole = interior_angle(t, corner);
      if(!is_left)
        angle += whole;
    }
    angle = std::clamp(angle, 0., whole);
    enter(corner / 3);
    m_from_corner = corner;
    m_entered = none;
    m_point = this->corner(corner);
    const Planar side = vector(corner);
    const double length = norm(side);
    m_direction =
        length > 0. ? turned((1. / length) * side, unit_vector(angle)) : unit_vector(angle);
    m_path.locations.back().triangle = m_triangle;
    m_path.locations.back().barycentric = at_corner(corner);
  }

  // Goes on from a corner of this triangle that the path has hit.
  void pass_corner(Index corner)
  {
    add(m_triangle, at_corner(corner));
    // The way back, counterclockwise from the side that leaves the corner.  It lies in another
    // triangle where the path came into this one so near to the corner that it has hit it since.
    const double whole = interior_angle(t, corner);
    const Planar side = vector(corner), back = -1. * m_direction;
    const double way_back =
        near_middle(std::atan2(internal::cross(side, back), dot(side, back)), whole);

    // Angles on the right of the path (counterclockwise from the way back) and on its left.
    double right = whole - way_back, left = way_back;
    bool is_border = false;
    Index turn = turn_left(t, corner);
    for(; turn != none && turn != corner; turn = turn_left(t, turn))
      right += interior_angle(t, turn);
    if(turn == none)
    {
      is_border = true;
      for(turn = turn_right(t, corner); turn != none; turn = turn_right(t, turn))
        left += interior_angle(t, turn);
    }
    if(!is_border)
      sweep(corner, way_back + (right + left) / 2.);
    else if(right > pi - 1e-9)
      sweep(corner, way_back + std::min(right, pi));
    else if(left > pi - 1e-9)
      sweep(corner, way_back - std::min(left, pi));
    else
      m_path.end = Straightest_end::border;
  }

  // Leaves a corner at an angle that may be far outside of it.
  void sweep(Index corner, double angle)
  {
    std::size_t turns = t.first[t.corner[corner] + 1] - t.first[t.corner[corner]] + 1;
    for(double whole = interior_angle(t, corner); turns-- > 0 && angle > whole;)
    {
      const Index next = turn_left(t, corner);
      if(next == none)
        break;
      angle -= whole;
      corner = next;
      whole = interior_angle(t, corner);
    }
    while(turns-- > 0 && angle < 0.)
    {
      const Index next = turn_right(t, corner);
      if(next == none)
        break;
      corner = next;
      angle += interior_angle(t, corner);
    }
    leave_corner(corner, std::clamp(angle, 0., interior_angle(t, corner)));
  }

  const Glued_triangles& t;
  Straightest_path m_path;
  double m_left;           // of the length
  const double m_rounding; // a path that reaches the border with so little left has its length

  Index m_triangle;
  std::array<Planar, 3> m_corners;
  Planar m_point, m_direction;
  Index m_entered = none;     // the side on which m_point lies, or none
  Index m_from_corner = none; // the corner at which m_point lies, or none
};

} // namespace

Straightest_path straightest(const Glued_triangles& t, const Location& from, double angle,
                             double length)
{
  if(!std::isfinite(angle) || !std::isfinite(length) || length < 0.)
    throw Invalid_argument_error(
        "A straightest path needs a finite direction and a finite length that is not negative.");
  if(t.is_cloud())
    throw Unsupported_surface_error("A cloud has no straightest paths: nothing is glued.");
  const Location start = cleaned(t, from);
  if(start.triangle == none)
  {
    Straightest_path result;
    result.locations.push_back(start);
    result.end = length > 0. ? Straightest_end::border : Straightest_end::length;
    return result;
  }
  return Walk(t, start, angle, length)();
}

namespace {

// A direction in the plane of a triangle, from the side that leaves the corner.
Planar projected(const Glued_triangles& t, Index corner, const Spatial& direction)
{
  const Spatial& origin = t.point[t.corner[corner]];
  const Spatial axis_1 = unit(t.point[t.corner[next_side(corner)]] - origin);
  const Spatial third = t.point[t.corner[previous_side(corner)]] - origin;
  const Spatial axis_2 = unit(third - dot(third, axis_1) * axis_1);
  return {dot(direction, axis_1), dot(direction, axis_2)};
}

} // namespace

Straightest_path straightest_in_space(const Glued_triangles& t, const Location& from,
                                      const std::array<double, 3>& direction, double length)
{
  const double size = norm(direction);
  if(!(size > 0.) || !std::isfinite(size))
    throw Invalid_argument_error("The direction of a straightest geodesic is zero or not finite.");
  const Spatial towards = (1. / size) * direction;
  Location start = cleaned(t, from);
  if(start.triangle == none)
    throw Invalid_argument_error("A straightest geodesic cannot start at an isolated vertex.");
  Planar in_plane = projected(t, 3 * start.triangle, towards);
  if(const Index site = site_of(t, start); site != none)
  {
    // How well a triangle holds the direction: whether it does, then the nearer plane.
    std::pair<bool, double> best = {false, -1.};
    for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
    {
      const Index corner = t.star[i];
      const Planar candidate = projected(t, corner, towards);
      const Planar opening = corner_angle(t, corner);
      const bool is_inside = candidate[1] >= 0. && cross(candidate, opening) >= 0.;
      if(std::make_pair(is_inside, norm(candidate)) > best)
      {
        best = {is_inside, norm(candidate)};
        start = {corner / 3, none, at_corner(corner)};
        in_plane = projected(t, 3 * start.triangle, towards);
      }
    }
  }
  // What a unit vector along the normal leaves in the plane is rounding.
  if(!(norm(in_plane) > 1e-14))
    throw Invalid_argument_error(
        "The direction of a straightest geodesic is normal to the surface.");
  return straightest(t, start, std::atan2(in_plane[1], in_plane[0]), length);
}

} // namespace CGAL::Geodesic_processing::internal
