// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_PLANAR_VALUE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_PLANAR_VALUE_H

#include <type_traits>

namespace CGAL::Geodesic_processing::internal {

// A place in the plane as the value of a map: a `Point_2`, or an array.
template <typename Value>
Value planar_value(double u, double v)
{
  if constexpr(std::is_constructible_v<Value, double, double>)
    return Value(u, v);
  else
    return Value{u, v};
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_PLANAR_VALUE_H
