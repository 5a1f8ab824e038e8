// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_SUPERNODES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_SUPERNODES_H

#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The Cholesky factor L of a sparse matrix whose rows and columns were put in another order.  Columns
// that follow each other and have entries in the same rows are a supernode, a dense block.  Views of
// arrays of another's, as CHOLMOD lays them out.
struct Supernodes
{
  std::size_t size = 0;                 // of the matrix
  std::size_t number_of_supernodes = 0; // of supernodes

  const int* permutation = nullptr;  // #size: the place in the matrix of each row of L
  const int* column_begin = nullptr; // #number + 1: the first column of each
  const int* row_begin = nullptr;    // #number + 1: where the rows of each begin in `row`
  const int* entry_begin = nullptr;  // #number: where its entries begin
  const int* row = nullptr;          // ascending; those of the block's own columns come first
  const double* entry = nullptr;     // column by column; above the diagonal they are not read
};

// Each of `count` columns, one after another, is a right side, and becomes the solution.  Columns are
// treated thirty-two at once.  What is zero in all of them up to a place in the order costs nothing there:
// right sides with few entries take little more than half of the time, where places near each other in
// the order come together.
//
// With the wide instructions of a processor that has them, more quickly than by general matrix products,
// which know neither how few the columns are nor how small most of the blocks.  What a column becomes
// depends neither on the others nor on their number.  O(entries) for each.
//
// \param space  of any size: what later calls need not ask the system for again
CGAL_GEODESIC_PROCESSING_EXPORT
void substitute(const Supernodes& factor, double* columns, std::size_t count,
                std::vector<double>& workspace);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_SUPERNODES_H
