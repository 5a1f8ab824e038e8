// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/split_at_isolines.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The part of a triangle between two levels: at most two vertices on each of two isolines, and a
// corner between them. Each vertex has the edge to the next vertex.
struct Level_band
{
  struct Vertex
  {
    Index vertex;
    Index edge;
  };
  std::array<Vertex, 5> boundary;
  std::size_t size = 0;

  void append(Index vertex, Index edge) { boundary[size++] = {vertex, edge}; }

  // Removes edges between equal vertices.
  void remove_degenerate_edges()
  {
    std::size_t kept = 0;
    const Index first = boundary[0].vertex;
    for(std::size_t i = 0; i < size; ++i)
      if(boundary[i].vertex != (i + 1 < size ? boundary[i + 1].vertex : first))
        boundary[kept++] = boundary[i];
    size = kept;
  }

  // Reverses the orientation.
  void reverse()
  {
    const std::array<Vertex, 5> forward = boundary;
    for(std::size_t i = 0; i < size; ++i)
      boundary[i] = {forward[size - 1 - i].vertex, forward[(2 * size - 2 - i) % size].edge};
  }
};

class Isoline_splitter
{
public:
  Isoline_splitter(const Surface_arrays& triangles, const std::vector<double>& values,
                   std::vector<double> levels, Edge_interpolation interpolation)
      : m_triangles(triangles), m_values(values), m_interpolation(interpolation)
  {
    std::sort(levels.begin(), levels.end());
    m_label.push_back(0);
    for(std::size_t i = 0; i < levels.size(); ++i)
      if(i + 1 == levels.size() || levels[i] < levels[i + 1])
      {
        m_levels.push_back(levels[i]);
        m_label.push_back(static_cast<Index>(i + 1));
      }
    m_rank.reserve(values.size());
    for(const double value : values)
      m_rank.push_back(
          std::isfinite(value)
              ? static_cast<Index>(std::upper_bound(m_levels.begin(), m_levels.end(), value) -
                                   m_levels.begin())
              : none);
  }

  Split_mesh_at_isolines split()
  {
    add_new_vertices();
    for(Index f = 0; f < m_triangles.number_of_triangles(); ++f)
    {
      const Index h = 3 * f, a = rank(h), b = rank(h + 1), c = rank(h + 2);
      if(a == none || b == none || c == none)
        split_without_values(f);
      else if(a == b && b == c)
      {
        m_label_of_part = m_label[a];
        add_triangle({m_triangles.corner[h], m_first_edge[h]},
                     {m_triangles.corner[h + 1], m_first_edge[h + 1]},
                     {m_triangles.corner[h + 2], m_first_edge[h + 2]});
      }
      else
        split_at_levels(f);
    }
    for(const Index edge : m_isoline_edges)
      m_result.isoline_halfedges.push_back(m_first_halfedge[edge]);
    return std::move(m_result);
  }

private:
  // Returns the number of different levels that are at most the value at the source of a halfedge,
  // or none if the value is not finite.
  Index rank(Index h) const { return m_rank[m_triangles.corner[h]]; }
  Index rank_at_target(Index h) const { return rank(next_halfedge(h)); }

  bool has_level(Index v) const { return m_rank[v] > 0 && m_levels[m_rank[v] - 1] == m_values[v]; }

  // Returns the number of new vertices on the edge of a halfedge.
  Index number_of_new_vertices(Index h) const
  {
    Index low = rank(h), high = rank_at_target(h);
    if(low == high || low == none || high == none)
      return 0;
    const bool is_rising = low < high;
    if(!is_rising)
      std::swap(low, high);
    return high - low - (has_level(m_triangles.corner[is_rising ? next_halfedge(h) : h]) ? 1 : 0);
  }

  // Adds the new vertices of all edges, numbers the parts of all edges, and reserves the triangles:
  // a new vertex adds one triangle in each triangle of its edge.
  void add_new_vertices()
  {
    const Index number_of_halfedges = static_cast<Index>(m_triangles.corner.size());
    std::uint64_t number_of_vertices = m_values.size(), number_of_edges = 0;
    std::uint64_t number_of_triangles = m_triangles.number_of_triangles();
    m_first_new_vertex.assign(number_of_halfedges, none);
    m_first_edge.assign(number_of_halfedges, none);
    for(Index h = 0; h < number_of_halfedges; ++h)
    {
      const Index number = number_of_new_vertices(h), twin = m_triangles.twin[h];
      number_of_triangles += number;
      if(number_of_triangles > (std::uint64_t(1) << 31) / 3)
        throw Invalid_argument_error("The split mesh has more than 2^31 halfedges.");
      if(twin != none && twin < h)
      {
        m_first_new_vertex[h] = m_first_new_vertex[twin];
        m_first_edge[h] = m_first_edge[twin];
        continue;
      }
      m_first_new_vertex[h] = static_cast<Index>(number_of_vertices);
      m_first_edge[h] = static_cast<Index>(number_of_edges);
      number_of_vertices += number;
      number_of_edges += number + 1;
    }
    m_result.new_vertices.reserve(number_of_vertices - m_values.size());
    m_points.reserve(number_of_vertices - m_values.size());
    for(Index h = 0; h < number_of_halfedges; ++h)
      if(m_triangles.twin[h] == none || h < m_triangles.twin[h])
        add_new_vertices(h);
    m_first_halfedge.assign(number_of_edges, none);
    m_result.triangles.reserve(number_of_triangles);
    m_result.labels.reserve(number_of_triangles);
    m_result.twins.reserve(3 * number_of_triangles);
  }

