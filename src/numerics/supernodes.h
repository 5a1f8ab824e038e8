// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_SUPERNODES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_SUPERNODES_H

#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The Cholesky factor L of a permuted sparse matrix. Adjacent columns with entries in the same rows
// form a supernode, which is a dense block. The pointers refer to the arrays of a CHOLMOD factor.
struct Supernodes
{
  std::size_t size = 0; // number of rows of the matrix
  std::size_t number_of_supernodes = 0;

  const int* permutation = nullptr;  // #size: the row of the matrix for each row of L
  const int* column_begin = nullptr; // #supernodes + 1: the first column of each
  const int* row_begin = nullptr;    // #supernodes + 1: the first index in `row` of each
  const int* entry_begin = nullptr;  // #supernodes: the first index in `entry` of each
  const int* row = nullptr;          // ascending for each supernode; its diagonal rows come first
  const double* entry = nullptr;     // column-major; entries above the diagonal are not read
};

// Replaces each of `count` columns, a right-hand side, by its solution. The columns are contiguous
// in memory. Blocks of 32 columns are solved at once. In the forward substitution, a supernode is
// skipped if the right-hand sides of the block are zero there. If right-hand sides have few
// entries, and those of a block are close in the order, this saves almost half of the time.
//
// The kernels use AVX2 if the processor has it. They are faster than general matrix products, which
// are not optimized for few columns and small blocks. The solution of a column does not depend on
// the other columns. O(#entries of L) for each column.
//
// workspace  is resized; reuse it to avoid allocations
CGAL_GEODESIC_PROCESSING_EXPORT
void substitute(const Supernodes& factor, double* columns, std::size_t count,
                std::vector<double>& workspace);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_SUPERNODES_H
