// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_STATE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_STATE_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_pool.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_queue.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The last segment of a path to a vertex.
struct Window_arrival
{
  double distance = infinity; // minus the smallest offset
  // The unit vector to the source in the plane of the triangle of `corner`; the first axis is the
  // halfedge that leaves the corner.
  Vec2 direction = {1., 0.};
  Index corner = none; // a corner of the vertex; none if the vertex is on a source
  Index origin = none; // of the window, or the other end of the edge
};

// The piece of a source in a triangle, from `begin` to `end` in barycentric coordinates.
struct Source_piece
{
  Index triangle;
  Index source;
  std::array<double, 3> begin, end;
  double offset;
};

// The data of window propagation: the results of the last query, and the variables of the running
// one.
//
// Between two queries only the entries that `reached` and `queue` list, and the numbers of crossings
// in `crossed_blocks`, differ from their defaults.
//
// With a relative tolerance, the distances of vertices are lower bounds, and `upper` holds upper
// bounds.
struct CGAL_GEODESIC_PROCESSING_EXPORT Window_state
{
  struct Vertex : Window_arrival
  {
    Index source = none;
    Index state = 0; // flags
  };
  static constexpr Index reached_flag = 1;   // is in `reached`
  static constexpr Index finalized_flag = 2; // has relaxed its neighbors

  Window_state(std::shared_ptr<const Surface_arrays> triangles,
               std::shared_ptr<const std::vector<bool>> is_pseudo_source);
  // Resets everything that the last query changed, also a cancelled one; O(visited).
  void clear();
  // Sets the relative tolerance of the next query; requires a cleared state.
  void set_tolerance(double tolerance);

  // Returns the label of the source, and the distance, of the origin of windows.
  Index source_of(Index origin) const
  {
    return origin < vertices.size() ? vertices[origin].source
                                    : source_pieces[origin - vertices.size()].source;
  }
  double distance_of(Index origin) const
  {
    return origin < vertices.size() ? vertices[origin].distance
                                    : source_pieces[origin - vertices.size()].offset;
  }

  // Returns by how much the upper bound of a vertex exceeds its distance, rounded up.
  float error(Index vertex) const
  {
    return is_exact() ? 0.f
                      : std::nextafter(float(upper[vertex] - vertices[vertex].distance),
                                       std::numeric_limits<float>::infinity());
  }
  bool is_exact() const { return upper.empty(); }
  // Returns an upper bound of the distance of a vertex.
  double upper_bound(Index vertex) const
  {
    return is_exact() ? vertices[vertex].distance : upper[vertex];
  }

  std::shared_ptr<const Surface_arrays> triangles;
  std::shared_ptr<const std::vector<bool>> is_pseudo_source; // #vertices: paths may bend here
  double max_edge_length = 0.;

  std::vector<Vertex> vertices; // #vertices
  double relative_tolerance = 0.;
  std::vector<double> upper; // #vertices; empty if the relative tolerance is 0
  std::vector<Index> reached;
  Window_queue queue; // halfedges, and #halfedges + vertex

  Window_pool pool;
  std::vector<std::uint8_t> number_of_crossings; // #halfedges: how often windows have crossed it
  // Blocks of so many halfedges need 1/64 of the memory of a list of all crossed halfedges.
  static constexpr Index block_size = 64;
  std::vector<bool> is_crossed_block; // #halfedges / block_size, rounded up
  std::vector<Index> crossed_blocks;
  // The windows that have crossed a halfedge, if it has been crossed often.
  std::unordered_map<Index, std::vector<Window>> known_windows;
  std::vector<Window> windows; // 1 + those that cross now; the first entry is unused

  std::vector<Source_piece> source_pieces;
  std::vector<std::pair<Index, Index>> pieces_by_triangle; // (triangle, piece), sorted
  double min_offset = 0.;
  double max_distance = infinity; // minus min_offset
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_STATE_H
