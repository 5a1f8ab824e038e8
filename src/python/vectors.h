// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PYTHON_VECTORS_H
#define GEODESIC_PYTHON_VECTORS_H

#include "python/Surface.h"

#include <array>
#include <cmath>
#include <string>

// Arguments and results of maps: vectors in space, points of the plane, and indices.

namespace python {

// A point of the plane: a value of a UV map.
using UV = std::array<double, 2>;

// A readable property map of the rows of an array with two columns.
template <typename Key>
struct UV_map
{
  using key_type = Key;
  using value_type = UV;
  using reference = UV;
  using category = boost::readable_property_map_tag;

  const Numbers* numbers;

  friend UV get(const UV_map& map, Key key)
  {
    const auto row = std::size_t(key);
    return {(*map.numbers)(row, 0), (*map.numbers)(row, 1)};
  }
};

// A writable property map of the rows of an array with two columns; reading is for functions that
// change a map.
template <typename Key>
struct UV_output_map
{
  using key_type = Key;
  using value_type = UV;
  using reference = UV;
  using category = boost::read_write_property_map_tag;

  double* data;

  friend UV get(const UV_output_map& map, Key key)
  {
    const double* const row = map.data + 2 * std::size_t(key);
    return {row[0], row[1]};
  }
  friend void put(const UV_output_map& map, Key key, const UV& value)
  {
    double* const row = map.data + 2 * std::size_t(key);
    row[0] = value[0];
    row[1] = value[1];
  }
};

// Returns a new array of points of the plane, one row for each vertex.
template <typename Domain>
py::array_t<double> uv_array(const Surface<Domain>& surface)
{
  return py::array_t<double>(Shape{py::ssize_t(surface.number_of_points()), 2});
}

// Reads a vector in space. Throws Invalid_argument_error if a component is not finite.
inline Kernel::Vector_3 vector(const py::object& object, const std::string& name)
{
  const Numbers components(object, name, {3});
  for(std::size_t k = 0; k < 3; ++k)
    if(!std::isfinite(components(k)))
      reject("A component of " + name + " is not finite.");
  return {components(0), components(1), components(2)};
}

// Returns the coordinates of a point, or the components of a vector.
template <typename Point_or_vector>
py::array_t<double> coordinate_array(const Point_or_vector& p)
{
  const std::array<double, 3> coordinates = {p[0], p[1], p[2]};
  return py::array_t<double>(3, coordinates.data());
}

// Returns the origin and the axes of a tangent plane.
template <typename Frame>
py::tuple frame_arrays(const Frame& frame)
{
  return py::make_tuple(coordinate_array(frame.origin), coordinate_array(frame.u),
                        coordinate_array(frame.v));
}

// Calls f with named parameters, to which `up_direction` is added if it is not None.
template <typename NamedParameters, typename Function>
void with_up_direction(const py::object& up, const NamedParameters& np, const Function& f)
{
  if(up.is_none())
    f(np);
  else
    f(np.up_direction(vector(up, "up")));
}

// Returns an integer that is not negative, and smaller than 2^31.
inline std::size_t size_number(const py::handle& object, const std::string& name)
{
  return index(object, name, std::size_t(1) << 31);
}

} // namespace python

#endif // GEODESIC_PYTHON_VECTORS_H
