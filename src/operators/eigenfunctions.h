// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_EIGENFUNCTIONS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_EIGENFUNCTIONS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/numerics/dense_product.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <cstddef>

// Eigenfunctions of the cotangent Laplacian with lumped mass: L f = value M f. They vanish on the
// boundary. On a component without boundary, their integral is zero.

namespace CGAL::Geodesic_processing::internal {

struct Eigenfunctions
{
  Vector value; // #functions: positive, in ascending order
  // #vertices by #functions: one column for each value, orthonormal with respect to the lumped
  // mass
  Matrix function;
};

// Returns the minimum relative gap between the eigenvalues k and k + 1 (counted from 1) if they
// belong to different groups. The difference is compared with the larger value. By Weyl's law the
// mean gap is 1/k. The limit of 1/50 exceeds the error by which a triangulation splits a multiple
// eigenvalue of a smooth surface.
constexpr double spectral_gap(std::size_t k) { return k > 50 ? 1. / double(k) : 0.02; }

// Computes the eigenfunctions of the smallest eigenvalues. Their number is `number`, increased
// until the next eigenvalue is separated by a gap, or the number of all that exist. Hence the space
// that they span does not depend on the choice of a basis of an eigenspace. A cloud has no boundary
// condition. The result is deterministic.
//
// Method: block Lanczos iteration with the inverse operator. By Sylvester's law of inertia, the
// number of eigenvalues below the gap is counted, so that none is missed. The basis has at most
// 512 + 9 `number` columns when a gap is found, plus those of missed eigenvalues.
//
// Throws `Unsupported_surface_error` if this basis contains no gap because many eigenvalues are
// equal, or if more than 512 components have no boundary.
CGAL_GEODESIC_PROCESSING_EXPORT
Eigenfunctions eigenfunctions(const Surface_arrays& triangles, const Operators& operators,
                              std::size_t number);

// Returns true for each vertex of a boundary edge. On a cloud all are false.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<bool> boundary_vertices(const Surface_arrays& triangles);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_EIGENFUNCTIONS_H
