// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/paths/path_to_sources.h>
#include "paths/straighten.h"
#include <CGAL/Geodesic_processing/internal/paths/straightest.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// State of a site.
constexpr Index reached_flag = 1; // it is among the reached
constexpr Index left_flag = 2;    // its distance has been handed on

// Sums of thousands of lengths differ by less than this part of them.
constexpr double rounding = 1e-12;
// Gaps and sources that differ by less, in parts of the side or of the distance, are the same.
constexpr double same = 1e-13;
// A path that bends by this angle is longer by a part of 1e-17 only: it counts as straight.
constexpr double straight = 1e-8;
// Windows that overlap less than by this part of the smaller one are not worth to be parted.
constexpr double worth_parting = 0.6;
// Windows cross a side once or twice.  Those that have come more often than this may go in circles,
// around spikes and between faces that lie on each other.
constexpr std::uint8_t many_crossings = 8;
// Where everything lies on one line, all are as near as each other: there is no end of them.
constexpr std::size_t most_known = 1000;

// Whether the place on the base lies right of the window's line to the apex (positive) or left.
template <typename Window>
double side_of(const Window& w, double place, const Planar& top)
{
  return (place * double(w.weight) - w.source[0]) * top[1] + w.source[1] * (top[0] - place);
}

// The window seen in a mirror: its side runs the other way.
template <typename Window>
Window mirrored(Window w, double length)
{
  if(w.weight == 0.f)
    w.offset -= w.source[0] * length;
  w.source[0] = length * double(w.weight) - w.source[0];
  const double begin = w.begin;
  w.begin = length - w.end;
  w.end = length - begin;
  return w;
}

// The part of a window that leaves by the left side, as its twin sees it, which runs from the origin
// along `axis` to the apex.  Its ends are so far left (negative, the first one at least) or right.
template <typename Window>
Window through_left(Window w, double begin, double end, const Planar& axis, double length)
{
  // The line through (b, 0) meets the side at the share b y / (b y + side_of(b)) of its length.
  const double y = w.source[1];
  w.begin = length * (w.begin * y / (w.begin * y + begin));
  w.end = end < 0. ? length * (w.end * y / (w.end * y + end)) : length;
  w.source = {dot(w.source, axis), std::min(0., cross(axis, w.source))};
  return w;
}

// Parts two windows that overlap, the first one before the second, where they are equally far.
// False when the first one is not needed any more.
template <typename Window>
bool part(Window& a, Window& b, double least)
{
  double low = std::max(a.begin, b.begin), high = std::min(a.end, b.end);
  if(high - low < -least)
    return true;
  const auto is_same = [&](double p, double q) { return std::abs(p - q) <= same * std::abs(p); };
  if(std::abs(a.source[0] - b.source[0]) <= same * std::abs(a.source[0]) + least &&
     std::abs(a.source[1] - b.source[1]) <= same * std::abs(a.source[1]) + least &&
     is_same(a.offset, b.offset) && a.weight == b.weight)
  {
    b.begin = std::min(a.begin, b.begin);
    b.end = std::max(a.end, b.end);
    return false;
  }
  if(!(high - low > worth_parting * std::min(a.end - a.begin, b.end - b.begin) + least))
    return true;
  double at_low = a.distance(low) - b.distance(low), at_high = a.distance(high) - b.distance(high);
  if(at_low >= 0. && at_high >= 0.)
  {
    if(a.end <= b.end)
    {
      if(a.begin >= b.begin)
        return false;
      a.end = low;
    }
    return true;
  }
  if(at_low <= 0. && at_high <= 0.)
  {
    if(b.begin >= a.begin)
      b.begin = high;
    return true;
  }
  if(at_low > 0.)
    return true; // they do not come in order: both stay whole
  // What is cut off is surely farther: the two ends close in on the same place.
  const double enough = 1e-14 * (std::abs(a.source[0]) + std::abs(a.source[1]));
  for(int step = 0; step < 4 && low < high; ++step)
  {
    const double middle = low + (high - low) * (at_low / (at_low - at_high));
    if(!(middle > low && middle < high))
      break;
    const double value = a.distance(middle) - b.distance(middle);
    if(value <= enough)
    {
      low = middle;
      at_low = value;
    }
    if(value >= -enough)
    {
      high = middle;
      at_high = value;
    }
  }
  if(a.end <= b.end)
    a.end = high;
  if(b.begin >= a.begin)
    b.begin = low;
  return true;
}

