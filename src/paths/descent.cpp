// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/descent.h"

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <unordered_map>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Calls f with each triangle that contains a canonical location.
template <typename Function>
void for_each_incident_triangle(const Surface_arrays& t, const Surface_location& location,
                                Function f)
{
  if(const Index vertex = vertex_of(t, location); vertex != none)
    for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
      f(t.ring[i] / 3);
  else
  {
    f(location.triangle);
    const Index h = halfedge_of(location);
    if(h != none && t.twin[h] != none)
      f(t.twin[h] / 3);
  }
}

// Dijkstra's algorithm on the edges of the vertices that it visits.
class Edge_search
{
public:
  // Records a path of edges to a vertex if it is shorter than the known one.
  //
  // from  the previous vertex of the path, or `none`
  void relax(Index vertex, double length, Index from)
  {
    const auto [entry, is_new] = m_visited.try_emplace(vertex, Visited_vertex{length, from});
    if(is_new || length < entry->second.length)
    {
      entry->second = {length, from};
      m_queue.emplace(length, vertex);
    }
  }
  // Relaxes along all edges of a vertex.
  void relax_edges(const Surface_arrays& t, Index vertex)
  {
    const double length = m_visited.find(vertex)->second.length;
    for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
    {
      const Index corner = t.ring[i], previous = previous_halfedge(corner);
      relax(t.corner[next_halfedge(corner)], length + t.length[corner], vertex);
      relax(t.corner[previous], length + t.length[previous], vertex);
    }
  }
  // Finalizes the closest vertex and returns it, or `none` if all visited vertices are final.
  Index finalize_next()
  {
    while(!m_queue.empty())
    {
      const Index vertex = m_queue.top().second;
      m_queue.pop();
      if(Visited_vertex& visited = m_visited.find(vertex)->second; !visited.is_final)
      {
        visited.is_final = true;
        return vertex;
      }
    }
    return none;
  }
  // Returns the vertices of the path to a vertex, in reverse order.
  std::vector<Index> reverse_path(Index vertex) const
  {
    std::vector<Index> result;
    for(; vertex != none; vertex = m_visited.find(vertex)->second.from)
      result.push_back(vertex);
    return result;
  }

private:
  struct Visited_vertex
  {
    double length;
    Index from;
    bool is_final = false;
  };
  using Entry = std::pair<double, Index>;

  std::unordered_map<Index, Visited_vertex> m_visited;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_queue;
};

} // namespace

Descent::Descent(const Surface_arrays& t, const std::vector<Front_source>& sources) : m_triangles(t)
{
  if(t.is_cloud())
    throw Unsupported_surface_error(
        "Gradient descent requires a mesh, because the triangles of a cloud are not connected.");
  for(Index s = 0; s < sources.size(); ++s)
  {
    const Front_source& source = sources[s];
    for(std::size_t i = 0; i < source.polyline.size(); ++i)
    {
      const Surface_location begin = canonical(t, source.polyline[i]);
      const Surface_location end =
          i + 1 < source.polyline.size() ? canonical(t, source.polyline[i + 1]) : begin;
      const auto add = [&](Index triangle)
      {
        const auto first = *barycentric_in(t, triangle, begin);
        m_pieces.push_back(
            {triangle, s, source.offset, first, barycentric_in(t, triangle, end).value_or(first)});
      };
      if(begin.triangle == none)
        m_isolated.emplace_back(begin.vertex, s);
      else
        for_each_incident_triangle(t, begin, add);
    }
    // The last location is added as a point, for triangles that do not contain the previous one.
    if(source.polyline.size() > 1)
    {
      const Surface_location end = canonical(t, source.polyline.back());
      if(end.triangle != none)
        for_each_incident_triangle(t, end,
                                   [&](Index triangle)
                                   {
                                     const auto b = *barycentric_in(t, triangle, end);
                                     m_pieces.push_back({triangle, s, source.offset, b, b});
                                   });
    }
  }
  std::stable_sort(m_pieces.begin(), m_pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.triangle < b.triangle; });
}

// A path while it is traced.
struct Descent::Tracer
{
  const Descent& descent;
  const Surface_arrays& t;
  const std::function<double(Index)>& distance;
  Descent_path path;
  Surface_location current;
  double value = 0.;

  Tracer(const Descent& descent, const std::function<double(Index)>& distance)
      : descent(descent), t(descent.m_triangles), distance(distance)
  {}

  double interpolated_value(const Surface_location& location) const
  {
    double sum = 0.;
    for(Index k = 0; k < 3; ++k)
      if(location.barycentric[k] != 0.)
        sum += location.barycentric[k] * distance(t.corner[3 * location.triangle + k]);
    return sum;
  }

