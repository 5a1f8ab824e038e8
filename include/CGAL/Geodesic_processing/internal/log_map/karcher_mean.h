// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_KARCHER_MEAN_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_KARCHER_MEAN_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

struct Mean_options
{
  // The gradient is small enough if its norm is at most this fraction of the distance to the
  // farthest location.
  double tolerance = 1e-8;
  std::size_t maximum_number_of_iterations = 100;
  std::optional<Surface_location> initial_location;
  std::function<bool(double)> callback; // receives the fraction done; returns false to cancel
};

struct Mean_location
{
  Surface_location location; // canonical
  double value = 0.;         // the weighted sum of squared distances
  double gradient_norm = 0.; // of sum w_i d_i^2 / 2 divided by sum w_i
  bool is_converged = false; // whether the gradient norm is small enough
  std::size_t number_of_iterations = 0;
};

// Finds a local minimum of sum w_i d(x, p_i)^2 over all locations x of a mesh, with exact
// distances.
//
// The gradient is - sum w_i log_x(p_i) at points where the surface is flat. At vertices and at the
// boundary, the gradient norm is minus the smallest directional derivative (steepest_descent()),
// or 0 if no derivative is negative. If several shortest paths lead from x to p_i, one of them is
// used.
//
// Each iterate is the endpoint of a straightest geodesic. The step is that of a quasi-Newton method
// (BFGS), whose axes are transported parallel along the geodesic. The initial Hessian is that of
// the plane. If the sum does not decrease sufficiently, the step of the gradient is tried, and
// halved. So the sum never increases, except by round-off errors. Minima at vertices with an angle
// above 2 pi, or above pi at the boundary, are kinks: such a vertex is tried if convergence is
// slow.
//
// locations  not empty
// weights    #locations: positive
//
// Throws Invalid_argument_error if the locations and the initial location are not in one component.
// Throws Cancelled if the callback returns false, and Unsupported_surface_error as
// Window_propagation::run(). Takes one window propagation for each evaluation, of which there is
// usually one per iteration.
CGAL_GEODESIC_PROCESSING_EXPORT
Mean_location karcher_mean(const std::shared_ptr<const Surface_arrays>& triangles,
                           const std::vector<Surface_location>& locations,
                           const std::vector<double>& weights, const Mean_options& options = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_KARCHER_MEAN_H
