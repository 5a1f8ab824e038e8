// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_NONCONTRACTIBLE_LOOP_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_NONCONTRACTIBLE_LOOP_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Computes a shortest loop from a canonical location to itself among those that are not
// contractible. Returns no location if all loops are contractible. The first and the last location
// are the given one.
//
// Let U be the length of some noncontractible loop. The two halves of the loop are shortest paths
// in the universal cover (Erickson and Whittlesey 2005). So its midpoint is in a triangle of which
// two copies are closer than U/2 to the same copy of the location. The homotopy classes of all
// these pairs of copies are collected. For each class, Window_propagation finds the shortest path
// between two copies of the location, on the union of two disks of this radius. Classes whose lower
// bound exceeds the shortest loop are skipped.
//
// The length is exact up to round-off errors, as that of Window_propagation::path_between(). A loop
// does not pass from one fan of a nonmanifold vertex to another.
//
// Takes some window propagations on the triangles that are closer than U/2.
//
// Throws Unsupported_surface_error on a cloud, and as Window_propagation::run().
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Surface_location> shortest_noncontractible_loop(const Surface_arrays& triangles,
                                                            const Surface_location& through);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_NONCONTRACTIBLE_LOOP_H
