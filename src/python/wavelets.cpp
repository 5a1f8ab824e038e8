// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Mesh_surface.h"

#include <CGAL/Geodesic_processing/Subdivision_wavelet.h>
#include <CGAL/Geodesic_processing/decode_wavelets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace python {

namespace {

// A property map of rows of three numbers.
struct Row_map
{
  using key_type = Mesh::Vertex_index;
  using value_type = std::array<double, 3>;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  const Numbers* numbers;

  friend value_type get(const Row_map& map, Mesh::Vertex_index v)
  {
    const Numbers& rows = *map.numbers;
    return {rows(std::size_t(v), 0), rows(std::size_t(v), 1), rows(std::size_t(v), 2)};
  }
};
// One column of an array.
struct Column_map
{
  using key_type = Mesh::Vertex_index;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;

  const Numbers* numbers;
  std::size_t column;

  friend double get(const Column_map& map, Mesh::Vertex_index v)
  {
    return (*map.numbers)(std::size_t(v), map.column);
  }
};
// Rows of three numbers of an array in C order.
struct Output_row_map
{
  using key_type = Mesh::Vertex_index;
  using value_type = std::array<double, 3>;
  using reference = value_type&;
  using category = boost::writable_property_map_tag;

  double* data;

  friend void put(const Output_row_map& map, Mesh::Vertex_index v, const value_type& row)
  {
    std::copy(row.begin(), row.end(), map.data + 3 * std::size_t(v));
  }
};

// The wavelet transform of a mesh as Python sees it. It is immutable.
class Wavelet
{
public:
  Wavelet(const Mesh_surface& surface, const py::object& levels, const py::object& prediction,
          bool do_update)
  {
    const std::size_t number_of_levels = levels.is_none()
                                             ? std::numeric_limits<std::size_t>::max()
                                             : index(levels, "number of levels", 1 << 16);
    const auto kind =
        choice<GP::Wavelet_prediction>(prediction, "prediction",
                                       {{"butterfly", GP::Wavelet_prediction::butterfly},
                                        {"linear", GP::Wavelet_prediction::linear}});
    const auto np = GP::parameters::number_of_levels(number_of_levels)
                        .wavelet_prediction(kind)
                        .do_update(do_update);
    Computation().run([&] { m_wavelet.emplace(surface.domain(), np); });
  }

  std::size_t number_of_levels() const { return m_wavelet->number_of_levels(); }
  // Returns the number of vertices of each level.
  py::array_t<std::int64_t> numbers_of_vertices() const
  {
    std::vector<std::size_t> result;
    for(std::size_t level = 0; level <= number_of_levels(); ++level)
      result.push_back(m_wavelet->number_of_vertices(level));
    return index_array(result);
  }
  // Returns the vertices in the order of the coefficients.
  py::array_t<std::int64_t> order() const
  {
    std::vector<Mesh::Vertex_index> result;
    for(std::size_t i = 0; i < m_wavelet->number_of_vertices(); ++i)
      result.push_back(m_wavelet->vertex(i));
    return index_array(result);
  }
  // Returns the ends of the edge at whose midpoint each vertex was added, in that order.
  py::array_t<std::int64_t> parents() const
  {
    py::array_t<std::int64_t> result(Shape{py::ssize_t(m_wavelet->number_of_vertices()), 2});
    std::int64_t* next = result.mutable_data();
    for(std::size_t i = 0; i < m_wavelet->number_of_vertices(); ++i)
      for(const std::size_t parent : m_wavelet->parents(i))
        *next++ = std::int64_t(parent);
    return result;
  }
  // Returns the triangles of a level: positions in that order.
  py::array_t<std::int64_t> triangles(const py::object& level) const
  {
    const auto triangles = m_wavelet->triangles(index(level, "level", number_of_levels() + 1));
    py::array_t<std::int64_t> result(Shape{py::ssize_t(triangles.size()), 3});
    std::int64_t* next = result.mutable_data();
    for(const auto& triangle : triangles)
      for(const std::size_t corner : triangle)
        *next++ = std::int64_t(corner);
    return result;
  }

  // Returns the coefficients of values of vertices. They have the shape of the values.
  py::array_t<double> analyze(const py::object& object, bool use_frames) const
  {
    const bool has_one_channel = is_flat(object);
    const Numbers values(object, "values", shape(has_one_channel ? 0 : any));
    const std::size_t channels = has_one_channel ? 1 : values.row_size();
    if(use_frames && channels != 3)
      reject("Frames need values with three components.");
    py::array_t<double> result =
        has_one_channel ? py::array_t<double>(shape(0)) : py::array_t<double>(shape(channels));
    double* const data = result.mutable_data();
    Computation().run(
        [&]
        {
          if(use_frames)
          {
            const auto details =
                m_wavelet->analyze(Row_map{&values}, GP::parameters::do_use_frames(true));
            std::copy(details.values.begin(), details.values.end(), data);
            return;
          }
          // The channels are independent of each other, and their number is a constant for the
          // library.
          for(std::size_t c = 0; c < channels; ++c)
          {
            const auto details = m_wavelet->analyze(Column_map{&values, c});
            for(std::size_t i = 0; i < details.values.size(); ++i)
              data[i * channels + c] = details.values[i];
          }
        });
    return result;
  }

