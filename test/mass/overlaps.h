// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_MASS_OVERLAPS_H
#define CGAL_GEODESIC_PROCESSING_TEST_MASS_OVERLAPS_H

#include "Results.h"

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace mass_test {

using Triangle_2 = std::array<Kernel::Point_2, 3>;

// Returns whether the corners are in clockwise order or collinear.
bool is_not_ccw(const Triangle_2& triangle);

// Returns the indices of two counterclockwise triangles whose interiors intersect, if there are
// any. The test is exact.
std::optional<std::pair<std::size_t, std::size_t>>
find_overlap(const std::vector<Triangle_2>& triangles);

} // namespace mass_test

#endif // CGAL_GEODESIC_PROCESSING_TEST_MASS_OVERLAPS_H
