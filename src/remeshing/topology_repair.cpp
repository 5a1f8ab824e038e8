// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/topology_repair.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Labels the vertices that are connected to the closest vertex of each sample within its cell.
Cells flood_cells(const Surface_arrays& t, const Sampling& sampling)
{
  const std::vector<double>& distances = sampling.distances();
  std::vector<Index> nearest(sampling.samples().size(), none); // #samples: the closest vertex
  for(const Index vertex : sampling.sampled_vertices())
    if(Index& known = nearest[sampling.labels()[vertex]];
       known == none || distances[vertex] < distances[known])
      known = vertex;

  Cells result;
  result.labels.assign(t.number_of_vertices(), none);
  std::vector<Index> reached;
  for(Index sample = 0; sample < nearest.size(); ++sample)
  {
    if(nearest[sample] == none)
      continue;
    const Index cell = Index(result.samples.size());
    result.samples.push_back(sample);
    reached = {nearest[sample]};
    result.labels[nearest[sample]] = cell;
    while(!reached.empty())
    {
      const Index vertex = reached.back();
      reached.pop_back();
      for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
        for(const Index corner : {next_halfedge(t.ring[i]), previous_halfedge(t.ring[i])})
          if(const Index next = t.corner[corner];
             result.labels[next] == none && sampling.labels()[next] == sample)
          {
            result.labels[next] = cell;
            reached.push_back(next);
          }
    }
  }
  return result;
}

// Returns the cell of the labeled neighbor that minimizes its distance plus the edge length.
Index closest_adjacent_cell(const Surface_arrays& t, const std::vector<double>& distances,
                            const std::vector<Index>& labels, Index vertex)
{
  Index best = none;
  double min_distance = infinity;
  const auto visit = [&](Index next, double length)
  {
    if(labels[next] != none && distances[next] + length < min_distance)
    {
      best = labels[next];
      min_distance = distances[next] + length;
    }
  };
  for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
  {
    const Index corner = t.ring[i], previous = previous_halfedge(corner);
    visit(t.corner[next_halfedge(corner)], t.length[corner]);
    visit(t.corner[previous], t.length[previous]);
  }
  return best;
}

std::vector<Index> find_off_feature_cells(const Refined_surface& surface, const Sampling& sampling,
                                          const Cells& cells)
{
  std::vector<bool> touches_feature(cells.samples.size(), false);
  for(Index vertex = 0; vertex < cells.labels.size(); ++vertex)
    if(surface.is_feature_vertex()[vertex] && cells.labels[vertex] != none)
      touches_feature[cells.labels[vertex]] = true;
  std::vector<Index> result;
  for(Index cell = 0; cell < cells.samples.size(); ++cell)
    if(touches_feature[cell] && !surface.is_on_feature(sampling.samples()[cells.samples[cell]]))
      result.push_back(cell);
  return result;
}

std::vector<Index> find_cells_without_own_sample(const Refined_surface& surface,
                                                 const Sampling& sampling, const Cells& cells)
{
  const Surface_arrays& t = surface.triangles();
  std::vector<Index> result;
  for(Index cell = 0; cell < cells.samples.size(); ++cell)
  {
    const Surface_location& sample = sampling.samples()[cells.samples[cell]];
    if(!surface.is_on_feature(sample))
      continue;
    const Surface_location clean = canonical(t, sample);
    const Index vertex = vertex_of(t, clean), h = halfedge_of(clean);
    const std::array<Index, 2> ends = {vertex != none ? vertex : t.corner[h],
                                       vertex != none ? vertex : t.corner[next_halfedge(h)]};
    const Index a = cells.labels[ends[0]], b = cells.labels[ends[1]];
    if(a != cell && b != cell)
      for(const Index c : {cell, a, b})
        result.push_back(c);
  }
  return result;
}

// Keeps the vertex with the larger distance; the earlier one of equal distances.
void keep_farthest(const std::vector<double>& distances, Index vertex, Index& best)
{
  if(best == none || distances[vertex] > distances[best])
    best = vertex;
}

// Candidates for new samples in each cell (#cells), or none.
struct Extreme_vertices
{
  std::vector<Index> farthest, farthest_on_feature, nearest_on_feature;
};

Extreme_vertices extreme_vertices(const Refined_surface& surface, const Cells& cells,
                                  const std::vector<double>& distances)
{
  const std::vector<Index> no_vertices(cells.samples.size(), none);
  Extreme_vertices result = {no_vertices, no_vertices, no_vertices};
  for(Index vertex = 0; vertex < cells.labels.size(); ++vertex)
    if(const Index cell = cells.labels[vertex]; cell != none)
    {
      keep_farthest(distances, vertex, result.farthest[cell]);
      if(!surface.is_feature_vertex()[vertex])
        continue;
      keep_farthest(distances, vertex, result.farthest_on_feature[cell]);
      Index& nearest = result.nearest_on_feature[cell];
      if(nearest == none || distances[vertex] < distances[nearest])
        nearest = vertex;
    }
  return result;
}

