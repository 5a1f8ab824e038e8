// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TRANSPORT_COSTS_H
#define CGAL_GEODESIC_PROCESSING_TRANSPORT_COSTS_H

#include <limits>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingTransport
///
/// Stores the earth mover's distance of two mass distributions with certified bounds, in the unit
/// of the coordinates times that of the masses.
struct Earth_movers_cost
{
  double value = 0.; ///< the mean of the lower and the upper bound
  /// Certified lower bound, which also holds for geodesic distances on the surface
  double lower = 0.;
  /// Certified upper bound for flows that are constant in each face. It can be smaller than the cost
  /// on the surface, for which `upper_continuous` is a bound
  double upper = 0.;
  /// Certified upper bound for flows on the surface; infinite unless `do_bound_from_above` is set
  double upper_continuous = std::numeric_limits<double>::infinity();
  /// The value extrapolated from the last two refinement levels, not certified; without refinement
  /// the same as `value`
  double estimate = 0.;
  unsigned number_of_iterations = 0; ///< the number of iterations on the finest level
  /// The largest difference of the divergence of the flow and the masses, relative to the total
  /// mass that is moved
  double residual = 0.;
  bool is_converged = false; ///< whether the gap between the bounds is within the tolerance
};

/// \ingroup PkgGeodesicProcessingTransport
///
/// Stores the cost of a barycenter with certified bounds. The cost is the weighted sum of squared
/// earth mover's distances. Its unit is the square of the unit of `Earth_movers_cost`.
struct Transport_barycenter_cost
{
  double value = 0.; ///< the mean of the lower and the upper bound
  /// Certified lower bound of the cost of every mass distribution, also for geodesic distances on
  /// the surface
  double lower = 0.;
  /// Certified upper bound of the cost of the computed barycenter, for flows that are constant in
  /// each face
  double upper = 0.;
  /// The upper bound of the distance from the barycenter to each of the given mass distributions
  std::vector<double> distances;
  unsigned number_of_iterations = 0; ///< the number of iterations
  /// The largest difference of the divergence of a flow and the masses that it moves, relative to
  /// the total mass
  double residual = 0.;
  bool is_converged = false; ///< whether the gap between the bounds is within the tolerance
};

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_TRANSPORT_COSTS_H
