// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_PATCHES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_PATCHES_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <array>
#include <vector>

// A mesh is divided into patches by a label for each triangle; triangles in no patch have the label
// none.

namespace CGAL::Geodesic_processing::internal {

// Computes a label for each triangle from labels of vertices: the label of two or three of its
// corners, or otherwise the label of the corner of smallest distance. If a corner has no label,
// the triangle has none.
//
// distances, labels: #vertices
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Index> label_patches(const Surface_arrays& triangles,
                                 const std::vector<double>& distances,
                                 const std::vector<Index>& labels);

// Keeps the largest connected piece of each patch and, at each vertex, one sector of each patch.
// All other pieces and sectors are merged into an adjacent patch, if there is one. O(n).
CGAL_GEODESIC_PROCESSING_EXPORT
void merge_patch_fragments(const Surface_arrays& triangles, std::vector<Index>& patch);

// Returns for each patch whether it is a topological disk: connected, with one boundary cycle that
// visits no vertex twice. Patches of at most one triangle count as disks. O(n).
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<bool> are_disks(const Surface_arrays& triangles, const std::vector<Index>& patch,
                            Index number_of_patches);

// Bisects a connected mesh. Returns the label 0 for triangles that are reached over fewer edges
// from `first`, otherwise 1. O(n).
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Index> bisect_patch(const Surface_arrays& triangles, Index first, Index second);

// Returns two triangles of a connected mesh that are far apart, measured by the number of edges
// between them: a double sweep of breadth-first search. O(n).
CGAL_GEODESIC_PROCESSING_EXPORT
std::array<Index, 2> farthest_triangle_pair(const Surface_arrays& triangles);

// Splits connected components off and bisects patches until all are disks. New patches get the
// next labels. Returns one triangle of each new patch. O(n log n).
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Index> split_into_disks(const Surface_arrays& triangles, std::vector<Index>& patch,
                                    Index number_of_patches);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_PATCHES_H