  // Adds the new vertices of an edge, from the lower to the upper end.
  void add_new_vertices(Index h)
  {
    const bool is_rising = rank(h) < rank_at_target(h);
    const Index low = is_rising ? h : next_halfedge(h), high = is_rising ? next_halfedge(h) : h;
    const double lower = m_values[m_triangles.corner[low]];
    const double upper = m_values[m_triangles.corner[high]];
    const double length = m_triangles.scale * m_triangles.length[h];
    Surface_location location;
    location.triangle = h / 3;
    location.barycentric = {0., 0., 0.};
    double t = 0.;
    for(Index i = 0; i < number_of_new_vertices(h); ++i)
    {
      // Round-off errors of circular interpolation must not exchange new vertices.
      t = std::max(
          t, isoline_position(lower, upper, m_levels[rank(low) + i], length, m_interpolation));
      location.barycentric[low % 3] = 1. - t;
      location.barycentric[high % 3] = t;
      m_result.new_vertices.push_back(location);
      m_points.push_back(scaled_coordinates(m_triangles, location));
    }
  }

  // Returns the vertex at which an edge has a level, which is above its lower value and at most its
  // upper value. `low` and `high` are the corners at its ends, and h is its halfedge.
  Index vertex_at_level(Index h, Index low, Index high, Index level) const
  {
    const Index upper = m_triangles.corner[high];
    return level + 1 == rank(high) && has_level(upper) ? upper
                                                       : m_first_new_vertex[h] + level - rank(low);
  }

  // Returns the part of an edge between two levels. `low` is the corner at its lower end.
  Index edge_in_band(Index h, Index low, Index band_rank) const
  {
    return m_first_edge[h] + band_rank - rank(low);
  }

  Index new_edge()
  {
    m_first_halfedge.push_back(none);
    return static_cast<Index>(m_first_halfedge.size() - 1);
  }

  // Splits a triangle with three finite values, not all between the same levels.
  void split_at_levels(Index f)
  {
    Index low = 3 * f, high = 3 * f;
    for(Index corner = 3 * f + 1; corner < 3 * f + 3; ++corner)
    {
      if(rank(corner) < rank(low))
        low = corner;
      if(rank(corner) > rank(high))
        high = corner;
    }
    const Index middle = 3 * f + 3 - low % 3 - high % 3;
    const Index low_vertex = m_triangles.corner[low], high_vertex = m_triangles.corner[high];
    const Index middle_vertex = m_triangles.corner[middle];
    const bool is_middle_next = next_halfedge(low) == middle;
    // The halfedges of the edges between these corners
    const Index longest = is_middle_next ? high : low;
    const Index lower = is_middle_next ? low : middle, upper = is_middle_next ? middle : high;

    // The ends of the isoline below a band, on the longest edge and on one of the others, and the
    // edge between them
    Index p = low_vertex, q = low_vertex, isoline = none;
    for(Index band_rank = rank(low); band_rank <= rank(high); ++band_rank)
    {
      Level_band band;
      band.append(p, isoline);
      if(band_rank <= rank(middle))
        band.append(q, edge_in_band(lower, low, band_rank));
      if(band_rank == rank(middle))
        q = middle_vertex;
      if(band_rank >= rank(middle))
        band.append(q, edge_in_band(upper, middle, band_rank));
      p = q = high_vertex;
      if(band_rank < rank(high))
      {
        p = vertex_at_level(longest, low, high, band_rank);
        q = band_rank < rank(middle) ? vertex_at_level(lower, low, middle, band_rank)
                                     : vertex_at_level(upper, middle, high, band_rank);
        if(p != q)
        {
          // The isoline can be an edge of the triangle.
          isoline = p == high_vertex && q == middle_vertex ? m_first_edge[upper] : new_edge();
          m_isoline_edges.push_back(isoline);
        }
      }
      band.append(q, isoline);
      band.append(p, edge_in_band(longest, low, band_rank));
      band.remove_degenerate_edges();
      if(band.size < 3)
        continue;
      if(!is_middle_next)
        band.reverse();
      m_label_of_part = m_label[band_rank];
      triangulate(band);
    }
  }

