// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CONTINUOUS_FLOW_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CONTINUOUS_FLOW_H

#include <CGAL/Geodesic_processing/internal/Glued_triangles.h>
#include <CGAL/Geodesic_processing/internal/operators.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// What it costs to move point masses at sites on the surface itself: never less than the best way.  A
// field whose divergence() are the masses may start and end within triangles' sides, which is less than
// that.  Here masses are spread over the triangles around their sites, and what leaves a triangle
// through a side enters the next one: a field of Raviart and Thomas (1977), found near the given one,
// and shortened along all fields that have no divergence and wind around no handle.
//
// flow      #triangles; masses are its divergence()
// measure   #triangles: length is that of the vector after this symmetric tensor; empty: as it is
//
// Of meshes only.  Two factorizations and some hundred solutions.
CGAL_GEODESIC_PROCESSING_EXPORT
double cost_of_continuous_flow(const Glued_triangles& triangles, const Operators& operators,
                               const Field& flow, const std::vector<Tensor>& measure = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CONTINUOUS_FLOW_H
