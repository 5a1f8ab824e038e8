// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATH_SURFACE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATH_SURFACE_H

#include <CGAL/Geodesic_processing/internal/core/Glued_triangles.h>
#include <CGAL/Geodesic_processing/internal/core/spatial.h>

namespace CGAL::Geodesic_processing::internal {

// The point of a surface that is nearest to a place.
struct Foot
{
  Spatial point = {0., 0., 0.};
  Spatial normal = {0., 0., 0.}; // of the surface, of either sign; zero where it is not known
  Spatial rim = {0., 0., 0.};    // where the surface ends here: the unit tangent that leaves it
  Index site = none;             // where the search for the next foot may begin
};

// All that a path has to know of the surface it runs on.
class Path_surface
{
public:
  virtual ~Path_surface() = default;

  // `near`: the site of the foot of a point nearby, or none.
  virtual Foot foot(const Spatial& point, Index near) const = 0;

  // What a curve has instead of a point that is near the surface, where that goes less far.
  virtual Spatial drawn_near(const Spatial& point, Index) const { return point; }
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATH_SURFACE_H
