// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/remeshing/base_mesh.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/mesh/feature_polylines.h>
#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/mesh/refinement.h>
#include "mesh/Split_mesh.h"
#include "paths/shorten_in_strip.h"
#include "remeshing/strip_search.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Tried one after the other until every edge has a path. The first level keeps edges close to their
// cells. If cells have few vertices, this may leave no room for some edges.
constexpr std::array<Detour_factors, 3> detour_levels = {
    Detour_factors{2., 16., false}, Detour_factors{1., 1., true}, Detour_factors{2., 4., true}};
// Confines each edge to the cells of its end vertices.
constexpr Detour_factors no_detour = {infinity, infinity, false};
// Limits of the visits of the search: per halfedge of the mesh, plus per base edge. On meshes of
// needles each traced edge multiplies the number of triangles that the next one crosses.
constexpr std::size_t max_visits_per_halfedge = 50, max_visits_per_edge = 1500;
// Limits of the triangles of the split mesh: a constant, plus a multiple of the number of triangles
// of the mesh and base edges. On 60 scans and CAD models, split meshes have up to 70,000 triangles,
// with one exception: a model of 14,740 needles has 250,000.
constexpr std::size_t min_triangle_limit = 150000, max_triangles_per_element = 10;
constexpr Index curve_label = Split_mesh::curve_label;

// Traces the edges of a base mesh and splits the mesh along them.
class Builder
{
public:
  Builder(const Surface_arrays& coarse, const std::vector<Surface_location>& samples,
          const std::vector<std::array<Index, 3>>& triangles, const std::vector<bool>& is_feature,
          const Detour_factors& factors, const std::vector<Index>& cells)
      : m_mesh(coarse, is_feature)
  {
    m_result.triangles = triangles;
    index_edges(samples.size());
    m_max_triangles =
        min_triangle_limit +
        max_triangles_per_element * (coarse.number_of_triangles() + m_result.halfedge.size());
    for(const Surface_location& sample : samples)
    {
      m_result.vertex.push_back(m_mesh.insert(sample));
      m_result.samples.push_back(m_mesh.locations()[m_result.vertex.back()]);
    }
    m_base_vertex.assign(m_mesh.locations().size(), none);
    for(Index i = 0; i < m_result.vertex.size(); ++i)
      m_base_vertex[m_result.vertex[i]] = i;
    m_is_blocked.assign(m_mesh.locations().size(), factors.is_confined());
    for(const Index vertex : m_result.vertex)
      m_is_blocked[vertex] = !factors.can_pass_samples;
    std::vector<Index> cell_of_vertex = m_base_vertex;
    for(Index vertex = 0; vertex < coarse.number_of_vertices(); ++vertex)
      if(cell_of_vertex[vertex] == none)
        cell_of_vertex[vertex] = cells[vertex];
    m_search.emplace(m_mesh, factors, std::move(cell_of_vertex),
                     max_visits_per_halfedge * coarse.corner.size() +
                         max_visits_per_edge * m_result.halfedge.size());
  }

  // Returns nothing if an edge has no path or a region is not a disk.
  std::optional<Base_mesh> run()
  {
    if(!trace_features() || !trace_edges())
      return std::nullopt;
    split_shortcuts();
    split_duplicate_edges();
    if(!label_regions())
      return std::nullopt;
    finish();
    return std::move(m_result);
  }

private:
  const Surface_arrays& t() const { return m_mesh.triangles(); }

  void index_edges(std::size_t number_of_samples)
  {
    std::vector<Index> corners;
    for(const auto& f : m_result.triangles)
      corners.insert(corners.end(), f.begin(), f.end());
    m_result.twin = twins_of_soup(number_of_samples, corners);
    m_result.edge.assign(corners.size(), none);
    for(Index h = 0; h < corners.size(); ++h)
    {
      const Index twin = m_result.twin[h];
      if(twin != none && twin < h)
        continue;
      const Index edge = Index(m_result.halfedge.size());
      m_result.edge[h] = edge;
      if(twin != none)
        m_result.edge[twin] = edge;
      m_result.halfedge.push_back(h);
      m_edge_between[std::minmax(corners[h], corners[next_halfedge(h)])] = edge;
    }
    m_result.path.resize(m_result.halfedge.size());
  }

  Index base_corner(Index h) const { return m_result.triangles[h / 3][h % 3]; }

  void block(Index vertex)
  {
    if(m_is_blocked.size() <= vertex)
      m_is_blocked.resize(t().point.size(), false);
    m_is_blocked[vertex] = true;
  }

