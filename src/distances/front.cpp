// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/front.h>

#include "core/arcs.h"
#include <CGAL/Geodesic_processing/internal/mesh/glue.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/planar.h>
#include "core/prefetch.h"
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// State of a site.
constexpr Index reached_flag = 1; // it is among the reached
constexpr Index final_flag = 2;   // it has left the queue
constexpr Index origin_flag = 4;  // it lies on a source: its front leaves in all directions
constexpr Index blind_flag = 8;   // it was reached along a side although the front came otherwise:
                                  //   its direction is not to be trusted
constexpr Index flat_flag = 16;   // its source is a segment: the front may be a straight line
constexpr Index arrival_flags = origin_flag | blind_flag | flat_flag;
constexpr Index one_correction = 32;
constexpr Index most_corrections = 4096; // most sites need none, in webs of needles some need
    //   thousands; a bound for inputs that contradict themselves

// A final site is corrected, and what others took from it is taken back, when its distance falls by
// more than this fraction: a front fitted to a distance too long bends too much, and gives what later
// offers cannot undo, distances too short.  On an irregular square 1e-8 left errors of 2e-4 where
// 1e-12 leaves rounding, at the same cost.
constexpr double worth_a_correction = 1e-12;
// On a curved surface, where a front errs anyway, that is done only when it falls by more than this
// fraction of a side: the same errors, and a quarter faster where half of the triangles are obtuse.
constexpr double worth_a_retraction = 1e-2;
// A neighbour that spread before this site had a distance spreads once more into the triangle between when it
// is nearer, by more than this fraction of the side, than the front of this site makes it.  On the side of a
// cube blown up to a sphere distances were off by up to 2.8 %, 0.04 % in the mean; with this fraction by 0.20 and
// 0.007 %, with 1e-2 by 0.44 and 0.013 %, with none by 0.20 and 0.0066 %.
constexpr double worth_a_return = 1e-3;
// A spoke that leaves the source's line by more than this sine, beyond a half turn, lies in the shadow
// of its site: the front gets there another way.
constexpr double in_shadow = -1e-12;
// Offers to a site that waits count when they are smaller by more than this fraction: the least of many
// that differ by their roundings is too small, and the more so the farther the front goes.
constexpr double worth_an_offer = 1e-14;
// What is taken back in all, as a multiple of the sites reached: scans need 0.2, webs of needles one,
// and where sheets of needles fold over each other (a lantern of Schwarz) it has no end.  From there
// on a site is corrected a few times only.
constexpr std::size_t most_forgotten = 4;
constexpr std::size_t few_forgotten = 20000; // which every query may, small ones too
constexpr Index few_corrections = 8;

// The circular front that passes a site x at the origin and is seen at y, behind the side that runs
// from x along the first axis for `length`.
struct Circle
{
  Planar source;    // unit vector from x to where the front comes from; second coordinate <= 0
  double curvature; // of the front at x
};

// The distance gained from x to y, and the unit vector at y back to the source.  False when the
// straight line from the source does not cross the side.
bool pass(const Circle& circle, double length, const Planar& y, double& gain, Planar& back)
{
  const Planar b = circle.source - circle.curvature * y;
  if(b[1] >= 0.)
    return false;
  const double crossing = y[0] * b[1] - y[1] * b[0]; // along the side, times b[1] < 0
  if(crossing > 0. || crossing < length * b[1])
    return false;
  const double size = norm(b);
  // |y - r u| - r with r = 1 / curvature, which stays exact for straight fronts.
  gain = (dot(y, y) * circle.curvature - 2. * dot(y, circle.source)) / (size + 1.);
  back = (1. / size) * b;
  return true;
}

// Sets the source's direction of a circle of known curvature that gains `difference` along a side of
// this length; false when there is none.
bool source_by_distances(double length, double difference, Circle& circle)
{
  const double cosine = -difference / length + 0.5 * circle.curvature * (length - difference) *
                                                   (length + difference) / length;
  if(!(std::abs(cosine) <= 1.))
    return false;
  circle.source = {cosine, -std::sqrt((1. - cosine) * (1. + cosine))};
  return true;
}

// By how much more a front gains along a side of this length than a circle of this curvature does, where
// `cosine` is that of the angle between side and source.
double excess(double curvature, double length, double difference, double cosine)
{
  return difference + length * cosine -
         0.5 * curvature * (length - difference) * (length + difference);
}

// The curvature at x of the circle that has the source's direction at x and gains `difference`
// along a side of this length, or `least` where that is more.  With d = difference, l = length, c =
// cosine of the angle between side and source, |l e - r u| = r + d gives
// 1 / r = 2 (d + l c) / (l^2 - d^2).  What it exceeds `least` by counts only beyond the rounding of
// distances of this size: taken as it is, rounding only ever bends, and grows along the way (1e-10
// after 300 sides of a flat square, instead of 1e-15).
double bent(double least, double length, double difference, double cosine, double distance)
{
  const double denominator = (length - difference) * (length + difference);
  const double bend = difference + length * cosine;
  const bool is_more =
      denominator > 0. && excess(least, length, difference, cosine) > 1e-11 * distance;
  return is_more ? 2. * bend / denominator : least;
}

// A vector perpendicular to the unit vector `from`, turned with it the short way to the line of the
// unit vector `to`: across a sharp edge this unfolds, where a projection would bend it to the edge.
Spatial turned_into(const Spatial& v, const Spatial& from, const Spatial& to)
{
  const double cosine = dot(from, to);
  const Spatial axis = cosine < 0. ? -1. * to : to;
  return v - (dot(v, axis) / (1. + std::abs(cosine))) * (from + axis);
}

