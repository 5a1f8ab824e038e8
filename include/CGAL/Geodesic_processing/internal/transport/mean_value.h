// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_MEAN_VALUE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_MEAN_VALUE_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/numerics/Sparse_solver.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <memory>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

// Computes mean value coordinates of a point in space with respect to a closed mesh (Ju, Schaefer
// and Warren 2005): one number for each vertex. They sum to 1, and the weighted sum of the vertices
// is the point.
//
// For each ray from the point, the hat functions are divided by the distance at every intersection
// with the mesh. They are added at an exit and subtracted at an entry. The coordinates are the mean
// over all directions, normalized. They are continuous. Inside of a convex mesh they are positive.
// On the surface they are the barycentric coordinates.
class CGAL_GEODESIC_PROCESSING_EXPORT Mean_value_coordinates
{
public:
  // Throws Unsupported_surface_error if the mesh has no triangle or has a boundary.
  explicit Mean_value_coordinates(std::shared_ptr<const Surface_arrays> triangles);

  // Returns the coordinates of a point, given in the input coordinates. If the point is closer to
  // the surface than 1e-12 times the extent, the coordinates of the closest point are returned.
  // O(n)
  //
  // Throws Invalid_argument_error if a coordinate is not finite. Throws Unsupported_surface_error
  // if the sum of the weights is only a round-off error. This is the case if the mesh has no
  // interior or the point is too far away.
  Vector operator()(const Vec3& point) const;

  // Returns true if both points, which must not be on the surface, are inside or both are outside.
  // Throws as operator().
  bool are_on_same_side(const Vec3& p, const Vec3& q) const;

private:
  // Returns unnormalized coordinates and their sum. The sum is positive on one side of the surface.
  // On the surface it is infinite, and the coordinates are normalized.
  std::pair<Vector, double> weights(const Vec3& point) const;

  std::shared_ptr<const Surface_arrays> m_triangles;
  double m_distance_tolerance; // smaller distances count as zero
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_MEAN_VALUE_H
