// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/straighten.h"

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Angles nearer to pi than this count as pi: cutting such a corner, with legs a and b, shortens the
// path by less than 1e-18 (a + b).
constexpr double angle_tolerance = 1e-9;

// Sides that a path crosses one after the other, each given in the triangle that it leaves.
struct Strip
{
  Index triangle = none; // where it begins
  std::vector<Index> sides;

  Index last_triangle(const Glued_triangles& t) const
  {
    return sides.empty() ? triangle : t.twin[sides.back()] / 3;
  }
  // Crosses one more side; going straight back undoes the crossing before.
  void cross(const Glued_triangles& t, Index side)
  {
    if(!sides.empty() && t.twin[sides.back()] == side)
      sides.pop_back();
    else
      sides.push_back(side);
  }
};

// A point where the path may bend, and the straight part that leaves it.
struct Knot
{
  Location location; // an end of the path, or a site
  Index site = none;
  Index previous = none, next = none;

  // To the next knot; no side of it contains either
  Strip strip;
  double length = 0.;

  // At a site: the direction in which the path leaves and the one back to where it came from, each
  // as an angle from the side that leaves a corner.
  Index corner_out = none, corner_in = none;
  double angle_out = 0., angle_in = 0.;

  bool waits = false; // in the list of knots to be looked at
};

// A strip in the plane, its begin at the origin.
struct Unfolded_strip
{
  std::vector<Planar> left, right; // ends of the sides that are crossed
  Planar end;
  Planar first_side, last_side; // at the corners opposite to the first and the last side crossed
};

// Where a funnel bends.
struct Bend
{
  Index side; // place in the strip of the first side that ends there
  bool is_left;
};

class Straightener
{
public:
  explicit Straightener(const Glued_triangles& t) : t(t) {}

  Straight_path operator()(const std::vector<Location>& path);

private:
  void read(const std::vector<Location>& path);
  bool pull_all_taut();
  void pull_locally_taut();
  Straight_path written();

  Index new_knot(const Location& location);
  void drop(Index knot);
  void link(Index a, Index b);
  double put(Strip strip, Index first, Index last);
  void merge_repeated(Index first, Index last);
  bool go_around(Strip& strip, Index first, Index last) const;
  void trim(Strip& strip, const Location& begin, const Location& end) const;
  void unfold(const Strip& strip, const Location& begin, const Location& end);
  void find_bends(const Strip& strip);
  void measure(Index knot);
  Index corner_at(const Location& location, Index triangle) const;
  void angles(Index knot, double& left, double& right) const;

  const Glued_triangles& t;
  std::deque<Knot> m_knots; // linked; front() is the path's begin
  std::vector<Index> m_free;
  Index m_begin = none, m_end = none;
  std::size_t m_work = 0;

  // Of the strip in hand
  Unfolded_strip m_unfolded;
  std::vector<Bend> m_bends;
  struct Funnel_point
  {
    Planar point;
    Bend bend;
  };
  std::vector<Funnel_point> m_left, m_right;
};

// --------------------------------------------------------------------------- strips in the plane

bool contains(const Glued_triangles& t, Index side, Index site, Index location_side)
{
  if(site != none)
    return t.corner[side] == site || t.corner[next_side(side)] == site;
  return location_side != none && (side == location_side || t.twin[side] == location_side);
}

// Drops the sides at both ends of a strip that the path's ends lie on.
void Straightener::trim(Strip& strip, const Location& begin, const Location& end) const
{
  auto& sides = strip.sides;
  {
    const Index site = site_of(t, begin), side = side_of(begin);
    std::size_t count = 0;
    while(count < sides.size() && contains(t, sides[count], site, side))
      ++count;
    if(count > 0)
    {
      strip.triangle = t.twin[sides[count - 1]] / 3;
      sides.erase(sides.begin(), sides.begin() + count);
    }
  }
  const Index site = site_of(t, end), side = side_of(end);
  while(!sides.empty() && contains(t, sides.back(), site, side))
    sides.pop_back();
}