  // Labels the feature edges of the mesh with the base edges that follow them. Returns false if a
  // feature polyline between two samples is not exactly one base edge.
  bool trace_features()
  {
    const std::vector<Index>& label = m_mesh.labels();
    for(Index base_vertex = 0; base_vertex < m_result.vertex.size(); ++base_vertex)
      for(const Index first_halfedge : m_mesh.halfedges_around(m_result.vertex[base_vertex]))
      {
        if(label[first_halfedge] != curve_label)
          continue;
        std::vector<Index> path = {m_result.vertex[base_vertex]}, halfedges = {first_halfedge};
        for(;;)
        {
          const Index h = halfedges.back(), last_vertex = path.back();
          const Index next_vertex =
              m_mesh.source(h) == last_vertex ? m_mesh.target(h) : m_mesh.source(h);
          path.push_back(next_vertex);
          if(m_base_vertex[next_vertex] != none)
            break;
          Index continuation = none;
          for(const Index other : m_mesh.halfedges_around(next_vertex))
            if(label[other] == curve_label && other != h && t().twin[other] != h)
              continuation = other;
          if(continuation == none || path.size() > t().point.size())
            return false;
          halfedges.push_back(continuation);
        }
        const auto found =
            m_edge_between.find(std::minmax(base_vertex, m_base_vertex[path.back()]));
        if(found == m_edge_between.end() || !m_result.path[found->second].empty())
          return false;
        for(const Index h : halfedges)
          m_mesh.set_label(h, found->second);
        store_path(found->second, std::move(path));
      }
    return std::none_of(label.begin(), label.end(), [](Index l) { return l == curve_label; });
  }

  // Stores the path of an edge in the direction of its halfedge, and blocks its vertices.
  void store_path(Index edge, std::vector<Index> path)
  {
    for(const Index vertex : path)
      block(vertex);
    if(m_base_vertex[path.front()] != base_corner(m_result.halfedge[edge]))
      std::reverse(path.begin(), path.end());
    m_result.path[edge] = std::move(path);
  }

