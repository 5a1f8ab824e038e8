// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_surface_file.h"
#include "io/write_utilities.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace program {

namespace {

// Returns whether a property is a color channel with integer values in [0, 255], which is written
// as bytes.
bool is_byte_color(const std::pair<const std::string, std::vector<double>>& property)
{
  const auto& [name, values] = property;
  return std::find(color_names.begin(), color_names.end(), name) != color_names.end() &&
         std::all_of(values.begin(), values.end(),
                     [](double x) { return x >= 0. && x <= 255. && x == std::floor(x); });
}

template <typename Values>
void append_little_endian_values(std::string& bytes, const Values& values)
{
  for(const auto& value : values)
    append_little_endian(bytes, value);
}

// Writes a surface. The points of its polylines follow its own points.
class Ply_writer
{
public:
  explicit Ply_writer(const Surface_file& surface) : m_surface(surface)
  {
    for(const auto& property : surface.properties)
      m_is_byte_property.push_back(is_byte_color(property));
  }

  std::string write()
  {
    append_vertex_header();
    append_face_header();
    append_edge_header();
    m_bytes += "end_header\n";
    m_bytes.reserve(m_bytes.size() + max_size_of_body());
    append_vertices();
    append_faces();
    append_edges();
    return std::move(m_bytes);
  }

private:
  std::size_t number_of_vertices() const
  {
    std::size_t result = m_surface.points.size();
    for(const std::vector<Point>& polyline : m_surface.polylines)
      result += polyline.size();
    return result;
  }

  std::size_t max_size_of_body() const
  {
    const std::size_t numbers_of_vertex = 3 + 3 + m_surface.properties.size(),
                      numbers_of_face = 3 * m_surface.vectors.size();
    return number_of_vertices() * (sizeof(double) * numbers_of_vertex + 2 * sizeof(std::uint32_t)) +
           m_surface.number_of_polygons() *
               (1 + sizeof(double) * numbers_of_face +
                sizeof(std::uint32_t) * m_surface.face_numbers.size()) +
           sizeof(std::uint32_t) * (m_surface.corners.size() + 2 * m_surface.edges.size());
  }

  void append_vertex_header()
  {
    m_bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
              std::to_string(number_of_vertices()) +
              "\nproperty double x\nproperty double y\nproperty double z\n";
    if(!m_surface.normals.empty())
      m_bytes += "property double nx\nproperty double ny\nproperty double nz\n";
    std::size_t k = 0;
    for(const auto& [name, values] : m_surface.properties)
      m_bytes += (m_is_byte_property[k++] ? "property uchar " : "property double ") +
                 to_identifier(name) + "\n";
  }

  void append_face_header()
  {
    if(m_surface.number_of_polygons() == 0)
      return;
    // The number of corners is a byte, which all readers accept. The program writes only triangles.
    m_bytes += "element face " + std::to_string(m_surface.number_of_polygons()) +
               "\nproperty list uchar int vertex_indices\n";
    for(const auto& [name, vectors] : m_surface.vectors)
      for(const char* axis : {"_x", "_y", "_z"})
        m_bytes += "property double " + to_identifier(name) + axis + "\n";
    for(const auto& [name, numbers] : m_surface.face_numbers)
      m_bytes += "property uint " + to_identifier(name) + "\n";
  }

  void append_edge_header()
  {
    std::size_t number_of_edges = m_surface.edges.size();
    for(const std::vector<Point>& polyline : m_surface.polylines)
      number_of_edges += polyline.empty() ? 0 : polyline.size() - 1;
    if(number_of_edges > 0)
      m_bytes += "element edge " + std::to_string(number_of_edges) +
                 "\nproperty int vertex1\nproperty int vertex2\n";
  }

  template <typename Function>
  void append_properties(Function value_of)
  {
    std::size_t k = 0;
    for(const auto& property : m_surface.properties)
      if(const double value = value_of(property.second); m_is_byte_property[k++])
        append_little_endian(m_bytes, static_cast<std::uint8_t>(value));
      else
        append_little_endian(m_bytes, value);
  }

  void append_vertices()
  {
    for(std::size_t i = 0; i < m_surface.points.size(); ++i)
    {
      append_little_endian_values(m_bytes, m_surface.points[i]);
      if(!m_surface.normals.empty())
        append_little_endian_values(m_bytes, m_surface.normals[i]);
      append_properties([i](const std::vector<double>& values) { return values[i]; });
    }
    for(const std::vector<Point>& polyline : m_surface.polylines)
      for(const Point& point : polyline)
      {
        append_little_endian_values(m_bytes, point);
        if(!m_surface.normals.empty())
          append_little_endian_values(m_bytes, Point{0., 0., 0.});
        append_properties([](const std::vector<double>&) { return 0.; });
      }
  }

  void append_faces()
  {
    const std::vector<std::size_t>& begin = m_surface.polygon_begin;
    for(std::size_t f = 0; f < m_surface.number_of_polygons(); ++f)
    {
      append_little_endian(m_bytes, static_cast<std::uint8_t>(begin[f + 1] - begin[f]));
      for(std::size_t c = begin[f]; c < begin[f + 1]; ++c)
        append_little_endian(m_bytes, m_surface.corners[c]);
      for(const auto& [name, vectors] : m_surface.vectors)
        append_little_endian_values(m_bytes, vectors[f]);
      for(const auto& [name, numbers] : m_surface.face_numbers)
        append_little_endian(m_bytes, numbers[f]);
    }
  }

  void append_edges()
  {
    for(const auto& edge : m_surface.edges)
      append_little_endian_values(m_bytes, edge);
    std::size_t begin = m_surface.points.size();
    for(const std::vector<Point>& polyline : m_surface.polylines)
    {
      for(std::size_t i = 0; i + 1 < polyline.size(); ++i)
      {
        append_little_endian(m_bytes, static_cast<std::uint32_t>(begin + i));
        append_little_endian(m_bytes, static_cast<std::uint32_t>(begin + i + 1));
      }
      begin += polyline.size();
    }
  }

  const Surface_file& m_surface;
  std::vector<bool> m_is_byte_property; // #properties: whether the values are written as bytes
  std::string m_bytes;
};

} // namespace

std::string to_ply(const Surface_file& surface) { return Ply_writer(surface).write(); }

} // namespace program
