// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "paths/straighten.h"
#include <CGAL/Geodesic_processing/internal/paths/straightest.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

// The way back: from any place to where the sources are.

namespace CGAL::Geodesic_processing::internal {

namespace {

// Sums of thousands of lengths differ by less than this part of them.
constexpr double rounding = 1e-12;
// Arrivals at a site from directions that differ by less are one; in radians.
constexpr double same_direction = 1e-6;
// Paths that are nowhere farther from each other than this part of their length are one.
constexpr double same_path = 1e-6;
// A line that is followed back meets its source to this part of a side, and touches sites to this angle.
constexpr double same_place = 1e-6;
// It crosses a side at its end when it is nearer to it than this part of it.
constexpr double at_end = 1e-9;
// Where a whole circle of places is equally far from a source, there is no end of paths.
constexpr std::size_t most_paths = 64;

// The angle of a direction in the frame of a corner, around its site: counterclockwise from the side
// that leaves the first corner of the site's star.
double polar_angle(const Glued_triangles& t, Index corner, const Planar& direction)
{
  double result = std::atan2(std::max(0., direction[1]), direction[0]);
  for(Index i = t.first[t.corner[corner]]; t.star[i] != corner; ++i)
    result += interior_angle(t, t.star[i]);
  return result;
}

// That of a direction in the layout of a triangle, from a clean location in it: Departure's.
double polar_angle_at(const Glued_triangles& t, const Location& from, const Planar& way)
{
  const auto corners = unfolded(t, from.triangle);
  if(const Index corner = corner_of(from); corner != none)
    return polar_angle(t, corner,
                       turned_back(way, corners[next_side(corner) % 3] - corners[corner % 3]));
  const Index side = side_of(from);
  if(side == none)
    return std::atan2(way[1], way[0]);
  const Planar back = turned_back(way, corners[next_side(side) % 3] - corners[side % 3]);
  return std::atan2(std::max(0., back[1]), back[0]) + (t.twin[side] < side ? pi : 0.);
}

// The direction of a side in the layout of its triangle.
Planar direction_of(const std::array<Planar, 3>& corners, Index side)
{
  const Planar way = corners[next_side(side) % 3] - corners[side % 3];
  const double size = norm(way);
  return size > 0. ? (1. / size) * way : Planar{1., 0.};
}

// A line in the layout of a triangle.
struct Line
{
  Index triangle;
  Planar from, goal;
};

// Whether a point lies to the left of a line, seen from its begin, by an angle of more than `touch`.
bool is_left(const Line& line, const Planar& point, double touch)
{
  const Planar way = line.goal - line.from, there = point - line.from;
  return cross(way, there) > touch * norm(way) * norm(there);
}

// The side through which a line leaves the triangle that it begins in.
Index first_side(const std::array<Planar, 3>& corners, const Line& line, double touch)
{
  for(const Index begin : {0, 1, 2})
  {
    const Index end = (begin + 1) % 3;
    if((corners[begin] == line.from || !is_left(line, corners[begin], touch)) &&
       (corners[end] == line.from || is_left(line, corners[end], touch)))
      return 3 * line.triangle + begin;
  }
  return 3 * line.triangle;
}

// Follows a line to the point where it should end: it leaves a triangle to the right of the third corner
// or to the left, by an angle of more than `touch`.  Returns it in the layout of its last triangle, or
// nothing where it misses the point.  Where it crosses sides is appended to `crossings`, unless null.
std::optional<Line> followed(const Glued_triangles& t, Line line, const Location& end, double touch,
                             std::vector<Location>* crossings)
{
  const std::vector<Index> goals = triangles_at(t, end);
  auto corners = unfolded(t, line.triangle);
  Index side = first_side(corners, line, touch);
  // A shortest path crosses no triangle twice.
  for(std::size_t i = 0; i < t.number_of_triangles(); ++i)
  {
    if(std::find(goals.begin(), goals.end(), line.triangle) != goals.end())
    {
      const Planar place = unfolded_point(corners, *seen_from(t, line.triangle, end));
      if(norm(place - line.goal) < same_place * t.length[side])
        return Line{line.triangle, line.from, place};
    }
    const Planar way = line.goal - line.from, begin = corners[side % 3],
                 on = corners[next_side(side) % 3] - begin;
    const bool is_before =
        dot(begin - line.goal, way) < 0. || dot(begin + on - line.goal, way) < 0.;
    if(!is_before || t.twin[side] == none)
      return std::nullopt;
    if(crossings != nullptr)
    {
      const double across = cross(way, on);
      const double share = across > 0. ? cross(way, line.from - begin) / across : 0.;
      crossings->push_back(cleaned(t, {line.triangle, none,
                                       on_side(side, share < at_end        ? 0.
                                                     : share > 1. - at_end ? 1.
                                                                           : share)}));
    }
    // To the layout of the triangle across the side.
    const Planar direction = direction_of(corners, side);
    side = t.twin[side];
    line.triangle = side / 3;
    corners = unfolded(t, line.triangle);
    const Planar turn = turned_back(-1. * direction_of(corners, side), direction);
    line.from = corners[next_side(side) % 3] + turned(line.from - begin, turn);
    line.goal = corners[next_side(side) % 3] + turned(line.goal - begin, turn);
    side = is_left(line, corners[previous_side(side) % 3], touch) ? next_side(side)
                                                                  : previous_side(side);
  }
  return std::nullopt;
}

// A line may touch a saddle site on either side.
std::optional<Line> followed(const Glued_triangles& t, const Line& line, const Location& end,
                             std::vector<Location>* crossings = nullptr)
{
  for(const double touch : {0., same_place, -same_place})
  {
    if(crossings != nullptr)
      crossings->clear();
    if(const auto found = followed(t, line, end, touch, crossings))
      return found;
  }
  return std::nullopt;
}

// Whether rounding has led a path astray.
bool is_broken(const Glued_triangles& t, const std::vector<Location>& path)
{
  return std::adjacent_find(path.begin(), path.end(),
                            [&](const Location& p, const Location& q)
                            { return common_triangle(t, p, q) == none; }) != path.end();
}

// Whether every point of a path lies beside the other path.
bool runs_along(const Glued_triangles& t, const std::vector<Location>& path,
                const std::vector<Location>& other, double width)
{
  const auto is_beside = [&](const Location& location)
  {
    for(const Index triangle : triangles_at(t, location))
    {
      const auto corners = unfolded(t, triangle);
      const Planar p = unfolded_point(corners, *seen_from(t, triangle, location));
      bool has_last = false, inside = false;
      Planar last = {0., 0.};
      for(const Location& on : other)
      {
        const auto seen = seen_from(t, triangle, on);
        if(seen)
        {
          const Planar q = unfolded_point(corners, *seen);
          if(norm(p - foot(p, has_last ? last : q, q, inside)) <= width)
            return true;
          last = q;
        }
        has_last = seen.has_value();
      }
    }
    return false;
  };
  return std::all_of(path.begin(), path.end(), is_beside);
}

} // namespace

double Window_propagation::distance(const Location& location) const
{
  if(const Index site = site_of(*m_triangles, location); site != none)
    return distance(site);
  const std::lock_guard lock(m_search.mutex);
  const double distance = back().search(*this, location).distance;
  return distance <= m_maximum ? distance + m_lowest_offset : infinity;
}

Window_propagation& Window_propagation::back() const
{
  if(!m_search.windows)
    m_search.windows.reset(new Window_propagation(m_triangles, m_is_pseudo_source));
  return *m_search.windows;
}

// As a goal's site is not nearer to its sources than the distance there, a window that is too far from
// it is late: only those that may be on a shortest path go on.
const Window_propagation::Meeting& Window_propagation::search(const Window_propagation& goal,
                                                              const Location& from)
{
  m_keeps_all = false;
  m_meeting = Meeting{};
  send_back(goal, from);
  return m_meeting;
}

// Keeps all ways of at most this length by which the goal's sources are reached.
void Window_propagation::search_all(const Window_propagation& goal, const Location& from,
                                    double maximum)
{
  m_keeps_all = true;
  m_meeting = Meeting{};
  m_meeting.distance = maximum;
  m_meetings.clear();
  m_arrivals.clear();
  send_back(goal, from);
}

void Window_propagation::send_back(const Window_propagation& goal, const Location& from)
{
  const Glued_triangles& t = *m_triangles;
  clear();
  m_goal = &goal;
  m_maximum = infinity;
  const Index site = site_of(t, from);
  const Index origin = site != none ? site : Index(m_sites.size()); // or its first piece
  for(const Index triangle : triangles_at(t, from))
    meet_sources(triangle, unfolded_point(unfolded(t, triangle), *seen_from(t, triangle, from)),
                 origin);
  m_lowest_offset = 0.;
  start({{{from}, 0., 0}});
  while(!m_queue.empty())
  {
    m_maximum = m_meeting.distance * (1. + rounding);
    const Index item = m_queue.pop().site, sides = Index(t.corner.size());
    if(item < sides)
      cross(item);
    else
      leave(item - sides);
  }
}

// Arrivals from the same direction are one path.
void Window_propagation::keep(Index site, const Arrival& arrival)
{
  if(!(arrival.distance + m_goal->m_sites[site].distance <= m_meeting.distance))
    return;
  const Glued_triangles& t = *m_triangles;
  std::vector<Arrival>& arrivals = m_arrivals[site];
  if(arrival.corner != none)
  {
    double total = 0.;
    for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
      total += interior_angle(t, t.star[i]);
    const double angle = polar_angle(t, arrival.corner, arrival.direction);
    for(const Arrival& other : arrivals)
    {
      const double apart = other.corner == none
                               ? total / 2.
                               : std::abs(polar_angle(t, other.corner, other.direction) - angle);
      if(std::min(apart, total - apart) < same_direction)
        return;
    }
  }
  arrivals.push_back(arrival);
}

// Looks for sources of the goal next to where windows are sent back from.
void Window_propagation::meet_sources(Index triangle, const Planar& place, Index origin)
{
  const auto& pieces = m_goal->m_pieces_of;
  for(auto i = std::lower_bound(pieces.begin(), pieces.end(), std::pair(triangle, Index(0)));
      i != pieces.end() && i->first == triangle; ++i)
  {
    const Piece& piece = m_goal->m_pieces[i->second];
    const auto corners = unfolded(*m_triangles, triangle);
    bool inside = false;
    meet(piece,
         foot(place, unfolded_point(corners, piece.begin), unfolded_point(corners, piece.end),
              inside),
         place, 0., origin);
  }
}

// Looks for sources of the goal in a triangle that windows cross.
void Window_propagation::meet_sources_behind(Index side)
{
  const Glued_triangles& t = *m_triangles;
  const auto& pieces = m_goal->m_pieces_of;
  const Index triangle = side / 3;
  auto i = std::lower_bound(pieces.begin(), pieces.end(), std::pair(triangle, Index(0)));
  if(i == pieces.end() || i->first != triangle)
    return;
  const auto corners = unfolded(t, triangle);
  const Planar begin = corners[side % 3];
  const Planar axis = (1. / t.length[side]) * (corners[next_side(side) % 3] - begin);
  bool inside = false;
  for(; i != pieces.end() && i->first == triangle; ++i)
  {
    const Piece& piece = m_goal->m_pieces[i->second];
    const Planar p = unfolded_point(corners, piece.begin), q = unfolded_point(corners, piece.end);
    for(std::size_t k = 1; k < m_windows.size(); ++k)
    {
      const Window& w = m_windows[k];
      const Planar source = begin + turned(w.source, axis), nearest = foot(source, p, q, inside);
      const Planar seen = turned_back(nearest - begin, axis);
      const auto is_right = [&](double place) {
        return internal::cross(Planar{place, 0.} - w.source, seen - w.source) >= 0.;
      };
      if(!is_right(w.begin) && is_right(w.end))
      {
        meet(piece, nearest, source, w.offset, w.origin);
        continue;
      }
      for(const double place : {w.begin, w.end})
      {
        const Planar end = begin + place * axis;
        const Index origin = place <= 0.               ? t.corner[side]
                             : place >= t.length[side] ? t.corner[next_side(side)]
                                                       : w.origin;
        meet(piece, foot(end, p, q, inside), end, w.distance(place), origin);
      }
    }
  }
}

void Window_propagation::meet(const Piece& piece, const Planar& place, const Planar& from,
                              double distance, Index origin)
{
  const double total = piece.offset + norm(from - place) + distance;
  if(m_keeps_all ? !(total <= m_meeting.distance) : !(total < m_meeting.distance))
    return;
  const auto corners = unfolded(*m_triangles, piece.triangle);
  const Planar begin = unfolded_point(corners, piece.begin);
  const double size = norm(unfolded_point(corners, piece.end) - begin);
  const double share = size > 0. ? norm(place - begin) / size : 0.;
  Meeting meeting = {total, none, {piece.triangle, none, {}}, from - place, norm(from - place),
                     origin};
  for(int k = 0; k < 3; ++k)
    meeting.place.barycentric[k] = (1. - share) * piece.begin[k] + share * piece.end[k];
  if(m_keeps_all)
    m_meetings.push_back(meeting);
  else
    m_meeting = meeting;
}

std::vector<Location> Window_propagation::path(const Location& from) const
{
  const Glued_triangles& t = *m_triangles;
  std::vector<Location> path;
  double length = 0.;
  Index site = site_of(t, from);
  if(site == none)
  {
    const std::lock_guard lock(m_search.mutex);
    Window_propagation& windows = back();
    const Meeting& meeting = windows.search(*this, from);
    if(meeting.distance == infinity || meeting.distance > m_maximum)
      return {};
    site = meeting.site;
    if(site == none)
    {
      path.push_back(cleaned(t, meeting.place));
      length +=
          windows.append_line(meeting.place, meeting.way, meeting.length, meeting.origin, path);
    }
    else
      path.push_back(at_site(t, site));
    if(const Index origin = site == none ? meeting.origin : site; origin < m_sites.size())
      length += windows.append_chain(origin, path);
    std::reverse(path.begin(), path.end());
  }
  else if(m_sites[site].distance < infinity)
    path.push_back(at_site(t, site));
  else
    return {};
  if(site != none)
    length += append_chain(site, path);
  if(is_broken(t, path))
    return {};
  const Straight_path result = straighten(t, path);
  return result.length <= length + 1e-9 * (length + m_longest * rounding) ? result.locations
                                                                          : std::vector<Location>();
}

std::vector<std::vector<Location>> Window_propagation::paths(const Location& from,
                                                             double tolerance) const
{
  const Glued_triangles& t = *m_triangles;
  const std::lock_guard lock(m_search.mutex);
  Window_propagation& windows = back();
  const Index here = site_of(t, from);
  const double shortest =
      here == none ? windows.search(*this, from).distance : m_sites[here].distance;
  if(shortest == infinity || shortest > m_maximum)
    return {};
  const double longest = shortest * (1. + std::max(tolerance, rounding));
  windows.search_all(*this, from, longest);

  std::vector<std::vector<Location>> found;
  for(const Index site : windows.m_reached)
    if(m_sites[site].distance < infinity && m_sites[site].corner == none &&
       windows.m_sites[site].distance + m_sites[site].distance <= longest)
      windows.branch(site, {at_site(t, site)}, found);
  for(const Meeting& meeting : windows.m_meetings)
  {
    std::vector<Location> path = {cleaned(t, meeting.place)};
    windows.append_line(meeting.place, meeting.way, meeting.length, meeting.origin, path);
    windows.branch(meeting.origin, path, found);
  }

  std::vector<std::vector<Location>> result;
  for(std::vector<Location>& path : found)
  {
    std::reverse(path.begin(), path.end());
    if(is_broken(t, path))
      continue;
    path = straighten(t, path).locations;
    const double width = same_path * path_length(t, path);
    if(std::none_of(result.begin(), result.end(),
                    [&](const std::vector<Location>& other) {
                      return runs_along(t, path, other, width) && runs_along(t, other, path, width);
                    }))
      result.push_back(std::move(path));
  }
  return result;
}

Departure Window_propagation::departure(const Location& to) const
{
  const Glued_triangles& t = *m_triangles;
  const std::vector<Location> path = this->path(to);
  Departure result;
  if(path.empty())
    return result;
  result.from = result.next = path.back();
  result.length = path_length(t, path);
  if(path.size() == 1)
    return result;
  result.next = path[path.size() - 2];
  const Index triangle = common_triangle(t, path.back(), result.next);
  const auto corners = unfolded(t, triangle);
  const auto here = *seen_from(t, triangle, path.back());
  const Planar way =
      unfolded_point(corners, *seen_from(t, triangle, result.next)) - unfolded_point(corners, here);
  result.from = {triangle, none, here};
  result.angle = std::atan2(way[1], way[0]);
  result.polar_angle = polar_angle_at(t, result.from, way);
  return result;
}

double Window_propagation::polar_angle_of_departure(Index site) const
{
  const auto comes_from_site = [&]
  { return m_sites[site].origin < m_sites.size() && m_sites[site].corner != none; };
  while(comes_from_site() && m_sites[m_sites[site].origin].corner != none)
    site = m_sites[site].origin;
  if(m_sites[site].corner == none)
    return 0.;
  const Arrival& arrival = m_sites[site];
  const auto corners = unfolded(*m_triangles, arrival.corner / 3);
  const Planar from = corners[arrival.corner % 3];
  const Line line = {arrival.corner / 3, from,
                     from + gain(arrival) *
                                turned(arrival.direction, direction_of(corners, arrival.corner))};
  if(const auto end = point_of(arrival.origin))
    if(const auto found = followed(*m_triangles, line, *end))
      return polar_angle_at(
          *m_triangles, {found->triangle, none, *seen_from(*m_triangles, found->triangle, *end)},
          found->from - found->goal);
  return departure(at_site(*m_triangles, site)).polar_angle;
}

// The point that windows come from, if it is one.
std::optional<Location> Window_propagation::point_of(Index origin) const
{
  if(origin < m_sites.size())
    return at_site(*m_triangles, origin);
  const Piece& piece = m_pieces[origin - m_sites.size()];
  if(piece.begin != piece.end)
    return std::nullopt;
  return cleaned(*m_triangles, {piece.triangle, none, piece.begin});
}

// How long the line is by which windows came.
double Window_propagation::gain(const Arrival& arrival) const
{
  return arrival.distance - (arrival.origin < m_sites.size()
                                 ? m_sites[arrival.origin].distance
                                 : m_pieces[arrival.origin - m_sites.size()].offset);
}

// Appends the way from a site to the source that its windows came from, without the site itself, and
// returns its length.
double Window_propagation::append_chain(Index site, std::vector<Location>& path) const
{
  double length = 0.;
  for(; site < m_sites.size() && m_sites[site].corner != none; site = m_sites[site].origin)
    length += append_arrival(m_sites[site], path);
  return length;
}

// Goes on from a site by every way that was kept, and adds the paths to their beginning.
void Window_propagation::branch(Index site, const std::vector<Location>& path,
                                std::vector<std::vector<Location>>& paths) const
{
  if(paths.size() == most_paths)
    return;
  if(site >= m_sites.size() || m_sites[site].corner == none)
    return paths.push_back(path);
  const auto arrivals = m_arrivals.find(site);
  if(arrivals == m_arrivals.end())
    return;
  for(const Arrival& arrival : arrivals->second)
  {
    std::vector<Location> longer = path;
    append_arrival(arrival, longer);
    branch(arrival.origin, longer, paths);
  }
}

// Appends the straight line from a site to where an arrival there came from.
double Window_propagation::append_arrival(const Arrival& arrival, std::vector<Location>& path) const
{
  const Glued_triangles& t = *m_triangles;
  const auto corners = unfolded(t, arrival.corner / 3);
  return append_line({arrival.corner / 3, none, at_corner(arrival.corner)},
                     turned(arrival.direction, direction_of(corners, arrival.corner)),
                     gain(arrival), arrival.origin, path);
}

// Appends the straight line to the site or the piece of a source that is seen in a direction of the
// layout of a triangle.
double Window_propagation::append_line(const Location& from, const Planar& way, double length,
                                       Index origin, std::vector<Location>& path) const
{
  const Glued_triangles& t = *m_triangles;
  const Location first = path.back();
  if(const auto end = point_of(origin))
  {
    const Planar here = unfolded_point(unfolded(t, from.triangle), from.barycentric);
    const double size = norm(way);
    const Planar there = here + (size > 0. ? std::max(length, 0.) / size : 0.) * way;
    std::vector<Location> crossings;
    if(followed(t, {from.triangle, here, there}, *end, &crossings))
    {
      crossings.push_back(*end);
      for(const Location& location : crossings)
        if(!is_same_point(t, path.back(), location))
          path.push_back(location);
      return length;
    }
  }
  const double angle = std::atan2(way[1], way[0]);
  for(const Location& on : straightest(t, from, angle, std::max(length, 0.)).locations)
    if(const Location location = cleaned(t, on); !is_same_point(t, path.back(), location))
      path.push_back(location);
  Location end;
  if(origin < m_sites.size())
    end = at_site(t, origin);
  else
  {
    const Piece& piece = m_pieces[origin - m_sites.size()];
    end = {piece.triangle, none, piece.begin};
    if(const auto last = seen_from(t, piece.triangle, path.back());
       last && piece.begin != piece.end)
    {
      const auto corners = unfolded(t, piece.triangle);
      const Planar p = unfolded_point(corners, piece.begin), q = unfolded_point(corners, piece.end);
      bool inside = false;
      const double share =
          norm(foot(unfolded_point(corners, *last), p, q, inside) - p) / norm(q - p);
      for(int k = 0; k < 3; ++k)
        end.barycentric[k] = (1. - share) * piece.begin[k] + share * piece.end[k];
    }
    end = cleaned(t, end);
  }
  // Rounding may have led it past the end by a triangle or two.
  while(path.size() > 1 && common_triangle(t, path.back(), end) == none &&
        !is_same_point(t, path.back(), first))
    path.pop_back();
  if(!is_same_point(t, path.back(), end))
    path.push_back(end);
  return length;
}

} // namespace CGAL::Geodesic_processing::internal
