// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/subdivision/hierarchy.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Level = Subdivision::Level;

// The four triangles of the next coarser level's triangle.
struct Tile
{
  Index middle; // the central triangle
  Triangle corners, midpoints;
};

// Finds a partition of the triangles of a level into tiles.
class Tiling
{
public:
  explicit Tiling(const Level& level)
      : m_level(level), m_tile_of_face(level.triangles.size(), none),
        m_role(level.number_of_vertices, Role::unknown), m_is_counted(level.triangles.size(), false)
  {}

  // Returns the tiles of all components, sorted by their central triangles, or nothing if a
  // component has no tiling.
  std::optional<std::vector<Tile>> find()
  {
    std::vector<Tile> result;
    for(Index f = 0; f < m_tile_of_face.size(); ++f)
    {
      if(m_tile_of_face[f] != none)
        continue;
      const std::size_t size = component_size(f);
      std::vector<Tile> best;
      std::array<Index, 4> candidates = {f, none, none, none};
      for(Index k = 0; k < 3; ++k)
        if(const Index twin = m_level.twin[3 * f + k]; twin != none)
          candidates[k + 1] = twin / 3;
      for(const Index middle : candidates)
      {
        if(middle == none)
          continue;
        std::vector<Tile> tiles = grow_tiling(middle);
        if(4 * tiles.size() == size && (best.empty() || corner_sum(tiles) < corner_sum(best)))
          best = std::move(tiles);
        reset();
      }
      if(best.empty())
        return {};
      grow_tiling(best.front().middle);
      m_claimed_faces.clear();
      m_claimed_vertices.clear();
      result.insert(result.end(), best.begin(), best.end());
    }
    std::sort(result.begin(), result.end(),
              [](const Tile& a, const Tile& b) { return a.middle < b.middle; });
    return result;
  }

private:
  enum class Role : std::uint8_t
  {
    unknown,
    corner,
    midpoint
  };

  // Returns the number of triangles in the connected component of a triangle, and marks them.
  std::size_t component_size(Index seed)
  {
    std::vector<Index> stack = {seed};
    std::size_t size = 1;
    m_is_counted[seed] = true;
    while(!stack.empty())
    {
      const Index f = stack.back();
      stack.pop_back();
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
        if(const Index twin = m_level.twin[h]; twin != none && !m_is_counted[twin / 3])
        {
          m_is_counted[twin / 3] = true;
          stack.push_back(twin / 3);
          ++size;
        }
    }
    return size;
  }

  // Returns the sum of the indices of the corners. It breaks ties between several tilings.
  static std::uint64_t corner_sum(const std::vector<Tile>& tiles)
  {
    std::uint64_t result = 0;
    for(const Tile& tile : tiles)
      for(const Index v : tile.corners)
        result += v;
    return result;
  }

  // Assigns a triangle to a tile. Returns false if it already belongs to a tile.
  bool claim(Index face, Index middle)
  {
    if(m_tile_of_face[face] != none)
      return false;
    m_tile_of_face[face] = middle;
    m_claimed_faces.push_back(face);
    return true;
  }

  // Assigns a role to a vertex. Returns false if it already has the other role.
  bool claim(Index vertex, Role role)
  {
    if(m_role[vertex] == Role::unknown)
    {
      m_role[vertex] = role;
      m_claimed_vertices.push_back(vertex);
    }
    return m_role[vertex] == role;
  }

  // Undoes all assignments since the last accepted tiling.
  void reset()
  {
    for(const Index f : m_claimed_faces)
      m_tile_of_face[f] = none;
    for(const Index v : m_claimed_vertices)
      m_role[v] = Role::unknown;
    m_claimed_faces.clear();
    m_claimed_vertices.clear();
  }