double angle_between(const Planar& p, const Planar& q)
{
  return std::atan2(cross(p, q), dot(p, q));
}

void Straightener::unfold(const Strip& strip, const Location& begin, const Location& end)
{
  Unfolded_strip& u = m_unfolded;
  const std::size_t count = strip.sides.size();
  m_work += count + 1;
  u.left.resize(count);
  u.right.resize(count);

  auto corners = unfolded(t, strip.triangle);
  const Planar origin = unfolded_point(corners, *seen_from(t, strip.triangle, begin));
  for(Planar& corner : corners)
    corner = corner - origin;
  if(count == 0)
  {
    u.end = unfolded_point(corners, *seen_from(t, strip.triangle, end));
    return;
  }

  Index side = strip.sides.front();
  Planar right = corners[side % 3], left = corners[next_side(side) % 3];
  u.first_side = right - corners[previous_side(side) % 3];
  // The vector across, left to right, and its direction are carried along: differences of
  // positions far from the origin would lose the digits of small triangles.
  Planar across = right - left, direction = {1., 0.};
  Planar forward = u.first_side; // from the corner opposite to a side
  for(std::size_t i = 0;; ++i)
  {
    u.left[i] = left;
    u.right[i] = right;
    const Index entered = t.twin[strip.sides[i]];
    const double length = norm(across), ahead = norm(forward);
    if(length > 0.)
      direction = (1. / length) * across;
    else if(ahead > 0.) // a side of length zero is seen as the limit of short ones
      direction = (-1. / ahead) * turned_left(forward);
    const double base = t.length[entered];
    const Planar local =
        third_corner(base, t.length[previous_side(entered)], t.length[next_side(entered)]);
    const Planar height = local[1] * turned_left(direction);
    const Planar from_left = local[0] * direction + height;
    const Planar from_right = (local[0] - base) * direction + height;
    if(i + 1 == count)
    {
      const auto b = *seen_from(t, entered / 3, end);
      u.end = left + b[next_side(entered) % 3] * across + b[previous_side(entered) % 3] * from_left;
      u.last_side = -1. * from_left;
      return;
    }
    if(strip.sides[i + 1] == next_side(entered))
    {
      forward = across;
      left = left + from_left;
      across = -1. * from_right;
    }
    else
    {
      forward = -1. * across;
      right = left + from_left;
      across = from_left;
    }
  }
}

// The bends of the shortest path in the unfolded strip.  Ends of sides that the path passes nearer
// than rounding can tell count as bends: which side of a site is the shorter one is decided by the
// angles there.
void Straightener::find_bends(const Strip& strip)
{
  const Unfolded_strip& u = m_unfolded;
  m_bends.clear();
  // The two chains of the funnel start with its apex.
  m_left.assign(1, {Planar{0., 0.}, {0, true}});
  m_right.assign(1, {Planar{0., 0.}, {0, false}});
  std::size_t left_apex = 0, right_apex = 0;

  // Adds a point to the end of the chain `near`; `sign` is 1 for the right chain.
  const auto add = [&](std::vector<Funnel_point>& near, std::size_t& near_apex,
                       std::vector<Funnel_point>& far, std::size_t& far_apex, double sign,
                       const Planar& point, double width, Bend bend)
  {
    // A hundred roundings of the farthest position.  Points nearer to each other are one.
    const double tolerance = 2e-14 * (norm(point) + width);
    while(near.size() > near_apex + 1)
    {
      const Planar& last = near.back().point;
      std::size_t before = near.size() - 2;
      while(before > near_apex && norm(last - near[before].point) <= tolerance)
        --before;
      const Planar leg = last - near[before].point, step = point - last;
      const double turn = sign * cross(leg, step);
      const bool is_ahead = turn < -tolerance * norm(leg) || dot(leg, step) >= 0.;
      if(norm(leg) > tolerance && turn <= tolerance * norm(leg + step) && is_ahead)
        break;
      near.pop_back();
    }
    if(near.size() == near_apex + 1)
    {
      const std::size_t apex = far_apex;
      while(far_apex + 1 < far.size())
      {
        // A point at the place of the apex is a bend too, so that both are gone around together.
        const Planar leg = far[far_apex + 1].point - far[far_apex].point;
        const Planar chord = point - far[far_apex].point;
        const double turn = sign * cross(leg, chord), slack = tolerance * norm(chord);
        if(turn < -slack || norm(chord) <= tolerance ||
           (turn <= slack && dot(leg, chord - leg) < 0.))
          break;
        ++far_apex;
        m_bends.push_back(far[far_apex].bend);
      }
      if(far_apex != apex)
      {
        near.assign(1, far[far_apex]);
        near_apex = 0;
      }
    }
    near.push_back({point, bend});
  };

  const std::size_t count = strip.sides.size();
  for(std::size_t i = 0; i < count; ++i)
  {
    const Index place = static_cast<Index>(i);
    const bool left_stays = i > 0 && strip.sides[i] == previous_side(t.twin[strip.sides[i - 1]]);
    const bool right_stays = i > 0 && !left_stays;
    const double width = t.length[strip.sides[i]];
    if(!right_stays)
      add(m_right, right_apex, m_left, left_apex, 1., u.right[i], width, {place, false});
    if(!left_stays)
      add(m_left, left_apex, m_right, right_apex, -1., u.left[i], width, {place, true});
  }
  add(m_right, right_apex, m_left, left_apex, 1., u.end, 0., {static_cast<Index>(count), false});
  for(std::size_t i = right_apex + 1; i + 1 < m_right.size(); ++i)
    m_bends.push_back(m_right[i].bend);
}