  // Traces the edges that follow no feature: a minimum spanning tree first (Kruskal), then the
  // others. Both groups are sorted by the distance of the end vertices in space. Returns false if
  // an edge has no path.
  bool trace_edges()
  {
    std::vector<Index> sorted, order, others;
    std::vector<double> length;
    boost::disjoint_sets_with_storage<> components(m_result.vertex.size());
    const auto merges_components = [&](Index edge)
    {
      const Index h = m_result.halfedge[edge];
      const auto p = components.find_set(base_corner(h)),
                 q = components.find_set(base_corner(next_halfedge(h)));
      if(p != q)
        components.link(p, q);
      return p != q;
    };
    for(Index edge = 0; edge < m_result.halfedge.size(); ++edge)
    {
      const Index h = m_result.halfedge[edge];
      length.push_back(m_mesh.distance_between(m_result.vertex[base_corner(h)],
                                               m_result.vertex[base_corner(next_halfedge(h))]));
      if(m_result.path[edge].empty())
        sorted.push_back(edge);
      else
        merges_components(edge);
    }
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](Index a, Index b) { return length[a] < length[b]; });
    for(const Index edge : sorted)
      (merges_components(edge) ? order : others).push_back(edge);
    order.insert(order.end(), others.begin(), others.end());
    return std::all_of(order.begin(), order.end(), [&](Index edge) { return trace_edge(edge); });
  }

  // Returns the corners at the source of a base halfedge that lie between the traced edges adjacent
  // to it in the cyclic order. The path of the halfedge must start in one of these corners.
  std::vector<Index> sector(Index h) const
  {
    const std::vector<Index> corners = m_mesh.corners_around(m_result.vertex[base_corner(h)]);
    Index right_halfedge = h;
    do
    {
      const Index twin = m_result.twin[right_halfedge];
      right_halfedge = twin == none ? none : next_halfedge(twin);
    } while(right_halfedge != none && right_halfedge != h &&
            m_result.path[m_result.edge[right_halfedge]].empty());
    if(right_halfedge == h || right_halfedge == none)
      return corners;
    const std::vector<Index>& label = m_mesh.labels();
    const auto begin =
        std::find_if(corners.begin(), corners.end(),
                     [&](Index c) { return label[c] == m_result.edge[right_halfedge]; });
    std::vector<Index> result;
    if(begin == corners.end())
      return result;
    for(std::size_t i = std::size_t(begin - corners.begin()), n = 0; n < corners.size(); ++n)
    {
      result.push_back(corners[i]);
      if(label[previous_halfedge(corners[i])] != none)
        break;
      i = (i + 1) % corners.size();
    }
    return result;
  }

  // Traces an edge along a single mesh edge if possible, otherwise through a strip of triangles.
  bool trace_edge(Index edge)
  {
    const Index h = m_result.halfedge[edge], twin = m_result.twin[h];
    if(twin == none || t().number_of_triangles() > m_max_triangles)
      return false;
    const Index from = m_result.vertex[base_corner(h)], to = m_result.vertex[base_corner(twin)];
    const std::vector<Index> start_corners = sector(h), goal_corners = sector(twin);
    const auto is_goal = [&](Index corner)
    { return std::find(goal_corners.begin(), goal_corners.end(), corner) != goal_corners.end(); };
    for(const Index corner : start_corners)
      if(m_mesh.target(corner) == to && m_mesh.labels()[corner] == none &&
         is_goal(next_halfedge(corner)))
      {
        m_mesh.set_label(corner, edge);
        store_path(edge, {from, to});
        return true;
      }
    m_search->set_nearby_cells({base_corner(h), base_corner(twin),
                                base_corner(previous_halfedge(h)),
                                base_corner(previous_halfedge(twin))});
    const std::vector<Index> crossed_halfedges = m_search->find(start_corners, goal_corners, to);
    if(crossed_halfedges.empty())
      return false;
    m_is_blocked.resize(t().point.size(), false);
    const Strip_path strip = shorten_in_strip(m_mesh, m_is_blocked, from, to, crossed_halfedges);
    return !strip.halfedges.empty() && split_along(edge, from, to, strip);
  }

  // Splits the triangles of a strip along a path. Returns false if the strip is not connected.
  bool split_along(Index edge, Index from, Index to, const Strip_path& strip)
  {
    const std::vector<Index>& halfedges = strip.halfedges;
    const std::vector<double>& fractions = strip.fractions;
    std::vector<bool> is_right_turn;
    for(std::size_t i = 0; i + 1 < halfedges.size(); ++i)
      is_right_turn.push_back(halfedges[i + 1] == next_halfedge(t().twin[halfedges[i]]));
    std::vector<Index> path = {from};
    Index h = halfedges.front();
    for(std::size_t i = 0; i < halfedges.size(); ++i)
    {
      if(m_mesh.apex(h) != path.back())
        return false;
      const Index entry = t().twin[h];
      m_search->add_vertex_on(h, fractions[i]);
      path.push_back(m_mesh.split_edge(h, fractions[i]));
      m_mesh.set_label(next_halfedge(h), edge);
      if(i + 1 < halfedges.size())
        // The split of v u x by p leaves the triangles v p x and p u x. The latter is adjacent to
        // the first part of the path.
        h = is_right_turn[i] ? next_halfedge(t().twin[h]) : previous_halfedge(entry);
      else
      {
        if(m_mesh.apex(entry) != to)
          return false;
        m_mesh.set_label(next_halfedge(entry), edge);
      }
    }
    path.push_back(to);
    store_path(edge, std::move(path));
    return true;
  }

  // Splits unlabeled edges between two vertices of one path. A map that is linear in each triangle
  // would map their triangles onto the base edge.
  void split_shortcuts()
  {
    std::vector<std::vector<Index>> edges(t().point.size());
    for(Index edge = 0; edge < m_result.path.size(); ++edge)
      for(const Index vertex : m_result.path[edge])
        edges[vertex].push_back(edge);
    // Halfedges that a split creates or renumbers are visited later in this loop.
    for(Index h = 0; h < t().corner.size(); ++h)
    {
      if(m_mesh.labels()[h] != none || t().twin[h] < h)
        continue;
      const Index p = m_mesh.source(h), q = m_mesh.target(h);
      if(p >= edges.size() || q >= edges.size())
        continue;
      const auto& edges_of_q = edges[q];
      if(std::any_of(edges[p].begin(), edges[p].end(),
                     [&](Index edge) {
                       return std::find(edges_of_q.begin(), edges_of_q.end(), edge) !=
                              edges_of_q.end();
                     }))
        m_mesh.split_edge(h, 0.5);
    }
  }

  // If several edges connect the same two vertices, splits those that are not labeled, except one.
  // A map that is linear in each triangle would map them, and all that they enclose, onto a
  // segment.
  void split_duplicate_edges()
  {
    using Ends = std::pair<Index, Index>;
    const auto ends = [&](Index h) -> Ends
    { return std::minmax(m_mesh.source(h), m_mesh.target(h)); };
    std::vector<std::pair<Ends, Index>> edges;
    for(Index h = 0; h < t().corner.size(); ++h)
      if(!(t().twin[h] < h))
        edges.emplace_back(ends(h), h);
    std::sort(edges.begin(), edges.end());
    for(std::size_t i = 1; i < edges.size(); ++i)
    {
      if(edges[i].first != edges[i - 1].first)
        continue;
      // A split changes the numbers of some halfedges, but not their ends.
      const auto [p, q] = edges[i].first;
      bool is_first = true;
      for(const Index h : m_mesh.halfedges_around(p))
        if(ends(h) == edges[i].first && m_mesh.labels()[h] == none &&
           !std::exchange(is_first, false))
        {
          m_mesh.split_edge(h, 0.5);
          break;
        }
    }
  }

  // Labels the triangles of each region. Returns false if the triangles between the edges of a base
  // triangle are not a disk, or if some triangles belong to no region.
  bool label_regions()
  {
    const std::vector<Index>& label = m_mesh.labels();
    m_result.region.assign(t().number_of_triangles(), none);
    std::vector<Index> start, last_region(t().point.size(), none);
    for(Index f = 0; f < m_result.triangles.size(); ++f)
    {
      start.clear();
      for(const Index corner : m_mesh.corners_around(m_result.vertex[m_result.triangles[f][0]]))
        if(label[corner] == m_result.edge[3 * f])
          start.push_back(corner / 3);
      if(start.size() != 1 || m_result.region[start[0]] != none ||
         !fill_region(f, start[0], last_region))
        return false;
    }
    return std::find(m_result.region.begin(), m_result.region.end(), none) == m_result.region.end();
  }

  // Labels the triangles that are connected to `start` without crossing the edges of a base
  // triangle. Returns true if they form a disk (Euler's formula) whose perimeter is these edges.
  // last_region: #vertices, the last region in which each vertex was counted
  bool fill_region(Index f, Index start, std::vector<Index>& last_region)
  {
    const std::vector<Index>& label = m_mesh.labels();
    std::size_t number_of_triangles = 0, number_of_halfedges = 0, number_on_edges = 0,
                number_of_vertices = 0;
    m_result.region[start] = f;
    std::vector<Index> stack = {start};
    while(!stack.empty())
    {
      const Index triangle = stack.back();
      stack.pop_back();
      ++number_of_triangles;
      for(Index h = 3 * triangle; h < 3 * triangle + 3; ++h)
      {
        if(last_region[m_mesh.source(h)] != f)
        {
          last_region[m_mesh.source(h)] = f;
          ++number_of_vertices;
        }
        ++number_of_halfedges;
        if(label[h] != none)
        {
          const Index* edge = &m_result.edge[3 * std::size_t(f)];
          if(std::find(edge, edge + 3, label[h]) == edge + 3)
            return false;
          ++number_on_edges;
          continue;
        }
        const Index other = t().twin[h] / 3;
        if(m_result.region[other] == none)
        {
          m_result.region[other] = f;
          stack.push_back(other);
        }
      }
    }
    std::size_t perimeter = 0;
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      perimeter += m_result.path[m_result.edge[h]].size() - 1;
    return number_on_edges == perimeter && number_of_vertices + number_of_triangles ==
                                               (number_of_halfedges + number_on_edges) / 2 + 1;
  }

  // Copies the split mesh to the result.
  void finish()
  {
    Surface_arrays& fine = m_result.fine;
    fine = m_mesh.triangles();
    for(Index h = 0; h < fine.corner.size(); ++h)
      fine.length.push_back(std::max(m_mesh.length(h), min_edge_length));
    build_rings(fine, fine.point.size());
    for(Index h = 0; h < fine.corner.size(); ++h)
      m_result.barycentric.push_back(m_mesh.barycentric(h / 3, fine.corner[h]));
    m_result.parent = m_mesh.coarse_triangles();
    m_result.edge_of_halfedge = m_mesh.labels();
  }

  Split_mesh m_mesh;
  std::optional<Strip_search> m_search;
  std::size_t m_max_triangles = 0; // no edge is traced if the split mesh has more
  Base_mesh m_result;
  std::map<std::pair<Index, Index>, Index> m_edge_between;
  std::vector<Index> m_base_vertex; // #vertices before tracing: the base vertex, or none
  std::vector<bool> m_is_blocked;   // #vertices: paths must not be moved across these
};

