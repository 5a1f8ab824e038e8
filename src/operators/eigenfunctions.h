// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_EIGENFUNCTIONS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_EIGENFUNCTIONS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/numerics/dense_product.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <cstddef>

// Functions psi with -laplacian(psi) = value * psi that vanish on the border and, on each component that
// has none, integrate to zero: the cotangent Laplacian and the lumped mass.

namespace CGAL::Geodesic_processing::internal {

struct Eigenfunctions
{
  Vector value; // #functions, ascending, positive
  Matrix
      function; // #sites by #functions, orthonormal for the lumped mass; one column for each value
};

// Two values next to each other, the k-th and the one after it, belong to one group when they differ by
// less than this part of the larger one: the mean distance of values, which is 1/k by Weyl's law, and at
// most a fiftieth, more than what triangles tell apart that is one on a smooth surface.
constexpr double spectral_gap(std::size_t k) { return k > 50 ? 1. / double(k) : 0.02; }

// Those of the least values: `number` of them and as many more as it takes for the next value to lie
// beyond a gap, or all that there are.  So their span does not depend on a choice of functions.  A cloud
// has no known border.  Deterministic; by a block Lanczos method of the inverse, and that none is missing
// is counted by Sylvester's law of inertia.
CGAL_GEODESIC_PROCESSING_EXPORT
Eigenfunctions eigenfunctions(const Surface_arrays& triangles, const Operators& operators,
                              std::size_t number);

// Which sites lie on the border: one of their sides is glued to none.  None of a cloud's.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<bool> border_vertices(const Surface_arrays& triangles);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_EIGENFUNCTIONS_H