// Returns the index of an element in a sorted list, or the size of the list.
template <typename Tuple>
std::size_t find_index(const std::vector<Tuple>& list, const Tuple& element)
{
  const auto position = std::lower_bound(list.begin(), list.end(), element);
  return position != list.end() && *position == element ? std::size_t(position - list.begin())
                                                        : list.size();
}

template <typename Tuple>
void mark_cells(const std::vector<Tuple>& contacts, std::vector<bool>& is_marked)
{
  for(const Tuple& contact : contacts)
    for(const Index cell : contact)
      is_marked[cell] = true;
}

// The farthest vertex at each invalid contact of cells, in the order of the lists of `Dual`.
struct Contact_vertices
{
  std::vector<Index> at_interface, at_boundary_crossing, at_triple_point;
};

void find_farthest_at_interfaces(const Refined_surface& surface, const Cells& cells,
                                 const std::vector<double>& distances, const Dual& dual,
                                 Contact_vertices& result)
{
  const Surface_arrays& t = surface.triangles();
  std::vector<bool> is_disconnected(cells.samples.size(), false);
  mark_cells(dual.disconnected_interfaces, is_disconnected);
  mark_cells(dual.repeated_boundary_crossings, is_disconnected);
  for(Index h = 0; h < t.corner.size(); ++h)
  {
    const Index x = t.corner[h], z = t.corner[next_halfedge(h)];
    const Index a = cells.labels[x], b = cells.labels[z];
    if(a == b || !is_disconnected[a] || !is_disconnected[b])
      continue;
    const std::array<Index, 2> cell_pair = {std::min(a, b), std::max(a, b)};
    if(const auto i = find_index(dual.disconnected_interfaces, cell_pair);
       i < result.at_interface.size())
    {
      keep_farthest(distances, x, result.at_interface[i]);
      keep_farthest(distances, z, result.at_interface[i]);
    }
    if(const auto i = find_index(dual.repeated_boundary_crossings, cell_pair);
       i < result.at_boundary_crossing.size() && surface.is_feature()[h])
    {
      keep_farthest(distances, x, result.at_boundary_crossing[i]);
      keep_farthest(distances, z, result.at_boundary_crossing[i]);
    }
  }
}

void find_farthest_at_triple_points(const Surface_arrays& t, const Cells& cells,
                                    const std::vector<double>& distances, const Dual& dual,
                                    std::vector<Index>& at_triple_point)
{
  if(at_triple_point.empty())
    return;
  std::vector<bool> is_repeated(cells.samples.size(), false);
  mark_cells(dual.repeated_triple_points, is_repeated);
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    std::array<Index, 3> cells_around;
    for(Index k = 0; k < 3; ++k)
      cells_around[k] = cells.labels[t.corner[3 * f + k]];
    if(!is_repeated[cells_around[0]] || !is_repeated[cells_around[1]] ||
       !is_repeated[cells_around[2]])
      continue;
    std::sort(cells_around.begin(), cells_around.end());
    if(const auto i = find_index(dual.repeated_triple_points, cells_around);
       i < at_triple_point.size())
      for(Index k = 0; k < 3; ++k)
        keep_farthest(distances, t.corner[3 * f + k], at_triple_point[i]);
  }
}

Contact_vertices farthest_at_contacts(const Refined_surface& surface, const Cells& cells,
                                      const std::vector<double>& distances, const Dual& dual)
{
  Contact_vertices result;
  result.at_interface.assign(dual.disconnected_interfaces.size(), none);
  result.at_boundary_crossing.assign(dual.repeated_boundary_crossings.size(), none);
  result.at_triple_point.assign(dual.repeated_triple_points.size(), none);
  find_farthest_at_interfaces(surface, cells, distances, dual, result);
  find_farthest_at_triple_points(surface.triangles(), cells, distances, dual,
                                 result.at_triple_point);
  return result;
}

// Appends up to `number` vertices of each selected cell that are not samples yet.
void add_vertices_of_cells(const Cells& cells, const std::vector<double>& distances,
                           const std::vector<bool>& is_selected, std::size_t number,
                           std::vector<Surface_location>& samples)
{
  std::vector<bool> is_candidate(cells.labels.size(), false);
  std::vector<std::size_t> number_of_candidates(cells.samples.size(), 0);
  for(Index vertex = 0; vertex < cells.labels.size(); ++vertex)
    is_candidate[vertex] =
        cells.labels[vertex] != none && is_selected[cells.labels[vertex]] && distances[vertex] > 0.;
  for(const Surface_location& sample : samples)
    is_candidate[sample.vertex] = false;
  for(Index vertex = 0; vertex < cells.labels.size(); ++vertex)
    if(is_candidate[vertex])
      ++number_of_candidates[cells.labels[vertex]];
  std::vector<std::size_t> number_visited(cells.samples.size(), 0);
  for(Index vertex = 0; vertex < cells.labels.size(); ++vertex)
    if(is_candidate[vertex])
    {
      const Index cell = cells.labels[vertex];
      const std::size_t step = (number_of_candidates[cell] + number - 1) / number;
      if(number_visited[cell]++ % step == 0)
        samples.push_back({none, vertex, {}});
    }
}

} // namespace

