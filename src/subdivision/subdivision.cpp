// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/subdivision/subdivision.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/mesh/glue.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Level = Subdivision::Level;

constexpr std::size_t most_sides = std::size_t(1) << 31;

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
  for(Index side = 0; side < level.twin.size(); ++side)
    if(is_first_of_edge(level, side))
    {
      const auto [a, b] = ends(level, side);
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

Level coarsest(const std::vector<Triangle>& triangles, Index number_of_vertices)
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
  for(Index side = 0; side < level.twin.size(); ++side)
    if(is_first_of_edge(level, side))
    {
      level.midpoint[side] = Index(parents.size());
      parents.push_back(ends(level, side));
    }
    else
      level.midpoint[side] = level.midpoint[level.twin[side]];
}

// The halves of a side belong to the children at its ends, and keep its place among the sides there.
Index first_half(Index side) { return 3 * (4 * (side / 3) + side % 3) + side % 3; }
Index second_half(Index side) { return 3 * (4 * (side / 3) + (side + 1) % 3) + side % 3; }

Level finer(const Level& level)
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
      const Index side = 3 * f + k, twin = level.twin[side];
      result.twin[first_half(side)] = twin == none ? none : second_half(twin);
      result.twin[second_half(side)] = twin == none ? none : first_half(twin);
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
  std::size_t sides = 3 * std::max<std::size_t>(triangles, 1);
  for(unsigned i = 0; i < times && sides < most_sides; ++i)
    sides *= 4;
  if(sides >= most_sides)
    throw Invalid_argument_error("So many subdivisions make more than 2^31 sides.");
}

} // namespace

bool is_mesh(const Level& level)
{
  std::vector<Index> fans(level.number_of_vertices, 0), rings(level.number_of_vertices, 0);
  std::vector<bool> is_seen(level.twin.size(), false);
  for(Index side = 0; side < level.twin.size(); ++side)
  {
    const Index v = corner(level, side);
    fans[v] += level.twin[side] == none; // each fan ends with such a side
    if(is_seen[side])
      continue;
    // All around a vertex, unless there is a border.
    Index at = side;
    while(at != none && !is_seen[at])
    {
      is_seen[at] = true;
      at = level.twin[previous_side(at)];
    }
    rings[v] += at == side;
  }
  for(Index v = 0; v < level.number_of_vertices; ++v)
    if(rings[v] > 0 && rings[v] + fans[v] > 1)
      return false;
  return true;
}

Subdivision subdivide(const std::vector<Triangle>& triangles, Index number_of_vertices,
                      unsigned times)
{
  check_size(triangles.size(), times);
  Subdivision result;
  result.levels.push_back(coarsest(triangles, number_of_vertices));
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
  subdivision.levels.push_back(finer(subdivision.levels.back()));
  subdivision.levels.back().number_of_vertices = Index(subdivision.parents.size());
}