Index Straightener::corner_at(const Location& location, Index triangle) const
{
  const auto seen = seen_from(t, triangle, location);
  for(Index k = 0; k < 3; ++k)
    if((*seen)[k] == 1.)
      return 3 * triangle + k;
  return none;
}

// The length of the straight part that leaves a knot, and its directions at both ends.
void Straightener::measure(Index index)
{
  Knot& from = m_knots[index];
  Knot& to = m_knots[from.next];
  const Strip& strip = from.strip;
  unfold(strip, from.location, to.location);
  const Unfolded_strip& u = m_unfolded;
  from.length = norm(u.end);
  if(from.site != none)
    from.corner_out = corner_at(from.location, strip.triangle);
  if(to.site != none)
    to.corner_in = corner_at(to.location, strip.last_triangle(t));

  if(!strip.sides.empty())
  {
    if(from.site != none)
      from.angle_out =
          std::clamp(angle_between(u.first_side, u.end), 0., interior_angle(t, from.corner_out));
    if(to.site != none)
      to.angle_in =
          std::clamp(angle_between(u.last_side, -1. * u.end), 0., interior_angle(t, to.corner_in));
    return;
  }
  // In one triangle; along a side the angles are those of the triangle, without rounding.
  const auto corners = unfolded(t, strip.triangle);
  const auto angle_at = [&](Index corner, Index other, const Planar& way)
  {
    if(other == next_side(corner))
      return 0.;
    const double whole = interior_angle(t, corner);
    if(other == previous_side(corner))
      return whole;
    const Planar side = corners[next_side(corner) % 3] - corners[corner % 3];
    return std::clamp(angle_between(side, way), 0., whole);
  };
  const Index other = to.site == none ? none : to.corner_in;
  if(from.site != none)
    from.angle_out = angle_at(from.corner_out, other, u.end);
  if(to.site != none)
    to.angle_in = angle_at(to.corner_in, from.site == none ? none : from.corner_out, -1. * u.end);
}

// ---------------------------------------------------------------------------------------- knots

Index Straightener::new_knot(const Location& location)
{
  Index index;
  if(m_free.empty())
  {
    index = static_cast<Index>(m_knots.size());
    m_knots.emplace_back();
  }
  else
  {
    index = m_free.back();
    m_free.pop_back();
    m_knots[index] = Knot();
  }
  m_knots[index].location = location;
  m_knots[index].site = site_of(t, location);
  return index;
}

