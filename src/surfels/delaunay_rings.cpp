// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surfels/delaunay_rings.h"

#include <CGAL/Geodesic_processing/internal/core/parallel.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>
#include "surfels/Voronoi_cell.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Random samples of a plane need 28 neighbors on average until their Voronoi cell is certain.
// Cells that need more than `number_of_ring_neighbors` use up to this number.
constexpr std::size_t max_number_of_neighbors = 64;

// A bisector has half the distance of its neighbor. So it can intersect the cell only if the
// squared distance of the neighbor is at most 4 times the squared radius of the cell. The factor
// is larger because the weights of the power diagram can move a bisector across a corner.
constexpr double squared_reach_ratio = 4.000001;

// Returns a hash of the vertex in [0, 1).
double pseudo_random(Index v)
{
  std::uint64_t x = (v + 1ull) * 0x9e3779b97f4a7c15ull;
  x = (x ^ x >> 31) * 0xbf58476d1ce4e5b9ull;
  return static_cast<double>(x >> 11) * 0x1p-53;
}

// Returns the weights of a power diagram (#surfels), so that different tangent planes choose the
// same diagonal for cocircular surfels (lattices). The weights are far above round-off errors; at
// 1e-9 of the squared spacing, they change no triangle that is not nearly cocircular.
std::vector<double> power_weights(const Distinct_surfels& surfels, const Ragged_rows& neighbors)
{
  std::vector<double> weight(surfels.size(), 0.);
  for(Index i = 0; i < surfels.size(); ++i)
    if(neighbors.begin(i) != neighbors.end(i))
    {
      const double nearest = norm(surfels.point[i] - surfels.point[*neighbors.begin(i)]);
      weight[i] = 1e-9 * pseudo_random(i) * nearest * nearest;
    }
  return weight;
}

struct Ring_input
{
  const Distinct_surfels& surfels;
  const Ragged_rows& neighbors;
  const std::vector<double>& search_radius;
  const std::vector<double>& radius;
  std::vector<double> weight; // of the power diagram
};

// Computes the rings of surfels one at a time. Keeps its arrays between them: one per thread.
class Ring_builder
{
public:
  explicit Ring_builder(const Ring_input& input) : m_input(input), m_surfels(input.surfels) {}

  // Appends the ring of a surfel.
  void append_ring(Index i, std::vector<Index>& ring)
  {
    const double max_circumradius = max_circumradius_ratio * m_input.radius[i];
    if(!(max_circumradius > 0.))
      return;
    m_vertex = i;
    m_center = m_surfels.point[i];
    std::tie(m_u, m_v) = tangent_frame(m_surfels.normal[i]);
    m_cell.reset(max_circumradius);
    m_steep_neighbors.clear();
    std::for_each(m_input.neighbors.begin(i), m_input.neighbors.end(i),
                  [&](Index j) { add_neighbor(j); });
    add_farther_neighbors(max_circumradius);
    add_steep_neighbors();
    append_fans(ring);
  }

private:
  using Point_2 = std::array<double, 2>;

  // Returns the coordinates of surfel j in the tangent plane, relative to the current surfel.
  Point_2 project(Index j) const
  {
    const Vec3 chord = m_surfels.point[j] - m_center;
    return {dot(chord, m_u), dot(chord, m_v)};
  }

  std::size_t previous_corner(std::size_t corner) const
  {
    return corner == 0 ? m_cell.corners().size() - 1 : corner - 1;
  }

  // Returns true if a corner of the cell is the circumcenter of an admissible triangle.
  bool has_triangle(std::size_t corner) const
  {
    const auto& corners = m_cell.corners();
    const Voronoi_cell::Corner& c = corners[corner];
    const Index a = corners[previous_corner(corner)].edge, b = c.edge;
    if(a == none || b == none)
      return false;
    const std::vector<double>& radius = m_input.radius;
    const double max_radius =
        max_circumradius_ratio * std::min({radius[m_vertex], radius[a], radius[b]});
    return c.x * c.x + c.y * c.y <= max_radius * max_radius &&
           m_surfels.compatibility(a, b) != Compatibility::incompatible;
  }

  // Returns true if a triangle of the current cell contains the direction q.
  bool is_covered(const Point_2& q) const
  {
    const auto& corners = m_cell.corners();
    for(std::size_t k = 0; k < corners.size(); ++k)
      if(has_triangle(k))
      {
        const Point_2 a = project(corners[previous_corner(k)].edge);
        const Point_2 b = project(corners[k].edge);
        if(a[0] * q[1] >= a[1] * q[0] && q[0] * b[1] >= q[1] * b[0])
          return true;
      }
    return false;
  }