// The sites of targets, and how far past each the front must be before it is final: by the longest
// side around it, as no triangle can then give it a smaller distance.
std::vector<std::pair<Index, double>> waits(const Glued_triangles& t,
                                            const std::vector<Location>& targets)
{
  std::vector<std::pair<Index, double>> result;
  for(const Location& target : targets)
    for(int k = 0; k < (target.triangle == none ? 1 : 3); ++k)
    {
      const Index site = target.triangle == none ? target.site : t.corner[3 * target.triangle + k];
      double longest = 0.;
      for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
        for(const Index side : {t.star[i], next_side(t.star[i]), previous_side(t.star[i])})
          longest = std::max(longest, t.length[side]);
      result.emplace_back(site, longest);
    }
  return result;
}

} // namespace

// What comes to a site.
struct Front::Arrival
{
  double distance;
  Planar direction;
  Index corner;
  Index flags;
  double wait; // how much later than its distance it leaves the queue
};

Front::Front(std::shared_ptr<const Glued_triangles> triangles, Front_kind kind)
    : m_triangles(std::move(triangles)), m_kind(kind), m_sites(m_triangles->number_of_sites()),
      m_sources(m_triangles->number_of_sites(), none), m_queue(m_triangles->number_of_sites())
{
  if(kind == Front_kind::planar || (kind == Front_kind::euclidean && !m_triangles->is_cloud()))
    m_spokes = shared_spokes(*m_triangles, kind == Front_kind::planar);
  if(kind == Front_kind::euclidean)
    m_directions.resize(m_sites.size());
  if(kind == Front_kind::euclidean && m_triangles->is_cloud())
    m_islands = std::make_shared<const std::vector<Index>>(islands(*m_triangles).first);
}

bool Front::run(const std::vector<Source>& sources, const Front_limits& limits)
{
  const Glued_triangles& t = *m_triangles;
  for(const Index site : m_reached)
  {
    m_sites[site] = Site{};
    m_sources[site] = none;
  }
  m_reached.clear();
  m_queue.clear();
  m_corrected.clear();
  m_forgotten = 0;
  m_maximum = limits.maximum_distance;
  m_slowness = limits.slowness;
  m_known = limits.known;
  m_improves = true;
  // A Euclidean front with speeds is a planar one.
  if(m_slowness && m_kind == Front_kind::euclidean && !m_has_splits)
  {
    m_spokes = shared_spokes(t, true);
    m_has_splits = true;
  }
  start(sources);

  std::vector<std::pair<Index, double>> targets = waits(t, limits.targets);
  const bool has_targets = !targets.empty();

  bool is_finished = true;
  for(std::size_t visits = 0; !m_queue.empty(); ++visits)
  {
    const Queue::Entry entry = m_queue.front();
    // Sites that wait leave the queue late: those behind may be nearer than this one.
    const double distance = m_sites[entry.site].distance;
    if(distance > limits.maximum_distance || distance == infinity)
    {
      m_queue.pop();
      continue;
    }
    while(!targets.empty() &&
          m_sites[targets.back().first].distance + targets.back().second < entry.key)
      targets.pop_back();
    if(has_targets && targets.empty())
      break;
    if(limits.callback && visits % 4096 == 0 &&
       !limits.callback(std::min(1., double(visits) / double(m_sites.size()))))
    {
      is_finished = false;
      break;
    }
    m_queue.pop();
    // What comes next is mostly known already: what lies around it is on its way while this one spreads.
    if(!m_queue.empty())
    {
      prefetch_around(m_queue.front().site);
      if(m_known)
        prefetch(m_known->data() + m_queue.front().site);
    }
    Site& site = m_sites[entry.site];
    site.state |= final_flag;
    m_improves = !m_known || (m_kind != Front_kind::arcs && site.distance < (*m_known)[entry.site]);
    if(!m_improves && !may_improve_around(entry.site))
      continue;
    switch(m_kind)
    {
    case Front_kind::arcs:
      spread_along_arcs(entry.site);
      break;
    case Front_kind::planar:
      spread_planar(entry.site);
      break;
    case Front_kind::euclidean:
      if(m_slowness)
        spread_planar(entry.site);
      else if(t.is_cloud())
        spread_on_cloud(entry.site);
      else
        spread_euclidean(entry.site);
      break;
    }
    if(!m_corrected.empty())
      retract();
  }

  // Sites that never left the queue were not reached.
  const auto is_open = [&](Index site)
  {
    if(m_sites[site].state & final_flag)
      return false;
    m_sites[site] = Site{};
    m_sources[site] = none;
    return true;
  };
  m_reached.erase(std::remove_if(m_reached.begin(), m_reached.end(), is_open), m_reached.end());
  m_queue.clear();
  return is_finished;
}

void Front::prefetch_around(Index site) const
{
  if(!m_spokes)
    return prefetch(m_triangles->star.data() + m_triangles->first[site]);
  const Spokes::First& first = m_spokes->first[site];
  // Lines of memory: four hold the spokes of a site of six neighbours, two hold three splits.  They may
  // lie behind what there is, where no pointer leads.
  const auto prefetch_lines = [](const void* address, std::uintptr_t number)
  {
    for(std::uintptr_t line = 0; line < number; ++line)
      prefetch(
          reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(address) + 64 * line));
  };
  prefetch_lines(m_spokes->spokes.data() + first.spoke, 4);
  if(m_directions.empty())
    return prefetch_lines(m_spokes->splits.data() + first.split, 2);
  prefetch(m_triangles->star.data() + first.star);
  prefetch(&m_directions[site]);
}

