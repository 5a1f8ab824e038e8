// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/noncontractible_loop.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include "core/unfold.h"
#include "distances/Cover.h"
#include "paths/Shortest_path_forest.h"
#include "paths/shorten_geodesic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns the edge, one of its halfedges, that closes the shortest noncontractible loop with paths
// of a forest with one root; or none.
//
// Triangles with one edge that is not in the forest are removed, one after the other. Loops that
// their edges close are contractible. The others are not (Erickson and Whittlesey 2005).
Index closing_edge(const Surface_arrays& t, const Shortest_path_forest& forest)
{
  std::vector<bool> is_removed(t.corner.size(), false);
  std::vector<Index> leaves;
  const auto remaining_edge = [&](Index triangle)
  {
    Index result = none;
    for(Index h = 3 * triangle; h < 3 * triangle + 3; ++h)
      if(!is_removed[h])
      {
        if(result != none)
          return none;
        result = h;
      }
    return result;
  };
  for(Index h = 0; h < t.corner.size(); ++h)
    is_removed[h] = forest.contains(h);
  for(Index triangle = 0; triangle < t.number_of_triangles(); ++triangle)
    leaves.push_back(triangle);
  while(!leaves.empty())
  {
    const Index h = remaining_edge(leaves.back());
    leaves.pop_back();
    if(h == none)
      continue;
    is_removed[h] = true;
    if(t.twin[h] == none)
      continue;
    is_removed[t.twin[h]] = true;
    leaves.push_back(t.twin[h] / 3);
  }
  Index result = none;
  for(Index h = 0; h < t.corner.size(); ++h)
    if(!is_removed[h] && forest.loop_length(h) < infinity &&
       (result == none || forest.loop_length(h) < forest.loop_length(result)))
      result = h;
  return result;
}

// Returns a lower bound of the distances on an edge, or in a triangle, from those of the corners.
double lower_bound_on_edge(double begin, double end, double length)
{
  return 0.5 * (begin + end - length);
}
double lower_bound_in_triangle(const std::array<double, 3>& distance, double max_length)
{
  return std::max(0., *std::max_element(distance.begin(), distance.end()) - max_length);
}

class Noncontractible_loop_finder
{
public:
  // through: canonical, in the triangle
  Noncontractible_loop_finder(const Surface_arrays& t, const Homotopy& homotopy,
                              const Surface_location& through)
      : t(t), m_homotopy(homotopy), m_through(through), m_cover(t, homotopy, through.triangle)
  {}

  // Replaces a noncontractible loop by a shortest one if it is longer.
  void operator()(std::vector<Surface_location>& loop, double& length);

private:
  struct Homotopy_class
  {
    double lower; // bound of the length
    Homotopy::Word word;
  };

  double max_length(Index triangle) const
  {
    return *std::max_element(&t.length[3 * triangle], &t.length[3 * triangle] + 3);
  }
  void grow_disk(double radius);
  void compute_distances(double radius);
  std::vector<Homotopy_class> classes(double length) const;
  void improve(const Homotopy_class& homotopy_class, std::vector<Surface_location>& loop,
               double& length) const;

  const Surface_arrays& t;
  const Homotopy& m_homotopy;
  Surface_location m_through;
  Cover m_cover;
  std::vector<std::array<double, 3>> m_distance; // #copies: of the corners, from the location
};

// Computes the exact distances in the cover.
void Noncontractible_loop_finder::compute_distances(double radius)
{
  double factor;
  const auto arrays = m_cover.arrays(factor);
  const double max = *std::max_element(t.length.begin(), t.length.end());
  Window_propagation windows(arrays);
  Surface_location source = m_through;
  source.triangle = 0;
  Front_limits limits;
  limits.maximum_distance = (radius + max) / factor;
  windows.run({{{source}, 0., 0}}, limits);
  m_distance.resize(m_cover.size());
  for(Index corner = 0; corner < arrays->corner.size(); ++corner)
    m_distance[corner / 3][corner % 3] = factor * windows.distance(arrays->corner[corner]);
}

// Grows the cover until it contains all points that are closer than the radius. A path to a point
// outside would leave the cover through an open edge that is closer than the radius.
void Noncontractible_loop_finder::grow_disk(double radius)
{
  using Entry = std::pair<double, Index>; // a lower bound of the distance, and an open halfedge
  for(bool has_grown = true; has_grown;)
  {
    has_grown = false;
    compute_distances(radius);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto push_open_edges = [&](Index copy)
    {
      for(Index h = 3 * copy; h < 3 * copy + 3; ++h)
        if(m_cover.is_open(h))
        {
          const double bound =
              lower_bound_on_edge(m_distance[copy][h % 3], m_distance[copy][next_halfedge(h) % 3],
                                  t.length[m_cover.base(h)]);
          if(bound <= radius)
            queue.push({bound, h});
        }
    };
    for(Index copy = 0; copy < m_cover.size(); ++copy)
      push_open_edges(copy);
    while(!queue.empty())
    {
      const Index h = queue.top().second;
      queue.pop();
      if(!m_cover.is_open(h))
        continue;
      has_grown = true;
      const Index twin = t.twin[m_cover.base(h)], copy = m_cover.add_across(h);
      // The distances of new corners are estimated along edges, until the next exact distances.
      const double begin = m_distance[h / 3][h % 3], end = m_distance[h / 3][next_halfedge(h) % 3];
      std::array<double, 3> distance;
      distance[twin % 3] = end;
      distance[next_halfedge(twin) % 3] = begin;
      distance[previous_halfedge(twin) % 3] =
          std::min(end + t.length[previous_halfedge(twin)], begin + t.length[next_halfedge(twin)]);
      m_distance.push_back(distance);
      push_open_edges(copy);
    }
  }
}

