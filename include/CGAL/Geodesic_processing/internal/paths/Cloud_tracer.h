// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_CLOUD_TRACER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_CLOUD_TRACER_H

#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

class Fitted_cloud;

// A geodesic on a cloud. The vertices of locations are positions in the caller's arrays, and all
// lengths are in the caller's unit.
struct Traced_path
{
  std::vector<Tangent_location> locations; // at least one
  std::vector<Vec3> points;                // #locations: on the fitted surface
  double length = 0.;                      // of the smooth curve
  bool is_cut_by_boundary = false;
};

// Traces geodesics on the surface that is fitted to a cloud of surfels, by trace_on_surface().
//
// The surface is that of Cloud_path_finder with default options: noise is removed if it is found.
// Copies share the fitted cloud and can be used concurrently.
class CGAL_GEODESIC_PROCESSING_EXPORT Cloud_tracer
{
public:
  // Fits the surface; O(n log n). The arguments and the exceptions are those of Fitted_cloud.
  Cloud_tracer(std::vector<Vec3> points, std::vector<Vec3> normals,
               const std::vector<double>& radii, unsigned number_of_threads);

  // Returns the geodesic from a location in a direction.
  //
  // from       a position in the caller's arrays, and an offset in the caller's unit; it is
  //            projected to the surface
  // direction  projected to the tangent plane of the surface
  // length     finite and not negative
  //
  // The steps are half of the distance to the sixth nearest surfel. Throws the exceptions of
  // trace_on_surface().
  Traced_path operator()(const Tangent_location& from, const Vec3& direction, double length) const;

private:
  std::shared_ptr<const Fitted_cloud> m_cloud;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_CLOUD_TRACER_H
