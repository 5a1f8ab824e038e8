// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_PATH_OPTIONS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_PATH_OPTIONS_H

#include <CGAL/Geodesic_processing/internal/paths/path_energy.h>
#include <CGAL/Geodesic_processing/parameters.h>

namespace CGAL::Geodesic_processing::internal {

// Returns the options of the path energy that are given by named parameters.
template <typename NamedParameters>
Path_options path_options(const NamedParameters& np)
{
  Path_options result;
  result.alpha = parameter(np, internal_np::node_weight, result.alpha);
  result.beta = parameter(np, internal_np::segment_weight, result.beta);
  result.number_of_control_points =
      parameter(np, internal_np::number_of_control_points, result.number_of_control_points);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_PATH_OPTIONS_H