void Straightener::drop(Index knot)
{
  m_knots[knot].waits = false;
  m_free.push_back(knot);
}

void Straightener::link(Index a, Index b)
{
  m_knots[a].next = b;
  m_knots[b].previous = a;
}

// The angles on both sides of a path at a site.
void Straightener::angles(Index index, double& left, double& right) const
{
  const Knot& knot = m_knots[index];
  const Index in = knot.corner_in, out = knot.corner_out;
  const double whole_in = interior_angle(t, in);
  // From the way back to the way on, counterclockwise: on the right of the path.
  const auto sweep = [&](bool counterclockwise)
  {
    double sum = counterclockwise ? whole_in - knot.angle_in : knot.angle_in;
    for(Index corner = in;;)
    {
      corner = counterclockwise ? turn_left(t, corner) : turn_right(t, corner);
      if(corner == none)
        return infinity;
      const double whole = interior_angle(t, corner);
      if(corner == out)
        return sum + (counterclockwise ? knot.angle_out : whole - knot.angle_out);
      if(corner == in)
        return infinity; // another fan of a pinched site
      sum += whole;
    }
  };
  const double turn = knot.angle_out - knot.angle_in;
  right = in == out && turn >= 0. ? turn : sweep(true);
  left = in == out && turn <= 0. ? -turn : sweep(false);
}

// Leads a strip that goes from before the first to the last of some knots around their sites, on
// the side where the angle is below pi, and on to where the last knot's part ends.  Knots at one
// point in space are seen as one: the angles between them are those of a straight line. False when
// both angles are large enough.
bool Straightener::go_around(Strip& strip, Index first, Index last) const
{
  double left = 0., right = 0.;
  for(Index index = first;; index = m_knots[index].next)
  {
    double one_left, one_right;
    angles(index, one_left, one_right);
    left += one_left;
    right += one_right;
    if(index == last)
      break;
    left -= pi;
    right -= pi;
  }
  if(!(std::min(left, right) < pi - angle_tolerance))
    return false;
  const bool counterclockwise = right <= left;
  for(Index index = first;; index = m_knots[index].next)
  {
    const Knot& knot = m_knots[index];
    const double turn = knot.angle_out - knot.angle_in;
    Index corner = knot.corner_in;
    if(corner != knot.corner_out || (counterclockwise ? turn < 0. : turn > 0.))
      do
      {
        strip.cross(t, counterclockwise ? previous_side(corner) : corner);
        corner = counterclockwise ? turn_left(t, corner) : turn_right(t, corner);
      } while(corner != knot.corner_out);
    for(const Index side : knot.strip.sides)
      strip.cross(t, side);
    if(index == last)
      return true;
  }
}

// Puts the shortest path in a strip between two knots; returns its length.
double Straightener::put(Strip strip, Index first, Index last)
{
  trim(strip, m_knots[first].location, m_knots[last].location);
  unfold(strip, m_knots[first].location, m_knots[last].location);
  find_bends(strip);

  // Bends touch the sides begin .. end - 1 of the strip; the knots at both ends touch none.
  const auto& sides = strip.sides;
  std::size_t begin = 0, end = 0;
  Index from = first;
  const auto fill_part = [&](std::size_t next_begin)
  {
    Strip& part = m_knots[from].strip;
    part.sides.clear();
    if(end <= next_begin)
    {
      part.triangle = end == 0 ? strip.triangle : t.twin[sides[end - 1]] / 3;
      part.sides.assign(sides.begin() + end, sides.begin() + next_begin);
    }
    else // both are ends of one side
      part.triangle = sides[std::max(begin, next_begin)] / 3;
  };
  for(const Bend& bend : m_bends)
  {
    Location location;
    location.triangle = sides[bend.side] / 3;
    location.barycentric = at_corner(bend.is_left ? next_side(sides[bend.side]) : sides[bend.side]);
    const Index knot = new_knot(location);
    fill_part(bend.side);
    link(from, knot);
    from = knot;
    begin = bend.side;
    end = begin + 1;
    while(end < sides.size() &&
          (sides[end] == previous_side(t.twin[sides[end - 1]])) == bend.is_left)
      ++end;
  }
  fill_part(sides.size());
  link(from, last);

  double length = 0.;
  for(Index knot = first; knot != last; knot = m_knots[knot].next)
  {
    trim(m_knots[knot].strip, m_knots[knot].location, m_knots[m_knots[knot].next].location);
    measure(knot);
    length += m_knots[knot].length;
  }
  return length;
}

