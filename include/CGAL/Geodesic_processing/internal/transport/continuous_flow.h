// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_CONTINUOUS_FLOW_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_CONTINUOUS_FLOW_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A flow on the surface itself: masses are spread over the triangles around their sites, and what leaves a
// triangle through a side enters the next one.  Within triangles it is a field of Raviart and Thomas
// (1977): its divergence is constant there.
struct Continuous_flow
{
  std::vector<double>
      outward_flux; // #sides: what flows out of the triangle there, zero at a border
  std::vector<double> absorbed_mass; // #triangles: what stays there
  double cost = 0.;                  // never less than that of the best way, spreading included
};

// The one near a field that may start and end within triangles' sides, shortened along all fields that
// have no divergence; around handles only where there is no border, and lengths are those of the surface.
//
// flow      #triangles; masses are its divergence()
// measure   #triangles: length is that of the vector after this symmetric tensor; empty: as it is
//
// Of meshes only.  Two factorizations and some hundred solutions.
CGAL_GEODESIC_PROCESSING_EXPORT
Continuous_flow continuous_flow(const Surface_arrays& triangles, const Operators& operators,
                                const Field& flow, const std::vector<Metric_tensor>& metric = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_CONTINUOUS_FLOW_H