// Sites where a shortest path may bend: those with more than 2 pi around them, or a border, or a
// second fan.
std::shared_ptr<const std::vector<bool>> pseudo_sources(const Glued_triangles& t)
{
  if(t.is_cloud())
    throw Unsupported_surface_error("Exact distances need a mesh, not a cloud.");
  auto result = std::make_shared<std::vector<bool>>(t.number_of_sites());
  for(Index site = 0; site < t.number_of_sites(); ++site)
  {
    double angle = 0.;
    bool is_border = false;
    for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
    {
      angle += interior_angle(t, t.star[i]);
      is_border = is_border || t.twin[t.star[i]] == none;
    }
    Index fan = 0, corner = t.first[site] < t.first[site + 1] ? t.star[t.first[site]] : none;
    if(!is_border && corner != none)
      do
      {
        ++fan;
        corner = turn_left(t, corner);
      } while(corner != t.star[t.first[site]]);
    (*result)[site] =
        is_border || angle > 2. * pi + straight || fan < t.first[site + 1] - t.first[site];
  }
  return result;
}

// Takes from a window the parts at its ends where another one is not farther.
template <typename Window>
void trim(Window& w, const Window& other)
{
  const double low = std::max(w.begin, other.begin), high = std::min(w.end, other.end);
  const auto is_nearer = [&](double place)
  { return other.distance(place) <= w.distance(place) + same * std::abs(w.distance(place)); };
  if(!(low < high) || (low > w.begin && high < w.end) || !is_nearer(low) || !is_nearer(high))
    return;
  // Two hyperbolas meet up to twice: in between, the difference has one extremum.
  const double slope = (w.source[0] - other.source[0]) / (w.offset - other.offset);
  const double between =
      w.source[0] + std::abs(w.source[1]) * slope / std::sqrt(1. - slope * slope);
  if(between > low && between < high && !is_nearer(between))
    return;
  if(low == w.begin)
    w.begin = high;
  else
    w.end = low;
}

} // namespace

Window_propagation::Window_propagation(std::shared_ptr<const Glued_triangles> triangles)
    : Window_propagation(triangles, pseudo_sources(*triangles))
{}

Window_propagation::Window_propagation(std::shared_ptr<const Glued_triangles> triangles,
                                       std::shared_ptr<const std::vector<bool>> is_pseudo_source)
    : m_triangles(std::move(triangles)), m_is_pseudo_source(std::move(is_pseudo_source)),
      m_sites(m_triangles->number_of_sites()),
      m_queue(m_triangles->corner.size() + m_triangles->number_of_sites()),
      m_waiting(2 * m_triangles->corner.size()), m_free(33), m_crossed(m_triangles->corner.size())
{
  for(const double length : m_triangles->length)
    m_longest = std::max(m_longest, length);
}

bool Window_propagation::run(const std::vector<Source>& sources, const Front_limits& limits)
{
  if(limits.slowness)
    throw Unsupported_surface_error("Exact distances know no speeds.");
  clear();
  m_lowest_offset = infinity;
  for(const Source& source : sources)
    m_lowest_offset = std::min(m_lowest_offset, source.offset);
  m_maximum = limits.maximum_distance - m_lowest_offset;
  start(sources);

  const Index sides = Index(m_triangles->corner.size());
  std::size_t next_look = 0; // at the targets, of the visits
  bool is_finished = true;
  for(std::size_t visits = 0; !m_queue.empty(); ++visits)
  {
    if(limits.callback && visits % 4096 == 0 &&
       !limits.callback(std::min(1., double(m_reached.size()) / double(m_sites.size()))))
    {
      // Whatever still waits is not nearer than the queue's first by more than a side.
      m_maximum = std::min(m_maximum, m_queue.front().key - m_longest);
      is_finished = false;
      break;
    }
    const Index item = m_queue.pop().site;
    if(item < sides)
      cross(item);
    else
    {
      leave(item - sides);
      if(!limits.targets.empty() && visits >= next_look)
      {
        keep_targets_only(limits.targets);
        next_look = visits + std::max<std::size_t>(64, limits.targets.size());
      }
    }
  }
  keep_targets_only(limits.targets);
  const auto is_too_far = [&](Index site)
  {
    if(m_sites[site].distance <= m_maximum)
      return false;
    m_sites[site] = Site{};
    return true;
  };
  m_reached.erase(std::remove_if(m_reached.begin(), m_reached.end(), is_too_far), m_reached.end());
  return is_finished;
}

