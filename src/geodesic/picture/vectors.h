// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_PICTURE_VECTORS_H
#define GEODESIC_PROGRAM_PICTURE_VECTORS_H

#include <CGAL/Geodesic_processing/internal/core/vec3.h>

namespace program {

// Not public: the points of a picture are arrays, as those of kernels.
using CGAL::Geodesic_processing::internal::cross;
using CGAL::Geodesic_processing::internal::dot;
using CGAL::Geodesic_processing::internal::norm;
using CGAL::Geodesic_processing::internal::operator+;
using CGAL::Geodesic_processing::internal::operator-;
using CGAL::Geodesic_processing::internal::operator*;

} // namespace program

#endif // GEODESIC_PROGRAM_PICTURE_VECTORS_H
