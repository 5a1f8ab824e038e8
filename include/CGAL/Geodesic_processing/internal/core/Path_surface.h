// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_PATH_SURFACE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_PATH_SURFACE_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

namespace CGAL::Geodesic_processing::internal {

// The closest point of a surface to a query point.
struct Projection
{
  Vec3 point = {0., 0., 0.};
  Vec3 normal = {0., 0., 0.}; // of the surface, of either sign; zero if unknown
  // if the point is on the boundary: the unit tangent that points off the surface
  Vec3 conormal = {0., 0., 0.};
  Index vertex = none; // a vertex near the point, a hint for the next query; or none
};

// The surface that a path is kept on.
class Path_surface
{
public:
  virtual ~Path_surface() = default;

  // Returns the closest point of the surface to `point`. `hint` is the vertex of the projection of
  // a point nearby, or none.
  virtual Projection project(const Vec3& point, Index hint) const = 0;

  // Returns `point` if it is close enough to the surface; otherwise a point that is. The vertex is
  // a hint as above. By default the surface has no such limit.
  virtual Vec3 clamped_to_coverage(const Vec3& point, Index) const { return point; }
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_PATH_SURFACE_H
