// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_TRACE_ON_SURFACE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_TRACE_ON_SURFACE_H

#include <CGAL/Geodesic_processing/internal/core/Path_surface.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <functional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

struct Traced_curve
{
  std::vector<Projection> points;    // on the surface; the first one is the start
  Vec3 end_direction = {0., 0., 0.}; // unit tangent at the last point
  double length = 0.;                // of the smooth curve through the points
  bool is_cut_by_boundary = false;   // whether the curve is shorter than requested
};

// Traces a geodesic on a smooth surface that is given by its projection.
//
// The acceleration of a geodesic is normal to the surface, so its tangent is transported parallel.
// A step of length h solves this equation by collocation at its beginning, middle and end (Lobatto
// IIIA). The three points are projected to the surface, and the tangent is transported by the
// double reflection of Wang, Juettler, Zheng and Liu (2008), applied to the integral of the
// normals. The error of the endpoint and the direction is O(h^4) on smooth surfaces.
//
// If the normal changes by more than 15 degrees in a step, the step is halved, at most three times.
// If the normal still changes by more than 40 degrees, there is a sharp edge: both tangent planes
// are unfolded at their line of intersection.
//
// The curve ends at the boundary: where projections have a conormal, are displaced tangentially, or
// are not covered. The position of the boundary is found by bisection. Holes narrower than about
// four steps are crossed, because the surface that is fitted to a random cloud has such holes. A
// curve that would end in a hole ends in front of it and counts as cut.
//
// max_step   returns the maximum length of a step near a vertex; positive
// from       on the surface
// direction  projected to the tangent plane at `from`
// length     finite and not negative
//
// If the boundary is not reached, the relative difference of the length to the requested one is at
// most 1e-9, unless the fit changes abruptly at the end. Throws Invalid_argument_error if the
// direction is zero, not finite or normal to the surface, or if the length is invalid. Linear in
// the number of steps, with six projections per step.
CGAL_GEODESIC_PROCESSING_EXPORT
Traced_curve trace_on_surface(const Path_surface& surface,
                              const std::function<double(Index)>& max_step, const Projection& from,
                              const Vec3& direction, double length);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_TRACE_ON_SURFACE_H
