// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_NEIGHBORS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_NEIGHBORS_H

#include <CGAL/Geodesic_processing/internal/spatial_search/Kd_tree.h>
#include <CGAL/Geodesic_processing/internal/spatial_search/Leaf_neighbors.h>
#include <CGAL/Geodesic_processing/internal/mesh/morton_order.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Sorting of clouds, compatibility of surfels, and the search for compatible neighbors.

namespace CGAL::Geodesic_processing::internal {

// Number of surfels that a thread processes at a time. Results do not depend on the number of
// threads.
inline constexpr std::size_t surfel_block_size = 2048;

// Throws Invalid_argument_error if the numbers of points and normals differ, or the number of radii
// is neither zero nor the number of points. Throws Unsupported_surface_error if there are more
// than 2^25 points.
CGAL_GEODESIC_PROCESSING_EXPORT
void check_sizes(std::size_t points, std::size_t normals, std::size_t radii);

// Normalizes vectors of any positive length, without overflow or underflow.
// Throws Invalid_argument_error if a vector is zero or not finite.
CGAL_GEODESIC_PROCESSING_EXPORT
void normalize(std::vector<Vec3>& normals);

// Classifies how two surfels can be neighbors on a surface, by the product of the chord between
// them with the sum of their normals. On a circular arc, the chord is perpendicular to the sum.
// Between two parallel sheets it is not. Across a sharp edge or with noise, it need not be.
enum class Compatibility
{
  incompatible,
  steep,
  gentle
};

struct Compatibility_test
{
  double cosine; // of the maximum angle between the normals

  // Bounds of the product of the sum of the normals with the unit vector of the chord. The gentle
  // bound separates parallel sheets at the distance of one spacing: it only admits chords to the
  // other sheet that are at least 4 spacings long. The steep bound, for chords across sharp edges,
  // increases with the difference of the normals.
  static constexpr double max_gentle_rise = 0.5, max_steep_rise = 1., rise_gain = 0.7;

  // Classifies the surfels at p and q with the unit normals n and m.
  Compatibility operator()(const Vec3& p, const Vec3& n, const Vec3& q, const Vec3& m) const
  {
    const double normal_cosine = dot(n, m);
    if(normal_cosine <= cosine)
      return Compatibility::incompatible;
    const Vec3 chord = q - p;
    const double rise = dot(n, chord) + dot(m, chord), squared_length = dot(chord, chord);
    if(rise * rise <= max_gentle_rise * max_gentle_rise * squared_length)
      return Compatibility::gentle;
    const double max_rise =
        std::min(max_steep_rise,
                 max_gentle_rise + rise_gain * std::sqrt(std::max(0., 2. - 2. * normal_cosine)));
    return rise * rise <= max_rise * max_rise * squared_length ? Compatibility::steep
                                                               : Compatibility::incompatible;
  }
};

// Surfels in the order of the kd-tree of their points. Coincident surfels with compatible normals
// are represented by one vertex, which is the first of them.
struct Sorted_surfels
{
  Frame frame;                        // caller's point = origin + scale * ours
  std::vector<Vec3> point, normal;    // #vertices
  Kd_tree tree;                       // of the points
  std::vector<Index> internal_vertex; // #surfels: the vertex of each surfel
  std::vector<Index> caller_vertex;   // #vertices: the surfel of each vertex
};

// Sorts surfels and merges coincident ones.
//
// normals  #surfels: unit vectors
// cosine   coincident surfels are merged if the cosine between their normals exceeds this number
// frame    the scaling of the coordinates; if null, it is unit_frame() of the points
//
// Throws the exceptions of unit_frame(). O(n log n).
CGAL_GEODESIC_PROCESSING_EXPORT
Sorted_surfels sort_surfels(std::vector<Vec3> points, const std::vector<Vec3>& normals,
                            double cosine, unsigned number_of_threads,
                            const Frame* frame = nullptr);

// Rows of different lengths, which several threads fill block by block. A block consists of
// `surfel_block_size` rows and has its own buffer. begin() and end() work before and after join().
class Ragged_rows
{
public:
  explicit Ragged_rows(std::size_t size)
      : row_begin(size + 1, 0), m_buffers((size + surfel_block_size - 1) / surfel_block_size)
  {}

