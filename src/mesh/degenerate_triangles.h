// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_DEGENERATE_TRIANGLES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_DEGENERATE_TRIANGLES_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <memory>

namespace CGAL::Geodesic_processing::internal {

// Returns the triangles of a mesh with edge lengths that satisfy the triangle inequality strictly:
// in each triangle, two edges are together longer than the third one by at least 1e-15 of it.  Only
// the two shorter edges of degenerate triangles become longer, by about that much.  The exception
// are triangles with three edges of length zero.
//
// The height above the longest edge is proportional to the square root of the difference.  With at
// most 3e-8 of the edge it hardly changes distances.  It is large enough to compute directions from
// an apex that was on the edge.
//
// Returns `mesh` itself if it has no degenerate triangle.  O(#triangles).
//
// Reference: N. Sharp and K. Crane, A Laplacian for nonmanifold triangle meshes, 2020 (intrinsic
// mollification).  There, as in mollify(), all edges become longer by the same length.
CGAL_GEODESIC_PROCESSING_EXPORT
std::shared_ptr<const Surface_arrays>
without_degenerate_triangles(std::shared_ptr<const Surface_arrays> mesh);

// Returns the sum of the heights of triangles whose two shorter edges exceed the third one by less
// than 1e-14 of it.  There the height is a round-off error of the lengths, or that of
// without_degenerate_triangles().  The sum also contains the edges of minimum length, which can be
// longer than on the input.  A path crosses each triangle at most once.  Therefore a distance
// exceeds the one on the input by at most this length, up to other round-off errors.  O(#triangles)
CGAL_GEODESIC_PROCESSING_EXPORT
double total_height_of_degenerate_triangles(const Surface_arrays& mesh);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_DEGENERATE_TRIANGLES_H
