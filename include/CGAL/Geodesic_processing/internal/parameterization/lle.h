// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_LLE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_LLE_H

#include <CGAL/Geodesic_processing/internal/parameterization/base_points.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

// Geodesic locally linear embedding (Peyré and Cohen 2005, section 3).

namespace CGAL::Geodesic_processing::internal {

// How many of its nearest base points each site has to know, for so many neighbours: their distances from each
// other are measured where fronts meet, which lies somewhat outside now and then.  With half as many more instead of a
// quarter maps take a seventh longer, and differ where they turn faces round anyway.
constexpr std::size_t number_of_nearest_for(std::size_t neighbors)
{
  return neighbors + (neighbors + 2) / 4 + 1;
}

// Places in the plane from the squares of all distances: the two largest eigenvectors of the centred matrix.
CGAL_GEODESIC_PROCESSING_EXPORT
Eigen::MatrixXd classical_scaling(const Eigen::MatrixXd& squares);

// Places of base points in the plane: the eigenvectors of the locally linear embedding under the linear map
// that fits distances between neighbours best, then moved until neighbourhoods are as rigid as possible; or the
// same from classical scaling along chains of neighbours, where that leaves less.  Where the surface is a piece of
// the plane both leave nothing.  Where groups of points have no neighbours in each other, each gets more, as far
// as they are known.
//
// Empty where these are still apart, or the points less than three.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Vec2> embed_base_points(const Base_points& base, std::size_t neighbors);

// Where every site goes, one without base points to what is not a number.  Continuous; a base point is where its
// image is, and a piece of the plane is mapped linearly.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Vec2> extend_embedding(const Base_points& base, const std::vector<Vec2>& images,
                                   std::size_t neighbors);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_LLE_H
