// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PYTHON_VECTOR_MAP_H
#define GEODESIC_PYTHON_VECTOR_MAP_H

#include "python/arrays.h"
#include "python/surface_types.h"

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <limits>

namespace python {

// A readable property map of vectors: the rows of an array.
template <typename Key>
struct Vector_map
{
  using key_type = Key;
  using value_type = Kernel::Vector_3;
  using reference = Kernel::Vector_3;
  using category = boost::readable_property_map_tag;

  const Numbers* vectors;

  friend Kernel::Vector_3 get(const Vector_map& map, Key key)
  {
    const std::size_t row(key);
    return {(*map.vectors)(row, 0), (*map.vectors)(row, 1), (*map.vectors)(row, 2)};
  }
};

// A writable property map of vectors: they are written to the rows of an array.
template <typename Key>
struct Vector_output_map
{
  using key_type = Key;
  using value_type = Kernel::Vector_3;
  using reference = Kernel::Vector_3&;
  using category = boost::writable_property_map_tag;

  double* data;

  friend void put(const Vector_output_map& map, Key key, const Kernel::Vector_3& vector)
  {
    for(int k = 0; k < 3; ++k)
      map.data[3 * std::size_t(key) + std::size_t(k)] = vector[k];
  }
};

// Returns a new array of vectors, one row each, that are not numbers.
inline py::array_t<double> vector_array(std::size_t size)
{
  py::array_t<double> result(Shape{py::ssize_t(size), 3});
  std::fill_n(result.mutable_data(), 3 * size, std::numeric_limits<double>::quiet_NaN());
  return result;
}

// Returns the components of a vector.
inline py::array_t<double> vector_components(const Kernel::Vector_3& vector)
{
  py::array_t<double> result(3);
  for(int k = 0; k < 3; ++k)
    result.mutable_at(k) = vector[k];
  return result;
}

} // namespace python

#endif // GEODESIC_PYTHON_VECTOR_MAP_H