// What the last run has left, also one that was cancelled.
void Window_propagation::clear()
{
  const Index sides = Index(m_triangles->corner.size());
  for(const Index site : m_reached)
    m_sites[site] = Site{};
  m_reached.clear();
  for(const Index side : m_crossed_sides)
    m_crossed[side] = 0;
  m_crossed_sides.clear();
  m_known.clear();
  while(!m_queue.empty())
    if(const std::size_t side = m_queue.pop().site; side < sides)
      for(const int part : {0, 1})
        release(m_waiting[2 * side + part]);
}

// Once all targets have a distance, nothing beyond the farthest one matters.
void Window_propagation::keep_targets_only(const std::vector<Location>& targets)
{
  const Glued_triangles& t = *m_triangles;
  double farthest = targets.empty() ? infinity : -infinity;
  for(const Location& target : targets)
    if(target.triangle == none)
      farthest = std::max(farthest, m_sites[target.site].distance);
    else
      for(Index k = 0; k < 3; ++k)
        farthest = std::max(farthest, m_sites[t.corner[3 * target.triangle + k]].distance +
                                          distance_in_triangle(t, target.triangle, at_corner(k),
                                                               target.barycentric));
  m_maximum = std::min(m_maximum, farthest + rounding * std::abs(farthest));
}

void Window_propagation::start(const std::vector<Source>& sources)
{
  const Glued_triangles& t = *m_triangles;
  m_pieces.clear();
  for(Index i = 0; i < sources.size(); ++i)
  {
    const std::vector<Location>& line = sources[i].polyline;
    const double offset = sources[i].offset - m_lowest_offset;
    for(const Location& location : line)
      start_at_point(location, i, offset);
    for(std::size_t k = 1; k < line.size(); ++k)
      for(const Index triangle : triangles_at(t, line[k - 1]))
        if(const auto p = seen_from(t, triangle, line[k - 1]), q = seen_from(t, triangle, line[k]);
           p && q)
        {
          m_pieces.push_back({triangle, i, *p, *q, offset});
          start_along(m_pieces.back());
        }
  }
  m_pieces_of.clear();
  for(Index i = 0; i < m_pieces.size(); ++i)
    m_pieces_of.emplace_back(m_pieces[i].triangle, i);
  std::sort(m_pieces_of.begin(), m_pieces_of.end());
}

void Window_propagation::start_at_point(const Location& location, Index source, double offset)
{
  const Glued_triangles& t = *m_triangles;
  if(const Index site = site_of(t, location); site != none)
  {
    offer(site, {offset, {1., 0.}, none, site}, source);
    return;
  }
  for(const Index triangle : triangles_at(t, location))
  {
    const auto b = *seen_from(t, triangle, location);
    const Index origin = Index(m_sites.size() + m_pieces.size());
    m_pieces.push_back({triangle, source, b, b, offset});
    const auto corners = unfolded(t, triangle);
    const Planar p = unfolded_point(corners, b);
    for(Index k = 0; k < 3; ++k)
    {
      const Index side = 3 * triangle + k;
      const double length = t.length[side];
      if(!(length > 0.))
        continue;
      const Planar axis = (1. / length) * (corners[(k + 1) % 3] - corners[k]);
      const Planar way = p - corners[k];
      const double gain = norm(way);
      offer(t.corner[side],
            {offset + gain, gain > 0. ? turned_back((1. / gain) * way, axis) : Planar{1., 0.}, side,
             origin},
            source);
      // Seen by the twin, which runs the other way.
      const Planar seen = turned_back(way, axis);
      if(b[(k + 2) % 3] > 0.)
        put(t.twin[side],
            {{length - seen[0], std::min(0., -seen[1])}, offset, 0., length, origin, 1.f});
    }
  }
}