Cells connected_cells(const Surface_arrays& t, const Sampling& sampling)
{
  Cells result = flood_cells(t, sampling);
  // Each round labels the unlabeled neighbors of the vertices that the previous round labeled, at
  // the beginning those of all labeled vertices. Labels are applied at the end of a round, so that
  // the result does not depend on the order of vertices. O(n log n) time for all rounds.
  std::vector<bool> is_disconnected(t.number_of_vertices(), false);
  std::vector<std::pair<Index, Index>> found; // vertex and cell
  const auto find = [&](Index vertex)
  {
    if(const Index cell = closest_adjacent_cell(t, sampling.distances(), result.labels, vertex);
       cell != none)
      found.emplace_back(vertex, cell);
  };
  for(const Index vertex : sampling.sampled_vertices())
    if(result.labels[vertex] == none)
    {
      is_disconnected[vertex] = true;
      find(vertex);
    }
  while(!found.empty())
  {
    std::vector<Index> next;
    for(const auto& [vertex, cell] : found)
    {
      result.labels[vertex] = cell;
      is_disconnected[vertex] = false;
      for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
        for(const Index corner : {next_halfedge(t.ring[i]), previous_halfedge(t.ring[i])})
          next.push_back(t.corner[corner]);
    }
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    found.clear();
    for(const Index vertex : next)
      if(is_disconnected[vertex])
        find(vertex);
  }
  return result;
}

std::vector<Index> farthest_vertices(const Cells& cells, const Sampling& sampling)
{
  std::vector<Index> result(cells.samples.size(), none);
  const std::vector<double>& distances = sampling.distances();
  for(Index vertex = 0; vertex < cells.labels.size(); ++vertex)
    if(const Index cell = cells.labels[vertex]; cell != none && distances[vertex] > 0.)
      keep_farthest(distances, vertex, result[cell]);
  return result;
}

Topology_check check_topology(const Refined_surface& surface, const Sampling& sampling,
                              const Cells& cells)
{
  return {
      dual(surface.triangles(), cells.labels, Index(cells.samples.size()), surface.is_feature()),
      find_off_feature_cells(surface, sampling, cells),
      find_cells_without_own_sample(surface, sampling, cells)};
}

Topology_repair repair_topology(const Refined_surface& surface, const Sampling& sampling,
                                const Cells& cells, const Topology_check& check,
                                std::size_t number_of_additional)
{
  const std::vector<double>& distances = sampling.distances();
  const Dual& found = check.dual;
  const Extreme_vertices extreme = extreme_vertices(surface, cells, distances);
  const Contact_vertices contact = farthest_at_contacts(surface, cells, distances, found);

  Topology_repair result;
  result.unresolved = check.cells_without_own_sample;
  std::vector<bool> is_handled(cells.samples.size(), false);
  const auto add = [&](std::initializer_list<Index> cells_around, Index vertex)
  {
    if(std::any_of(cells_around.begin(), cells_around.end(),
                   [&](Index c) { return is_handled[c]; }))
      return;
    // If the vertex is a sample already, any other vertex of these cells is used.
    for(const Index cell : cells_around)
      if(distances[vertex] == 0.)
        vertex = extreme.farthest[cell];
    for(const Index cell : cells_around)
      is_handled[cell] = true;
    if(distances[vertex] > 0.)
      result.samples.push_back({none, vertex, {}});
    else
      result.unresolved.insert(result.unresolved.end(), cells_around);
  };
  for(const Index cell : found.disconnected_boundaries)
    add({cell}, extreme.farthest_on_feature[cell]);
  for(const Index cell : check.off_feature_cells)
    add({cell}, extreme.nearest_on_feature[cell]);
  for(const Index cell : found.non_disks)
    add({cell}, extreme.farthest[cell]);
  for(std::size_t i = 0; i < contact.at_boundary_crossing.size(); ++i)
    add({found.repeated_boundary_crossings[i][0], found.repeated_boundary_crossings[i][1]},
        contact.at_boundary_crossing[i]);
  for(std::size_t i = 0; i < contact.at_interface.size(); ++i)
    add({found.disconnected_interfaces[i][0], found.disconnected_interfaces[i][1]},
        contact.at_interface[i]);
  for(std::size_t i = 0; i < contact.at_triple_point.size(); ++i)
    add({found.repeated_triple_points[i][0], found.repeated_triple_points[i][1],
         found.repeated_triple_points[i][2]},
        contact.at_triple_point[i]);
  if(number_of_additional > 0)
    add_vertices_of_cells(cells, distances, is_handled, number_of_additional, result.samples);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
