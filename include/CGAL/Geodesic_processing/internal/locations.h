// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_LOCATIONS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_LOCATIONS_H

#include <CGAL/Geodesic_processing/internal/Glued_triangles.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The site at a location, or none where it lies inside a side or a triangle.
CGAL_GEODESIC_PROCESSING_EXPORT
Index site_at(const Glued_triangles& triangles, const Location& location);

// The triangles that hold a location: all around a site, one or two at a side, else one.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Index> triangles_at(const Glued_triangles& triangles, const Location& location);

// Writes the location in terms of a triangle; false when the triangle does not hold it.
CGAL_GEODESIC_PROCESSING_EXPORT
bool express(const Glued_triangles& triangles, const Location& location, Index triangle,
             Location& result);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_LOCATIONS_H