// Returns the sample with the smallest geodesic distance from each vertex (#vertices).
std::vector<Index> nearest_sample_cells(const Surface_arrays& coarse,
                                        const std::vector<Surface_location>& samples)
{
  std::vector<Front_source> sources;
  for(Index i = 0; i < samples.size(); ++i)
    sources.push_back({{samples[i]}, 0., i});
  Front front(std::shared_ptr<const Surface_arrays>(&coarse, [](const Surface_arrays*) {}),
              Front_kind::euclidean);
  front.run(sources);
  std::vector<Index> result;
  for(Index vertex = 0; vertex < coarse.number_of_vertices(); ++vertex)
    result.push_back(front.source(vertex));
  return result;
}

// Expresses the base mesh of a refined surface in the triangles and the scale of the coarse mesh.
void map_to_coarse(const Refinement& surface, Base_mesh& base)
{
  if(surface.parent.empty())
    return;
  for(Surface_location& sample : base.samples)
    sample = to_coarse(surface, sample);
  for(Index h = 0; h < base.barycentric.size(); ++h)
    base.barycentric[h] =
        to_coarse(surface, {base.parent[h / 3], none, base.barycentric[h]}).barycentric;
  for(Index& parent : base.parent)
    parent = surface.parent[parent];
  Surface_arrays& fine = base.fine;
  const double unit = fine.scale / surface.coarse->scale; // a power of two
  for(Vec3& point : fine.point)
    point = unit * point;
  for(double& length : fine.length)
    length = std::max(unit * length, min_edge_length);
  fine.scale = surface.coarse->scale;
}

