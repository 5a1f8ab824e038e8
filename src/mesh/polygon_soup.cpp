// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/polygon_soup.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include "mesh/edges_of_soup.h"
#include "mesh/orient_triangles.h"
#include "mesh/triangulate_polygon.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

constexpr std::size_t max_number_of_halfedges = std::size_t(1) << 31;

void check(const Polygon_soup& soup, const Soup_options& options)
{
  if(options.merge_tolerance &&
     !(*options.merge_tolerance >= 0. && *options.merge_tolerance < infinity))
    throw Invalid_argument_error("merge_tolerance is negative or not finite.");
  const auto is_finite = [&](std::size_t i)
  {
    const Vec3& p = soup.points[i];
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  };
  const auto is_point = [&](std::size_t i) { return soup.corners[i] < soup.points.size(); };
  if(is_true_for_all(soup.points.size(), options.number_of_threads, is_finite) &&
     is_true_for_all(soup.corners.size(), options.number_of_threads, is_point))
    return;
  // Finds the first error.
  for(std::size_t i = 0; i < soup.points.size(); ++i)
    if(!is_finite(i))
      throw Invalid_argument_error("Point " + std::to_string(i) +
                                   " has a coordinate that is not finite.");
  for(std::size_t f = 0; f + 1 < soup.polygon_begin.size(); ++f)
    for(std::size_t i = soup.polygon_begin[f]; i < soup.polygon_begin[f + 1]; ++i)
      if(!is_point(i))
        throw Invalid_argument_error("Polygon " + std::to_string(f) +
                                     " has a corner that is not the index of a point.");
}

