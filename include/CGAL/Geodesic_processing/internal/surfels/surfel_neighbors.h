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

// What makes two surfels of a cloud neighbours, and how the neighbours of all are found.

namespace CGAL::Geodesic_processing::internal {

// Of the blocks in which surfels are treated, whatever the number of threads.
inline constexpr std::size_t surfel_block_size = 2048;

// Throws Invalid_argument_error when there are not as many normals, or radii, as points, and
// Unsupported_surface_error above 2^25 points.  No radii at all are right too.
CGAL_GEODESIC_PROCESSING_EXPORT
void check_sizes(std::size_t points, std::size_t normals, std::size_t radii);

// Makes vectors of any positive length unit vectors.
// Throws Invalid_argument_error when one has no direction.
CGAL_GEODESIC_PROCESSING_EXPORT
void normalize(std::vector<Vec3>& normals);

// How two surfels can be neighbours on a surface.  The chord of a circular arc makes equal angles
// with both normals, so that the sum of the normals is perpendicular to it; between two parallel
// sheets it is not, and across noise or a sharp edge it need not be.
enum class Compatibility
{
  incompatible,
  steep,
  gentle
};

struct Compatibility_test
{
  double cosine;

  // Largest products of the sum of the normals with the direction of the chord.  The first holds
  // parallel sheets at a distance of one mean spacing apart: chords to the other sheet would have to
  // be 4 spacings long.  Chords across sharp edges rise more, by as much as the normals differ.
  static constexpr double max_gentle_rise = 0.5, max_steep_rise = 1., rise_gain = 0.7;

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

// Surfels in the order of a tree over their points.  Those at one point with agreeing normals are one
// site, the first of them.
struct Sorted_surfels
{
  Frame frame;                        // caller's point = origin + scale * ours
  std::vector<Vec3> point, normal;    // #sites
  Kd_tree tree;                       // over the points
  std::vector<Index> internal_vertex; // #surfels
  std::vector<Index> caller_vertex;   // #sites
};

// normals  of unit length; cosine  of the angle at which they do not agree any more; frame  or none for a
// unit_frame(), as which it throws
CGAL_GEODESIC_PROCESSING_EXPORT
Sorted_surfels sort_surfels(std::vector<Vec3> points, const std::vector<Vec3>& normals,
                            double cosine, unsigned threads, const Frame* frame = nullptr);

// Rows of different lengths, filled block by block, and read by begin() and end().
class Ragged_rows
{
public:
  explicit Ragged_rows(std::size_t size)
      : row_begin(size + 1, 0), m_buffers((size + surfel_block_size - 1) / surfel_block_size)
  {}

  std::vector<Index>& buffer(std::size_t block) { return m_buffers[block]; }
  void end_row(std::size_t block, std::size_t row)
  {
    row_begin[row + 1] = static_cast<Index>(m_buffers[block].size());
  }
  // Puts all rows into `entries`, one after another, where `first` says.
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
      buffer = {};
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

  std::vector<Index> row_begin, entries; // when joined

private:
  std::vector<std::vector<Index>> m_buffers;
};

// Calls visit(block, i, found) for each point of the tree with itself and its `count` nearest ones,
// nearest first.
template <typename Visit>
void visit_nearest(const std::vector<Vec3>& point, const Kd_tree& tree, std::size_t count,
                   unsigned threads, const Visit& visit)
{
  for_each_block(tree.size(), surfel_block_size, threads,
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

// What lies around a surfel, whatever the normals.
struct Neighbor_distances
{
  std::vector<double> search_radius; // #surfels: the distance up to which all points have been seen
  std::vector<double> spacing; // #surfels: the distance to the sixth nearest, or the last if fewer
};

// The `count` nearest points of each, without those that do not agree with it, nearest first; all of
// them without an `agree`.  Rows are not joined.
CGAL_GEODESIC_PROCESSING_EXPORT
Ragged_rows find_neighbors(const Sorted_surfels& surfels,
                           const Compatibility_test* compatibility_test, std::size_t count,
                           unsigned threads, Neighbor_distances& distances);

// For each site the radius given, in the unit of the frame and no larger than the cloud, where squares are
// safe; or where none are given the distance to its neighbour of a rank, or the last, over sqrt(2).
// Throws Invalid_argument_error when one is negative or not finite.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<double> surfel_radii(const Sorted_surfels& surfels, const std::vector<double>& radii,
                                 const Ragged_rows& neighbors, std::size_t rank, unsigned threads);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_NEIGHBORS_H
