// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_DIFFUSION_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_DIFFUSION_H

#include <CGAL/Geodesic_processing/internal/operators/operators.h>

namespace CGAL::Geodesic_processing::internal {

// Computes one implicit Euler step of heat diffusion from a function of the vertices. In each
// direction, a point mass is spread with the standard deviation `radius`, in the unit of the
// lengths. The integral of the function is preserved, and constant functions do not change. This
// takes one factorization. The function and the result have one value for each vertex.
CGAL_GEODESIC_PROCESSING_EXPORT
Vector diffused(const Operators& operators, const Vector& function, double radius);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_DIFFUSION_H