// A segment sends straight fronts to both of its sides.
void Window_propagation::start_along(const Piece& piece)
{
  const Glued_triangles& t = *m_triangles;
  const Index origin = Index(m_sites.size() + m_pieces.size() - 1);
  const auto corners = unfolded(t, piece.triangle);
  const Planar p = unfolded_point(corners, piece.begin), q = unfolded_point(corners, piece.end);
  const double size = norm(q - p);
  if(!(size > 0.))
    return;
  const Planar along = (1. / size) * (q - p);
  for(Index k = 0; k < 3; ++k)
  {
    const Index side = 3 * piece.triangle + k;
    const double length = t.length[side];
    if(!(length > 0.))
      continue;
    const Planar axis = (1. / length) * (corners[(k + 1) % 3] - corners[k]);
    // Coordinates of the corner and of the side's direction, along the segment and across it.
    const Planar corner = turned_back(corners[k] - p, along), slope = turned_back(axis, along);
    if(corner[0] >= 0. && corner[0] <= size)
    {
      const Planar way = {0., corner[1] > 0. ? -1. : 1.};
      offer(
          t.corner[side],
          {piece.offset + std::abs(corner[1]), turned_back(turned(way, along), axis), side, origin},
          piece.source);
    }
    if(t.twin[side] == none || (piece.begin[(k + 2) % 3] == 0. && piece.end[(k + 2) % 3] == 0.))
      continue;
    for(const double up : {1., -1.})
    {
      // The part of the side where 0 <= x <= size and up y >= 0.
      double begin = 0., end = length;
      const auto clip = [&](double value, double rise) // value + rise place >= 0
      {
        if(rise > 0.)
          begin = std::max(begin, -value / rise);
        else if(rise < 0.)
          end = std::min(end, -value / rise);
        else if(value < 0.)
          end = -1.;
      };
      clip(corner[0], slope[0]);
      clip(size - corner[0], -slope[0]);
      clip(up * corner[1], up * slope[1]);
      const Planar back = turned_back(turned({0., -up}, along), axis);
      if(begin < end && back[1] > 0.) // it leaves the triangle
        put(t.twin[side], {{-back[0], -back[1]},
                           piece.offset + up * (corner[1] + length * slope[1]),
                           length - end,
                           length - begin,
                           origin,
                           0.f});
    }
  }
}

bool Window_propagation::offer(Index index, const Arrival& arrival, Index source)
{
  if(m_keeps_all)
    keep(index, arrival);
  Site& site = m_sites[index];
  const double distance = arrival.distance;
  if(!(distance < site.distance) || distance > m_maximum)
    return false;
  if(m_goal)
  {
    const double total = distance + m_goal->m_sites[index].distance;
    if(!(total <= m_meeting.distance * (1. + rounding)))
      return false;
    if(!m_keeps_all && total < m_meeting.distance)
      m_meeting = {total, index, {}, {}, 0., none};
  }
  if(!(site.state & reached_flag))
    m_reached.push_back(index);
  // Who has left does not go back for rounding.
  const bool is_known = (site.state & left_flag) && distance >= site.distance * (1. - same);
  site = {arrival, source, site.state | reached_flag};
  if(!is_known)
    m_queue.push(Index(m_triangles->corner.size() + index), distance);
  return true;
}

// A site tells its neighbours along the sides, and those whom no straight line reaches.
void Window_propagation::leave(Index index)
{
  const Glued_triangles& t = *m_triangles;
  m_sites[index].state |= left_flag;
  for(Index i = t.first[index]; i < t.first[index + 1]; ++i)
  {
    offer_along_side(t.star[i], false);
    offer_along_side(t.star[i], true);
    if(m_sites[index].corner == none)
      emit(t.star[i], 0., pi);
  }
  if(m_sites[index].corner != none && (*m_is_pseudo_source)[index])
    shine(index);
}

void Window_propagation::offer_along_side(Index corner, bool arriving)
{
  const Glued_triangles& t = *m_triangles;
  const Index index = t.corner[corner], side = arriving ? previous_side(corner) : corner;
  const Index far = arriving ? side : next_side(corner);
  const double distance = m_sites[index].distance + t.length[side];
  if(!m_keeps_all && !(distance < m_sites[t.corner[far]].distance))
    return;
  const bool is_on_axis = arriving || t.twin[corner] != none;
  offer(t.corner[far],
        {distance, is_on_axis ? Planar{1., 0.} : corner_angle(t, far),
         arriving || !is_on_axis ? far : t.twin[corner], index},
        m_sites[index].source);
}

