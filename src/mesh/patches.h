// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_PATCHES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_PATCHES_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <array>
#include <vector>

// A mesh in patches: a label for each triangle, or none for those that are in no patch.

namespace CGAL::Geodesic_processing::internal {

// Triangles go with two of their corners, or with the nearest one; those with a corner of none have none.
// distances, labels  #sites
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Index> label_patches(const Surface_arrays& triangles,
                                 const std::vector<double>& distances,
                                 const std::vector<Index>& labels);

// Leaves each patch its largest part: the others, and what meets its patch in a corner alone, go to
// a patch next to them, as far as there is one.  O(n).
CGAL_GEODESIC_PROCESSING_EXPORT
void merge_patch_fragments(const Surface_arrays& triangles, std::vector<Index>& patch);

// Which patches are discs: one piece with one border that touches itself nowhere.  O(n).
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<bool> are_disks(const Surface_arrays& triangles, const std::vector<Index>& patch,
                            Index number_of_patches);

// Two labels for the triangles of one piece: 0 where fewer sides are in between to the first triangle, else 1.  O(n).
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Index> bisect_patch(const Surface_arrays& triangles, Index first, Index second);

// Two triangles of one piece with about as many sides in between as can be.  O(n).
CGAL_GEODESIC_PROCESSING_EXPORT
std::array<Index, 2> farthest_triangle_pair(const Surface_arrays& triangles);

// Halves those that are none, until all are: parts get the next labels.  Returns a triangle of each of
// these.  O(n log n).
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Index> split_into_disks(const Surface_arrays& triangles, std::vector<Index>& patch,
                                    Index number_of_patches);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_PATCHES_H
