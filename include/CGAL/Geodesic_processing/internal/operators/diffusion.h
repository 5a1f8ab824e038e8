// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_DIFFUSION_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_DIFFUSION_H

#include <CGAL/Geodesic_processing/internal/operators/operators.h>

namespace CGAL::Geodesic_processing::internal {

// A function of the sites after it has flowed as heat does, in one implicit step: what is at a place is
// spread with the standard deviation `radius`, in the domain's scale, in each direction.  Its integral,
// and a constant, stay as they are.  One factorization.
CGAL_GEODESIC_PROCESSING_EXPORT
Vector diffused(const Operators& operators, const Vector& function, double radius);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_DIFFUSION_H
