// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_ORIENT_TRIANGLES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_ORIENT_TRIANGLES_H

#include <CGAL/Geodesic_processing/Soup_report.h>
#include <CGAL/Geodesic_processing/internal/core/Index.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Flips triangles for a consistent orientation, as few as possible in each component. Returns the
// twins of all halfedges. A component in which no consistent orientation exists is split at edges.
// Counts flipped triangles, split edges and components.
//
// corners: 3 #triangles, three different points each
// opposites: 3 #triangles, the other halfedge between the same two points, in either direction;
//            none if the edge has one halfedge or more than two
// O(n).
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Index> orient_triangles(std::vector<Index>& corners, std::vector<Index> opposites,
                                    Soup_report& report);

// Counts the connected components of the triangles, joined by edges. O(n) in practice.
// twins: 3 #triangles, the opposite halfedge or none
CGAL_GEODESIC_PROCESSING_EXPORT
std::size_t count_components(const std::vector<Index>& twins);

// Counts the boundary cycles, and computes the genus from this number, that of the components, which
// must be known, and that of the fans around all points. O(n).
CGAL_GEODESIC_PROCESSING_EXPORT
void measure_topology(std::size_t number_of_fans, const std::vector<Index>& twins,
                      Soup_report& report);

// Counts the fans of triangles around all points, and the points at which several fans meet. Returns
// the number of fans. O(n).
CGAL_GEODESIC_PROCESSING_EXPORT
std::size_t count_fans(std::size_t number_of_points, const std::vector<Index>& corners,
                       const std::vector<Index>& twins, Soup_report& report);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_ORIENT_TRIANGLES_H
