// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_PATH_SURFACE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_PATH_SURFACE_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

namespace CGAL::Geodesic_processing::internal {

// The point of a surface that is nearest to a place.
struct Projection
{
  Vec3 point = {0., 0., 0.};
  Vec3 normal = {0., 0., 0.};   // of the surface, of either sign; zero where it is not known
  Vec3 conormal = {0., 0., 0.}; // where the surface ends here: the unit tangent that leaves it
  Index vertex = none;          // where the search for the next foot may begin
};

// All that a path has to know of the surface it runs on.
class Path_surface
{
public:
  virtual ~Path_surface() = default;

  // `near`: the site of the foot of a point nearby, or none.
  virtual Projection project(const Vec3& point, Index hint) const = 0;

  // What a curve has instead of a point that is near the surface, where that goes less far.
  virtual Vec3 clamped_to_coverage(const Vec3& point, Index) const { return point; }
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_PATH_SURFACE_H
