// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_CHANNELS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_CHANNELS_H

#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

// Values of a property map as arrays of numbers. A number has one channel, an array one per
// element, and a point or vector three.

namespace CGAL::Geodesic_processing::internal {

template <typename Value>
struct Is_array : std::false_type
{};
template <typename T, std::size_t N>
struct Is_array<std::array<T, N>> : std::true_type
{};

template <typename Value>
constexpr std::size_t channel_count()
{
  if constexpr(std::is_arithmetic_v<Value>)
    return 1;
  else if constexpr(Is_array<Value>::value)
    return std::tuple_size_v<Value>;
  else
    return 3;
}

template <typename Value>
inline constexpr std::size_t number_of_channels = channel_count<Value>();

template <typename Value>
void append_channels(std::vector<double>& values, const Value& value)
{
  if constexpr(std::is_arithmetic_v<Value>)
    values.push_back(double(value));
  else
    for(int c = 0; c < int(number_of_channels<Value>); ++c)
      values.push_back(CGAL::to_double(value[c]));
}

template <typename Value>
Value from_channels(const double* values)
{
  if constexpr(std::is_arithmetic_v<Value>)
    return Value(values[0]);
  else if constexpr(Is_array<Value>::value)
  {
    Value result;
    for(std::size_t c = 0; c < result.size(); ++c)
      result[c] = typename Value::value_type(values[c]);
    return result;
  }
  else
    return Value(values[0], values[1], values[2]);
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_CHANNELS_H