  // Returns the entries of a block. Append the rows of the block in order, and call end_row()
  // after each.
  std::vector<Index>& buffer(std::size_t block) { return m_buffers[block]; }
  void end_row(std::size_t block, std::size_t row)
  {
    row_begin[row + 1] = static_cast<Index>(m_buffers[block].size());
  }
  // Replaces the rows of a block: calls append(row, begin, end, result) with the entries of each
  // row, which appends those of the new row. Different threads may replace different blocks.
  template <typename Append>
  void replace_rows(std::size_t block, const Append& append)
  {
    std::vector<Index>& buffer = m_buffers[block];
    std::vector<Index> result;
    result.reserve(buffer.size());
    const std::size_t last = std::min((block + 1) * surfel_block_size, row_begin.size() - 1);
    Index begin = 0;
    for(std::size_t row = block * surfel_block_size; row < last; ++row)
    {
      const Index end = row_begin[row + 1];
      append(row, buffer.data() + begin, buffer.data() + end, result);
      row_begin[row + 1] = static_cast<Index>(result.size());
      begin = end;
    }
    buffer.assign(result.begin(), result.end()); // mostly in the allocated memory
  }
  // Concatenates the blocks: row i consists of the entries row_begin[i] .. row_begin[i + 1] - 1.
  void join()
  {
    std::size_t total = 0;
    for(std::size_t block = 0; block < m_buffers.size(); ++block)
    {
      const std::size_t end = std::min((block + 1) * surfel_block_size, row_begin.size() - 1);
      for(std::size_t row = block * surfel_block_size; row < end; ++row)
        row_begin[row + 1] += static_cast<Index>(total);
      total += m_buffers[block].size();
    }
    entries.reserve(total);
    for(auto& buffer : m_buffers)
    {
      entries.insert(entries.end(), buffer.begin(), buffer.end());
      std::vector<Index>().swap(buffer); // frees the memory
    }
    m_buffers.clear();
  }

  const Index* begin(std::size_t row) const
  {
    const std::size_t block = row / surfel_block_size;
    return m_buffers.empty()              ? entries.data() + row_begin[row]
           : row % surfel_block_size == 0 ? m_buffers[block].data()
                                          : m_buffers[block].data() + row_begin[row];
  }
  const Index* end(std::size_t row) const
  {
    const Index* const data =
        m_buffers.empty() ? entries.data() : m_buffers[row / surfel_block_size].data();
    return data + row_begin[row + 1];
  }

  std::vector<Index> row_begin, entries; // valid after join()

private:
  std::vector<std::vector<Index>> m_buffers;
};

// Calls visit(block, i, found) for each point i of the tree. `found` contains the point itself and
// its `count` nearest points, sorted by distance. Threads visit different blocks in parallel.
template <typename Visit>
void visit_nearest(const std::vector<Vec3>& point, const Kd_tree& tree, std::size_t count,
                   unsigned number_of_threads, const Visit& visit)
{
  for_each_block(tree.size(), surfel_block_size, number_of_threads,
                 [&](std::size_t block, std::size_t begin, std::size_t end)
                 {
                   Leaf_neighbors nearest(point, tree, count + 1);
                   std::vector<Kd_tree::Neighbor> found;
                   for(Index i = static_cast<Index>(begin), last; i < end; i = last)
                   {
                     last = std::min(static_cast<Index>(end), nearest.leaf_end(i));
                     auto row = nearest.find(i, last).begin();
                     for(Index j = i; j < last; ++j, row += nearest.size())
                     {
                       found.assign(row, row + nearest.size());
                       visit(block, j, found);
                     }
                   }
                 });
}

// Distances from surfels to their nearest surfels, regardless of the normals.
struct Neighbor_distances
{
  // #surfels: all surfels within this distance were candidates; infinity if all of the cloud were
  std::vector<double> search_radius;
  std::vector<double> spacing; // #surfels: distance to the sixth nearest surfel, or the last one
};

// Computes for each surfel its `count` nearest surfels without the incompatible ones, sorted by
// distance. If `compatibility_test` is null, all of them are kept. Sets `distances`. The rows
// are not joined. O(n log n).
CGAL_GEODESIC_PROCESSING_EXPORT
Ragged_rows find_neighbors(const Sorted_surfels& surfels,
                           const Compatibility_test* compatibility_test, std::size_t count,
                           unsigned number_of_threads, Neighbor_distances& distances);

// Returns the scaled radius of each vertex. If `radii` (#surfels) is not empty, it is the given
// radius, but at most 8: this is larger than the cloud, and its square cannot overflow. Otherwise
// it is the distance to the neighbor of the given rank, or to the last one if there are fewer,
// divided by sqrt(2). Throws Invalid_argument_error if a given radius is negative or not finite.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<double> surfel_radii(const Sorted_surfels& surfels, const std::vector<double>& radii,
                                 const Ragged_rows& neighbors, std::size_t rank,
                                 unsigned number_of_threads);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_NEIGHBORS_H
