// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/front.h>

#include <CGAL/Geodesic_processing/internal/locations.h>
#include <CGAL/Geodesic_processing/internal/planar.h>
#include <CGAL/Geodesic_processing/internal/unfold.h>

#include <algorithm>
#include <cmath>
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
constexpr Index one_visit = 32;
constexpr Index most_visits = 64; // label correction settles after two or three; a bound for
                                  //   inputs whose triangles contradict each other

// A site that is final goes back into the queue when its distance falls by more than this: smaller
// gains are below what the circle through two distances can tell from rounding.
constexpr double worth_a_visit = 1e-9;

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
  const double crossing = y[0] - y[1] * b[0] / b[1];
  if(crossing < 0. || crossing > length)
    return false;
  const double size = norm(b);
  // |y - r u| - r with r = 1 / curvature, which stays exact for straight fronts.
  gain = (dot(y, y) * circle.curvature - 2. * dot(y, circle.source)) / (size + 1.);
  back = (1. / size) * b;
  return true;
}

// The curvature at x of the circle that has the source's direction at x and gains `difference`
// along a side of this length.  With d = difference, l = length, c = cosine of the angle between
// side and source, |l e - r u| = r + d gives 1 / r = 2 (d + l c) / (l^2 - d^2).
double fitted_curvature(double length, double difference, double cosine)
{
  const double denominator = (length - difference) * (length + difference);
  return denominator > 0. ? 2. * (difference + length * cosine) / denominator : 0.;
}

} // namespace

// What comes to a site.
struct Front::Arrival
{
  double distance;
  Planar direction;
  Index corner;
  Index flags;
  double wait = 0.;
};

Front::Front(std::shared_ptr<const Glued_triangles> triangles, Front_kind kind)
    : m_triangles(std::move(triangles)), m_kind(kind), m_sites(m_triangles->number_of_sites()),
      m_sources(m_triangles->number_of_sites(), none), m_queue(m_triangles->number_of_sites())
{
  if(kind == Front_kind::planar && !m_triangles->is_cloud())
    m_splits = std::make_shared<const Obtuse_splits>(obtuse_splits(*m_triangles));
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
  m_slowness = limits.slowness;
  start(sources);

  // A target is final once the front is past it by the longest side around it: no triangle can
  // then give it a smaller distance.
  std::vector<std::pair<Index, double>> targets;
  for(const Location& target : limits.targets)
    for(int k = 0; k < (target.triangle == none ? 1 : 3); ++k)
    {
      const Index site = target.triangle == none ? target.site : t.corner[3 * target.triangle + k];
      double longest = 0.;
      for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
        for(const Index side : {t.star[i], next_side(t.star[i]), previous_side(t.star[i])})
          longest = std::max(longest, t.length[side]);
      targets.emplace_back(site, longest);
    }
  const bool has_targets = !targets.empty();

  bool is_finished = true;
  for(std::size_t visits = 0; !m_queue.empty(); ++visits)
  {
    const Queue::Entry entry = m_queue.front();
    if(entry.key > limits.maximum_distance)
      break;
    if(has_targets)
    {
      while(!targets.empty() &&
            (m_sites[targets.back().first].distance + targets.back().second < entry.key))
        targets.pop_back();
      if(targets.empty())
        break;
    }
    if(limits.callback && visits % 4096 == 0 &&
       !limits.callback(std::min(1., double(visits) / double(m_sites.size()))))
    {
      is_finished = false;
      break;
    }
    m_queue.pop();
    Site& site = m_sites[entry.site];
    site.state = (site.state | final_flag) + one_visit;
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

void Front::start(const std::vector<Source>& sources)
{
  const Glued_triangles& t = *m_triangles;
  m_started_in.clear();
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
      if(const Index site = site_at(t, line[0]); site != none)
        start_at_site(site, sources[i].offset, i);
    }
    for(std::size_t k = 1; k < line.size(); ++k)
      for(const Index triangle : triangles_at(t, line[k - 1]))
        start_in_triangle(triangle, line[k - 1], line[k], sources[i].offset, i);
  }
}

void Front::start_at_site(Index site, double distance, Index source)
{
  offer(site, {distance, {1., 0.}, none, origin_flag}, source);
}