// Merges knots at the same site that nothing separates, from `first` up to `last`.
void Straightener::merge_repeated(Index first, Index last)
{
  for(Index index = first; index != last;)
  {
    Knot& knot = m_knots[index];
    const Index next = knot.next;
    Knot& follower = m_knots[next];
    if(knot.site == none || knot.site != follower.site || !knot.strip.sides.empty())
      index = next;
    else if(next != m_end)
    {
      knot.strip = std::move(follower.strip);
      knot.length = follower.length;
      knot.corner_out = follower.corner_out;
      knot.angle_out = follower.angle_out;
      link(index, follower.next);
      drop(next);
      if(next == last)
        return;
    }
    else if(index != m_begin)
    {
      follower.corner_in = knot.corner_in;
      follower.angle_in = knot.angle_in;
      link(knot.previous, next);
      drop(index);
      return;
    }
    else
      return;
  }
}

// ---------------------------------------------------------------------------------------- paths

void Straightener::read(const std::vector<Location>& given)
{
  std::vector<Location> path;
  for(const Location& location : given)
  {
    const Location clean = cleaned(t, location);
    if(path.empty() || !is_same_point(t, path.back(), clean))
      path.push_back(clean);
  }
  m_begin = new_knot(path.front());
  Index knot = m_begin;
  Strip strip;
  Index triangle = none;
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    const Index next_triangle = common_triangle(t, path[i], path[i + 1]);
    if(next_triangle == none)
      throw Invalid_argument_error(
          "Two consecutive locations of a path lie in no common triangle.");
    if(i == 0)
      strip.triangle = next_triangle;
    else if(next_triangle != triangle)
    {
      if(site_of(t, path[i]) != none)
      {
        const Index next = new_knot(path[i]);
        put(std::move(strip), knot, next);
        knot = next;
        strip = Strip();
        strip.triangle = next_triangle;
      }
      else
      {
        const Index side = side_of(path[i]);
        strip.cross(t, side / 3 == triangle ? side : t.twin[side]);
      }
    }
    triangle = next_triangle;
  }
  if(path.size() == 1)
    return;
  m_end = new_knot(path.back());
  put(std::move(strip), knot, m_end);
  merge_repeated(m_begin, m_end);
}

// Leads the path around all sites at once, as long strips; false when there is none to go around.
bool Straightener::pull_all_taut()
{
  bool is_changed = false;
  std::vector<Index> replaced;
  for(Index first = m_begin; first != m_end;)
  {
    Strip strip = m_knots[first].strip;
    replaced.clear();
    Index last = m_knots[first].next;
    while(last != m_end && go_around(strip, last, last))
    {
      replaced.push_back(last);
      last = m_knots[last].next;
    }
    if(!replaced.empty())
    {
      is_changed = true;
      put(std::move(strip), first, last);
      std::for_each(replaced.begin(), replaced.end(), [&](Index knot) { drop(knot); });
    }
    first = last;
  }
  merge_repeated(m_begin, m_end);
  return is_changed;
}

