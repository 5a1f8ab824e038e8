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

// Mean value coordinates of points in space with respect to a closed mesh (Ju, Schaefer and Warren 2005):
// a number for each site, whose sum is one, and with which the sites' points sum to the point.
//
// They are the means, over all directions from the point, of the hat functions where the ray leaves the
// mesh, less those where it enters, over the distance from there.  Inside of a convex mesh they are
// positive.  They are continuous, and on the surface barycentric coordinates of its triangles.
class CGAL_GEODESIC_PROCESSING_EXPORT Mean_value_coordinates
{
public:
  // Throws Unsupported_surface_error when there is no triangle, or one with a side on a border.
  explicit Mean_value_coordinates(std::shared_ptr<const Surface_arrays> triangles);

  // point  in the caller's coordinates.
  // Within 1e-12 of the surface, relative to its extent, they are those of the nearest point on it.
  // Throws Invalid_argument_error when a coordinate is not finite, and Unsupported_surface_error when
  // rounding hides where the inside is: there is none, or the point is too far away.  O(n)
  Vector operator()(const Vec3& point) const;

  // Whether two points, off the surface, are on the same side of it.  Throws as operator().
  bool are_on_same_side(const Vec3& p, const Vec3& q) const;

private:
  // Coordinates times their sum, which is positive on one side; on the surface the sum is infinite.
  std::pair<Vector, double> weights(const Vec3& point) const;

  std::shared_ptr<const Surface_arrays> m_triangles;
  double m_distance_tolerance; // distances below are zero
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_MEAN_VALUE_H
