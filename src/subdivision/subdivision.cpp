// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/subdivision/subdivision.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Level = Subdivision::Level;

constexpr std::size_t max_number_of_halfedges = std::size_t(1) << 31;

// Throws if a triangle has equal corners, or corners that are not below number_of_vertices.
void check_corners(const std::vector<Triangle>& triangles, Index number_of_vertices)
{
  for(const auto& [a, b, c] : triangles)
  {
    if(a >= number_of_vertices || b >= number_of_vertices || c >= number_of_vertices)
      throw Invalid_argument_error("A triangle refers to a vertex that does not exist.");
    if(a == b || b == c || c == a)
      throw Invalid_argument_error("A triangle refers to a vertex twice.");
  }
}

// Checks that two vertices have at most one common edge: midpoints are identified by their parents.
void check_edges(const Level& level)
{
  std::vector<std::array<Index, 2>> edges;
  for(Index h = 0; h < level.twin.size(); ++h)
    if(is_edge_representative(level, h))
    {
      const auto [a, b] = edge_vertices(level, h);
      edges.push_back({std::min(a, b), std::max(a, b)});
    }
  std::sort(edges.begin(), edges.end());
  const auto twice = std::adjacent_find(edges.begin(), edges.end());
  if(twice != edges.end())
    throw Invalid_argument_error("Vertices " + std::to_string((*twice)[0]) + " and " +
                                 std::to_string((*twice)[1]) +
                                 " have more than one edge, or their edge has more than two "
                                 "triangles or inconsistent orientations.");
}

// Checks the triangles and computes their twins.
Level coarsest_level(const std::vector<Triangle>& triangles, Index number_of_vertices)
{
  check_corners(triangles, number_of_vertices);
  std::vector<Index> corners;
  corners.reserve(3 * triangles.size());
  for(const Triangle& t : triangles)
    corners.insert(corners.end(), t.begin(), t.end());
  Level result;
  result.number_of_vertices = number_of_vertices;
  result.triangles = triangles;
  result.twin = twins_of_soup(number_of_vertices, corners);
  check_edges(result);
  return result;
}

// Numbers the midpoints of the edges and appends their parents.
void add_midpoints(Level& level, std::vector<std::array<Index, 2>>& parents)
{
  level.midpoint.resize(level.twin.size());
  for(Index h = 0; h < level.twin.size(); ++h)
    if(is_edge_representative(level, h))
    {
      level.midpoint[h] = Index(parents.size());
      parents.push_back(edge_vertices(level, h));
    }
    else
      level.midpoint[h] = level.midpoint[level.twin[h]];
}

// These functions return the halves of a halfedge. The halves belong to the children at its source
// and at its target. They are edge h % 3 of these triangles, as h is in its triangle.
Index first_half(Index h) { return 3 * (4 * (h / 3) + h % 3) + h % 3; }
Index second_half(Index h) { return 3 * (4 * (h / 3) + (h + 1) % 3) + h % 3; }

// Splits each triangle into four. Computes the twins from those of the level, without a search.
Level refined_level(const Level& level)
{
  Level result;
  result.triangles.reserve(4 * level.triangles.size());
  result.twin.resize(4 * level.twin.size());
  for(Index f = 0; f < level.triangles.size(); ++f)
  {
    const auto [a, b, c] = level.triangles[f];
    const Index* m = &level.midpoint[3 * f];
    result.triangles.insert(
        result.triangles.end(),
        {{a, m[0], m[2]}, {m[0], b, m[1]}, {m[2], m[1], c}, {m[1], m[2], m[0]}});
    for(Index k = 0; k < 3; ++k)
    {
      const Index h = 3 * f + k, twin = level.twin[h];
      result.twin[first_half(h)] = twin == none ? none : second_half(twin);
      result.twin[second_half(h)] = twin == none ? none : first_half(twin);
      // The edge that child k shares with the central child.
      const Index outer = 3 * (4 * f + k) + (k + 1) % 3, inner = 3 * (4 * f + 3) + (k + 1) % 3;
      result.twin[outer] = inner;
      result.twin[inner] = outer;
    }
  }
  return result;
}

// Throws if the subdivision would have too many halfedges for 32-bit indices.
void check_size(std::size_t triangles, unsigned times)
{
  std::size_t number_of_halfedges = 3 * std::max<std::size_t>(triangles, 1);
  for(unsigned i = 0; i < times && number_of_halfedges < max_number_of_halfedges; ++i)
    number_of_halfedges *= 4;
  if(number_of_halfedges >= max_number_of_halfedges)
    throw Invalid_argument_error("The subdivision would have 2^31 halfedges or more.");
}

} // namespace

