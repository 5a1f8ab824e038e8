// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_TEXELS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_TEXELS_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The triangles at the centers of the texels. Rows are in the order of increasing v.
struct Texel_map
{
  std::size_t size = 0;        // texels per row
  std::vector<Index> triangle; // size * size: the closest triangle, or none
  // size * size: the squared distance to it in texels; 0 inside
  std::vector<double> squared_distance;
};

// Finds, for the center of each texel, the closest triangle image within `margin` texels. Of
// several at the same distance, the first is chosen.
//
// coordinates: 3 #triangles: UV coordinates of each corner in the unit square
// Throws Invalid_argument_error if `size` is zero or above 2^14. O(texels + triangles).
CGAL_GEODESIC_PROCESSING_EXPORT
Texel_map rasterize_texels(const std::vector<Vec2>& coordinates, std::size_t size, double margin);

// Computes the barycentric coordinates of the point of a triangle that is closest to a given point.
CGAL_GEODESIC_PROCESSING_EXPORT
std::array<double, 3> nearest_barycentric(const std::array<Vec2, 3>& image, const Vec2& point);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_TEXELS_H
