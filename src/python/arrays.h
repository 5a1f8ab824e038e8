// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PYTHON_ARRAYS_H
#define GEODESIC_PYTHON_ARRAYS_H

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace python {

namespace py = pybind11;

// The extents of an array; `any` stands for each positive number.
using Shape = std::vector<py::ssize_t>;
constexpr py::ssize_t any = -1;

// Throws Invalid_argument_error with a sentence.
[[noreturn]] void reject(const std::string& sentence);

// A view of an array of numbers with one or two dimensions. float64 and float32 are read without a
// copy, with any strides. Other numbers are converted to float64. Can be read without the GIL.
class Numbers
{
public:
  // Throws Invalid_argument_error if `object` is not an array of numbers of this shape, or if it is
  // empty. `name` is that of the argument.
  Numbers(const py::handle& object, const std::string& name, const Shape& shape);

  std::size_t size() const { return m_size; }
  std::size_t row_size() const { return m_row_size; }
  double operator()(std::size_t i, std::size_t j = 0) const
  {
    const char* const address = m_data + std::ptrdiff_t(i) * m_stride + std::ptrdiff_t(j) * m_step;
    return m_is_double ? read<double>(address) : double(read<float>(address));
  }

private:
  // Arrays need not be aligned.
  template <typename Number>
  static Number read(const char* address)
  {
    Number result;
    std::memcpy(&result, address, sizeof(Number));
    return result;
  }

  py::array m_array;
  const char* m_data;
  std::size_t m_size, m_row_size;
  std::ptrdiff_t m_stride, m_step;
  bool m_is_double;
};

// A view of an array of integers, as Numbers. int32, int64, uint32 and uint64 are read without a
// copy.
class Integers
{
public:
  Integers(const py::handle& object, const std::string& name, const Shape& shape);

  std::size_t size() const { return m_size; }
  std::size_t row_size() const { return m_row_size; }
  // Numbers that are too large for int64 become negative.
  std::int64_t operator()(std::size_t i, std::size_t j = 0) const
  {
    const char* const address = m_data + std::ptrdiff_t(i) * m_stride + std::ptrdiff_t(j) * m_step;
    std::int64_t result = 0;
    if(m_is_wide)
      std::memcpy(&result, address, sizeof(result));
    else
    {
      std::uint32_t number;
      std::memcpy(&number, address, sizeof(number));
      result = m_is_signed ? std::int64_t(std::int32_t(number)) : std::int64_t(number);
    }
    return result;
  }

private:
  py::array m_array;
  const char* m_data;
  std::size_t m_size, m_row_size;
  std::ptrdiff_t m_stride, m_step;
  bool m_is_wide, m_is_signed;
};

// Reads an array of numbers with one dimension.
std::vector<double> numbers_of(const py::handle& object, const std::string& name,
                               py::ssize_t size = any);
// Returns a new array of an element type in C order, or `out` if it is not None. Throws
// Invalid_argument_error if the type is not float64 or float32, or if `out` is not a writable array
// of such a type with this shape in C order.
py::array matrix_output(const py::object& out, const Shape& shape, const py::object& type);

// Returns a new array of float64, or `out` if it is not None. Throws Invalid_argument_error if `out`
// is not a writable array of float64 with this shape.
py::array_t<double> output(const py::object& out, const Shape& shape);

// Returns whether the object is an array with one dimension, or a list or tuple of numbers.
bool is_flat(const py::handle& object);

// Returns the value of a word. Throws Invalid_argument_error if the object is none of the words.
// `name` is that of the argument.
template <typename Value>
Value choice(const py::handle& object, const std::string& name,
             std::initializer_list<std::pair<const char*, Value>> values)
{
  std::string words;
  std::size_t position = 0;
  for(const auto& [word, value] : values)
  {
    if(py::isinstance<py::str>(object) && object.cast<std::string>() == word)
      return value;
    words += (position == 0                  ? ""
              : position + 1 < values.size() ? ", "
                                             : " or ") +
             std::string(word);
    ++position;
  }
  reject(name + " is not " + words + ".");
}

// Returns a number. Throws Invalid_argument_error if the object is not a number.
double number(const py::handle& object, const std::string& name);
// Returns whether the object is an integer, also one of NumPy. bool is no integer.
bool is_integer(const py::handle& object);
// Returns whether the object is a list or a tuple of numbers, or an array.
bool is_row(const py::handle& object);
// Returns an integer. Throws Invalid_argument_error if it is not between 0 and size - 1.
std::size_t index(const py::handle& object, const std::string& name, std::size_t size);
// As index(), for an integer that was read from an array.
std::size_t checked_index(std::int64_t value, const std::string& name, std::size_t size);

} // namespace python

#endif // GEODESIC_PYTHON_ARRAYS_H