bool is_halfedge_mesh(const Level& level)
{
  std::vector<Index> number_of_fans(level.number_of_vertices, 0),
      number_of_rings(level.number_of_vertices, 0);
  std::vector<bool> is_visited(level.twin.size(), false);
  for(Index h = 0; h < level.twin.size(); ++h)
  {
    const Index v = source_vertex(level, h);
    number_of_fans[v] += level.twin[h] == none; // an open fan has one such halfedge
    if(is_visited[h])
      continue;
    // Rotate around the vertex, until the fan closes or ends at the boundary.
    Index current = h;
    while(current != none && !is_visited[current])
    {
      is_visited[current] = true;
      current = level.twin[previous_halfedge(current)];
    }
    number_of_rings[v] += current == h;
  }
  for(Index v = 0; v < level.number_of_vertices; ++v)
    if(number_of_rings[v] > 0 && number_of_rings[v] + number_of_fans[v] > 1)
      return false;
  return true;
}

Subdivision subdivide(const std::vector<Triangle>& triangles, Index number_of_vertices,
                      unsigned times)
{
  check_size(triangles.size(), times);
  Subdivision result;
  result.levels.push_back(coarsest_level(triangles, number_of_vertices));
  for(Index v = 0; v < number_of_vertices; ++v)
    result.parents.push_back({v, v});
  for(unsigned i = 0; i < times; ++i)
    subdivide(result);
  return result;
}

void subdivide(Subdivision& subdivision)
{
  check_size(subdivision.finest().triangles.size(), 1);
  add_midpoints(subdivision.levels.back(), subdivision.parents);
  subdivision.levels.push_back(refined_level(subdivision.levels.back()));
  subdivision.levels.back().number_of_vertices = Index(subdivision.parents.size());
}

std::vector<Coarse_location> coarse_locations(const Subdivision& subdivision)
{
  const std::size_t times = subdivision.levels.size() - 1;
  const std::vector<Triangle>& base = subdivision.levels.front().triangles;
  std::vector<Coarse_location> result(subdivision.number_of_vertices());
  // Barycentric coordinates of the corners of each triangle of the current level.
  using Coordinates = std::array<Index, 3>;
  std::vector<std::array<Coordinates, 3>> corners(base.size());
  const Index denominator = Index(1) << times;
  for(auto& c : corners)
    c = {Coordinates{denominator, 0, 0}, Coordinates{0, denominator, 0},
         Coordinates{0, 0, denominator}};
  for(std::size_t j = 0;; ++j)
  {
    const std::vector<Triangle>& triangles = subdivision.levels[j].triangles;
    for(Index f = 0; f < triangles.size(); ++f)
      for(int k = 0; k < 3; ++k)
        if(Coarse_location& location = result[triangles[f][k]]; location.triangle == none)
          location = {f >> (2 * j), corners[f][k]};
    if(j == times)
      return result;
    std::vector<std::array<Coordinates, 3>> children;
    children.reserve(4 * corners.size());
    for(const auto& [a, b, c] : corners)
    {
      const auto midpoint = [](const Coordinates& p, const Coordinates& q) {
        return Coordinates{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2};
      };
      const Coordinates m0 = midpoint(a, b), m1 = midpoint(b, c), m2 = midpoint(c, a);
      children.insert(children.end(), {{a, m0, m2}, {m0, b, m1}, {m2, m1, c}, {m1, m2, m0}});
    }
    corners = std::move(children);
  }
}

namespace {

using Coordinates = std::array<Index, 3>; // barycentric, times the common denominator

// Builds a subdivision into quads level by level.
class Quad_subdivider
{
public:
  Quad_subdivider(const std::vector<Triangle>& triangles, Index number_of_vertices, unsigned levels)
      : m_triangles(triangles), m_denominator(Index(6) << (2 * (levels - 1))),
        m_unit({Coordinates{m_denominator, 0, 0}, {0, m_denominator, 0}, {0, 0, m_denominator}})
  {
    m_base.levels.push_back(coarsest_level(triangles, number_of_vertices));
    for(Index v = 0; v < number_of_vertices; ++v)
      m_base.parents.push_back({v, v});
    add_midpoints(m_base.levels.front(), m_base.parents);
    add_base_vertices(number_of_vertices);
    split_triangles();
    add_level();
  }

  // Splits each quad into four.
  void refine()
  {
    const std::vector<std::array<Index, 4>> midpoints = add_edge_midpoints();
    std::vector<Quad> finer;
    std::vector<std::array<Coordinates, 4>> finer_corners;
    for(std::size_t q = 0; q < m_quads.size(); ++q)
    {
      const auto& p = m_corners[q];
      const Index center =
          add_vertex({m_quads[q].begin(), m_quads[q].end()}, triangle_of(q), {p.begin(), p.end()});
      const Coordinates& center_coordinates = m_result.locations[center].coordinates;
      for(int k = 0; k < 4; ++k)
      {
        const int before = (k + 3) % 4, after = (k + 1) % 4, across = (k + 2) % 4;
        Quad child;
        child[k] = m_quads[q][k];
        child[after] = midpoints[q][k];
        child[across] = center;
        child[before] = midpoints[q][before];
        finer.push_back(child);
        std::array<Coordinates, 4> locations;
        locations[k] = p[k];
        locations[after] = midpoint(p[k], p[after]);
        locations[across] = center_coordinates;
        locations[before] = midpoint(p[before], p[k]);
        finer_corners.push_back(locations);
      }
    }
    m_quads = std::move(finer);
    m_corners = std::move(finer_corners);
    m_quads_per_triangle *= 4;
    add_level();
  }

