// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_PACKING_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_PACKING_H

#include <CGAL/Geodesic_processing/internal/parameterization/outline.h>

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Where outlines go in a square texture: scaled by one factor, turned, and moved.
struct Packing
{
  double scale = 0.;            // texels per length
  std::vector<Vec2> directions; // #outlines: unit vectors, where the first axis is turned to
  std::vector<Vec2> offsets;    // #outlines, in texels: of the origin, from the lower left corner

  Vec2 operator()(std::size_t outline, const Vec2& point) const
  {
    return offsets[outline] + scale * rotated(point, directions[outline]);
  }
};

// Throws Invalid_argument_error where a texture has no room for so many outlines however small they are, or
// a number is out of range.
CGAL_GEODESIC_PROCESSING_EXPORT
void check_fits(std::size_t number_of_outlines, std::size_t texels, std::size_t gutter);

// Packs simple outlines into a square of so many texels, as large as it finds room for.  Between any two of them,
// along one of both axes, are `gutter` texels at least, and half as many to the sides of the square.
//
// Each comes into the lowest place, then the leftmost one, where its silhouette on a grid of cells fits, in one of
// four directions along its smallest rectangle; the longest one first.  Places between those that are there are
// found too, as all columns of a row of cells are tried at once by operations on words.
//
// Throws Invalid_argument_error where there is no room however small they are.
CGAL_GEODESIC_PROCESSING_EXPORT
Packing pack(const std::vector<Outline>& outlines, std::size_t texels, std::size_t gutter,
             unsigned threads);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_PACKING_H