  // Returns the position of the first piece of a source in a triangle, if there is one.
  std::vector<Piece>::const_iterator first_piece(Index triangle) const
  {
    return std::lower_bound(descent.m_pieces.begin(), descent.m_pieces.end(), triangle,
                            [](const Piece& p, Index f) { return p.triangle < f; });
  }

  void move_to(const Surface_location& next)
  {
    current = next;
    value = interpolated_value(next);
    if(path.locations.empty() || !is_same_point(t, path.locations.back(), next))
      path.locations.push_back(next);
  }

  // Ends the path at the closest source in a triangle of the current location. If
  // `must_match_value`, the path ends only if the distance to the source is at most the value of
  // the field. Returns whether the path has ended.
  bool try_finish(bool must_match_value)
  {
    double best_distance = infinity;
    Surface_location end;
    Index source = none;
    const auto try_triangle = [&](Index triangle)
    {
      auto piece = first_piece(triangle);
      if(piece == descent.m_pieces.end() || piece->triangle != triangle)
        return;
      const auto corners = unfolded(t, triangle);
      const Vec2 x = unfolded_point(corners, *barycentric_in(t, triangle, current));
      for(; piece != descent.m_pieces.end() && piece->triangle == triangle; ++piece)
      {
        const Vec2 p = unfolded_point(corners, piece->begin);
        const Vec2 pq = unfolded_point(corners, piece->end) - p;
        const double square = dot(pq, pq);
        const double fraction = square > 0. ? std::clamp(dot(x - p, pq) / square, 0., 1.) : 0.;
        const double candidate = piece->offset + norm(p + fraction * pq - x);
        if(candidate < best_distance)
        {
          best_distance = candidate;
          source = piece->source;
          end.triangle = triangle;
          for(int k = 0; k < 3; ++k)
            end.barycentric[k] = piece->begin[k] + fraction * (piece->end[k] - piece->begin[k]);
        }
      }
    };
    for_each_incident_triangle(t, current, try_triangle);
    // Interpolated distances exceed exact ones. The tolerance is for approximate fields.
    if(source == none || (must_match_value && !(best_distance <= value * (1. + 1e-6))))
      return false;
    end = canonical(t, end);
    if(!is_same_point(t, path.locations.back(), end))
      path.locations.push_back(end);
    path.source = source;
    return true;
  }

  struct Step
  {
    Surface_location to;
    double slope = 0.;
  };

  // Replaces the best step if another one decreases the field and is steeper.
  void consider_step(Step& best, const Surface_location& to, double length) const
  {
    const double drop = value - interpolated_value(to);
    if(!(drop > 0.))
      return;
    const double slope = length > 0. ? drop / length : infinity;
    if(slope > best.slope)
      best = {to, slope};
  }

  // Considers the steps to the corners of a triangle and, unless `vertices_only`, the step along
  // the negative gradient to the triangle's boundary.
  void consider_steps(Step& best, Index triangle, bool vertices_only) const
  {
    const auto barycentric = *barycentric_in(t, triangle, current);
    const auto corners = unfolded(t, triangle);
    const Vec2 x = unfolded_point(corners, barycentric);
    std::array<double, 3> values;
    for(Index k = 0; k < 3; ++k)
    {
      values[k] = distance(t.corner[3 * triangle + k]);
      Surface_location corner;
      corner.triangle = triangle;
      corner.barycentric = barycentric_at_corner(3 * triangle + k);
      if(barycentric[k] != 1.)
        consider_step(best, corner, norm(corners[k] - x));
    }
    if(!vertices_only && std::isfinite(values[0] + values[1] + values[2]) && corners[2][1] > 0.)
      consider_gradient_step(best, triangle, barycentric, corners, values);
  }

  // Considers the step along the negative gradient to the boundary of a triangle with positive
  // area.
  void consider_gradient_step(Step& best, Index triangle, const std::array<double, 3>& barycentric,
                              const std::array<Vec2, 3>& corners,
                              const std::array<double, 3>& values) const
  {
    const Vec2 x = unfolded_point(corners, barycentric);
    const double gradient_x = (values[1] - values[0]) / corners[1][0];
    const double gradient_y = (values[2] - values[0] - gradient_x * corners[2][0]) / corners[2][1];
    const Vec2 descent_direction = {-gradient_x, -gradient_y};
    for(Index k = 0; k < 3; ++k)
    {
      if(barycentric[(k + 2) % 3] == 0.)
      {
        // The location is on this edge: the descent direction must point inside.
        if(!(cross(corners[(k + 1) % 3] - corners[k], descent_direction) > 0.))
          return;
      }
    }
    for(Index k = 0; k < 3; ++k)
    {
      if(barycentric[(k + 2) % 3] == 0.)
        continue;
      const Vec2 edge = corners[(k + 1) % 3] - corners[k], to_corner = corners[k] - x;
      const double denominator = cross(descent_direction, edge);
      if(!(denominator > 0.))
        continue;
      const double fraction = -cross(descent_direction, to_corner) / denominator;
      if(!(fraction >= 0. && fraction <= 1.))
        continue;
      Surface_location to;
      to.triangle = triangle;
      // Snap to a close corner with a smaller value: it avoids many small steps around it.
      const double snap_fraction = 1e-4;
      if(fraction < snap_fraction && values[k] < value)
        to.barycentric = barycentric_at_corner(3 * triangle + k);
      else if(fraction > 1. - snap_fraction && values[(k + 1) % 3] < value)
        to.barycentric = barycentric_at_corner(3 * triangle + (k + 1) % 3);
      else
        to.barycentric = barycentric_on_halfedge(3 * triangle + k, fraction);
      consider_step(best, canonical(t, to), norm(to_corner + fraction * edge));
    }
  }