  Quad_subdivision result() { return std::move(m_result); }

private:
  // Returns the midpoint. It is exact, because the denominator has enough factors of two.
  static Coordinates midpoint(const Coordinates& p, const Coordinates& q)
  {
    Coordinates result;
    for(int i = 0; i < 3; ++i)
      result[i] = Index((std::size_t(p[i]) + q[i]) / 2);
    return result;
  }

  // Returns the base triangle that contains a quad: quads of one triangle are consecutive.
  Index triangle_of(std::size_t quad) const { return Index(quad / m_quads_per_triangle); }

  // Adds the centroid of its parents, whose coordinates in a base triangle are given.
  Index add_vertex(std::vector<Index> parents, Index triangle,
                   const std::vector<Coordinates>& coordinates)
  {
    std::array<std::size_t, 3> sum = {0, 0, 0};
    for(const auto& c : coordinates)
      for(int k = 0; k < 3; ++k)
        sum[k] += c[k];
    Coarse_location location{triangle, {}};
    for(int k = 0; k < 3; ++k)
      location.coordinates[k] = Index(sum[k] / coordinates.size());
    m_result.locations.push_back(location);
    m_result.parents.push_back(std::move(parents));
    return Index(m_result.parents.size() - 1);
  }

  // Appends the current quads as a level of the result.
  void add_level()
  {
    m_result.levels.push_back(m_quads);
    m_result.number_of_vertices.push_back(Index(m_result.parents.size()));
  }

  // Adds the vertices of the triangles and the midpoints of their edges.
  void add_base_vertices(Index number_of_vertices)
  {
    m_result.parents.resize(number_of_vertices);
    m_result.locations.resize(number_of_vertices);
    for(Index f = 0; f < m_triangles.size(); ++f)
      for(int k = 0; k < 3; ++k)
        if(Coarse_location& location = m_result.locations[m_triangles[f][k]];
           location.triangle == none)
          location = {f, m_unit[k]};
    const Level& level = m_base.levels.front();
    for(Index h = 0; h < level.twin.size(); ++h)
      if(is_edge_representative(level, h))
      {
        const auto [a, b] = edge_vertices(level, h);
        add_vertex({a, b}, h / 3, {m_unit[h % 3], m_unit[(h + 1) % 3]});
      }
  }

  // Splits each triangle into three quads.
  void split_triangles()
  {
    const std::vector<Index>& midpoints = m_base.levels.front().midpoint;
    for(Index f = 0; f < m_triangles.size(); ++f)
    {
      const Triangle& t = m_triangles[f];
      const Index center = add_vertex({t[0], t[1], t[2]}, f, {m_unit[0], m_unit[1], m_unit[2]});
      const Coordinates& center_coordinates = m_result.locations[center].coordinates;
      for(int k = 0; k < 3; ++k)
      {
        const int before = (k + 2) % 3;
        m_quads.push_back({t[k], midpoints[3 * f + k], center, midpoints[3 * f + before]});
        m_corners.push_back({m_unit[k], midpoint(m_unit[k], m_unit[(k + 1) % 3]),
                             center_coordinates, midpoint(m_unit[before], m_unit[k])});
      }
    }
  }

  // Adds the midpoints of all edges. Returns those of the four edges of each quad.
  std::vector<std::array<Index, 4>> add_edge_midpoints()
  {
    std::map<std::array<Index, 2>, Index> edge_midpoint;
    std::vector<std::array<Index, 4>> result(m_quads.size());
    for(std::size_t q = 0; q < m_quads.size(); ++q)
      for(int k = 0; k < 4; ++k)
      {
        const Index a = m_quads[q][k], b = m_quads[q][(k + 1) % 4];
        const auto [it, is_new] = edge_midpoint.try_emplace({std::min(a, b), std::max(a, b)}, none);
        if(is_new)
          it->second =
              add_vertex({a, b}, triangle_of(q), {m_corners[q][k], m_corners[q][(k + 1) % 4]});
        result[q][k] = it->second;
      }
    return result;
  }

  const std::vector<Triangle>& m_triangles;
  Index m_denominator;
  std::array<Coordinates, 3> m_unit; // of the corners of a triangle
  Subdivision m_base;
  Quad_subdivision m_result;
  std::vector<Quad> m_quads; // of the finest level
  std::vector<std::array<Coordinates, 4>>
      m_corners; // #quads: coordinates of the corners in the base triangle of the quad
  std::size_t m_quads_per_triangle = 3;
};

} // namespace

Quad_subdivision subdivide_into_quads(const std::vector<Triangle>& triangles,
                                      Index number_of_vertices, unsigned levels)
{
  if(levels == 0)
    throw Invalid_argument_error("A subdivision into quads must have at least one level.");
  check_size(triangles.size(), levels);
  Quad_subdivider subdivider(triangles, number_of_vertices, levels);
  for(unsigned level = 1; level < levels; ++level)
    subdivider.refine();
  return subdivider.result();
}

} // namespace CGAL::Geodesic_processing::internal