  // Returns the values of vertices. They have the shape of the coefficients.
  py::array_t<double> synthesize(const py::object& object, bool use_frames) const
  {
    const auto [details, details_shape] = read_details(object, use_frames);
    py::array_t<double> result(details_shape);
    double* const data = result.mutable_data();
    Computation().run(
        [&, &details = details]
        {
          if(use_frames)
            return m_wavelet->synthesize(details, Output_row_map{data});
          const std::size_t channels = details.number_of_channels;
          GP::Wavelet_details column{1, false, {}};
          column.values.resize(details.values.size() / channels);
          for(std::size_t c = 0; c < channels; ++c)
          {
            for(std::size_t i = 0; i < column.values.size(); ++i)
              column.values[i] = details.values[i * channels + c];
            m_wavelet->synthesize(
                column, Output_map<Mesh::Vertex_index, double>{data + c, std::ptrdiff_t(channels)});
          }
        });
    return result;
  }

  // Returns the coefficients without all but the largest details.
  py::array_t<double> keep_largest(const py::object& object, bool use_frames,
                                   const py::object& n) const
  {
    const std::size_t size = index(n, "number of vertices", std::size_t(1) << 32);
    auto [details, details_shape] = read_details(object, use_frames);
    Computation().run([&, &details = details] { m_wavelet->keep_largest(details, size); });
    py::array_t<double> result(details_shape);
    std::copy(details.values.begin(), details.values.end(), result.mutable_data());
    return result;
  }

  // Returns the progressive stream of coefficients.
  py::bytes encode(const py::object& object, bool use_frames, const py::object& bit_planes,
                   const py::object& max_bytes) const
  {
    const auto number_of_planes = unsigned(index(bit_planes, "number of bit planes", 1 << 16));
    const std::size_t size = max_bytes.is_none()
                                 ? std::numeric_limits<std::size_t>::max()
                                 : index(max_bytes, "number of bytes", std::size_t(1) << 62);
    const auto details = read_details(object, use_frames).first;
    std::vector<std::uint8_t> stream;
    Computation().run(
        [&]
        {
          stream = m_wavelet->encode(
              details,
              GP::parameters::number_of_bit_planes(number_of_planes).maximum_number_of_bytes(size));
        });
    return py::bytes(reinterpret_cast<const char*>(stream.data()), stream.size());
  }

private:
  // Returns (n,) if the number of channels is 0.
  Shape shape(py::ssize_t channels) const
  {
    const auto size = py::ssize_t(m_wavelet->number_of_vertices());
    return channels == 0 ? Shape{size} : Shape{size, channels};
  }
  std::pair<GP::Wavelet_details, Shape> read_details(const py::object& object,
                                                     bool use_frames) const
  {
    const bool has_one_channel = is_flat(object);
    const Numbers values(object, "details", shape(has_one_channel ? 0 : any));
    GP::Wavelet_details result;
    result.number_of_channels = has_one_channel ? 1 : values.row_size();
    result.is_in_frames = use_frames;
    result.values.reserve(values.size() * result.number_of_channels);
    for(std::size_t i = 0; i < values.size(); ++i)
      for(std::size_t c = 0; c < result.number_of_channels; ++c)
        result.values.push_back(values(i, c));
    if(use_frames && result.number_of_channels != 3)
      reject("Details in frames have three components.");
    return {std::move(result), shape(has_one_channel ? 0 : py::ssize_t(values.row_size()))};
  }

  std::optional<GP::Subdivision_wavelet<Mesh>> m_wavelet;
};

// A contiguous range of bytes.
struct Bytes
{
  const std::uint8_t* first;
  std::size_t length;

  const std::uint8_t* data() const { return first; }
  std::size_t size() const { return length; }
};

// Returns the mesh, the numbers of levels and of bit planes, and whether the stream is complete and
// whether it is damaged.
py::tuple decode_wavelets(const py::object& stream, const py::object& max_vertices)
{
  if(!py::isinstance<py::buffer>(stream))
    reject("A stream of wavelets is an object with bytes.");
  const py::buffer_info info = py::reinterpret_borrow<py::buffer>(stream).request();
  if(info.itemsize != 1 || info.ndim != 1 || info.strides[0] != 1)
    reject("A stream of wavelets is a contiguous range of bytes.");
  const std::size_t size = index(max_vertices, "number of vertices", std::size_t(1) << 32);
  const Bytes bytes{static_cast<const std::uint8_t*>(info.ptr), std::size_t(info.size)};
  GP::Wavelet_stream found;
  std::shared_ptr<Mesh_surface> result;
  Computation().run(
      [&]
      {
        Mesh mesh;
        found = GP::decode_wavelets(bytes, mesh, GP::parameters::maximum_number_of_vertices(size));
        result = surface_of_mesh(mesh);
      });
  return py::make_tuple(result, found.number_of_levels, found.number_of_bit_planes,
                        found.is_complete, found.is_damaged);
}

} // namespace

void bind_wavelets(py::module_& module, Mesh_class& mesh)
{
  py::class_<Wavelet>(module, "Wavelet")
      .def("number_of_levels", &Wavelet::number_of_levels)
      .def("numbers_of_vertices", &Wavelet::numbers_of_vertices)
      .def("order", &Wavelet::order)
      .def("parents", &Wavelet::parents)
      .def("triangles", &Wavelet::triangles)
      .def("analyze", &Wavelet::analyze)
      .def("synthesize", &Wavelet::synthesize)
      .def("keep_largest", &Wavelet::keep_largest)
      .def("encode", &Wavelet::encode);
  mesh.def("wavelet", [](const Mesh_surface& self, const py::object& levels,
                         const py::object& prediction, bool do_update)
           { return std::make_unique<Wavelet>(self, levels, prediction, do_update); });
  module.def("decode_wavelets", &decode_wavelets);
}

} // namespace python
