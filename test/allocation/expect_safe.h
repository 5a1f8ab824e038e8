// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_ALLOCATION_EXPECT_SAFE_H
#define CGAL_GEODESIC_PROCESSING_TEST_ALLOCATION_EXPECT_SAFE_H

#include <cstddef>
#include <functional>
#include <vector>

namespace allocation_test {

using Values = std::vector<double>;

// Runs a query many times; each time another allocation fails, in any thread. Expects that the
// query throws std::bad_alloc, or has the result of an undisturbed query if it can do without the
// memory. After each failure, the query is repeated and must have this result, and the number of
// allocated blocks must be the same as before.
//
// Allocations are those of this program, of static libraries and of CHOLMOD, and those by operator
// new. Allocations by malloc in other shared libraries do not fail.
void expect_safe(const std::function<Values()>& query);

// Returns the sum of the sizes of all blocks that a query allocates, in the same sense.
std::size_t allocated_bytes(const std::function<void()>& query);

} // namespace allocation_test

#endif // CGAL_GEODESIC_PROCESSING_TEST_ALLOCATION_EXPECT_SAFE_H
