// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_KARCHER_MEAN_ON_CLOUD_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_KARCHER_MEAN_ON_CLOUD_H

#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include <CGAL/Geodesic_processing/internal/paths/Cloud_path_finder.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

struct Cloud_mean_options
{
  // As Mean_options::tolerance. On random samples of a torus with 2,500 to 40,000 points, the
  // gradient cannot become smaller than 2e-6, because the fit is not smooth.
  double tolerance = 1e-5;
  std::size_t maximum_number_of_iterations = 100;
  unsigned number_of_threads = 1;
  std::function<bool(double)> callback; // receives the fraction done; returns false to cancel
};

// A location on a cloud. Its vertex is a position in the caller's arrays, and lengths are in the
// caller's unit.
struct Cloud_mean
{
  Tangent_location location;
  Vec3 point = {0., 0., 0.};
  double value = 0.;
  double gradient_norm = 0.;
  bool is_converged = false;
  std::size_t number_of_iterations = 0;
};

// Finds a local minimum of sum w_i d(x, p_i)^2 on the surface that is fitted to a cloud.
//
// The distances are lengths of geodesics (Cloud_departure_finder), and their initial directions
// yield the gradient. The iteration is that of karcher_mean(). At the end, the geodesics are
// compared with shortest paths, and the iteration continues if one of them is shorter. At the
// boundary of the surface, the component of the gradient that points off the surface is removed.
//
// locations  not empty; vertices are positions in the caller's arrays, offsets are in the caller's
//            unit
// weights    #locations: positive
// start      as a location
//
// Throws Invalid_argument_error if the locations are not all connected to the start. Throws
// Cancelled if the callback returns false. Each evaluation traces about two geodesics for each
// location. The first and the last one take a path for each location instead, which takes ten times
// as long.
CGAL_GEODESIC_PROCESSING_EXPORT
Cloud_mean karcher_mean_on_cloud(const Cloud_path_finder& finder,
                                 const std::vector<Tangent_location>& locations,
                                 const std::vector<double>& weights, const Tangent_location& start,
                                 const Cloud_mean_options& options = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_KARCHER_MEAN_ON_CLOUD_H
