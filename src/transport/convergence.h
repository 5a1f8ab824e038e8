// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TRANSPORT_CONVERGENCE_H
#define CGAL_GEODESIC_PROCESSING_TRANSPORT_CONVERGENCE_H

#include <algorithm>
#include <cmath>
#include <functional>

namespace CGAL::Geodesic_processing::internal {

// Reports the progress of an iteration and returns whether the callback, which may be empty,
// cancels it. On a logarithmic scale, progress grows from a relative gap of 1, if no lower bound
// is known, to the tolerance.
inline bool is_cancelled(const std::function<bool(double)>& callback, double gap, double tolerance)
{
  const double fraction = tolerance < 1. ? std::log(gap) / std::log(tolerance) : 1.;
  return callback && !callback(std::clamp(fraction, 0., 1.));
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_TRANSPORT_CONVERGENCE_H
