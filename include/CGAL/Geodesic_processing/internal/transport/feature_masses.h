// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_FEATURE_MASSES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_FEATURE_MASSES_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>
#include <CGAL/Geodesic_processing/internal/transport/Mass_distribution.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The uniform distributions of a surface and of a feature on it. On each component, both have the
// same total mass: its area, or zero if it contains no part of the feature.
struct Feature_masses
{
  Mass_distribution surface;     // density 1 on components with a part of the feature
  Mass_distribution feature;     // masses at locations
  std::vector<Index> component;  // #vertices
  std::vector<bool> has_feature; // #components
};

// Computes the uniform distribution on a feature (Solomon, Rustamov, Guibas and Butscher 2014,
// section 7). It has equal masses per length of the polylines. The mass of a segment is divided
// equally between its ends, as its integral against linear functions. If no polyline of a component
// has a length, each location of the component has the same mass. Components are separated by
// triangles of blocked metric.
//
// metric    #triangles tensors as for metric_operators(), or empty
// polylines consecutive locations of each have a common triangle
//
// O(n).
CGAL_GEODESIC_PROCESSING_EXPORT
Feature_masses uniform_feature_masses(const Surface_arrays& triangles,
                                      const std::vector<Metric_tensor>& metric,
                                      const std::vector<std::vector<Surface_location>>& polylines);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_FEATURE_MASSES_H