// Sends windows to where the shortest path bends at a site: more than pi from the way back, both
// ways round.
void Window_propagation::shine(Index index)
{
  const Glued_triangles& t = *m_triangles;
  const Index home = m_sites[index].corner;
  const Planar direction = m_sites[index].direction;
  const double right = std::atan2(std::max(direction[1], 0.), direction[0]);
  const double left = interior_angle(t, home) - right;
  double total = right + left;
  Index fan = 1, corner = turn_left(t, home);
  for(; corner != none && corner != home; corner = turn_left(t, corner), ++fan)
    total += interior_angle(t, corner);
  const bool is_closed = corner == home;
  if(!is_closed)
    total = infinity;
  double angle = left; // from the way back to the corner, counterclockwise
  for(corner = turn_left(t, home); corner != none && corner != home && angle < total - pi;
      corner = turn_left(t, corner))
  {
    emit(corner, pi - angle, total - pi - angle);
    angle += interior_angle(t, corner);
  }
  if(!is_closed)
  {
    angle = right;
    for(corner = turn_right(t, home); corner != none; corner = turn_right(t, corner), ++fan)
    {
      angle += interior_angle(t, corner);
      emit(corner, 0., angle - pi);
    }
  }
  if(fan == t.first[index + 1] - t.first[index])
    return;
  const auto is_in_fan = [&](Index other)
  {
    Index c = home;
    do
    {
      if(c == other)
        return true;
      c = turn_left(t, c);
    } while(c != none && c != home);
    for(c = turn_right(t, home); c != none && c != home; c = turn_right(t, c))
      if(c == other)
        return true;
    return false;
  };
  for(Index i = t.first[index]; i < t.first[index + 1]; ++i)
    if(!is_in_fan(t.star[i]))
      emit(t.star[i], 0., pi);
}

// Sends a window through the side opposite a corner, between two angles from the corner's side.
void Window_propagation::emit(Index corner, double from, double to)
{
  const Glued_triangles& t = *m_triangles;
  const Index side = next_side(corner);
  const double length = t.length[side], right = t.length[corner],
               left = t.length[previous_side(corner)], opening = interior_angle(t, corner);
  from = std::max(from, 0.);
  if(t.twin[side] == none || !(length > 0.) || !(std::min(to, opening) - from > straight))
    return;
  const auto place = [&](double angle) // from the left end
  {
    const double r = right * std::sin(angle), l = left * std::sin(opening - angle);
    return r + l > 0. ? length * (l / (r + l)) : 0.5 * length;
  };
  const Planar third = third_corner(length, left, right);
  put(t.twin[side], {{third[0], -third[1]},
                     m_sites[t.corner[corner]].distance,
                     to < opening ? place(to) : 0.,
                     from > 0. ? place(from) : length,
                     t.corner[corner],
                     1.f});
}

// Takes the windows that wait at a side and may be on a shortest path, in order along it.
void Window_propagation::gather(Index side)
{
  const Glued_triangles& t = *m_triangles;
  const double length = t.length[side], least = same * length;
  const double by_begin = most(t.corner[side]), by_end = most(t.corner[next_side(side)]) + length;
  List* const lists = &m_waiting[2 * std::size_t(side)];
  m_windows.resize(lists[0].size + lists[1].size + 1);
  Window* top = m_windows.data(); // the first one is none
  for(const int k : {0, 1})
  {
    const Window* const begin = m_pool.data() + lists[k].place;
    for(const Window* w = begin; w != begin + lists[k].size; ++w)
    {
      if(!(w->end - w->begin > least) ||
         is_late(*w, by_begin + w->end - w->offset, by_end - w->begin - w->offset))
        continue;
      top[1] = *w;
      for(; top != m_windows.data() && !part(top[0], top[1], least); --top)
        top[0] = top[1];
      if(top[1].end - top[1].begin > least)
        ++top;
    }
    release(lists[k]);
  }
  m_windows.resize(std::size_t(top - m_windows.data()) + 1);
  if(m_crossed[side] == 0)
    m_crossed_sides.push_back(side);
  if(m_crossed[side] < many_crossings)
    ++m_crossed[side];
  else
    drop_repeated(side);
}

