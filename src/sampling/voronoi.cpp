// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/sampling/voronoi.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

Voronoi_diagram::Voronoi_diagram(std::shared_ptr<const Surface_arrays> triangles, Front front,
                                 const std::vector<Front_source>& sources, Index number_of_cells,
                                 const Front_limits& limits)
    : m_triangles(std::move(triangles)), m_slowness(limits.slowness),
      m_distances(m_triangles->number_of_vertices(), infinity),
      m_labels(m_triangles->number_of_vertices(), none)
{
  std::vector<std::vector<Front_source>> cells(number_of_cells);
  for(const Front_source& source : sources)
  {
    cells[source.label].push_back(source);
    m_has_circular_fronts = m_has_circular_fronts && source.offset == 0.;
  }
  m_has_circular_fronts = m_has_circular_fronts && !m_slowness;

  std::size_t done = 0;
  Front_limits bounded = limits;
  bounded.targets.clear();
  if(limits.callback)
    bounded.callback = [&](double)
    { return limits.callback(double(done) / double(number_of_cells + 1)); };
  m_is_finished = front.run(sources, bounded);
  for(const Index vertex : front.reached())
  {
    m_distances[vertex] = front.distance(vertex);
    m_labels[vertex] = sources[front.source(vertex)].label;
  }

  // At the bisectors the common front is inaccurate, because its circles may combine distances from
  // two cells. The front of each cell corrects these. It must reach all vertices that share
  // triangles with the cell, along shortest paths. The bound of two edges covers the excess of
  // these vertices and of the vertices on their paths.
  std::vector<double> known = m_distances;
  for(Index vertex = 0; vertex < known.size(); ++vertex)
    known[vertex] += 2. * max_edge_time(vertex);
  bounded.known_distance = &known;
  std::vector<bool> has_own_distance(known.size(), false);
  for(Index label = 0; label < number_of_cells && m_is_finished; ++label)
  {
    ++done;
    m_is_finished = front.run(cells[label], bounded);
    for(const Index vertex : front.reached())
    {
      const double distance = front.distance(vertex);
      if(has_own_distance[vertex] && distance >= m_distances[vertex])
      {
        m_other_distances.push_back({vertex, label, distance});
        continue;
      }
      if(has_own_distance[vertex])
        m_other_distances.push_back({vertex, m_labels[vertex], m_distances[vertex]});
      m_distances[vertex] = distance;
      m_labels[vertex] = label;
      has_own_distance[vertex] = true;
    }
  }
  std::sort(m_other_distances.begin(), m_other_distances.end());
}

// Returns the maximum travel time along an edge of the triangles incident to a vertex.
double Voronoi_diagram::max_edge_time(Index vertex) const
{
  const Surface_arrays& t = *m_triangles;
  double result = 0.;
  for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
  {
    const Index f = t.ring[i] / 3;
    const double slowness = m_slowness ? (*m_slowness)[f] : 1.;
    if(slowness < infinity)
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        result = std::max(result, slowness * t.length[h]);
  }
  return result;
}

double Voronoi_diagram::distance(Index vertex, Index label) const
{
  if(m_labels[vertex] == label)
    return m_distances[vertex];
  const auto found = std::lower_bound(m_other_distances.begin(), m_other_distances.end(),
                                      Other_distance{vertex, label, -infinity});
  const bool is_found =
      found != m_other_distances.end() && found->vertex == vertex && found->label == label;
  return is_found ? found->distance : infinity;
}

// Returns the value that is compared between cells inside a triangle. The difference of the values
// of two cells must be linear in the point p. This holds for squared distances of circular fronts,
// as |p - a|^2 - |p - b|^2 is linear, and for distances of straight fronts.
double Voronoi_diagram::comparison_value(Index vertex, Index label) const
{
  const double result = distance(vertex, label);
  return m_has_circular_fronts ? result * result : result;
}

bool Voronoi_diagram::is_crossed(Index h) const
{
  return m_labels[m_triangles->corner[h]] != m_labels[m_triangles->corner[next_halfedge(h)]];
}

// Returns the number of cells with a corner of the triangle, or 0 if a corner is unreached.
int Voronoi_diagram::number_of_labels(Index triangle) const
{
  const Index* const c = &m_triangles->corner[3 * std::size_t(triangle)];
  const Index a = m_labels[c[0]], b = m_labels[c[1]], d = m_labels[c[2]];
  if(a == none || b == none || d == none)
    return 0;
  return a == b ? (b == d ? 1 : 2) : (b == d || a == d ? 2 : 3);
}

