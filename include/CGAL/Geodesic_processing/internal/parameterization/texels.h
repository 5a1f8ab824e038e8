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

// What the middles of texels show: rows from the lowest one up.
struct Texel_map
{
  std::size_t size = 0;                 // along a side
  std::vector<Index> triangle;          // size * size: the nearest triangle, or none
  std::vector<double> squared_distance; // size * size: how far it is, squared in texels; 0 inside
};

// The triangles whose images are within `margin` texels from the middles of texels; of several the nearest one,
// then the first.
//
// coordinates  3 #triangles: of corners in the unit square
// Throws Invalid_argument_error where the texture has no texels, or more than 2^28.  O(texels + triangles).
CGAL_GEODESIC_PROCESSING_EXPORT
Texel_map rasterize_texels(const std::vector<Vec2>& coordinates, std::size_t size, double margin);

// Of the place of an image that is nearest to another place in the plane.
CGAL_GEODESIC_PROCESSING_EXPORT
std::array<double, 3> nearest_barycentric(const std::array<Vec2, 3>& image, const Vec2& point);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_TEXELS_H