// A side that is crossed often remembers by what: windows that are nowhere nearer end here.
void Window_propagation::drop_repeated(Index side)
{
  std::vector<Window>& known = m_known[side];
  if(known.size() > most_known)
    return m_windows.resize(1);
  const double least = same * m_triangles->length[side];
  std::size_t kept = 1;
  for(std::size_t i = 1; i < m_windows.size(); ++i)
  {
    Window w = m_windows[i];
    for(double width = infinity; w.end - w.begin > least && w.end - w.begin < width;)
    {
      width = w.end - w.begin;
      for(const Window& other : known)
        trim(w, other);
    }
    if(w.end - w.begin > least)
      m_windows[kept++] = w;
  }
  m_windows.resize(kept);
  known.insert(known.end(), m_windows.begin() + 1, m_windows.end());
}

// The distance at a site beyond which no window counts.
double Window_propagation::most(Index site) const
{
  const double here = m_sites[site].distance * (1. + rounding);
  if(!m_goal)
    return here;
  return std::min(here, m_meeting.distance * (1. + rounding) - m_goal->m_sites[site].distance);
}

// Whether the far end of a window is farther from its source than by the near end of the side, for
// both ends, or all of it is beyond the maximum.
bool Window_propagation::is_late(const Window& w, double most_by_begin, double most_by_end) const
{
  const double most = m_maximum - w.offset;
  if(w.weight == 0.f)
    return -w.end * w.source[0] > most_by_begin || -w.begin * w.source[0] > most_by_end ||
           std::min(-w.begin * w.source[0], -w.end * w.source[0]) > most;
  const double to_begin = w.begin - w.source[0], to_end = w.end - w.source[0],
               square = w.source[1] * w.source[1];
  if(std::min({most_by_begin, most_by_end, most}) < 0. ||
     to_end * to_end + square > most_by_begin * most_by_begin ||
     to_begin * to_begin + square > most_by_end * most_by_end)
    return true;
  const double aside = std::max({to_begin, -to_end, 0.});
  return aside * aside + square > most * most;
}

void Window_propagation::cross(Index side)
{
  const Glued_triangles& t = *m_triangles;
  gather(side);
  const Window* const windows = m_windows.data() + 1;
  const std::size_t n = m_windows.size() - 1;
  if(n == 0)
    return;
  const Index next = next_side(side), previous = previous_side(side);
  const double base = t.length[side], left_length = t.length[previous],
               right_length = t.length[next];
  const Planar top = apex(t, side);

  // Those that may reach the apex, and the one beside them on either side.
  std::size_t first = 0, last = n;
  while(first < n && side_of(windows[first], windows[first].end, top) < 0.)
    ++first;
  while(last > first && side_of(windows[last - 1], windows[last - 1].begin, top) > 0.)
    --last;
  // The one that is nearest to the apex, also by a bend at one of its ends.
  double best = infinity, crossing = 0.;
  std::size_t nearest = n;
  Planar back = {1., 0.};
  const auto offer_to_apex = [&](const Window& w, double distance, double place, const Planar& way)
  {
    const double size = norm(way);
    const Planar direction =
        size > 0. ? turned_back((1. / size) * way, (-1. / left_length) * top) : Planar{1., 0.};
    // A bend at an end of the side is one at the site there.
    Index origin = w.origin;
    if(way[1] == -top[1] && place <= same * base)
      origin = t.corner[side];
    else if(way[1] == -top[1] && place >= base * (1. - same))
      origin = t.corner[next];
    offer(t.corner[previous], {distance, direction, previous, origin},
          origin < m_sites.size() ? m_sites[origin].source
                                  : m_pieces[origin - m_sites.size()].source);
  };
  for(std::size_t i = first - (first > 0); i < last + (last < n); ++i)
  {
    const Window& w = windows[i];
    const double at_begin = side_of(w, w.begin, top), at_end = side_of(w, w.end, top);
    double distance, place;
    Planar way;
    if(at_begin <= 0. && at_end >= 0.)
    {
      way = w.weight == 0.f ? w.source : w.source - top;
      distance = w.offset + (w.weight == 0.f ? -dot(way, top) : norm(way));
      place = at_end > at_begin ? w.begin + (w.end - w.begin) * (-at_begin / (at_end - at_begin))
                                : w.begin;
    }
    else
    {
      place = at_begin > 0. ? w.begin : w.end;
      way = Planar{place, 0.} - top;
      distance = w.distance(place) + norm(way);
    }
    if(m_keeps_all && left_length > 0.)
      offer_to_apex(w, distance, place, way);
    if(distance < best)
    {
      best = distance;
      nearest = i;
      crossing = place;
      back = way;
    }
  }
  if(nearest == n)
    return;
  if(best < m_sites[t.corner[previous]].distance && left_length > 0.)
    offer_to_apex(windows[nearest], best, crossing, back);

  if(m_goal)
    meet_sources_behind(side);

  // Lines that cross the nearest one's to the apex are not shortest behind it.
  if(t.twin[previous] != none && left_length > 0. && last > 0)
  {
    List list = allocate(last);
    Window* out = m_pool.data() + list.place;
    const Planar axis = (1. / left_length) * top;
    for(std::size_t i = 0; i < last; ++i)
    {
      const Window& w = windows[i];
      const double at_begin = side_of(w, w.begin, top), at_end = side_of(w, w.end, top);
      if(at_begin < 0. && !(i > nearest && w.begin >= crossing))
        *out++ = through_left(w, at_begin, at_end, axis, left_length);
    }
    list.size = Index(out - (m_pool.data() + list.place));
    put(t.twin[previous], 0, list);
  }
  if(t.twin[next] != none && right_length > 0. && first < n)
  {
    List list = allocate(n - first);
    Window* out = m_pool.data() + list.place;
    const Planar axis = (1. / right_length) * Planar{base - top[0], top[1]};
    for(std::size_t i = first; i < n; ++i)
    {
      const Window& w = windows[i];
      const double at_begin = side_of(w, w.begin, top), at_end = side_of(w, w.end, top);
      if(at_end > 0. && !(i < nearest && w.end <= crossing))
        *out++ = mirrored(through_left(mirrored(w, base), -at_end, -at_begin, axis, right_length),
                          right_length);
    }
    list.size = Index(out - (m_pool.data() + list.place));
    put(t.twin[next], 1, list);
  }
}