  // Adds the triangles of a band. It is strictly convex, because it has at most two vertices on
  // each edge of its triangle. All triangulations of convex polygons of at most five vertices are
  // fans; that with the shortest diagonals avoids needles.
  void triangulate(const Level_band& band)
  {
    std::size_t apex = 0;
    const auto at = [&](std::size_t k) { return band.boundary[(apex + k) % band.size]; };
    if(band.size > 3)
    {
      double shortest = infinity;
      std::size_t best = 0;
      for(apex = 0; apex < band.size; ++apex)
      {
        double sum = 0.;
        for(std::size_t k = 2; k + 1 < band.size; ++k)
        {
          const Vec3 diagonal = point(at(k).vertex) - point(at(0).vertex);
          sum += dot(diagonal, diagonal);
        }
        if(sum < shortest)
        {
          shortest = sum;
          best = apex;
        }
      }
      apex = best;
    }
    Index edge = at(0).edge;
    for(std::size_t k = 2; k < band.size; ++k)
    {
      const Index last = k + 1 < band.size ? new_edge() : at(k).edge;
      add_triangle({at(0).vertex, edge}, at(k - 1), {at(k).vertex, last});
      edge = last;
    }
  }

  // Splits a triangle that has a vertex without a finite value, at the new vertices of the edge
  // between two finite values.
  void split_without_values(Index f)
  {
    m_label_of_part = none;
    Index h = 3 * f;
    while(rank(previous_halfedge(h)) != none)
      ++h;
    const Index apex = m_triangles.corner[previous_halfedge(h)];
    const Index number = number_of_new_vertices(h);
    const bool is_rising = rank(h) < rank_at_target(h);
    Index edge = m_first_edge[previous_halfedge(h)], from = m_triangles.corner[h];
    for(Index i = 0; i <= number; ++i)
    {
      const bool is_last = i == number;
      const Index to = is_last ? m_triangles.corner[next_halfedge(h)]
                               : m_first_new_vertex[h] + (is_rising ? i : number - 1 - i);
      const Index next = is_last ? m_first_edge[next_halfedge(h)] : new_edge();
      add_triangle({apex, edge}, {from, m_first_edge[h] + (is_rising ? i : number - i)},
                   {to, next});
      edge = next;
      from = to;
    }
  }

  // Adds a triangle with the edges that leave its corners.
  void add_triangle(const Level_band::Vertex& a, const Level_band::Vertex& b,
                    const Level_band::Vertex& c)
  {
    m_result.triangles.push_back({a.vertex, b.vertex, c.vertex});
    m_result.labels.push_back(m_label_of_part);
    for(const Index edge : {a.edge, b.edge, c.edge})
    {
      const Index h = static_cast<Index>(m_result.twins.size()), twin = m_first_halfedge[edge];
      m_result.twins.push_back(twin);
      if(twin == none)
        m_first_halfedge[edge] = h;
      else
        m_result.twins[twin] = h;
    }
  }

  // Returns the scaled coordinates of a vertex.
  const Vec3& point(Index v) const
  {
    return v < m_values.size() ? m_triangles.point[v] : m_points[v - m_values.size()];
  }

  const Surface_arrays& m_triangles;
  const std::vector<double>& m_values;
  Edge_interpolation m_interpolation;
  std::vector<double> m_levels; // different levels, increasing
  std::vector<Index> m_label;   // #levels + 1: of the values below each level, and above all
  std::vector<Index> m_rank;    // #vertices, see rank()
  // 3 #triangles: the first of the new vertices and of the parts of the edge of a halfedge. Both
  // are numbered from the lower to the upper end
  std::vector<Index> m_first_new_vertex, m_first_edge;
  std::vector<Vec3> m_points; // #new vertices: scaled coordinates
  // #edges of the result: the first of its halfedges that was added, or none
  std::vector<Index> m_first_halfedge;
  std::vector<Index> m_isoline_edges;
  Index m_label_of_part = none;
  Split_mesh_at_isolines m_result;
};

} // namespace

Split_mesh_at_isolines split_at_isolines(const Surface_arrays& triangles,
                                         const std::vector<double>& values,
                                         const std::vector<double>& levels,
                                         Edge_interpolation interpolation)
{
  return Isoline_splitter(triangles, values, levels, interpolation).split();
}

} // namespace CGAL::Geodesic_processing::internal
