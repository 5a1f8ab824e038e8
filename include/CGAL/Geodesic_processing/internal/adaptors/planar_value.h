// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_PLANAR_VALUE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_PLANAR_VALUE_H

#include <type_traits>

namespace CGAL::Geodesic_processing::internal {

// Returns a point (u, v) of the plane as a value of a UV map, which can be a `Point_2` or an array
// of two numbers.
template <typename Value>
Value planar_value(double u, double v)
{
  if constexpr(std::is_constructible_v<Value, double, double>)
    return Value(u, v);
  else
  {
    static_assert(std::is_aggregate_v<Value>,
                  "The value of a UV map is a Point_2, a Vector_2 or a std::array of two numbers.");
    return Value{u, v};
  }
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_PLANAR_VALUE_H