// Returns the parameter on an edge at which the bisector of the cells of its ends crosses. The
// results for both halfedges sum to one.
double Voronoi_diagram::crossing_fraction(Index h) const
{
  const Surface_arrays& t = *m_triangles;
  if(t.twin[h] < h)
    return 1. - crossing_fraction(t.twin[h]);
  const Index x = t.corner[h], z = t.corner[next_halfedge(h)];
  const Index a = m_labels[x], b = m_labels[z];
  const double difference_at_x = comparison_value(x, b) - comparison_value(x, a),
               difference_at_z = comparison_value(z, a) - comparison_value(z, b);
  if(difference_at_x + difference_at_z > 0. && difference_at_x + difference_at_z < infinity)
    return std::clamp(difference_at_x / (difference_at_x + difference_at_z), 0., 1.);
  // Near an obstacle, one cell may not have reached both ends. The crossing is then that of two
  // fronts along the edge.
  const double travel_time = (m_slowness ? (*m_slowness)[h / 3] : 1.) * t.length[h];
  return travel_time > 0. && travel_time < infinity
             ? std::clamp(0.5 + 0.5 * (m_distances[z] - m_distances[x]) / travel_time, 0., 1.)
             : 0.5;
}

Surface_location Voronoi_diagram::crossing_location(Index h) const
{
  return {h / 3, none, barycentric_on_halfedge(h, crossing_fraction(h))};
}

