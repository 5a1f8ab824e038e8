// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_DELAUNAY_RINGS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_DELAUNAY_RINGS_H

#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include <CGAL/Geodesic_processing/internal/spatial_search/Kd_tree.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_neighbors.h>

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Number of nearest surfels from which the ring of a surfel is computed. On a thin sheet, half of
// them belong to the other side and the remaining 12 still suffice for a ring.
constexpr std::size_t number_of_ring_neighbors = 24;

// The surfels of the tree: one for each set of coincident surfels with compatible normals.
struct Distinct_surfels
{
  const std::vector<Vec3>& point; // at least tree.size()
  const std::vector<Vec3>& normal;
  const Kd_tree& tree;
  Compatibility_test compatibility_test;
  unsigned number_of_threads;

  std::size_t size() const { return tree.size(); }
  Compatibility compatibility(Index a, Index b) const
  {
    return compatibility_test(point[a], normal[a], point[b], normal[b]);
  }
};

// Computes for each surfel its triangles in the Delaunay triangulation of the projections of its
// neighbors to its tangent plane.
//
// neighbors      #surfels: the `number_of_ring_neighbors` nearest surfels without incompatible ones
// search_radius  #surfels: the distance up to which `neighbors` is complete
// radius         #surfels: a triangle is omitted if its circumradius exceeds
//                `max_circumradius_ratio` times the smallest radius of its corners
//
// Returns for each surfel the other corners of its triangles, counterclockwise. Consecutive
// entries a, b stand for the triangle (surfel, a, b). `none` separates two fans of triangles. It
// also terminates the last fan, unless the triangles surround the surfel. The rows are not joined.
// O(n log n).
CGAL_GEODESIC_PROCESSING_EXPORT
Ragged_rows find_delaunay_rings(const Distinct_surfels& surfels, const Ragged_rows& neighbors,
                                const std::vector<double>& search_radius,
                                const std::vector<double>& radius);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_DELAUNAY_RINGS_H