Window_propagation::List Window_propagation::allocate(std::size_t size)
{
  List result;
  while((std::size_t(1) << result.room) < size)
    ++result.room;
  std::vector<Index>& places = m_free[result.room];
  if(places.empty())
  {
    result.place = Index(m_pool.size());
    m_pool.resize(m_pool.size() + (std::size_t(1) << result.room));
  }
  else
  {
    result.place = places.back();
    places.pop_back();
  }
  // Whether it is in use is seen from its size.
  result.size = 1;
  return result;
}

void Window_propagation::release(List& list)
{
  if(list.size > 0)
    m_free[list.room].push_back(list.place);
  list = List{};
}

// Lets windows wait at a side.
void Window_propagation::put(Index side, int part, List list)
{
  const Glued_triangles& t = *m_triangles;
  if(list.size == 0)
  {
    list.size = 1;
    return release(list);
  }
  List& waiting = m_waiting[2 * std::size_t(side) + part];
  if(waiting.size > 0)
  {
    List both = allocate(waiting.size + list.size);
    const auto begin = m_pool.begin();
    std::merge(begin + waiting.place, begin + waiting.place + waiting.size, begin + list.place,
               begin + list.place + list.size, begin + both.place,
               [](const Window& a, const Window& b) { return a.begin + a.end < b.begin + b.end; });
    both.size = waiting.size + list.size;
    release(waiting);
    release(list);
    list = both;
  }
  waiting = list;
  m_queue.push(side, std::min(m_sites[t.corner[side]].distance,
                              m_sites[t.corner[next_side(side)]].distance));
}

void Window_propagation::put(Index side, const Window& window)
{
  if(side == none)
    return;
  const List list = allocate(1);
  m_pool[list.place] = window;
  put(side, 0, list);
}

Index Window_propagation::predecessor(Index index) const
{
  const Glued_triangles& t = *m_triangles;
  const Site& site = m_sites[index];
  if(site.corner == none)
    return none;
  const Index next = t.corner[next_side(site.corner)],
              previous = t.corner[previous_side(site.corner)];
  // The side nearer to the source's direction, if its far end is nearer at all.
  const Planar other = turned_back(corner_angle(t, site.corner), site.direction);
  const bool is_next = site.direction[0] >= other[0];
  for(const Index candidate : {is_next ? next : previous, is_next ? previous : next})
    if(m_sites[candidate].distance < site.distance && m_sites[candidate].source == site.source)
      return candidate;
  return none;
}

} // namespace CGAL::Geodesic_processing::internal
