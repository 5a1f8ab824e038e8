// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/arrays.h"

#include <CGAL/Geodesic_processing/exceptions.h>

#include <algorithm>

namespace python {

namespace {

// Formats extents like Python: "(n, 3)".
std::string text_of(const Shape& shape)
{
  std::string result = "(";
  for(std::size_t k = 0; k < shape.size(); ++k)
    result += (k > 0 ? ", " : "") + (shape[k] == any ? "n" : std::to_string(shape[k]));
  return result + (shape.size() == 1 ? ",)" : ")");
}

Shape shape_of(const py::array& array) { return {array.shape(), array.shape() + array.ndim()}; }

py::array to_array(const py::handle& object, const std::string& name)
{
  if(!object.is_none())
  {
    try
    {
      // NumPy accepts ragged lists with a warning and returns an array of objects.
      py::array result = py::array::ensure(object);
      if(result && result.dtype().kind() != 'O')
        return result;
    }
    catch(const py::error_already_set&)
    {}
  }
  PyErr_Clear();
  reject(name + " is not an array of numbers.");
}

void check_shape(const py::array& array, const std::string& name, const Shape& expected)
{
  const Shape given = shape_of(array);
  bool is_equal = given.size() == expected.size();
  for(std::size_t k = 0; is_equal && k < given.size(); ++k)
    is_equal = expected[k] == any || expected[k] == given[k];
  if(!is_equal)
    reject(name + " has the shape " + text_of(given) + ", but its shape must be " +
           text_of(expected) + ".");
  if(array.size() == 0)
    reject(name + " is empty.");
}

// Converts an array to another type if it does not have it.
template <typename Number>
py::array converted(const py::array& array, const std::string& name)
{
  py::array result = py::array_t<Number, py::array::forcecast>::ensure(array);
  if(result)
    return result;
  PyErr_Clear();
  reject(name + " is not an array of numbers.");
}

std::size_t row_size_of(const py::array& array)
{
  return array.ndim() > 1 ? std::size_t(array.shape(1)) : 1;
}

std::ptrdiff_t step_of(const py::array& array) { return array.ndim() > 1 ? array.strides(1) : 0; }

} // namespace

void reject(const std::string& sentence)
{
  throw CGAL::Geodesic_processing::Invalid_argument_error(sentence);
}

Numbers::Numbers(const py::handle& object, const std::string& name, const Shape& shape)
    : m_array(to_array(object, name))
{
  check_shape(m_array, name, shape);
  const char kind = m_array.dtype().kind();
  if(kind != 'f' && kind != 'i' && kind != 'u')
    reject(name + " is not an array of real numbers.");
  m_is_double = py::isinstance<py::array_t<double>>(m_array);
  if(!m_is_double && !py::isinstance<py::array_t<float>>(m_array))
  {
    m_array = converted<double>(m_array, name);
    m_is_double = true;
  }
  m_data = static_cast<const char*>(m_array.data());
  m_size = std::size_t(m_array.shape(0));
  m_row_size = row_size_of(m_array);
  m_stride = m_array.strides(0);
  m_step = step_of(m_array);
}

Integers::Integers(const py::handle& object, const std::string& name, const Shape& shape)
    : m_array(to_array(object, name))
{
  check_shape(m_array, name, shape);
  const char kind = m_array.dtype().kind();
  if(kind != 'i' && kind != 'u')
    reject(name + " is not an array of integers.");
  m_is_signed = kind == 'i';
  m_is_wide = py::isinstance<py::array_t<std::int64_t>>(m_array) ||
              py::isinstance<py::array_t<std::uint64_t>>(m_array);
  if(!m_is_wide && !py::isinstance<py::array_t<std::int32_t>>(m_array) &&
     !py::isinstance<py::array_t<std::uint32_t>>(m_array))
  {
    m_array = converted<std::int64_t>(m_array, name);
    m_is_wide = true;
  }
  m_data = static_cast<const char*>(m_array.data());
  m_size = std::size_t(m_array.shape(0));
  m_row_size = row_size_of(m_array);
  m_stride = m_array.strides(0);
  m_step = step_of(m_array);
}

std::vector<double> numbers_of(const py::handle& object, const std::string& name, py::ssize_t size)
{
  const Numbers numbers(object, name, {size});
  std::vector<double> result;
  for(std::size_t i = 0; i < numbers.size(); ++i)
    result.push_back(numbers(i));
  return result;
}

namespace {

bool is_aligned(const py::array& array, std::size_t size)
{
  for(py::ssize_t k = 0; k < array.ndim(); ++k)
    if(array.strides(k) % py::ssize_t(size) != 0)
      return false;
  return reinterpret_cast<std::uintptr_t>(array.data()) % size == 0;
}

// Throws Invalid_argument_error unless `out` is a writable array of numbers of this size and of this
// shape.
void check_output(const py::array& out, const Shape& shape, std::size_t size)
{
  if(shape_of(out) != shape)
    reject("out has the shape " + text_of(shape_of(out)) + ", but its shape must be " +
           text_of(shape) + ".");
  if(!out.writeable())
    reject("out is not writable.");
  if(!is_aligned(out, size)) // values are written as numbers of this type
    reject("out is not aligned.");
}

} // namespace

py::array matrix_output(const py::object& out, const Shape& shape, const py::object& type)
{
  if(out.is_none())
  {
    for(const py::dtype& known : {py::dtype::of<double>(), py::dtype::of<float>()})
      try
      {
        if(!type.is_none() && py::dtype::from_args(type).equal(known))
          return py::array(known, shape);
      }
      catch(const py::error_already_set& error)
      {
        if(error.matches(PyExc_MemoryError))
          throw;
      }
    reject("dtype is neither float64 nor float32.");
  }
  const bool is_double = py::isinstance<py::array_t<double>>(out);
  if(!is_double && !py::isinstance<py::array_t<float>>(out))
    reject("out is not an array of float64 or float32.");
  auto result = py::reinterpret_borrow<py::array>(out);
  check_output(result, shape, is_double ? sizeof(double) : sizeof(float));
  if(!(result.flags() & py::array::c_style))
    reject("out is not in C order.");
  return result;
}

py::array_t<double> output(const py::object& out, const Shape& shape)
{
  if(out.is_none())
    return py::array_t<double>(shape);
  if(!py::isinstance<py::array_t<double>>(out))
    reject("out is not an array of float64.");
  auto result = py::reinterpret_borrow<py::array_t<double>>(out);
  check_output(result, shape, sizeof(double));
  return result;
}

double number(const py::handle& object, const std::string& name)
{
  if(!object.is_none() && !PyBool_Check(object.ptr()))
  {
    const double result = PyFloat_AsDouble(object.ptr());
    if(!PyErr_Occurred())
      return result;
    PyErr_Clear();
  }
  reject(name + " is not a number.");
}

bool is_integer(const py::handle& object)
{
  if(!PyIndex_Check(object.ptr()) || PyBool_Check(object.ptr()))
    return false;
  return !py::isinstance<py::array>(object) ||
         (py::reinterpret_borrow<py::array>(object).ndim() == 0 &&
          py::reinterpret_borrow<py::array>(object).dtype().kind() != 'f');
}

bool is_row(const py::handle& object)
{
  if(py::isinstance<py::array>(object))
    return py::reinterpret_borrow<py::array>(object).ndim() > 0;
  if(!py::isinstance<py::tuple>(object) && !py::isinstance<py::list>(object))
    return false;
  for(const py::handle item : object)
    if(!PyNumber_Check(item.ptr()) || py::isinstance<py::array>(item))
      return false;
  return true;
}

bool is_flat(const py::handle& object)
{
  return py::isinstance<py::array>(object) ? py::reinterpret_borrow<py::array>(object).ndim() == 1
                                           : is_row(object);
}

std::size_t checked_index(std::int64_t value, const std::string& name, std::size_t size)
{
  if(value < 0 || std::size_t(value) >= size)
    reject("The " + name + " " + std::to_string(value) + " is not between 0 and " +
           std::to_string(std::int64_t(size) - 1) + ".");
  return std::size_t(value);
}

std::size_t index(const py::handle& object, const std::string& name, std::size_t size)
{
  if(is_integer(object))
  {
    const py::ssize_t result = PyNumber_AsSsize_t(object.ptr(), nullptr); // clips large numbers
    if(!PyErr_Occurred())
      return checked_index(result, name, size);
    PyErr_Clear();
  }
  reject("A " + name + " is not an integer.");
}

} // namespace python
