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

void check_corners(const std::vector<Triangle>& triangles, Index number_of_vertices)
{
  for(const auto& [a, b, c] : triangles)
  {
    if(a >= number_of_vertices || b >= number_of_vertices || c >= number_of_vertices)
      throw Invalid_argument_error("A triangle names a vertex that there is not.");
    if(a == b || b == c || c == a)
      throw Invalid_argument_error("A triangle names a vertex twice.");
  }
}

// A midpoint belongs to two vertices, so these have one edge.
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
    throw Invalid_argument_error(
        "Vertices " + std::to_string((*twice)[0]) + " and " + std::to_string((*twice)[1]) +
        " are joined by an edge of more than two triangles, or of two that "
        "are not oriented alike.");
}

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

// Numbers the midpoints.
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

// The halves of a side belong to the children at its ends, and keep its place among the sides there.
Index first_half(Index h) { return 3 * (4 * (h / 3) + h % 3) + h % 3; }
Index second_half(Index h) { return 3 * (4 * (h / 3) + (h + 1) % 3) + h % 3; }

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
      // The middle child's side, which ends where child k has its third midpoint.
      const Index outer = 3 * (4 * f + k) + (k + 1) % 3, inner = 3 * (4 * f + 3) + (k + 1) % 3;
      result.twin[outer] = inner;
      result.twin[inner] = outer;
    }
  }
  return result;
}

void check_size(std::size_t triangles, unsigned times)
{
  std::size_t number_of_halfedges = 3 * std::max<std::size_t>(triangles, 1);
  for(unsigned i = 0; i < times && number_of_halfedges < max_number_of_halfedges; ++i)
    number_of_halfedges *= 4;
  if(number_of_halfedges >= max_number_of_halfedges)
    throw Invalid_argument_error("So many subdivisions make more than 2^31 sides.");
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
    number_of_fans[v] += level.twin[h] == none; // each fan ends with such a side
    if(is_visited[h])
      continue;
    // All around a vertex, unless there is a border.
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
  // Of the corners of each triangle of a level.
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

// Vertices of quads, each the centre of those that it stems from.
struct Quad_builder
{
  Quad_subdivision& result;

  // With its place in a base triangle, in whose coordinates those of its parents are given.
  Index add(std::vector<Index> parents, Index triangle,
            const std::vector<std::array<Index, 3>>& coordinates)
  {
    std::array<std::size_t, 3> sum = {0, 0, 0};
    for(const auto& c : coordinates)
      for(int k = 0; k < 3; ++k)
        sum[k] += c[k];
    Coarse_location location{triangle, {}};
    for(int k = 0; k < 3; ++k)
      location.coordinates[k] = Index(sum[k] / coordinates.size());
    result.locations.push_back(location);
    result.parents.push_back(std::move(parents));
    return Index(result.parents.size() - 1);
  }
};

} // namespace

Quad_subdivision subdivide_into_quads(const std::vector<Triangle>& triangles,
                                      Index number_of_vertices, unsigned levels)
{
  if(levels == 0)
    throw Invalid_argument_error("A subdivision into quads has one level at least.");
  check_size(triangles.size(), levels);
  Subdivision coarse;
  coarse.levels.push_back(coarsest_level(triangles, number_of_vertices));
  for(Index v = 0; v < number_of_vertices; ++v)
    coarse.parents.push_back({v, v});
  Level& base = coarse.levels.front();
  add_midpoints(base, coarse.parents);

  Quad_subdivision result;
  Quad_builder builder{result};
  using Coordinates = std::array<Index, 3>;
  const Index denominator = Index(6) << (2 * (levels - 1));
  result.parents.resize(number_of_vertices);
  result.locations.resize(number_of_vertices);
  const std::array<Coordinates, 3> unit = {
      Coordinates{denominator, 0, 0}, {0, denominator, 0}, {0, 0, denominator}};
  for(Index f = 0; f < triangles.size(); ++f)
    for(int k = 0; k < 3; ++k)
      if(Coarse_location& location = result.locations[triangles[f][k]]; location.triangle == none)
        location = {f, unit[k]};
  for(Index h = 0; h < base.twin.size(); ++h)
    if(is_edge_representative(base, h))
    {
      const auto [a, b] = edge_vertices(base, h);
      builder.add({a, b}, h / 3, {unit[h % 3], unit[(h + 1) % 3]});
    }
  // The quads of triangle f, now and later, are a block: their corners' coordinates are in f.
  std::vector<std::array<Coordinates, 4>> corners;
  std::vector<Quad> quads;
  for(Index f = 0; f < triangles.size(); ++f)
  {
    const Triangle& t = triangles[f];
    const Index center = builder.add({t[0], t[1], t[2]}, f, {unit[0], unit[1], unit[2]});
    const Coordinates& center_coordinates = result.locations[center].coordinates;
    const auto midpoint = [&](int k)
    {
      Coordinates c = {0, 0, 0};
      c[k] = c[(k + 1) % 3] = denominator / 2;
      return c;
    };
    for(int k = 0; k < 3; ++k)
    {
      const int before = (k + 2) % 3;
      quads.push_back({t[k], base.midpoint[3 * f + k], center, base.midpoint[3 * f + before]});
      corners.push_back({unit[k], midpoint(k), center_coordinates, midpoint(before)});
    }
  }
  result.levels.push_back(quads);
  result.number_of_vertices.push_back(Index(result.parents.size()));

  for(unsigned level = 1; level < levels; ++level)
  {
    const std::size_t per_triangle = std::size_t(3) << (2 * (level - 1));
    std::map<std::array<Index, 2>, Index> edge_midpoint;
    std::vector<std::array<Index, 4>> midpoints(quads.size());
    for(std::size_t q = 0; q < quads.size(); ++q)
      for(int k = 0; k < 4; ++k)
      {
        const Index a = quads[q][k], b = quads[q][(k + 1) % 4];
        const auto [it, is_new] = edge_midpoint.try_emplace({std::min(a, b), std::max(a, b)}, none);
        if(is_new)
          it->second = builder.add({a, b}, Index(q / per_triangle),
                                   {corners[q][k], corners[q][(k + 1) % 4]});
        midpoints[q][k] = it->second;
      }
    std::vector<Quad> finer;
    std::vector<std::array<Coordinates, 4>> finer_corners;
    for(std::size_t q = 0; q < quads.size(); ++q)
    {
      const auto& p = corners[q];
      const Index center = builder.add({quads[q].begin(), quads[q].end()}, Index(q / per_triangle),
                                       {p.begin(), p.end()});
      const Coordinates& center_coordinates = result.locations[center].coordinates;
      const auto midpoint = [&](int k)
      {
        Coordinates c;
        for(int i = 0; i < 3; ++i)
          c[i] = Index((std::size_t(p[k][i]) + p[(k + 1) % 4][i]) / 2);
        return c;
      };
      for(int k = 0; k < 4; ++k)
      {
        const int before = (k + 3) % 4, after = (k + 1) % 4, across = (k + 2) % 4;
        Quad child;
        child[k] = quads[q][k];
        child[after] = midpoints[q][k];
        child[across] = center;
        child[before] = midpoints[q][before];
        finer.push_back(child);
        std::array<Coordinates, 4> locations;
        locations[k] = p[k];
        locations[after] = midpoint(k);
        locations[across] = center_coordinates;
        locations[before] = midpoint(before);
        finer_corners.push_back(locations);
      }
    }
    quads = std::move(finer);
    corners = std::move(finer_corners);
    result.levels.push_back(quads);
    result.number_of_vertices.push_back(Index(result.parents.size()));
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