std::vector<Base_place> base_places(const Subdivision& subdivision)
{
  const std::size_t times = subdivision.levels.size() - 1;
  const std::vector<Triangle>& base = subdivision.levels.front().triangles;
  std::vector<Base_place> result(subdivision.number_of_vertices());
  // Of the corners of each triangle of a level.
  using Coordinates = std::array<Index, 3>;
  std::vector<std::array<Coordinates, 3>> corners(base.size());
  const Index whole = Index(1) << times;
  for(auto& c : corners)
    c = {Coordinates{whole, 0, 0}, Coordinates{0, whole, 0}, Coordinates{0, 0, whole}};
  for(std::size_t j = 0;; ++j)
  {
    const std::vector<Triangle>& triangles = subdivision.levels[j].triangles;
    for(Index f = 0; f < triangles.size(); ++f)
      for(int k = 0; k < 3; ++k)
        if(Base_place& place = result[triangles[f][k]]; place.triangle == none)
          place = {f >> (2 * j), corners[f][k]};
    if(j == times)
      return result;
    std::vector<std::array<Coordinates, 3>> children;
    children.reserve(4 * corners.size());
    for(const auto& [a, b, c] : corners)
    {
      const auto middle = [](const Coordinates& p, const Coordinates& q) {
        return Coordinates{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2};
      };
      const Coordinates m0 = middle(a, b), m1 = middle(b, c), m2 = middle(c, a);
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
    Base_place place{triangle, {}};
    for(int k = 0; k < 3; ++k)
      place.coordinates[k] = Index(sum[k] / coordinates.size());
    result.places.push_back(place);
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
  Subdivision first;
  first.levels.push_back(coarsest(triangles, number_of_vertices));
  for(Index v = 0; v < number_of_vertices; ++v)
    first.parents.push_back({v, v});
  Level& base = first.levels.front();
  add_midpoints(base, first.parents);

  Quad_subdivision result;
  Quad_builder builder{result};
  using Coordinates = std::array<Index, 3>;
  const Index whole = Index(6) << (2 * (levels - 1));
  result.parents.resize(number_of_vertices);
  result.places.resize(number_of_vertices);
  const std::array<Coordinates, 3> unit = {Coordinates{whole, 0, 0}, {0, whole, 0}, {0, 0, whole}};
  for(Index f = 0; f < triangles.size(); ++f)
    for(int k = 0; k < 3; ++k)
      if(Base_place& place = result.places[triangles[f][k]]; place.triangle == none)
        place = {f, unit[k]};
  for(Index side = 0; side < base.twin.size(); ++side)
    if(is_first_of_edge(base, side))
    {
      const auto [a, b] = ends(base, side);
      builder.add({a, b}, side / 3, {unit[side % 3], unit[(side + 1) % 3]});
    }
  // The quads of triangle f, now and later, are a block: their corners' coordinates are in f.
  std::vector<std::array<Coordinates, 4>> corners;
  std::vector<Quad> quads;
  for(Index f = 0; f < triangles.size(); ++f)
  {
    const Triangle& t = triangles[f];
    const Index center = builder.add({t[0], t[1], t[2]}, f, {unit[0], unit[1], unit[2]});
    const Coordinates& at_center = result.places[center].coordinates;
    const auto middle = [&](int k)
    {
      Coordinates c = {0, 0, 0};
      c[k] = c[(k + 1) % 3] = whole / 2;
      return c;
    };
    for(int k = 0; k < 3; ++k)
    {
      const int before = (k + 2) % 3;
      quads.push_back({t[k], base.midpoint[3 * f + k], center, base.midpoint[3 * f + before]});
      corners.push_back({unit[k], middle(k), at_center, middle(before)});
    }
  }
  result.levels.push_back(quads);
  result.number_of_vertices.push_back(Index(result.parents.size()));

  for(unsigned level = 1; level < levels; ++level)
  {
    const std::size_t per_triangle = std::size_t(3) << (2 * (level - 1));
    std::map<std::array<Index, 2>, Index> middle_of;
    std::vector<std::array<Index, 4>> middles(quads.size());
    for(std::size_t q = 0; q < quads.size(); ++q)
      for(int k = 0; k < 4; ++k)
      {
        const Index a = quads[q][k], b = quads[q][(k + 1) % 4];
        const auto [at, is_new] = middle_of.try_emplace({std::min(a, b), std::max(a, b)}, none);
        if(is_new)
          at->second = builder.add({a, b}, Index(q / per_triangle),
                                   {corners[q][k], corners[q][(k + 1) % 4]});
        middles[q][k] = at->second;
      }
    std::vector<Quad> finer;
    std::vector<std::array<Coordinates, 4>> finer_corners;
    for(std::size_t q = 0; q < quads.size(); ++q)
    {
      const auto& p = corners[q];
      const Index center = builder.add({quads[q].begin(), quads[q].end()}, Index(q / per_triangle),
                                       {p.begin(), p.end()});
      const Coordinates& at_center = result.places[center].coordinates;
      const auto middle = [&](int k)
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
        child[after] = middles[q][k];
        child[across] = center;
        child[before] = middles[q][before];
        finer.push_back(child);
        std::array<Coordinates, 4> places;
        places[k] = p[k];
        places[after] = middle(k);
        places[across] = at_center;
        places[before] = middle(before);
        finer_corners.push_back(places);
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