void Front::start(const std::vector<Source>& sources)
{
  const Glued_triangles& t = *m_triangles;
  m_started_in.clear();
  m_is_single = sources.size() == 1;
  m_offsets.clear();
  for(const Source& source : sources)
    m_offsets.push_back(source.offset);
  m_lowest_offset = infinity;
  for(const Source& source : sources)
    m_lowest_offset = std::min(m_lowest_offset, source.offset);
  for(Index i = 0; i < sources.size(); ++i)
  {
    const std::vector<Location>& line = sources[i].polyline;
    if(line.size() == 1)
    {
      for(const Index triangle : triangles_at(t, line[0]))
        start_in_triangle(triangle, line[0], line[0], sources[i].offset, i);
      if(const Index site = site_of(t, line[0]); site != none)
        start_at_site(site, sources[i].offset, 0, i);
    }
    for(std::size_t k = 1; k < line.size(); ++k)
      for(const Index triangle : triangles_at(t, line[k - 1]))
        start_in_triangle(triangle, line[k - 1], line[k], sources[i].offset, i);
  }
  std::sort(m_started_in.begin(), m_started_in.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
}

void Front::start_at_site(Index site, double distance, Index flags, Index source)
{
  offer(site, {distance, {1., 0.}, none, origin_flag | flags, 0.}, source);
}

// Gives the corners of a triangle their distances to the part of a source that lies in it.
void Front::start_in_triangle(Index triangle, const Location& begin, const Location& end,
                              double offset, Index source)
{
  const Glued_triangles& t = *m_triangles;
  const auto p = seen_from(t, triangle, begin), q = seen_from(t, triangle, end);
  if(!p || !q)
    return;
  const Location begin_here = {triangle, none, *p}, end_here = {triangle, none, *q};
  const double slowness = m_slowness ? (*m_slowness)[triangle] : 1.;
  const auto corners = unfolded(t, triangle);
  // A segment sends a straight front out; past its ends the fitted curvature bends it.
  const Planar at_begin = unfolded_point(corners, *p), at_end = unfolded_point(corners, *q);
  const Index flat = norm(at_end - at_begin) > 0. ? flat_flag : 0;
  // What comes from a corner is told by the corner's distance.
  if(flat || corner_of(begin_here) == none)
    m_started_in.push_back({triangle, {{begin_here, end_here}, offset, source}});
  for(Index k = 0; k < 3; ++k)
  {
    const Index corner = 3 * triangle + k, site = t.corner[corner];
    bool inside = false;
    const Planar nearest = foot(corners[k], at_begin, at_end, inside);
    const Planar way = nearest - corners[k];
    const double length = norm(way);
    if(length == 0.)
      start_at_site(site, offset, flat, source);
    else if(slowness < infinity)
    {
      // Without directions, and on a cloud, the predecessor: where the nearest point is a site.
      const bool has_corner = has_directions() && !t.is_cloud();
      const Index site_there =
          inside ? none : site_of(t, nearest == at_begin ? begin_here : end_here);
      offer(site,
            {offset + slowness * length, in_corner((1. / length) * way, corners, corner),
             has_corner ? corner : site_there, flat, 0.},
            source);
    }
  }
}

// A unit vector of a triangle's layout, as the site at one of its corners keeps it.
Planar Front::in_corner(const Planar& vector, const std::array<Planar, 3>& corners,
                        Index corner) const
{
  const Glued_triangles& t = *m_triangles;
  const Planar side = corners[next_side(corner) % 3] - corners[corner % 3];
  const double length = norm(side);
  if(length == 0.)
    return {1., 0.};
  const Planar result = turned_back(vector, (1. / length) * side);
  if(!t.is_cloud())
    return result;
  const Spatial origin = t.point[t.corner[corner]];
  const Spatial axis_1 = unit(t.point[t.corner[next_side(corner)]] - origin);
  const Spatial third = t.point[t.corner[previous_side(corner)]] - origin;
  const Spatial axis_2 = unit(third - dot(third, axis_1) * axis_1);
  return tangent(t.corner[corner], result[0] * axis_1 + result[1] * axis_2);
}

bool Front::offer(Index index, const Arrival& arrival, Index source)
{
  if(!m_improves && !(arrival.distance < (*m_known)[index]))
    return false;
  // Without directions nobody asks for what is not final.
  if(arrival.distance > m_maximum && !has_directions())
    return false;
  Site& site = m_sites[index];
  const bool is_final = site.state & final_flag;
  if(is_final)
  {
    const Index most = can_retract() ? most_corrections : few_corrections;
    if(!has_directions() || site.state >= most * one_correction ||
       arrival.distance >= site.distance - worth_a_correction * (site.distance - m_lowest_offset))
      return false;
    site.state += one_correction;
    if(m_spokes && is_worth_retracting(index, site.distance - arrival.distance))
      m_corrected.push_back(index);
  }
  else if(arrival.distance >= site.distance)
  {
    // The same way, but now known to be the front's own.
    const bool is_better = arrival.distance == site.distance && (site.state & blind_flag) &&
                           !(arrival.flags & blind_flag);
    if(!is_better)
      return false;
  }
  const bool is_reached = site.state & reached_flag;
  site.distance = arrival.distance;
  if(!m_directions.empty())
    m_directions[index] = arrival.direction;
  site.corner = arrival.corner;
  site.state = (site.state & ~arrival_flags) | arrival.flags | reached_flag;
  m_sources[index] = source;
  // A site that knows no direction yet waits as long as the front may take along the side, so that
  // what comes through a triangle, as it should, comes first.
  if(is_reached)
    m_queue.push(index, arrival.distance + arrival.wait);
  else
  {
    m_reached.push_back(index);
    m_queue.insert(index, arrival.distance + arrival.wait);
    if(m_spokes)
      prefetch(&m_spokes->first[index]);
  }
  return true;
}

// Whether a site that does not improve what is known has a neighbour where its front still may.
bool Front::may_improve_around(Index site) const
{
  if(!m_spokes)
    return true;
  const double distance = m_sites[site].distance;
  for(Index i = m_spokes->first[site].spoke; i < m_spokes->first[site + 1].spoke; ++i)
    if(const Index end = m_spokes->spokes[i].end;
       distance < (*m_known)[end] && distance < m_sites[end].distance)
      return true;
  return false;
}

bool Front::can_retract() const
{
  return m_forgotten <= few_forgotten + most_forgotten * m_reached.size();
}

bool Front::is_worth_retracting(Index site, double correction) const
{
  const Spokes::Spoke& spoke = m_spokes->spokes[m_spokes->first[site].spoke];
  return !(spoke.flags & Spokes::Spoke::is_curved) ||
         correction > worth_a_retraction * spoke.length;
}

// Forgets what came through triangles with a corrected corner, and so on, and lets those around
// that are final spread once more.
void Front::retract()
{
  const Glued_triangles& t = *m_triangles;
  const Spokes& s = *m_spokes;
  if(!can_retract())
    return m_corrected.clear();
  std::vector<Index> forgotten;
  const auto forget_around = [&](Index from)
  {
    for(Index i = s.first[from].spoke; i < s.first[from + 1].spoke; ++i)
    {
      const Index index = s.spokes[i].end;
      Site& site = m_sites[index];
      if(site.distance == infinity || (site.state & origin_flag) || site.corner == none ||
         (t.corner[next_side(site.corner)] != from && t.corner[previous_side(site.corner)] != from))
        continue;
      site.distance = infinity;
      site.state &= ~(final_flag | arrival_flags);
      forgotten.push_back(index);
    }
  };
  for(const Index site : m_corrected)
    forget_around(site);
  m_corrected.clear();
  for(std::size_t i = 0; i < forgotten.size(); ++i)
    forget_around(forgotten[i]);
  m_forgotten += forgotten.size();
  for(const Index site : forgotten)
    for(Index i = s.first[site].spoke; i < s.first[site + 1].spoke; ++i)
      if(const Index end = s.spokes[i].end; m_sites[end].state & final_flag)
        m_queue.push(end, m_sites[end].distance);
}

// Offers the far end of a spoke what the site gives along it.
void Front::offer_along(Index site, const Spoke_place& place, Index flags)
{
  const Glued_triangles& t = *m_triangles;
  const Spokes::Spoke& spoke = m_spokes->spokes[place.spoke];
  const double distance = m_sites[site].distance + spoke.length;
  if(!(distance <= m_sites[spoke.end].distance))
    return;
  // At the far end the side leaves its corner in the triangle before the spoke; at a border, it
  // arrives at the corner in the triangle after it.
  Arrival arrival = {distance, {1., 0.}, none, flags, flags & blind_flag ? spoke.length : 0.};
  const bool has_before = place.spoke > m_spokes->first[site].spoke &&
                          ((&spoke)[-1].flags & Spokes::Spoke::has_triangle);
  if(has_before)
    arrival.corner = previous_side(t.star[place.star - 1]);
  else if(const Index corner = t.star[place.star]; t.twin[corner] != none)
    arrival.corner = t.twin[corner];
  else
  {
    arrival.corner = next_side(corner);
    arrival.direction = corner_angle(t, arrival.corner);
  }
  offer(spoke.end, arrival, m_sources[site]);
}

void Front::offer_along_all(Index site, Index flags)
{
  Spoke_place place = {m_spokes->first[site].spoke, m_spokes->first[site].star};
  for(; place.spoke < m_spokes->first[site + 1].spoke; ++place.spoke)
  {
    offer_along(site, place, flags);
    if(m_spokes->spokes[place.spoke].flags & Spokes::Spoke::has_triangle)
      ++place.star;
  }
}

void Front::spread_along_arcs(Index index)
{
  const double distance = m_sites[index].distance;
  const Index source = m_sources[index];
  const auto reach = [&](Index target, double gain)
  {
    if(distance + gain < m_sites[target].distance)
      offer(target, {distance + gain, {1., 0.}, index, 0, 0.}, source);
  };
  if(m_kind == Front_kind::arcs)
    for_each_arc(*m_triangles, m_slowness.get(), index, reach);
  else
    for_each_arc_of_graph(*m_triangles, m_slowness.get(), index, reach);
}

// Kimmel and Sethian 1998: the front crosses a triangle as a straight line, from two sites that are
// final to a third that is not.
void Front::spread_planar(Index index)
{
  const Glued_triangles& t = *m_triangles;
  const Spokes& s = *m_spokes;
  if(t.is_cloud())
    spread_along_arcs(index);
  const Site* const sites = m_sites.data();
  const auto is_final = [sites](Index site) { return (sites[site].state & final_flag) != 0; };
  const double distance = sites[index].distance;
  const Index source = m_sources[index];

  // The star holds the triangles that the spokes have, in the same order.
  const Index* triangle = m_slowness ? t.star.data() + t.first[index] : nullptr;
  double before = infinity; // slowness of the triangle before the spoke
  const Spokes::Spoke* const end = s.spokes.data() + s.first[index + 1].spoke;
  for(const Spokes::Spoke* spoke = s.spokes.data() + s.first[index].spoke; spoke != end; ++spoke)
  {
    double after = infinity;
    if(spoke->flags & Spokes::Spoke::has_triangle)
      after = m_slowness ? (*m_slowness)[*triangle++ / 3] : 1.;
    if(!is_final(spoke->end))
    {
      double best = distance + std::min(before, after) * spoke->length;
      Index predecessor = index;
      const auto cross = [&](const Spokes::Spoke& other, const Planar& opening, double slowness)
      {
        bool is_nearer_to_other;
        const double offered = cross_planar(index, other.end, other.length, spoke->length * opening,
                                            slowness, is_nearer_to_other);
        if(offered < best)
        {
          best = offered;
          predecessor = is_nearer_to_other ? other.end : index;
        }
      };
      if(after < infinity && !(spoke->flags & Spokes::Spoke::is_split) && is_final(spoke[1].end))
        cross(spoke[1], spoke->opening, after);
      if(before < infinity && !(spoke[-1].flags & Spokes::Spoke::next_is_split) &&
         is_final(spoke[-1].end))
        cross(spoke[-1], spoke[-1].opening, before);
      if(best < sites[spoke->end].distance)
        offer(spoke->end, {best, {1., 0.}, predecessor, 0, 0.}, source);
    }
    before = after;
  }

  for(Index i = s.first[index].split; i < s.first[index + 1].split; ++i)
  {
    const Spokes::Split& split = s.splits[i];
    if(is_final(split.target) || !is_final(split.along))
      continue;
    bool is_nearer_to_along;
    const double slowness = m_slowness ? (*m_slowness)[split.corner / 3] : 1.;
    const double offered =
        cross_planar(index, split.along, split.base, split.apex, slowness, is_nearer_to_along);
    if(offered < m_sites[split.target].distance)
      offer(split.target, {offered, {1., 0.}, split.neighbour, 0, 0.}, source);
  }
}

// What a straight front that passes x and z gives a site that lies at `apex` when the base, of this
// length, runs from x along the first axis to z; infinity when it does not come through between them.
double Front::cross_planar(Index x, Index z, double base, const Planar& apex, double slowness,
                           bool& is_nearer_to_z) const
{
  if(!is_same_front(x, z))
    return infinity;
  const double start = m_sites[x].distance, width = slowness * base;
  const double rise = (m_sites[z].distance - start) / width;
  if(!(std::abs(rise) < 1.) || !(width < infinity))
    return infinity;
  const Straight_front front(base, rise, apex);
  is_nearer_to_z = front.is_nearer_to_end;
  return start + slowness * front.gain;
}

void Front::spread_euclidean(Index index)
{
  const Index state = m_sites[index].state;
  if(state & origin_flag)
    return offer_along_all(index, state & flat_flag);
  if(state & blind_flag)
    return spread_blindly(index);
  // In the shadow of a saddle, behind a border, and in the other fans of a pinched site the site is a
  // source of its own.
  if(!spread_all_around(index))
    offer_along_all(index, state & flat_flag);
}

// A site hands on its front through the triangles that see it come: from the triangle that it came
// through, both ways around the site, as long as the source lies within a half turn of the side
// that is crossed.  Whether that is all around it.
bool Front::spread_all_around(Index index)
{
  const Spokes& s = *m_spokes;
  const Site& from = m_sites[index];
  const Index flat = from.state & flat_flag;
  const Planar direction = m_directions[index];
  const double least_curvature = 1. / (from.distance - offset_at(index));
  // Triangles are known by the spokes that they follow; those of the fan are begin .. end - 1.
  const Spoke_place entry = place_of(*m_triangles, s, index, from.corner);
  Index begin = entry.spoke, end = entry.spoke + 1;
  while(begin > s.first[index].spoke && (s.spokes[begin - 1].flags & Spokes::Spoke::has_triangle))
    --begin;
  while(s.spokes[end].flags & Spokes::Spoke::has_triangle)
    ++end;
  const bool is_closed = s.spokes[end].flags & Spokes::Spoke::is_repeated;
  const bool is_only_fan = end - begin == s.first[index + 1].star - s.first[index].star;
  const auto place = [&](Index spoke) {
    return Spoke_place{spoke, entry.star + spoke - entry.spoke};
  };
  const auto opening = [&](Index triangle) -> const Planar& { return s.spokes[triangle].opening; };
  // A lit side whose end no triangle reaches gets the side's own length, but no direction.
  const Index lit = blind_flag | flat;
  offer_along(index, place(entry.spoke), lit);
  offer_along(index, place(entry.spoke + 1), lit);

  // Counterclockwise; `angle` is the one between the source and the side about to be crossed.
  Index seen = 1, left = entry.spoke;
  Planar angle = turned_back(opening(left), direction);
  angle[1] = std::max(angle[1], 0.);
  for(;;)
  {
    if(++left == end)
    {
      if(!is_closed)
        break;
      left = begin;
    }
    if(left == entry.spoke)
      return is_only_fan;
    const Planar& opened = opening(left);
    const Planar next = turned(angle, opened);
    if(next[1] >= in_shadow)
      cross_circle(index, place(left), false, opened, angle, least_curvature);
    ++seen;
    angle = next;
    if(angle[1] < 0.)
      break;
    offer_along(index, place(left + 1), lit);
  }

  // Clockwise, until it meets the other way.
  angle = {direction[0], std::max(direction[1], 0.)};
  for(Index right = entry.spoke;;)
  {
    if(right == begin)
    {
      if(!is_closed)
        break;
      right = end;
    }
    --right;
    const Planar& opened = opening(right);
    const Planar next = turned(angle, opened);
    if(next[1] >= in_shadow)
      cross_circle(index, place(right), true, opened, angle, least_curvature);
    angle = next;
    if(angle[1] >= 0.)
      offer_along(index, place(right), lit);
    if(right == left)
      return is_only_fan && seen == end - begin;
    ++seen;
    if(angle[1] < 0.)
      break;
  }

  return false;
}

// Offers the end of a triangle's far side what a circular front gives it that crosses the side
// nearer to the source: the triangle's right one or, mirrored, its left one, as the site sees them.
void Front::cross_circle(Index index, const Spoke_place& place, bool mirrored,
                         const Planar& opening, const Planar& angle, double least_curvature)
{
  const Spokes::Spoke* const right = &m_spokes->spokes[place.spoke];
  const Spokes::Spoke &near = right[mirrored ? 1 : 0], &far = right[mirrored ? 0 : 1];
  const Site& x = m_sites[index];
  const Site& z = m_sites[near.end];
  // A distance still waiting along a side, too long, would bend the circle far too much.
  const bool is_guess = (z.state & (blind_flag | final_flag)) == blind_flag;
  if(!(z.distance < infinity) || is_guess)
    return;
  const double base = near.length;
  const Planar y = far.length * opening;
  // A front on a polyhedron bends at least as much as one that has come straight all the way, and so
  // gains at least as much: |y - r u| - r with r = 1 / curvature.
  const Index flags = (x.state | z.state) & flat_flag;
  double curvature = flags ? 0. : least_curvature;
  const Planar source = {angle[0], -angle[1]};
  const Site& target = m_sites[far.end];
  double most = target.distance - x.distance; // that is worth it
  if(!(target.state & blind_flag) && target.distance < infinity)
    most -= (target.state & final_flag ? worth_a_correction : worth_an_offer) *
            (target.distance - m_lowest_offset);
  if(curvature * (far.length - most) * (far.length + most) >= 2. * (most + dot(y, source)))
    return;
  // Fronts of two sources are never mixed.
  bool has_nearer_neighbour = false;
  if(is_same_front(index, near.end))
  {
    const double difference = z.distance - x.distance;
    has_nearer_neighbour = excess(curvature, base, difference, angle[0]) < -worth_a_return * base &&
                           (z.state & (final_flag | origin_flag | blind_flag)) == final_flag;
    curvature = bent(curvature, base, difference, angle[0], x.distance - offset_at(index));
  }
  double gain;
  Planar back;
  if(!pass({source, curvature}, base, y, gain, back))
    return;
  const double distance = x.distance + gain;
  if(!(distance < m_sites[far.end].distance))
    return;
  // From the plane in which the crossed side lies on the first axis to the corner of the target.
  Planar direction;
  if(mirrored)
  {
    const Planar side = Planar{base, 0.} - y;
    const double size = norm(side);
    if(size == 0.)
      return;
    direction = turned_back(back, (1. / size) * side);
    direction[1] = -direction[1];
  }
  else
    direction = turned_back(back, {-opening[0], -opening[1]});
  const Index corner = m_triangles->star[place.star];
  const Index arrived = mirrored ? next_side(corner) : previous_side(corner);
  const bool is_taken = offer(far.end, {distance, direction, arrived, flags, 0.}, m_sources[index]);
  // Once more from there: a front came to it past the other side of a vertex where the surface bends like a
  // sphere.  That ends, as nothing is taken twice.
  if(is_taken && has_nearer_neighbour && was_reached_after(index, near.end))
    cross_from(mirrored ? previous_side(corner) : next_side(corner), !mirrored);
}

// Whether a site was reached by one that has spread after this neighbour did.
bool Front::was_reached_after(Index site, Index neighbour) const
{
  const Glued_triangles& t = *m_triangles;
  const Index corner = m_sites[site].corner;
  const auto is_later = [&](Index other)
  { return m_sites[t.corner[other]].distance > m_sites[neighbour].distance; };
  return is_later(next_side(corner)) || is_later(previous_side(corner));
}

// Through the triangle of a corner, from its site.
void Front::cross_from(Index corner, bool mirrored)
{
  const Glued_triangles& t = *m_triangles;
  const Index site = t.corner[corner];
  Planar source;
  if(!source_at(corner, mirrored, source))
    return;
  const Spoke_place place = place_of(t, *m_spokes, site, corner);
  cross_circle(site, place, mirrored, m_spokes->spokes[place.spoke].opening,
               {source[0], -source[1]}, 1. / (m_sites[site].distance - offset_at(site)));
}

// Without a direction: the circle, or the straight line, that its distance and that of a neighbour
// determine (Reimers 2004).
void Front::spread_blindly(Index index)
{
  const Spokes& s = *m_spokes;
  const Site from = m_sites[index];
  offer_along_all(index, blind_flag | (from.state & flat_flag));
  const double curvature = 1. / (from.distance - offset_at(index));
  Spoke_place place = {s.first[index].spoke, s.first[index].star};
  for(; place.spoke < s.first[index + 1].spoke; ++place.spoke)
  {
    const Spokes::Spoke& right = s.spokes[place.spoke];
    if(!(right.flags & Spokes::Spoke::has_triangle))
      continue;
    const Spokes::Spoke& left = (&right)[1];
    for(const bool mirrored : {false, true})
    {
      const Spokes::Spoke& near = mirrored ? left : right;
      Circle circle{{1., 0.}, (from.state | m_sites[near.end].state) & flat_flag ? 0. : curvature};
      if(m_sources[near.end] == m_sources[index] &&
         source_by_distances(near.length, m_sites[near.end].distance - from.distance, circle))
        cross_circle(index, place, mirrored, right.opening, {circle.source[0], -circle.source[1]},
                     curvature);
    }
    ++place.star;
  }
}

// Surfels know their directions in space: a triangle unfolds by a projection to its plane.
void Front::spread_on_cloud(Index index)
{
  const Glued_triangles& t = *m_triangles;
  const Site from = m_sites[index];
  const auto [axis_1, axis_2] = tangent_frame(t.normal[index]);
  const Spatial source = m_directions[index][0] * axis_1 + m_directions[index][1] * axis_2;
  const bool is_origin = from.state & origin_flag, is_blind = from.state & blind_flag;
  const auto reach = [&](Index target, double length)
  {
    const double distance = from.distance + length;
    if(!(distance <= m_sites[target].distance))
      return;
    const Spatial back = t.point[index] - t.point[target];
    // Whoever gets no more than a side's length knows no direction, and waits.
    const Index flat = from.state & flat_flag;
    Index flags = is_origin && !flat ? 0 : blind_flag | flat;
    // A copy is the same place.
    if(length == 0.)
      flags = from.state & arrival_flags;
    offer(target, {distance, tangent(target, back), index, flags, flags & blind_flag ? length : 0.},
          m_sources[index]);
  };
  // Where there are triangles the front passes them and their sides only: longer arcs would cut
  // off what comes through triangles.  Between islands there is nothing else.
  for(Index i = t.graph.first[index]; i < t.graph.first[index + 1]; ++i)
    if((*m_islands)[index] != (*m_islands)[t.graph.target[i]])
      reach(t.graph.target[i], t.graph.length[i]);
  for(Index i = t.first[index]; i < t.first[index + 1]; ++i)
  {
    const Index corner = t.star[i], previous = previous_side(corner);
    reach(t.corner[next_side(corner)], t.length[corner]);
    reach(t.corner[previous], t.length[previous]);
  }
  if(is_origin)
    return;
  for(Index i = t.first[index]; i < t.first[index + 1]; ++i)
  {
    const Index corner = t.star[i];
    const Index ends[2] = {t.corner[next_side(corner)], t.corner[previous_side(corner)]};
    for(const int k : {0, 1})
      cross_on_cloud(index, is_blind ? nullptr : &source, ends[k], ends[1 - k]);
  }
}

// As cross_circle(), with coordinates in the plane of the triangle; without a source's direction as
// spread_blindly().
void Front::cross_on_cloud(Index from, const Spatial* source, Index along, Index target)
{
  const Glued_triangles& t = *m_triangles;
  const Site& x = m_sites[from];
  const Site& z = m_sites[along];
  const bool is_guess = (z.state & (blind_flag | final_flag)) == blind_flag;
  if(!(z.distance < infinity) || is_guess)
    return;
  const Spatial side = t.point[along] - t.point[from], way = t.point[target] - t.point[from];
  const double base = norm(side);
  if(base == 0.)
    return;
  const Spatial axis_1 = (1. / base) * side;
  const double y_0 = dot(way, axis_1);
  const Spatial across = way - y_0 * axis_1;
  const double y_1 = norm(across);
  if(y_1 == 0.)
    return;
  const Spatial axis_2 = (1. / y_1) * across;
  const Spatial plane = cross(axis_1, axis_2);

  const bool is_same = is_same_front(from, along);
  const double difference = z.distance - x.distance;
  const Index flags = (x.state | z.state) & flat_flag;
  Circle circle;
  circle.curvature = flags ? 0. : 1. / (x.distance - offset_at(from));
  if(source)
  {
    const Spatial turned = turned_into(*source, t.normal[from], plane);
    const Planar projected = {dot(turned, axis_1), dot(turned, axis_2)};
    const double size = norm(projected);
    if(size == 0. || projected[1] > 0.)
      return;
    circle.source = (1. / size) * projected;
    if(is_same)
      circle.curvature =
          bent(circle.curvature, base, difference, circle.source[0], x.distance - offset_at(from));
  }
  else if(!is_same || !source_by_distances(base, difference, circle))
    return;
  double gain;
  Planar back;
  if(!pass(circle, base, {y_0, y_1}, gain, back))
    return;
  const double distance = x.distance + gain;
  // A predecessor is nearer to the source than the target: else two sites could be each other's.
  const bool from_is_nearer = x.distance < distance;
  const bool along_is_nearer = is_same && z.distance < distance;
  if(!(distance < m_sites[target].distance) || !(from_is_nearer || along_is_nearer))
    return;
  const bool is_along =
      along_is_nearer && (!from_is_nearer || std::abs(y_0) >= std::abs(base - y_0));
  offer(target,
        {distance,
         tangent(target, turned_into(back[0] * axis_1 + back[1] * axis_2, plane, t.normal[target])),
         is_along ? along : from, flags, 0.},
        m_sources[from]);
}

// A direction in space as coordinates in the tangent plane of a surfel.
Planar Front::tangent(Index site, const Spatial& direction) const
{
  const auto [axis_1, axis_2] = tangent_frame(m_triangles->normal[site]);
  const Planar result = {dot(direction, axis_1), dot(direction, axis_2)};
  const double size = norm(result);
  return size > 0. ? (1. / size) * result : Planar{1., 0.};
}

Index Front::predecessor(Index index) const
{
  const Glued_triangles& t = *m_triangles;
  const Site& site = m_sites[index];
  if(!(site.distance < infinity) || (site.state & origin_flag) || site.corner == none)
    return none;
  if(!has_directions() || t.is_cloud())
    return site.corner;
  const Index next = t.corner[next_side(site.corner)],
              previous = t.corner[previous_side(site.corner)];
  // The side nearer to the source's direction, if its far end is nearer at all.
  const Planar other = turned_back(corner_angle(t, site.corner), m_directions[index]);
  const bool is_next = m_directions[index][0] >= other[0];
  for(const Index candidate : {is_next ? next : previous, is_next ? previous : next})
    if(m_sites[candidate].distance < site.distance && m_sources[candidate] == m_sources[index])
      return candidate;
  return none;
}

double Front::distance(const Location& location) const
{
  if(const Index site = site_of(*m_triangles, location); site != none)
    return m_sites[site].distance;
  // On a side the front comes through either triangle.
  double result = infinity;
  for(const Index triangle : triangles_at(*m_triangles, location))
    result = std::min(result, distance_in(triangle, *seen_from(*m_triangles, triangle, location)));
  return result <= m_maximum ? result : infinity;
}

// The distance of a place in a triangle, as the front comes through it.
double Front::distance_in(Index triangle, const std::array<double, 3>& barycentric) const
{
  const Glued_triangles& t = *m_triangles;
  const double slowness = m_slowness ? (*m_slowness)[triangle] : 1.;
  const auto corners = unfolded(t, triangle);
  const Planar p = unfolded_point(corners, barycentric);
  double result = infinity;
  for(auto it = std::lower_bound(m_started_in.begin(), m_started_in.end(), triangle,
                                 [](const auto&part, Index f) { return part.first < f; });
      it != m_started_in.end() && it->first == triangle; ++it)
  {
    const Source& source = it->second;
    bool inside = false;
    const Planar q = foot(p, unfolded_point(corners, source.polyline[0].barycentric),
                          unfolded_point(corners, source.polyline[1].barycentric), inside);
    result = std::min(result, source.offset + slowness * norm(p - q));
  }
  for(Index k = 0; k < 3; ++k)
    result = std::min(result, m_sites[t.corner[3 * triangle + k]].distance +
                                  slowness * norm(p - corners[k]));
  if(m_kind == Front_kind::arcs)
    return result;
  // The front that enters through each side.
  for(Index k = 0; k < 3; ++k)
    for(const bool mirrored : {false, true})
    {
      const Index side = 3 * triangle + k, from = mirrored ? next_side(side) : side,
                  along = mirrored ? side : next_side(side);
      const Site& x = m_sites[t.corner[from]];
      const Site& z = m_sites[t.corner[along]];
      const double base = t.length[side];
      if(base == 0. || !(x.distance < infinity) || !(z.distance < infinity) ||
         m_sources[t.corner[from]] != m_sources[t.corner[along]])
        continue;
      const Planar axis = (1. / base) * (corners[along % 3] - corners[from % 3]);
      Planar y = turned_back(p - corners[from % 3], axis);
      y[1] = std::abs(y[1]);
      const double difference = z.distance - x.distance;
      Circle circle;
      const bool is_planar = m_slowness || m_kind == Front_kind::planar;
      const bool is_flat = is_planar || ((x.state | z.state) & flat_flag);
      circle.curvature =
          is_flat ? 0. : 1. / std::max(x.distance - offset_at(t.corner[from]), base * 1e-12);
      if(is_planar || (x.state & (origin_flag | blind_flag)) ||
         !source_at(from, mirrored, circle.source))
      {
        if(!source_by_distances(base, difference / slowness, circle))
          continue;
      }
      else
        circle.curvature = bent(circle.curvature, base, difference, circle.source[0],
                                x.distance - offset_at(t.corner[from]));
      double gain;
      Planar back;
      if(pass(circle, base, y, gain, back))
        result = std::min(result, x.distance + slowness * gain);
    }
  return result;
}

// The direction to the source at a site, turned around it into the triangle of a corner and seen
// from the side that leaves the corner or, mirrored, arrives there; false in its shadow.
bool Front::source_at(Index corner, bool mirrored, Planar& source) const
{
  const Glued_triangles& t = *m_triangles;
  const Site& site = m_sites[t.corner[corner]];
  const Planar direction = m_directions[t.corner[corner]];
  if(t.is_cloud() || site.corner == none || site.corner == corner)
    return false;
  Planar angle = mirrored ? direction : turned_back(corner_angle(t, site.corner), direction);
  angle[1] = std::max(angle[1], 0.);
  for(Index c = mirrored ? turn_right(t, site.corner) : turn_left(t, site.corner);
      c != none && c != site.corner; c = mirrored ? turn_right(t, c) : turn_left(t, c))
  {
    if(c == corner)
    {
      source = {angle[0], -angle[1]};
      return true;
    }
    angle = turned(angle, corner_angle(t, c));
    if(angle[1] < 0.)
      break;
  }
  return false;
}

} // namespace CGAL::Geodesic_processing::internal
