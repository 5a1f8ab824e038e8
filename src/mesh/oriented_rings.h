// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_ORIENTED_RINGS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_ORIENTED_RINGS_H

#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>

#include <cstddef>
#include <optional>

namespace CGAL::Geodesic_processing::internal {

// Fills `twin`, `ring_begin` and `ring` from `corner`, in the order of build_rings(), and returns
// the numbers of fans. Returns nothing if an edge has three or more triangles, or two of opposite
// orientations; then the arrays are not complete. O(n) time for bounded degrees.
//
// All data of a vertex is found in its own triangles, so that the time is that of one pass over the
// memory if the triangles are in the order of their smallest vertex.
CGAL_GEODESIC_PROCESSING_EXPORT
std::optional<Ring_counts> build_oriented_rings(Surface_arrays& arrays,
                                                std::size_t number_of_vertices,
                                                unsigned number_of_threads);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_ORIENTED_RINGS_H