  // Returns whether an incident triangle of a vertex contains a source.
  bool has_incident_source(Index vertex) const
  {
    for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
    {
      const Index triangle = t.ring[i] / 3;
      const auto piece = first_piece(triangle);
      if(piece != descent.m_pieces.end() && piece->triangle == triangle)
        return true;
    }
    return false;
  }

  // Moves along the shortest path of edges to a vertex with a smaller value, or to one with a
  // source in an incident triangle. Returns false if there is no such vertex.
  bool escape_local_minimum()
  {
    Edge_search search;
    const Index start_vertex = vertex_of(t, current);
    if(start_vertex != none)
      search.relax(start_vertex, 0., none);
    else
      for_each_incident_triangle(
          t, current,
          [&](Index triangle)
          {
            const auto barycentric = *barycentric_in(t, triangle, current);
            for(Index c = 3 * triangle; c < 3 * triangle + 3; ++c)
              search.relax(t.corner[c],
                           distance_in_triangle(t, triangle, barycentric, barycentric_at_corner(c)),
                           none);
          });
    for(Index vertex = search.finalize_next(); vertex != none; vertex = search.finalize_next())
    {
      if(distance(vertex) < value || has_incident_source(vertex))
      {
        const std::vector<Index> vertices = search.reverse_path(vertex);
        for(auto v = vertices.rbegin(); v != vertices.rend(); ++v)
          move_to(vertex_location(t, *v));
        return true;
      }
      search.relax_edges(t, vertex);
    }
    return false;
  }

  // Returns the corner vertex with the smallest sum of its value and its distance from the
  // location, or `none` if all values are infinite.
  Index closest_finite_corner(const Surface_location& from) const
  {
    double best = infinity;
    Index start_vertex = none;
    for_each_incident_triangle(t, from,
                               [&](Index triangle)
                               {
                                 const auto barycentric = *barycentric_in(t, triangle, from);
                                 for(Index c = 3 * triangle; c < 3 * triangle + 3; ++c)
                                 {
                                   const double candidate =
                                       distance(t.corner[c]) +
                                       distance_in_triangle(t, triangle, barycentric,
                                                            barycentric_at_corner(c));
                                   if(candidate < best)
                                   {
                                     best = candidate;
                                     start_vertex = t.corner[c];
                                   }
                                 }
                               });
    return start_vertex;
  }

  // Traces the path. Returns whether it reaches a source.
  bool run(const Surface_location& from)
  {
    move_to(from);
    if(!std::isfinite(value))
    {
      const Index start_vertex = closest_finite_corner(from);
      if(start_vertex == none)
        return try_finish(false);
      move_to(vertex_location(t, start_vertex));
    }
    // The decrease of a step across a triangle has no positive lower bound. After more steps than
    // the mesh has halfedges, only steps to vertices are made, which guarantees termination.
    for(std::size_t number_of_steps = 0;; ++number_of_steps)
    {
      if(try_finish(true))
        return true;
      Step best;
      for_each_incident_triangle(
          t, current,
          [&](Index triangle)
          { consider_steps(best, triangle, number_of_steps > t.corner.size()); });
      if(best.slope > 0.)
        move_to(best.to);
      else if(try_finish(false))
        return true;
      else
      {
        const double previous_value = value;
        if(!escape_local_minimum())
          return false;
        if(!(value < previous_value))
          return try_finish(false);
      }
    }
  }
};

Descent_path Descent::operator()(const Surface_location& from,
                                 const std::function<double(Index)>& distance) const
{
  const Surface_location begin = canonical(m_triangles, from);
  if(begin.triangle == none)
  {
    // An isolated vertex is reached only if it is a source.
    for(const auto& [vertex, source] : m_isolated)
      if(vertex == begin.vertex)
        return {{begin}, source};
    return {};
  }
  Tracer tracer(*this, distance);
  if(!tracer.run(begin))
    return {};
  return std::move(tracer.path);
}

} // namespace CGAL::Geodesic_processing::internal
