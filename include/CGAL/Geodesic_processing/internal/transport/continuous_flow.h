// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_CONTINUOUS_FLOW_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_CONTINUOUS_FLOW_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A flow on the continuous surface. The mass of a vertex is spread uniformly over the incident
// triangles. The flux out of a triangle through an edge enters the adjacent triangle. In each
// triangle, the flow is a Raviart-Thomas field (1977) and has constant divergence.
struct Continuous_flow
{
  std::vector<double> outward_flux;  // #halfedges: the flux out of the triangle; 0 on the boundary
  std::vector<double> absorbed_mass; // #triangles: mass that remains in the triangle
  double cost = 0.; // upper bound of the optimal cost, the cost of spreading included
};

// Computes a continuous flow with small cost from a flow that is constant in each triangle. It is
// first corrected to balance the flux through each edge. Its cost is then reduced in the space of
// divergence-free fields. Circulations around handles are included only if the mesh has no boundary
// and `metric` is empty.
//
// flow    #triangles vectors; the masses are its minus_divergence()
//
// metric  #triangles tensors A: the length of a vector v is |A v|; empty for the lengths as they
//   are
//
// Throws Unsupported_surface_error if the surface is a cloud. Two factorizations and some hundred
// solutions.
CGAL_GEODESIC_PROCESSING_EXPORT
Continuous_flow continuous_flow(const Surface_arrays& triangles, const Operators& operators,
                                const Field& flow, const std::vector<Metric_tensor>& metric = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_CONTINUOUS_FLOW_H