  // Clips the cell at the bisector with a neighbor. If `only_in_gaps`, neighbors in the direction
  // of an existing triangle are ignored.
  void clip(Index j, bool only_in_gaps)
  {
    const Point_2 q = project(j);
    const double squared_length = q[0] * q[0] + q[1] * q[1];
    if(squared_length <= squared_reach_ratio * m_cell.squared_radius() &&
       !(only_in_gaps && is_covered(q)))
      m_cell.clip(q[0], q[1], (squared_length + m_input.weight[m_vertex] - m_input.weight[j]) / 2.,
                  j);
  }

  // Clips the cell with a gentle neighbor; keeps a steep one for add_steep_neighbors().
  void add_neighbor(Index j)
  {
    const Compatibility compatibility = m_surfels.compatibility(m_vertex, j);
    if(compatibility == Compatibility::gentle)
      clip(j, false);
    else if(compatibility == Compatibility::steep)
      m_steep_neighbors.push_back(j);
  }

  // Searches for more neighbors if the cell reaches beyond the search radius.
  void add_farther_neighbors(double max_circumradius)
  {
    const double search_radius = m_input.search_radius[m_vertex];
    const double needed_squared_radius =
        squared_reach_ratio *
        std::min(m_cell.squared_radius(), max_circumradius * max_circumradius);
    if(!(needed_squared_radius > search_radius * search_radius))
      return;
    m_surfels.tree.nearest(m_surfels.point, m_center, max_number_of_neighbors, m_farther_neighbors,
                           needed_squared_radius);
    for(std::size_t k = std::min(number_of_ring_neighbors + 1, m_farther_neighbors.size());
        k < m_farther_neighbors.size(); ++k)
      add_neighbor(m_farther_neighbors[k].point);
  }

  // Fills gaps between the triangles of gentle neighbors, as they occur along sharp edges.
  void add_steep_neighbors()
  {
    for(const Index j : m_steep_neighbors)
    {
      // If the chord is nearly parallel to the normal, its projection has no reliable direction.
      const Point_2 q = project(j);
      const Vec3 chord = m_surfels.point[j] - m_center;
      if(16. * (q[0] * q[0] + q[1] * q[1]) > dot(chord, chord))
        clip(j, true);
    }
  }

  // Appends the triangles of the cell in the format of find_delaunay_rings().
  void append_fans(std::vector<Index>& ring) const
  {
    const auto& corners = m_cell.corners();
    const std::size_t n = corners.size(), ring_begin = ring.size();
    // Start after a gap if there is one, so that no fan is split.
    std::size_t start = 0;
    while(start < n && has_triangle(start))
      ++start;
    if(start == n)
    {
      for(const Voronoi_cell::Corner& c : corners)
        ring.push_back(c.edge);
      return;
    }
    for(std::size_t k = 1; k < n; ++k)
    {
      const std::size_t corner = (start + k) % n;
      if(!has_triangle(corner))
        continue;
      const Index a = corners[previous_corner(corner)].edge;
      if(ring.size() == ring_begin || ring.back() != a)
      {
        if(ring.size() != ring_begin)
          ring.push_back(none);
        ring.push_back(a);
      }
      ring.push_back(corners[corner].edge);
    }
    if(ring.size() != ring_begin)
      ring.push_back(none);
  }

  const Ring_input& m_input;
  const Distinct_surfels& m_surfels;
  Index m_vertex = none;
  Vec3 m_center, m_u, m_v; // the surfel, and the basis of its tangent plane
  Voronoi_cell m_cell;
  std::vector<Kd_tree::Neighbor> m_farther_neighbors;
  std::vector<Index> m_steep_neighbors;
};

} // namespace

Ragged_rows find_delaunay_rings(const Distinct_surfels& surfels, const Ragged_rows& neighbors,
                                const std::vector<double>& search_radius,
                                const std::vector<double>& radius)
{
  const Ring_input input = {surfels, neighbors, search_radius, radius,
                            power_weights(surfels, neighbors)};
  Ragged_rows rings(surfels.size());
  for_each_block(surfels.size(), surfel_block_size, surfels.number_of_threads,
                 [&](std::size_t block, std::size_t begin, std::size_t end)
                 {
                   Ring_builder builder(input);
                   for(Index i = static_cast<Index>(begin); i < end; ++i)
                   {
                     builder.append_ring(i, rings.buffer(block));
                     rings.end_row(block, i);
                   }
                 });
  return rings;
}

} // namespace CGAL::Geodesic_processing::internal