double euclidean_distance(const Vec3& p, const Vec3& q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

// A hash table that maps a cell of a grid to the last point that was inserted into it. Cells whose
// hashes agree in their upper half share an entry.
class Cell_table
{
public:
  // Returns the last point of a cell, or none.
  Index find(std::uint64_t hash) const { return m_entries[position(hash >> 32)].point; }

  // Inserts a point, and returns the one before it in the same cell, or none.
  Index insert(std::uint64_t hash, Index point)
  {
    if(2 * m_number_of_cells > m_entries.size())
      grow();
    Entry& entry = m_entries[position(hash >> 32)];
    if(entry.point == none)
      ++m_number_of_cells;
    entry.tag = static_cast<std::uint32_t>(hash >> 32);
    return std::exchange(entry.point, point);
  }

private:
  struct Entry
  {
    std::uint32_t tag = 0;
    Index point = none;
  };

  // Returns the position of the entry with a tag, or of the unused one where it belongs.
  std::size_t position(std::uint64_t tag) const
  {
    std::size_t i = tag & (m_entries.size() - 1);
    while(m_entries[i].point != none && m_entries[i].tag != tag)
      i = (i + 1) & (m_entries.size() - 1);
    return i;
  }
  void grow()
  {
    std::vector<Entry> old(2 * m_entries.size());
    std::swap(m_entries, old);
    for(const Entry& entry : old)
      if(entry.point != none)
        m_entries[position(entry.tag)] = entry;
  }

  std::vector<Entry> m_entries = std::vector<Entry>(16); // a power of two
  std::size_t m_number_of_cells = 0;
};

// Replaces each point by the first earlier one that is within the tolerance and has not been
// replaced itself. Returns the replacements and counts them; see Repaired_soup.
std::vector<Index> merge_points(const std::vector<Vec3>& points, double tolerance,
                                std::size_t& number_of_merged_points)
{
  double extent = 0.;
  for(const Vec3& p : points)
    for(const double x : p)
      extent = std::max(extent, std::abs(x));
  // The points that are not replaced are sorted into the cells of a grid. A cell is larger than the
  // tolerance by more than the round-off errors of its indices, so that neighbors are in adjacent
  // cells.
  const double cell_size = std::max({1.001 * tolerance, extent * 0x1p-40, 0x1p-1000});
  const int reach = tolerance > 0. ? 1 : 0;
  using Cell = std::array<std::int64_t, 3>;
  const auto cell_of = [&](const Vec3& p)
  {
    Cell cell;
    for(std::size_t k = 0; k < 3; ++k)
      cell[k] = static_cast<std::int64_t>(std::floor(p[k] / cell_size));
    return cell;
  };
  const auto hash = [](const Cell& cell)
  {
    std::uint64_t result = 0;
    for(const std::int64_t x : cell)
    {
      result = (result ^ static_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u;
      result ^= result >> 32;
    }
    return result;
  };

  std::vector<Index> replacement(points.size()), next(points.size(), none);
  Cell_table last_in_cell;
  for(Index i = 0; i < points.size(); ++i)
  {
    const Cell cell = cell_of(points[i]);
    Index first = none;
    for(int x = -reach; x <= reach; ++x)
      for(int y = -reach; y <= reach; ++y)
        for(int z = -reach; z <= reach; ++z)
          for(Index j = last_in_cell.find(hash({cell[0] + x, cell[1] + y, cell[2] + z})); j != none;
              j = next[j])
            if(j < first && euclidean_distance(points[i], points[j]) <= tolerance)
              first = j;
    replacement[i] = first != none ? first : i;
    if(first != none)
      ++number_of_merged_points;
    else
      next[i] = last_in_cell.insert(hash(cell), i);
  }
  if(number_of_merged_points == 0)
    replacement.clear();
  return replacement;
}

// Returns whether a triangle has no area in double precision.
bool has_no_area(const Vec3& a, const Vec3& b, const Vec3& c)
{
  std::array<double, 3> length = {euclidean_distance(a, b), euclidean_distance(b, c),
                                  euclidean_distance(c, a)};
  std::sort(length.begin(), length.end());
  return length[0] <= 0. || length[0] + length[1] <= length[2];
}

// Returns whether all polygons are triangles of three different corners.
bool has_only_triangles(const Polygon_soup& soup, unsigned number_of_threads)
{
  const std::size_t number_of_polygons = soup.polygon_begin.size() - 1;
  const auto is_triangle = [&](std::size_t f)
  {
    const Index* const corner = soup.corners.data() + 3 * f;
    return soup.polygon_begin[f] == 3 * f && corner[0] != corner[1] && corner[1] != corner[2] &&
           corner[2] != corner[0];
  };
  return soup.corners.size() == 3 * number_of_polygons &&
         is_true_for_all(number_of_polygons, number_of_threads, is_triangle);
}

// Appends the triangles of all polygons. If all are triangles that need no change, moves the
// corners of the soup and leaves `polygon` empty.
void triangulate(Polygon_soup& soup, const Soup_options& options, Repaired_soup& result)
{
  if(result.replacement.empty() && !options.do_remove_degenerate_faces &&
     has_only_triangles(soup, options.number_of_threads))
  {
    result.corners = std::move(soup.corners);
    return;
  }
  constexpr std::size_t max_corners = 10000; // the triangulation takes quadratic time
  result.corners.reserve(soup.corners.size());
  result.polygon.reserve(soup.polygon_begin.size());
  std::vector<Index> face;
  std::vector<Vec3> points;
  const auto add = [&](std::size_t f, Index a, Index b, Index c)
  {
    if(a == b || b == c || c == a ||
       (options.do_remove_degenerate_faces &&
        has_no_area(soup.points[a], soup.points[b], soup.points[c])))
    {
      ++result.report.number_of_degenerate_faces;
      return;
    }
    result.corners.insert(result.corners.end(), {a, b, c});
    result.polygon.push_back(static_cast<Index>(f));
  };
  for(std::size_t f = 0; f + 1 < soup.polygon_begin.size(); ++f)
  {
    face.clear();
    for(std::size_t i = soup.polygon_begin[f]; i < soup.polygon_begin[f + 1]; ++i)
    {
      const Index point = soup.corners[i],
                  corner = result.replacement.empty() ? point : result.replacement[point];
      if(face.empty() || face.back() != corner)
        face.push_back(corner);
    }
    while(face.size() > 1 && face.front() == face.back())
      face.pop_back();
    if(face.size() > max_corners)
      throw Unsupported_surface_error("Polygon " + std::to_string(f) + " has " +
                                      std::to_string(face.size()) +
                                      " corners, but the maximum is 10,000.");
    if(face.size() < 3)
    {
      ++result.report.number_of_degenerate_faces;
      continue;
    }
    if(soup.polygon_begin[f + 1] - soup.polygon_begin[f] > 3)
      ++result.report.number_of_triangulated_polygons;
    if(face.size() == 3)
    {
      add(f, face[0], face[1], face[2]);
      continue;
    }
    points.clear();
    for(const Index corner : face)
      points.push_back(soup.points[corner]);
    for(const auto& [a, b, c] : triangulate_polygon(points))
      add(f, face[a], face[b], face[c]);
  }
}

struct Halfedge_pairs
{
  std::vector<Index> opposite;    // #halfedges; see orient_triangles()
  std::vector<bool> is_duplicate; // #triangles
  std::size_t number_of_duplicates = 0;
  std::size_t number_of_nonmanifold_edges = 0;
};

// Finds duplicates: triangles with the same corners in the same cyclic order as an earlier one.
// Triangles of opposite orientation are not duplicates, because they may be a closed surface.
// Pairs the other halfedges of each edge if there are two.
Halfedge_pairs pair_halfedges(std::size_t number_of_points, const std::vector<Index>& corners)
{
  Halfedge_pairs result;
  result.opposite.assign(corners.size(), none);
  result.is_duplicate.assign(corners.size() / 3, false);
  const auto pair = [&](Index g, Index h)
  {
    result.opposite[g] = h;
    result.opposite[h] = g;
  };
  // Triangles with a common edge are duplicates if the edge has the same direction in both and if
  // they have the same third corner.
  const auto triangle = [&](Index h)
  { return std::make_pair(corners[h], corners[previous_halfedge(h)]); };
  std::vector<Index> remaining;
  const auto pair_all = [&](const std::vector<Index>& edge)
  {
    if(edge.size() == 2 && corners[edge[0]] != corners[edge[1]])
      return pair(edge[0], edge[1]);
    remaining = edge;
    std::stable_sort(remaining.begin(), remaining.end(),
                     [&](Index g, Index h) { return triangle(g) < triangle(h); });
    for(std::size_t i = 1; i < remaining.size(); ++i)
      if(triangle(remaining[i - 1]) == triangle(remaining[i]))
        result.is_duplicate[remaining[i] / 3] = true;
    remaining.erase(std::remove_if(remaining.begin(), remaining.end(),
                                   [&](Index h) { return result.is_duplicate[h / 3]; }),
                    remaining.end());
    if(remaining.size() == 2)
      pair(remaining[0], remaining[1]);
    else if(remaining.size() > 2)
      ++result.number_of_nonmanifold_edges;
  };
  for_each_edge_of_soup(number_of_points, corners, pair_all);
  result.number_of_duplicates = static_cast<std::size_t>(
      std::count(result.is_duplicate.begin(), result.is_duplicate.end(), true));
  return result;
}

void remove_duplicates(Repaired_soup& soup, Halfedge_pairs& pairs)
{
  if(pairs.number_of_duplicates == 0)
    return;
  std::vector<Index> new_triangle(soup.polygon.size());
  Index number_kept = 0;
  for(Index f = 0; f < soup.polygon.size(); ++f)
  {
    new_triangle[f] = number_kept;
    if(!pairs.is_duplicate[f])
      ++number_kept;
  }
  for(Index f = 0; f < soup.polygon.size(); ++f)
  {
    if(pairs.is_duplicate[f])
      continue;
    const Index g = new_triangle[f];
    soup.polygon[g] = soup.polygon[f];
    for(Index k = 0; k < 3; ++k)
    {
      const Index opposite = pairs.opposite[3 * f + k];
      soup.corners[3 * g + k] = soup.corners[3 * f + k];
      pairs.opposite[3 * g + k] =
          opposite == none ? none : 3 * new_triangle[opposite / 3] + opposite % 3;
    }
  }
  soup.polygon.resize(number_kept);
  soup.corners.resize(3 * std::size_t(number_kept));
  pairs.opposite.resize(3 * std::size_t(number_kept));
}

// Merges points and triangulates polygons; fills all but the twins. See triangulate().
Repaired_soup triangulated(Polygon_soup& soup, const Soup_options& options)
{
  check(soup, options);
  Repaired_soup result;
  if(options.merge_tolerance)
    result.replacement =
        merge_points(soup.points, *options.merge_tolerance, result.report.number_of_merged_points);
  triangulate(soup, options, result);
  if(result.corners.size() > max_number_of_halfedges)
    throw Unsupported_surface_error("The polygons have more than 2^31 halfedges.");
  return result;
}

// Removes duplicates, orients the triangles and pairs their halfedges.
void glue(std::size_t number_of_points, Repaired_soup& soup)
{
  if(soup.polygon.empty())
  {
    soup.polygon.resize(soup.corners.size() / 3);
    std::iota(soup.polygon.begin(), soup.polygon.end(), Index(0));
  }
  Halfedge_pairs pairs = pair_halfedges(number_of_points, soup.corners);
  remove_duplicates(soup, pairs);
  soup.report.number_of_duplicate_triangles = pairs.number_of_duplicates;
  soup.report.number_of_split_edges = pairs.number_of_nonmanifold_edges;
  soup.twins = orient_triangles(soup.corners, std::move(pairs.opposite), soup.report);
  const std::size_t number_of_fans =
      count_fans(number_of_points, soup.corners, soup.twins, soup.report);
  measure_topology(number_of_fans, soup.twins, soup.report);
}

// Moves the points that have not been replaced to the front, and changes the corners accordingly.
void remove_replaced_points(std::vector<Vec3>& points, const std::vector<Index>& replacement,
                            std::vector<Index>& corners)
{
  std::vector<Index> position(points.size());
  Index number_kept = 0;
  for(Index i = 0; i < points.size(); ++i)
    if(replacement[i] == i)
    {
      position[i] = number_kept;
      points[number_kept++] = points[i];
    }
  points.resize(number_kept);
  for(Index& corner : corners)
    corner = position[corner];
}

} // namespace

Repaired_soup repair_soup(Polygon_soup soup, const Soup_options& options)
{
  Repaired_soup result = triangulated(soup, options);
  glue(soup.points.size(), result);
  return result;
}

Soup_arrays build_soup_arrays(Polygon_soup soup, const Soup_options& options)
{
  const auto begin_step = [&]
  {
    if(options.callback)
      options.callback(0.);
  };
  const std::size_t number_of_polygons = soup.polygon_begin.size() - 1;
  begin_step();
  Repaired_soup repaired = triangulated(soup, options);
  soup.corners = {};
  soup.polygon_begin = {};
  if(!repaired.replacement.empty())
    remove_replaced_points(soup.points, repaired.replacement, repaired.corners);

  begin_step();
  Soup_arrays result;
  Mesh_counts counts;
  if(auto arrays =
         build_oriented_arrays(soup.points, repaired.corners, counts, options.number_of_threads))
  {
    result.mesh = std::move(*arrays);
    repaired.report.number_of_components = counts.number_of_components;
    repaired.report.number_of_nonmanifold_points = counts.rings.number_of_nonmanifold_vertices;
    measure_topology(counts.rings.number_of_fans, result.mesh.arrays.twin, repaired.report);
  }
  else
  {
    begin_step();
    glue(soup.points.size(), repaired);
    begin_step();
    result.mesh = build_mesh_arrays(std::move(soup.points), repaired.corners, repaired.twins);
  }
  begin_step();
  result.mesh.arrays.number_of_threads = options.number_of_threads;
  result.report = repaired.report;
  result.report.number_of_triangles_without_area = result.mesh.number_of_degenerate_triangles;
  result.replacement = std::move(repaired.replacement);
  if(result.mesh.face_of_triangle.size() != number_of_polygons)
    result.polygon = std::move(repaired.polygon);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