void Straightener::pull_locally_taut()
{
  std::deque<Index> waiting;
  const auto enqueue = [&](Index index)
  {
    if(index != m_begin && index != m_end && !m_knots[index].waits)
    {
      m_knots[index].waits = true;
      waiting.push_back(index);
    }
  };
  std::size_t size = 0;
  for(Index knot = m_begin; knot != m_end; knot = m_knots[knot].next)
  {
    size += m_knots[knot].strip.sides.size() + 1;
    enqueue(knot);
  }
  // Every turn shortens the path, so this ends; the bound is for surfaces on which each does so by
  // next to nothing.
  const std::size_t enough = m_work + 10000000 + 1000 * size;
  while(!waiting.empty() && m_work < enough)
  {
    const Index index = waiting.front();
    waiting.pop_front();
    if(!m_knots[index].waits)
      continue; // merged or replaced meanwhile
    m_knots[index].waits = false;
    Index first = m_knots[index].previous, last = m_knots[index].next;
    while(first != m_begin && m_knots[first].length == 0.)
      first = m_knots[first].previous;
    while(last != m_end && m_knots[m_knots[last].previous].length == 0.)
      last = m_knots[last].next;
    const Index first_around = m_knots[first].next, last_around = m_knots[last].previous;
    Strip strip = m_knots[first].strip;
    if(!go_around(strip, first_around, last_around))
      continue;

    const Knot first_before = m_knots[first], last_before = m_knots[last];
    double length = m_knots[first].length;
    for(Index knot = first_around; knot != last; knot = m_knots[knot].next)
      length += m_knots[knot].length;
    if(put(std::move(strip), first, last) < length)
    {
      for(Index knot = first_around;; knot = m_knots[knot].next)
      {
        drop(knot);
        if(knot == last_around)
          break;
      }
      for(Index knot = first;; knot = m_knots[knot].next)
      {
        enqueue(knot);
        if(knot == last)
          break;
      }
      merge_repeated(first, last);
    }
    else
    {
      // Shorter by less than rounding: leave it.
      for(Index knot = m_knots[first].next; knot != last; knot = m_knots[knot].next)
        drop(knot);
      m_knots[first] = first_before;
      m_knots[last] = last_before;
    }
  }
}

Straight_path Straightener::written()
{
  Straight_path result;
  const auto add = [&](const Location& location)
  {
    if(result.locations.empty() || !is_same_point(t, result.locations.back(), location))
      result.locations.push_back(location);
  };
  if(m_end == none)
    return {{m_knots[m_begin].location}, 0., {}};
  for(Index index = m_begin; index != m_end; index = m_knots[index].next)
  {
    const Knot& knot = m_knots[index];
    add(knot.location);
    if(index != m_begin)
    {
      Touched_site touched{result.locations.size() - 1, 0., 0.};
      angles(index, touched.left, touched.right);
      result.touched.push_back(touched);
    }
    result.length += knot.length;
    unfold(knot.strip, knot.location, m_knots[knot.next].location);
    for(std::size_t i = 0; i < knot.strip.sides.size(); ++i)
    {
      // The share of the side, from its right to its left end.
      const double right = -cross(m_unfolded.end, m_unfolded.right[i]);
      const double left = cross(m_unfolded.end, m_unfolded.left[i]);
      double share = right / (left + right);
      if(!(left + right > 0.)) // along the side, or nowhere
        share = norm(m_unfolded.right[i]) <= norm(m_unfolded.left[i]) ? 0. : 1.;
      share = std::clamp(share, 0., 1.);
      Location location;
      location.triangle = knot.strip.sides[i] / 3;
      location.barycentric = on_side(knot.strip.sides[i], share);
      add(location);
    }
  }
  add(m_knots[m_end].location);
  return result;
}

Straight_path Straightener::operator()(const std::vector<Location>& path)
{
  read(path);
  if(m_end != none)
  {
    // Turns all along the path are cheaper together, the last ones one by one.
    for(int i = 0; i < 8 && pull_all_taut(); ++i)
      ;
    pull_locally_taut();
  }
  return written();
}

} // namespace

Straight_path straighten(const Glued_triangles& t, const std::vector<Location>& path)
{
  if(path.empty())
    throw Invalid_argument_error("A path to be straightened has no location.");
  if(t.is_cloud())
    throw Unsupported_surface_error("Paths on a cloud cannot be straightened: nothing is glued.");
  return Straightener(t)(path);
}

} // namespace CGAL::Geodesic_processing::internal
