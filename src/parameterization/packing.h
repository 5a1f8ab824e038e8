// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_PACKING_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_PACKING_H

#include <CGAL/Geodesic_processing/internal/parameterization/outline.h>

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The similarity transformations that put outlines into a square texture. All have the same scale.
struct Packing
{
  double scale = 0.; // texels per length
  // #outlines: unit vectors, the images of the first axis under the rotations
  std::vector<Vec2> directions;
  // #outlines: translations in texels, relative to the lower left corner of the texture
  std::vector<Vec2> offsets;

  Vec2 operator()(std::size_t outline, const Vec2& point) const
  {
    return offsets[outline] + scale * rotated(point, directions[outline]);
  }
};

// Throws Invalid_argument_error if a parameter is out of range, or if so many outlines do not fit
// into the texture at any scale.
CGAL_GEODESIC_PROCESSING_EXPORT
void check_fits(std::size_t number_of_outlines, std::size_t texels, std::size_t gutter);

// Packs simple outlines into a square of `texels` x `texels` at the largest scale that it finds.
// The gap between two outlines is at least `gutter` texels along at least one axis, and half of it
// to the boundary of the square.
//
// Outlines are inserted by decreasing size. Each gets the lowest position, then the leftmost, at
// which its rasterized silhouette is free, in one of four orientations along its smallest
// rectangle. Gaps between outlines are used, too, because all columns of a row are tested at once
// by bit operations.
//
// Throws Invalid_argument_error if the outlines do not fit at any scale.
CGAL_GEODESIC_PROCESSING_EXPORT
Packing pack(const std::vector<Outline>& outlines, std::size_t texels, std::size_t gutter,
             unsigned number_of_threads);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_PACKING_H