// Returns the samples on the refined surface. If no vertex of the triangles around a sample belongs
// to its cell, the closest vertex of the cell in space replaces it.
std::vector<Surface_location> samples_in_cells(const Remeshing& found)
{
  const Surface_arrays& t = *found.surface.triangles;
  std::vector<Surface_location> result = to_fine(found.surface, found.samples);
  std::vector<bool> is_off_cell(result.size(), true);
  for(Index i = 0; i < result.size(); ++i)
    for(const Index f : triangles_at(t, result[i]))
      for(Index k = 0; k < 3; ++k)
        if(found.cells[t.corner[3 * f + k]] == i)
          is_off_cell[i] = false;
  std::vector<double> min_distance(result.size(), infinity);
  const std::vector<Surface_location> samples = result;
  for(Index vertex = 0; vertex < found.cells.size(); ++vertex)
    if(const Index cell = found.cells[vertex]; cell != none && is_off_cell[cell])
      if(const double distance = norm(t.point[vertex] - scaled_coordinates(t, samples[cell]));
         distance < min_distance[cell])
      {
        min_distance[cell] = distance;
        result[cell] = vertex_location(t, vertex);
      }
  return result;
}

// Returns the base mesh of the dual triangulation, with each edge confined to two cells.
std::optional<Base_mesh> base_mesh_in_cells(const Remeshing& found,
                                            const std::vector<bool>& is_feature)
{
  const Refinement& surface = found.surface;
  const std::vector<Index> coarse = coarse_halfedges(surface);
  std::vector<bool> is_fine_feature;
  for(const Index h : coarse)
    is_fine_feature.push_back(h != none && is_feature[h]);
  auto result = Builder(*surface.triangles, samples_in_cells(found), found.dual_triangles,
                        is_fine_feature, no_detour, found.cells)
                    .run();
  if(result)
    map_to_coarse(surface, *result);
  return result;
}

} // namespace

std::optional<Base_mesh> build_base_mesh(const Surface_arrays& coarse,
                                         const std::vector<Surface_location>& samples,
                                         const std::vector<std::array<Index, 3>>& triangles,
                                         const std::vector<bool>& is_feature)
{
  const std::vector<Index> cells = nearest_sample_cells(coarse, samples);
  for(const Detour_factors& factors : detour_levels)
    if(auto result = Builder(coarse, samples, triangles, is_feature, factors, cells).run())
      return result;
  return std::nullopt;
}

Base_mesh build_base_mesh(const std::shared_ptr<const Surface_arrays>& triangles,
                          const Remeshing_options& options)
{
  const std::vector<bool> is_feature =
      options.is_feature.empty() ? boundary_and_sharp_halfedges(*triangles) : options.is_feature;
  const Remeshing found = remesh(triangles, options);
  if(!found.is_finished)
  {
    Base_mesh cancelled;
    cancelled.is_finished = false;
    return cancelled;
  }
  auto result = build_base_mesh(*triangles, found.samples, found.triangles, is_feature);
  if(!result)
    result = base_mesh_in_cells(found, is_feature);
  if(!result)
    throw Unsupported_surface_error(
        "The edges of the base mesh cannot be traced: the surface is too thin or too coarse.");
  return std::move(*result);
}

} // namespace CGAL::Geodesic_processing::internal