Surface_location Voronoi_diagram::triple_point(Index triangle) const
{
  const Index* const c = &m_triangles->corner[3 * std::size_t(triangle)];
  const Index a = m_labels[c[0]], b = m_labels[c[1]], d = m_labels[c[2]];
  // The point at which the three linear functions are equal, if it is inside the triangle.
  std::array<double, 3> u, v, p;
  for(int k = 0; k < 3; ++k)
  {
    u[k] = comparison_value(c[k], a) - comparison_value(c[k], b);
    v[k] = comparison_value(c[k], b) - comparison_value(c[k], d);
  }
  double sum = 0.;
  for(int k = 0; k < 3; ++k)
  {
    p[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
    sum += p[k];
  }
  bool is_inside = true;
  for(double& b_k : p)
  {
    b_k /= sum;
    is_inside = is_inside && b_k >= 0.;
  }
  if(is_inside)
    return {triangle, none, p};
  // Otherwise the three cells do not meet inside the triangle, and the mean of the three crossings
  // is used.
  Surface_location result = {triangle, none, {0., 0., 0.}};
  for(Index k = 0; k < 3; ++k)
  {
    const Surface_location edge_point = crossing_location(3 * triangle + k);
    for(int j = 0; j < 3; ++j)
      result.barycentric[j] += edge_point.barycentric[j] / 3.;
  }
  return result;
}

Index Voronoi_diagram::triangle_label(Index triangle) const
{
  if(number_of_labels(triangle) == 0)
    return none;
  const Index* const c = &m_triangles->corner[3 * std::size_t(triangle)];
  Index result = none;
  double min_value = infinity, min_distance = infinity;
  for(int k = 0; k < 3; ++k)
  {
    const Index label = m_labels[c[k]];
    const double at_center = comparison_value(c[0], label) + comparison_value(c[1], label) +
                             comparison_value(c[2], label);
    // If no cell has known distances at all corners, the corner with the smallest distance decides.
    if(at_center < min_value || (min_value == infinity && m_distances[c[k]] < min_distance))
      result = label;
    min_value = std::min(min_value, at_center);
    min_distance = std::min(min_distance, m_distances[c[k]]);
  }
  return result;
}

// Traces bisectors from triangle to triangle.
struct Voronoi_diagram::Bisector_tracer
{
  const Voronoi_diagram& voronoi;
  std::vector<bool> is_visited = std::vector<bool>(voronoi.m_triangles->corner.size(), false);

  Index reached_twin(Index h) const
  {
    const Index twin = voronoi.m_triangles->twin[h];
    return twin != none && voronoi.number_of_labels(twin / 3) > 0 ? twin : none;
  }
  void mark(Index h)
  {
    is_visited[h] = true;
    if(const Index twin = voronoi.m_triangles->twin[h]; twin != none)
      is_visited[twin] = true;
  }
  // Appends the bisector that enters the triangle of halfedge h, up to its end.
  void follow(Index h, std::vector<Surface_location>& polyline)
  {
    while(h != none)
    {
      if(voronoi.number_of_labels(h / 3) == 3)
        return polyline.push_back(voronoi.triple_point(h / 3));
      const Index exit_halfedge =
          voronoi.is_crossed(next_halfedge(h)) ? next_halfedge(h) : previous_halfedge(h);
      polyline.push_back(voronoi.crossing_location(exit_halfedge));
      if(is_visited[exit_halfedge]) // the bisector is closed
        return;
      mark(exit_halfedge);
      h = reached_twin(exit_halfedge);
    }
  }
};

std::vector<Voronoi_diagram::Bisector> Voronoi_diagram::bisectors() const
{
  const Surface_arrays& t = *m_triangles;
  std::vector<Bisector> result;
  Bisector_tracer tracer{*this};
  // If the bisector enters through halfedge h, the cell of its source is on the left.
  const auto trace_inwards = [&](Index h)
  {
    tracer.mark(h);
    result.push_back(
        {m_labels[t.corner[h]], m_labels[t.corner[next_halfedge(h)]], {crossing_location(h)}});
    tracer.follow(h, result.back().polyline);
  };
  for(Index f = 0; f < t.number_of_triangles(); ++f)
    if(number_of_labels(f) == 3)
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        if(!tracer.is_visited[h])
        {
          tracer.mark(h);
          result.push_back({m_labels[t.corner[next_halfedge(h)]],
                            m_labels[t.corner[h]],
                            {triple_point(f), crossing_location(h)}});
          tracer.follow(tracer.reached_twin(h), result.back().polyline);
        }
  for(const bool is_loop : {false, true})
    for(Index h = 0; h < t.corner.size(); ++h)
      if(!tracer.is_visited[h] && number_of_labels(h / 3) > 0 && is_crossed(h) &&
         (is_loop || tracer.reached_twin(h) == none))
      {
        trace_inwards(h);
        result.back().is_closed = is_loop;
      }
  return result;
}

std::vector<Index> Voronoi_diagram::add_crossings(Cut_mesh& mesh) const
{
  const Surface_arrays& t = *m_triangles;
  std::vector<Index> result(t.corner.size(), none);
  for(Index h = 0; h < t.corner.size(); ++h)
    if(t.twin[h] < h)
      result[h] = result[t.twin[h]];
    else if(m_labels[t.corner[h]] != none && m_labels[t.corner[next_halfedge(h)]] != none &&
            is_crossed(h))
      result[h] = mesh.add_vertex(crossing_location(h));
  return result;
}

Voronoi_diagram::Cut_mesh Voronoi_diagram::cut() const
{
  const Surface_arrays& t = *m_triangles;
  Cut_mesh result;
  for(Index vertex = 0; vertex < m_labels.size(); ++vertex)
    result.vertices.push_back({none, vertex, {}});
  const std::vector<Index> crossing_vertex = add_crossings(result);

  const auto add_triangle = [&](Index a, Index b, Index c, Index label)
  {
    result.corners.insert(result.corners.end(), {a, b, c});
    result.labels.push_back(label);
  };
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const int number_of_cells = number_of_labels(f);
    const Index center = number_of_cells == 3 ? result.add_vertex(triple_point(f)) : none;
    bool is_uncut = true;
    for(Index right = 3 * f; right < 3 * f + 3; ++right)
    {
      // The corners are a, b and c, and the crossings are on the edges ab (right) and ca (left).
      const Index left = previous_halfedge(right);
      const Index a = t.corner[right], b = t.corner[next_halfedge(right)], c = t.corner[left];
      const Index label = number_of_cells > 0 ? m_labels[a] : none;
      if(crossing_vertex[right] == none)
        continue;
      is_uncut = false;
      if(number_of_cells == 3)
      {
        add_triangle(a, crossing_vertex[right], center, label);
        add_triangle(a, center, crossing_vertex[left], label);
      }
      else if(number_of_cells == 0)
      {
        add_triangle(a, crossing_vertex[right], c, none);
        add_triangle(crossing_vertex[right], b, c, none);
      }
      else if(crossing_vertex[left] != none)
      {
        add_triangle(a, crossing_vertex[right], crossing_vertex[left], label);
        add_triangle(crossing_vertex[right], b, c, m_labels[b]);
        add_triangle(crossing_vertex[right], c, crossing_vertex[left], m_labels[b]);
      }
    }
    if(is_uncut)
      add_triangle(t.corner[3 * f], t.corner[3 * f + 1], t.corner[3 * f + 2],
                   number_of_cells > 0 ? m_labels[t.corner[3 * f]] : none);
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
