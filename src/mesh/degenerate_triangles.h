// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_DEGENERATE_TRIANGLES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_DEGENERATE_TRIANGLES_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <memory>

namespace CGAL::Geodesic_processing::internal {

// Returns the triangles of a mesh with edge lengths that satisfy the triangle inequality strictly:
// in each triangle, two edges are together longer than the third one by at least 1e-15 of it. Only
// the two shorter edges of degenerate triangles become longer, by about that much. The exception
// are triangles with three edges of length zero.
//
// The height above the longest edge is proportional to the square root of the difference. With at
// most 3e-8 of the edge it hardly changes distances. It is large enough to compute directions from
// an apex that was on the edge.
//
// Returns `mesh` itself if it has no degenerate triangle. O(#triangles).
//
// Reference: N. Sharp and K. Crane, A Laplacian for nonmanifold triangle meshes, 2020 (intrinsic
// mollification). There, as in mollify(), all edges become longer by the same length.
CGAL_GEODESIC_PROCESSING_EXPORT
std::shared_ptr<const Surface_arrays>
without_degenerate_triangles(std::shared_ptr<const Surface_arrays> mesh);

// How much the distances on a mesh with edge lengths in double precision differ from those on the
// input, beyond relative errors of 2e-12.
struct Distance_error
{
  double excess = 0.;    // they are at most this much too long
  double shortfall = 0.; // they are at most this much too short
};

// Returns bounds of the error, the sums of errors of single triangles. A shortest path crosses each
// triangle at most once. Other triangles than these have no part in it:
//
// - Thin ones, whose longest edge c exceeds the height h more than 30 times: The edge lengths have
//   relative errors of 2 epsilon, and unfolding adds as much. The square of a segment is a
//   combination of the squared lengths whose coefficients have a sum of at most 5/4. Its error is
//   at most 10 epsilon c^2. The error of a segment with two ends on the boundary is at most the
//   root of that, and at most 10 epsilon c^2 / h. The excess and the shortfall contain this error.
// - Degenerate ones, whose two shorter edges exceed the third one by less than 1e-14 of it: The
//   height is a round-off error of the lengths, or that of without_degenerate_triangles(). It is
//   added to the excess. The height on the input is added to the shortfall.
// - Those with edges that are longer than the distance of their ends, because shorter edges are set
//   to min_edge_length: The difference is added to the excess.
//
// Complexity: O(#triangles).
CGAL_GEODESIC_PROCESSING_EXPORT
Distance_error distance_error_of_thin_triangles(const Surface_arrays& mesh);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_DEGENERATE_TRIANGLES_H