// Gives the corners of a triangle their distances to the part of a source that lies in it.
void Front::start_in_triangle(Index triangle, const Location& begin, const Location& end,
                              double offset, Index source)
{
  const Glued_triangles& t = *m_triangles;
  Location p, q;
  if(!express(t, begin, triangle, p) || !express(t, end, triangle, q))
    return;
  m_started_in.push_back({triangle, {{p, q}, offset, source}});
  const double slowness = m_slowness ? (*m_slowness)[triangle] : 1.;
  const auto corners = layout(t, triangle);
  const Planar at_begin = position(corners, p), at_end = position(corners, q);
  for(Index k = 0; k < 3; ++k)
  {
    const Index corner = 3 * triangle + k, site = t.corner[corner];
    bool inside = false;
    const Planar way = foot(corners[k], at_begin, at_end, inside) - corners[k];
    const double length = norm(way);
    if(length == 0.)
      start_at_site(site, offset, source);
    else if(slowness < infinity)
    {
      offer(site,
            {offset + slowness * length, in_corner((1. / length) * way, corners, corner),
             t.is_cloud() ? none : corner, inside ? flat_flag : 0},
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
  Site& site = m_sites[index];
  const bool is_final = site.state & final_flag;
  if(is_final)
  {
    if(m_kind == Front_kind::planar || site.state >= most_visits * one_visit ||
       arrival.distance >= site.distance - worth_a_visit * (site.distance - m_lowest_offset))
      return false;
  }
  else if(arrival.distance >= site.distance)
  {
    // The same way, but now known to be the front's own.
    const bool is_better = arrival.distance == site.distance && (site.state & blind_flag) &&
                           !(arrival.flags & blind_flag);
    if(!is_better)
      return false;
  }
  if(!(site.state & reached_flag))
    m_reached.push_back(index);
  site.distance = arrival.distance;
  site.direction = arrival.direction;
  site.corner = arrival.corner;
  site.state = (site.state & ~arrival_flags) | arrival.flags | reached_flag;
  m_sources[index] = source;
  // A site that knows no direction yet waits as long as the front may take along the side, so that
  // what comes through a triangle, as it should, comes first.
  m_queue.push(index, arrival.distance + arrival.wait);
  return true;
}

// Offers the far end of a side what the site at its near end can give along it: of the side that
// leaves a corner, or of the one that arrives there.
void Front::offer_along_side(Index corner, bool arriving, Index flags)
{
  const Glued_triangles& t = *m_triangles;
  const Site& from = m_sites[t.corner[corner]];
  const Index side = arriving ? previous_side(corner) : corner;
  const Index far = arriving ? side : next_side(corner);
  const double slowness = m_slowness ? (*m_slowness)[corner / 3] : 1.;
  if(!(slowness < infinity))
    return;
  const double gain = slowness * t.length[side], distance = from.distance + gain;
  if(distance <= m_sites[t.corner[far]].distance)
    offer(t.corner[far],
          {distance, arriving ? Planar{1., 0.} : corner_angle(t, far), far, flags,
           flags & blind_flag ? gain : 0.},
          m_sources[t.corner[corner]]);
}

void Front::offer_along_sides(Index site, Index flags)
{
  const Glued_triangles& t = *m_triangles;
  for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
  {
    offer_along_side(t.star[i], false, flags);
    offer_along_side(t.star[i], true, flags);
  }
}

// On a cloud a site's corner field holds its predecessor.
void Front::offer_along_arcs(Index site)
{
  const Glued_triangles& t = *m_triangles;
  const Site& from = m_sites[site];
  for(Index i = t.graph.first[site]; i < t.graph.first[site + 1]; ++i)
  {
    const Index target = t.graph.target[i];
    const double distance = from.distance + t.graph.length[i];
    if(distance < m_sites[target].distance)
      offer(target, {distance, {1., 0.}, site, 0}, m_sources[site]);
  }
}

void Front::spread_along_arcs(Index site)
{
  if(m_triangles->is_cloud() && !m_slowness)
    offer_along_arcs(site);
  else
    offer_along_sides(site, 0);
}

// The two neighbours in the triangle of a corner: along its side, and counterclockwise from there.
std::array<Front::Seen, 2> Front::neighbours(Index corner) const
{
  const Glued_triangles& t = *m_triangles;
  return {Seen{t.corner[next_side(corner)], {t.length[corner], 0.}},
          Seen{t.corner[previous_side(corner)], apex(t, corner)}};
}

Front::Seen Front::seen_behind(Index split) const
{
  return {m_splits->splits[split].site, m_splits->splits[split].position};
}

// Kimmel and Sethian 1998: the front crosses a triangle as a straight line.
void Front::spread_planar(Index site)
{
  const Glued_triangles& t = *m_triangles;
  if(t.is_cloud() && !m_slowness)
    offer_along_arcs(site);
  else
    offer_along_sides(site, 0);
  for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
  {
    const Index corner = t.star[i], left = previous_side(corner), right = next_side(corner);
    // The site is the second neighbour seen from the next corner, the first seen from the one before.
    for(const Index target : {right, left})
    {
      const Index split = m_splits ? m_splits->split_of_corner[target] : none;
      const std::array<Seen, 2> ends = neighbours(target);
      if(split == none)
        cross_planar(target, ends[0], ends[1]);
      else if(target == right)
        cross_planar(target, seen_behind(split), ends[1]);
      else
        cross_planar(target, ends[0], seen_behind(split));
    }
  }
  if(m_splits)
    for(Index i = m_splits->first[site]; i < m_splits->first[site + 1]; ++i)
    {
      const Obtuse_splits::Split& split = m_splits->splits[m_splits->behind[i]];
      const std::array<Seen, 2> ends = neighbours(split.corner);
      cross_planar(split.corner, ends[0], Seen{site, split.position});
      cross_planar(split.corner, Seen{site, split.position}, ends[1]);
    }
}

// In the plane of the corner, at the origin, a straight front that comes from the unit direction s
// has U(p) = U - slowness <p, s>: two known values give s up to U, |s| = 1 gives U.
void Front::cross_planar(Index corner, const Seen& right, const Seen& left)
{
  const Glued_triangles& t = *m_triangles;
  const Site& a = m_sites[right.site];
  const Site& b = m_sites[left.site];
  const Index target = t.corner[corner];
  const Site& to = m_sites[target];
  if(!(a.state & final_flag) || !(b.state & final_flag) || (to.state & final_flag) ||
     m_sources[right.site] != m_sources[left.site])
    return;
  const double slowness = m_slowness ? (*m_slowness)[corner / 3] : 1.;
  const double area = cross(right.position, left.position);
  if(!(slowness < infinity) || area <= 0.)
    return;
  // Solutions of <right, v> = 1, <left, v> = 1 and of the same with the distances.
  const auto solve = [&](double to_right, double to_left)
  {
    return Planar{(to_right * left.position[1] - to_left * right.position[1]) / area,
                  (to_left * right.position[0] - to_right * left.position[0]) / area};
  };
  const double base = a.distance; // distances relative to it keep their digits
  const Planar ones = solve(1., 1.), rest = solve(0., b.distance - base);
  // |x ones - rest| = slowness for x = U - base
  const double square = dot(ones, ones), half = dot(ones, rest);
  const double root = half * half - square * (dot(rest, rest) - slowness * slowness);
  if(!(root >= 0.) || !(square > 0.))
    return;
  const double gain = (half + std::sqrt(root)) / square;
  const Planar source = (1. / slowness) * (gain * ones - rest);
  if(cross(right.position, source) < 0. || cross(source, left.position) < 0.)
    return;
  const double distance = base + gain;
  if(distance < to.distance)
    offer(target, {distance, source, corner, 0}, m_sources[right.site]);
}

// A site hands on its front through the triangles that see it come: from the triangle that it came
// through, both ways around the site, as long as the source lies within a half turn of the side
// that is crossed.  Sides beyond lie in the shadow of a saddle or a border: there the site is a
// source of its own.
void Front::spread_euclidean(Index index)
{
  const Glued_triangles& t = *m_triangles;
  const Site from = m_sites[index];
  if(from.state & origin_flag)
    return offer_along_sides(index, 0);
  if(from.state & blind_flag)
    return spread_blindly(index);

  // A lit side whose end no triangle reaches gets the side's own length, but no direction.
  const Index lit = blind_flag | (from.state & flat_flag);
  const Index corner = from.corner;
  offer_along_side(corner, false, lit);
  offer_along_side(corner, true, lit);
  Index seen = 1;

  // Counterclockwise; `angle` is the one between the source and the side about to be crossed.
  Planar angle = turned_back(corner_angle(t, corner), from.direction);
  angle[1] = std::max(angle[1], 0.);
  Index left = turn_left(t, corner);
  for(; left != none && left != corner; left = turn_left(t, left))
  {
    const Planar opening = corner_angle(t, left);
    cross_circle(left, false, opening, angle);
    ++seen;
    angle = turned(angle, opening);
    if(angle[1] < 0.)
      break;
    offer_along_side(left, true, lit);
  }
  if(left == corner)
    return;

  // Clockwise, until it meets the other way.
  angle = {from.direction[0], std::max(from.direction[1], 0.)};
  Index right = turn_right(t, corner);
  for(; right != none; right = turn_right(t, right))
  {
    const Planar opening = corner_angle(t, right);
    cross_circle(right, true, opening, angle);
    angle = turned(angle, opening);
    if(angle[1] >= 0.)
      offer_along_side(right, false, lit);
    if(right == left)
      return;
    ++seen;
    if(angle[1] < 0.)
      break;
  }

  // The shadow between them, to the border on either hand.
  Index dark = left;
  for(; dark != none && dark != right; dark = turn_left(t, dark), ++seen)
    offer_along_side(dark, true, 0);
  if(dark == none)
    for(dark = right; dark != none; dark = turn_right(t, dark), ++seen)
      offer_along_side(dark, false, 0);
  // Other fans of a pinched site; where a shadow began a triangle was counted twice.
  if(seen < t.first[index + 1] - t.first[index] + 2)
    offer_along_sides(index, 0);
}

// Offers the end of a triangle's far side what a circular front gives it that crosses the side
// nearer to the source: the one that leaves the corner or, mirrored, the one that arrives there.
void Front::cross_circle(Index corner, bool mirrored, const Planar& opening, const Planar& angle)
{
  const Glued_triangles& t = *m_triangles;
  const Index next = next_side(corner), previous = previous_side(corner);
  const Index from = t.corner[corner], along = t.corner[mirrored ? previous : next],
              target = t.corner[mirrored ? next : previous];
  const Site& x = m_sites[from];
  const Site& z = m_sites[along];
  // A distance still waiting along a side, too long, would bend the circle far too much.
  const bool is_guess = (z.state & (blind_flag | final_flag)) == blind_flag;
  if(!(z.distance < infinity) || is_guess)
    return;
  const double base = t.length[mirrored ? previous : corner];
  const Planar y = t.length[mirrored ? corner : previous] * opening;
  // A front on a polyhedron bends at least as much as one that has come straight all the way.
  const Index flags = (x.state | z.state) & flat_flag;
  double curvature = flags ? 0. : 1. / (x.distance - m_lowest_offset);
  // Fronts of two sources are never mixed.
  if(m_sources[from] == m_sources[along])
    curvature = std::max(curvature, fitted_curvature(base, z.distance - x.distance, angle[0]));
  double gain;
  Planar back;
  if(!pass({{angle[0], -angle[1]}, curvature}, base, y, gain, back))
    return;
  const double distance = x.distance + gain;
  if(!(distance < m_sites[target].distance))
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
  offer(target, {distance, direction, mirrored ? next : previous, flags}, m_sources[from]);
}

// Without a direction: the circle, or the straight line, that its distance and that of a neighbour
// determine (Reimers 2004).
void Front::spread_blindly(Index index)
{
  const Glued_triangles& t = *m_triangles;
  const Site from = m_sites[index];
  offer_along_sides(index, blind_flag | (from.state & flat_flag));
  const double radius = from.distance - m_lowest_offset;
  for(Index i = t.first[index]; i < t.first[index + 1]; ++i)
    for(const bool mirrored : {false, true})
    {
      const Index corner = t.star[i];
      const Index side = mirrored ? previous_side(corner) : corner;
      const Index along = t.corner[mirrored ? side : next_side(corner)];
      const double length = t.length[side], gain = m_sites[along].distance - from.distance;
      if(!(std::abs(gain) < length) || m_sources[along] != m_sources[index])
        continue;
      double cosine = -gain / length;
      if(!(from.state & flat_flag))
        cosine += 0.5 * (length - gain) * (length + gain) / (length * radius);
      if(std::abs(cosine) <= 1.)
        cross_circle(corner, mirrored, corner_angle(t, corner),
                     {cosine, std::sqrt((1. - cosine) * (1. + cosine))});
    }
}

// Surfels know their directions in space: a triangle unfolds by a projection to its plane.
void Front::spread_on_cloud(Index index)
{
  const Glued_triangles& t = *m_triangles;
  const Site from = m_sites[index];
  offer_along_arcs(index);
  if(from.state & origin_flag)
    return;
  const auto [axis_1, axis_2] = tangent_frame(t.normal[index]);
  const Spatial source = from.direction[0] * axis_1 + from.direction[1] * axis_2;
  for(Index i = t.first[index]; i < t.first[index + 1]; ++i)
  {
    const Index corner = t.star[i];
    const Index ends[2] = {t.corner[next_side(corner)], t.corner[previous_side(corner)]};
    for(const int k : {0, 1})
      cross_on_cloud(index, source, ends[k], ends[1 - k]);
  }
}

void Front::cross_on_cloud(Index from, const Spatial& source, Index along, Index target)
{
  const Glued_triangles& t = *m_triangles;
  const Site& x = m_sites[from];
  const Site& z = m_sites[along];
  if(!(z.distance < infinity))
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
  const Planar projected = {dot(source, axis_1), dot(source, axis_2)};
  const double size = norm(projected);
  if(size == 0. || projected[1] > 0.)
    return;
  const Planar direction = (1. / size) * projected;
  const Index flags = (x.state | z.state) & flat_flag;
  double curvature = flags ? 0. : 1. / (x.distance - m_lowest_offset);
  if(m_sources[from] == m_sources[along])
    curvature = std::max(curvature, fitted_curvature(base, z.distance - x.distance, direction[0]));
  double gain;
  Planar back;
  if(!pass({direction, curvature}, base, {y_0, y_1}, gain, back))
    return;
  const double distance = x.distance + gain;
  if(distance < m_sites[target].distance)
    offer(target,
          {distance, tangent(target, back[0] * axis_1 + back[1] * axis_2),
           std::abs(y_0) < std::abs(base - y_0) ? from : along, flags},
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
  if(t.is_cloud())
    return site.corner;
  const Index next = t.corner[next_side(site.corner)],
              previous = t.corner[previous_side(site.corner)];
  // The side nearer to the source's direction, if its far end is nearer at all.
  const Planar other = turned_back(corner_angle(t, site.corner), site.direction);
  const bool is_next = site.direction[0] >= other[0];
  for(const Index candidate : {is_next ? next : previous, is_next ? previous : next})
    if(m_sites[candidate].distance < site.distance && m_sources[candidate] == m_sources[index])
      return candidate;
  return none;
}

double Front::distance(const Location& location) const
{
  const Glued_triangles& t = *m_triangles;
  if(const Index site = site_at(t, location); site != none)
    return m_sites[site].distance;
  const Index triangle = location.triangle;
  const double slowness = m_slowness ? (*m_slowness)[triangle] : 1.;
  const auto corners = layout(t, triangle);
  const Planar p = position(corners, location);
  double result = infinity;
  for(const auto& [started, source] : m_started_in)
    if(started == triangle)
    {
      bool inside = false;
      const Planar q = foot(p, position(corners, source.polyline[0]),
                            position(corners, source.polyline[1]), inside);
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
      circle.curvature = is_flat ? 0. : 1. / std::max(x.distance - m_lowest_offset, base * 1e-12);
      if(is_planar || (x.state & (origin_flag | blind_flag)) ||
         !source_at(from, mirrored, circle.source))
      {
        const double cosine = -difference / (slowness * base) + 0.5 * circle.curvature *
                                                                    (base - difference) *
                                                                    (base + difference) / base;
        if(!(std::abs(cosine) <= 1.))
          continue;
        circle.source = {cosine, -std::sqrt((1. - cosine) * (1. + cosine))};
      }
      else
        circle.curvature =
            std::max(circle.curvature, fitted_curvature(base, difference, circle.source[0]));
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
  if(t.is_cloud() || site.corner == none || site.corner == corner)
    return false;
  Planar angle =
      mirrored ? site.direction : turned_back(corner_angle(t, site.corner), site.direction);
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
