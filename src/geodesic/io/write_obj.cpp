// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_surface_file.h"
#include "io/write_utilities.h"

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace program {

namespace {

class Obj_writer
{
public:
  explicit Obj_writer(const Surface_file& surface)
      : m_surface(surface), m_has_normals(!surface.normals.empty()),
        m_has_corner_uv(!surface.corner_uv.empty()),
        m_has_uv(m_has_corner_uv || !surface.uv.empty())
  {
    // Colors are omitted if there are texture coordinates, because many programs multiply both.
    m_has_colors =
        !m_has_uv && std::all_of(color_names.begin(), color_names.end(),
                                 [&](auto name) { return surface.properties.count(name) > 0; });
  }

  std::string write()
  {
    if(!m_surface.material.empty())
      m_text = "mtllib " + m_surface.material + "\nusemtl texture\n";
    append_vertices();
    append_texture_coordinates();
    for(const Point& normal : m_surface.normals)
      append_line("vn", normal);
    append_faces();
    append_polylines();
    return std::move(m_text);
  }

private:
  template <typename Numbers>
  void append_line(const char* keyword, const Numbers& numbers)
  {
    m_text += keyword;
    append_numbers(m_text, numbers);
    m_text += '\n';
  }

  template <typename Function>
  void append_vertex(const Point& point, Function channel_of)
  {
    m_text += 'v';
    append_numbers(m_text, point);
    for(std::size_t c = 0; m_has_colors && c < 3; ++c)
      append_numbers(m_text, std::array<double, 1>{channel_of(color_names[c])});
    m_text += '\n';
  }

  void append_vertices()
  {
    for(std::size_t i = 0; i < m_surface.points.size(); ++i)
      append_vertex(m_surface.points[i],
                    [&](const char* name) { return m_surface.properties.at(name)[i] / 255.; });
    for(const std::vector<Point>& polyline : m_surface.polylines)
      for(const Point& point : polyline)
        append_vertex(point, [](const char*) { return 0.; });
  }

  // Appends each distinct texture coordinate of the corners once.
  void append_texture_coordinates()
  {
    for(const std::array<double, 2>& coordinates :
        m_has_corner_uv ? m_surface.corner_uv : m_surface.uv)
      if(!m_has_corner_uv ||
         m_texture_index.try_emplace(coordinates, m_texture_index.size() + 1).second)
        append_line("vt", coordinates);
  }

  // Appends v, v/vt, v//vn or v/vt/vn.
  void append_corner(std::size_t c)
  {
    const std::size_t index = std::size_t{m_surface.corners[c]} + 1;
    m_text += ' ';
    append_index(m_text, index);
    if(m_has_uv || m_has_normals)
      m_text += '/';
    if(m_has_uv)
      append_index(m_text, m_has_corner_uv ? m_texture_index.at(m_surface.corner_uv[c]) : index);
    if(m_has_normals)
    {
      m_text += '/';
      append_index(m_text, index);
    }
  }

  void append_faces()
  {
    for(std::size_t f = 0; f < m_surface.number_of_polygons(); ++f)
    {
      m_text += 'f';
      for(std::size_t c = m_surface.polygon_begin[f]; c < m_surface.polygon_begin[f + 1]; ++c)
        append_corner(c);
      m_text += '\n';
    }
  }

  void append_polylines()
  {
    std::size_t next = m_surface.points.size() + 1;
    for(const std::vector<Point>& polyline : m_surface.polylines)
    {
      if(polyline.empty())
        continue;
      m_text += 'l';
      for(std::size_t i = 0; i < polyline.size(); ++i)
        m_text += ' ' + std::to_string(next++);
      m_text += '\n';
    }
  }

  const Surface_file& m_surface;
  bool m_has_normals, m_has_corner_uv, m_has_uv, m_has_colors = false;
  // Indices of the texture coordinates of corners, beginning with 1
  std::unordered_map<std::array<double, 2>, std::size_t, boost::hash<std::array<double, 2>>>
      m_texture_index;
  std::string m_text;
};

} // namespace

std::string to_obj(const Surface_file& surface) { return Obj_writer(surface).write(); }

} // namespace program