// Returns the classes of all loops through the location that can be shorter than `length`.
std::vector<Noncontractible_loop_finder::Homotopy_class>
Noncontractible_loop_finder::classes(double length) const
{
  std::vector<Homotopy_class> result;
  std::vector<double> lower(m_cover.size());
  for(Index copy = 0; copy < m_cover.size(); ++copy)
    lower[copy] = lower_bound_in_triangle(m_distance[copy], max_length(m_cover.triangle(copy)));
  for(Index copy = 0; copy < m_cover.size(); ++copy)
    for(const Index other : m_cover.copies(m_cover.triangle(copy)))
    {
      const double bound = lower[copy] + lower[other];
      if(other >= copy || !(bound < length))
        continue;
      // The loop leads to the first copy and back from the second one.
      Homotopy::Word word = m_cover.word(copy);
      const Homotopy::Word back = Homotopy::inverse(m_cover.word(other));
      word.insert(word.end(), back.begin(), back.end());
      word = m_homotopy.reduced(word);
      const auto found = std::find_if(result.begin(), result.end(),
                                      [&](const Homotopy_class& c)
                                      {
                                        return m_homotopy.is_equal(c.word, word) ||
                                               m_homotopy.is_equal(c.word, Homotopy::inverse(word));
                                      });
      if(found == result.end())
        result.push_back({bound, word});
      else
        found->lower = std::min(found->lower, bound);
    }
  std::stable_sort(result.begin(), result.end(),
                   [](const Homotopy_class& a, const Homotopy_class& b)
                   { return a.lower < b.lower; });
  return result;
}

// Replaces the loop by the shortest loop of a class if it is longer.
void Noncontractible_loop_finder::improve(const Homotopy_class& homotopy_class,
                                          std::vector<Surface_location>& loop, double& length) const
{
  Cover disks(t, m_homotopy, m_through.triangle);
  const Index end = disks.copy(m_through.triangle, homotopy_class.word);
  for(Index copy = 0; copy < m_cover.size(); ++copy)
  {
    const Index triangle = m_cover.triangle(copy);
    if(lower_bound_in_triangle(m_distance[copy], max_length(triangle)) > 0.5 * length)
      continue;
    disks.copy(triangle, m_cover.word(copy));
    Homotopy::Word word = homotopy_class.word;
    word.insert(word.end(), m_cover.word(copy).begin(), m_cover.word(copy).end());
    disks.copy(triangle, m_homotopy.reduced(word));
  }
  double factor;
  const auto arrays = disks.arrays(factor);
  Surface_location from = m_through, to = m_through;
  from.triangle = 0;
  to.triangle = end;
  Window_propagation windows(arrays);
  const Bounded_path path = windows.path_between(from, to, length / factor);
  if(path.locations.empty())
    return;
  std::vector<Surface_location> new_loop;
  for(const Surface_location& location : path.locations)
  {
    Surface_location in_cover = canonical(*arrays, location);
    in_cover.triangle = disks.triangle(in_cover.triangle);
    new_loop.push_back(canonical(t, in_cover));
  }
  const double new_length = path_length(t, new_loop);
  if(!(new_length < length))
    return;
  loop = std::move(new_loop);
  length = new_length;
}

void Noncontractible_loop_finder::operator()(std::vector<Surface_location>& loop, double& length)
{
  grow_disk(0.5 * length);
  for(const Homotopy_class& homotopy_class : classes(length))
    if(homotopy_class.lower < length)
      improve(homotopy_class, loop, length);
}

} // namespace

std::vector<Surface_location> shortest_noncontractible_loop(const Surface_arrays& t,
                                                            const Surface_location& through)
{
  if(t.is_cloud())
    throw Unsupported_surface_error(
        "A loop requires a mesh, because the triangles of a cloud are not connected.");
  std::vector<Surface_location> result;
  double length = infinity;
  const Surface_location location = canonical(t, through);
  if(location.triangle == none)
    return result;
  const Homotopy homotopy(t);
  if(homotopy.number_of_generators() == 0)
    return result;
  Fans all_fans = fans(t);
  std::vector<Index> searched_fans;
  for(const Index triangle : triangles_at(t, location))
  {
    // A nonmanifold vertex has several fans. Otherwise one triangle is enough.
    const auto barycentric = *barycentric_in(t, triangle, location);
    const Index corner =
        3 * triangle +
        Index(std::max_element(barycentric.begin(), barycentric.end()) - barycentric.begin());
    const Index root = all_fans.fan[corner];
    if(!searched_fans.empty() && (vertex_of(t, location) == none ||
                                  std::count(searched_fans.begin(), searched_fans.end(), root) > 0))
      continue;
    searched_fans.push_back(root);
    const Shortest_path_forest forest(t, all_fans, root);
    const Index h = closing_edge(t, forest);
    if(h == none)
      continue;
    const Surface_location base = {triangle, none, barycentric};
    std::vector<Surface_location> loop = {base};
    for(const Surface_location& l : forest.loop_from_root(h))
      loop.push_back(l);
    loop.push_back({triangle, none, barycentric_at_corner(corner)});
    loop.push_back(base);
    Locally_shortest_path shortened = shorten_geodesic(t, loop);
    Noncontractible_loop_finder(t, homotopy, base)(shortened.locations, shortened.length);
    if(shortened.length < length)
    {
      result = std::move(shortened.locations);
      length = shortened.length;
    }
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