  // Returns all tiles that follow from one central triangle, or none if they are contradictory.
  std::vector<Tile> grow_tiling(Index seed)
  {
    std::vector<Tile> result;
    std::vector<Index> queue = {seed};
    for(std::size_t i = 0; i < queue.size(); ++i)
    {
      const Index middle = queue[i];
      if(m_tile_of_face[middle] == middle)
        continue;
      if(!claim(middle, middle))
        return {};
      const Triangle& t = m_level.triangles[middle];
      Tile tile = {middle, {}, {t[2], t[0], t[1]}};
      for(const Index v : t)
        if(!claim(v, Role::midpoint))
          return {};
      for(Index k = 0; k < 3; ++k)
      {
        const Index inner = m_level.twin[3 * middle + (k + 1) % 3];
        if(inner == none || !claim(inner / 3, middle))
          return {};
        const Index corner = tile.corners[k] = opposite_vertex(m_level, inner);
        if(!claim(corner, Role::corner))
          return {};
        for(const Index outer : {next_halfedge(inner), previous_halfedge(inner)})
        {
          const Index twin = m_level.twin[outer];
          if(twin == none)
            continue;
          // In the adjacent tile, the edge opposite to the corner is shared with the central
          // triangle.
          const Index across = internal::source_vertex(m_level, twin) == corner
                                   ? next_halfedge(twin)
                                   : previous_halfedge(twin);
          const Index opposite_inner = m_level.twin[across];
          if(opposite_inner == none ||
             (m_tile_of_face[twin / 3] != none && m_tile_of_face[twin / 3] != opposite_inner / 3))
            return {};
          queue.push_back(opposite_inner / 3);
        }
      }
      result.push_back(tile);
    }
    return result;
  }

  const Level& m_level;
  std::vector<Index> m_tile_of_face; // #triangles: the central triangle of its tile
  std::vector<Role> m_role;          // #vertices
  std::vector<bool> m_is_counted;    // #triangles: true if its component was counted
  std::vector<Index> m_claimed_faces, m_claimed_vertices; // to be reset
};

// Returns the same key for both directions of an edge.
std::uint64_t edge_key(Index a, Index b)
{
  return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
}

using Midpoints = std::unordered_map<std::uint64_t, Index>;

// A mesh without the levels that could be removed, in the indices of the input.
struct Coarsened_mesh
{
  Subdivision coarsest;
  std::vector<bool> is_midpoint;    // #vertices: true if it is removed
  std::vector<Midpoints> midpoints; // of each removed level by edge, coarsest level last
};

// Removes levels, at most `max_number_of_levels`, until the triangles are not a refinement.
Coarsened_mesh coarsen(const std::vector<Triangle>& triangles, Index number_of_vertices,
                       unsigned max_number_of_levels)
{
  Coarsened_mesh result = {subdivide(triangles, number_of_vertices, 0),
                           std::vector<bool>(number_of_vertices, false),
                           {}};
  while(result.midpoints.size() < max_number_of_levels &&
        !result.coarsest.finest().triangles.empty())
  {
    const auto tiles = Tiling(result.coarsest.finest()).find();
    if(!tiles)
      break;
    std::vector<Triangle> coarser;
    Midpoints edge_midpoints;
    for(const Tile& tile : *tiles)
    {
      coarser.push_back(tile.corners);
      for(int k = 0; k < 3; ++k)
        edge_midpoints[edge_key(tile.corners[k], tile.corners[(k + 1) % 3])] = tile.midpoints[k];
    }
    Subdivision next;
    try
    {
      next = subdivide(coarser, number_of_vertices, 0);
    }
    catch(const Invalid_argument_error&)
    {
      break; // a coarser mesh would have two edges between the same vertices
    }
    for(const auto& [edge, middle] : edge_midpoints)
      result.is_midpoint[middle] = true;
    result.midpoints.push_back(std::move(edge_midpoints));
    result.coarsest = std::move(next);
  }
  return result;
}

} // namespace

Hierarchy recover_hierarchy(const std::vector<Triangle>& triangles, Index number_of_vertices,
                            unsigned max_number_of_levels)
{
  auto [coarsest, is_midpoint, midpoints] =
      coarsen(triangles, number_of_vertices, max_number_of_levels);
  Hierarchy result;
  std::vector<Index> coarse_index(number_of_vertices, none);
  for(Index v = 0; v < number_of_vertices; ++v)
    if(!is_midpoint[v])
    {
      coarse_index[v] = Index(result.input_vertex.size());
      result.input_vertex.push_back(v);
    }
  std::vector<Triangle> base = coarsest.finest().triangles;
  for(Triangle& t : base)
    for(Index& v : t)
      v = coarse_index[v];
  result.subdivision = std::make_shared<Subdivision>(
      subdivide(base, Index(result.input_vertex.size()), unsigned(midpoints.size())));
  for(Index v = Index(result.input_vertex.size()); v < result.subdivision->number_of_vertices();
      ++v)
  {
    const auto [a, b] = result.subdivision->parents[v];
    while(v >= result.subdivision->levels[result.subdivision->levels.size() - midpoints.size()]
                   .number_of_vertices)
      midpoints.pop_back();
    result.input_vertex.push_back(
        midpoints.back().at(edge_key(result.input_vertex[a], result.input_vertex[b])));
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
