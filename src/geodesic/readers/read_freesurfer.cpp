// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Scanner.h"
#include "readers/Surface_file.h"
#include "readers/append_polygon.h"
#include "readers/binary_numbers.h"

#include <algorithm>
#include <utility>

namespace program {

namespace {

// The first three bytes of a file
constexpr std::uint64_t triangle_magic = 0xfffffe, quad_magic = 0xffffff, new_quad_magic = 0xfffffd;

std::uint64_t magic_number(std::string_view bytes)
{
  return bytes.size() < 3 ? 0 : bits_at(bytes, 3, true);
}

// Reads the big-endian numbers of a file one by one.
class Freesurfer_reader
{
public:
  Freesurfer_reader(std::string_view bytes, const std::string& name) : m_rest(bytes), m_name(name)
  {}

  Surface_file read()
  {
    const std::uint64_t magic = magic_number(m_rest);
    m_rest.remove_prefix(std::min<std::size_t>(3, m_rest.size()));
    if(magic == triangle_magic)
      read_triangles();
    else if(magic == quad_magic)
      read_quads({'i', 2}, 100.);
    else if(magic == new_quad_magic)
      read_quads({'f', 4}, 1.);
    else
      fail(m_name, "it is not a FreeSurfer surface");
    return std::move(m_surface);
  }

private:
  void read_triangles()
  {
    // Two lines of text name the creator; the second one is empty.
    for(int line = 0; line < 2; ++line)
    {
      const std::size_t end = m_rest.find('\n');
      if(end == std::string_view::npos)
        fail(m_name, "it is truncated");
      m_rest.remove_prefix(end + 1);
    }
    const double vertices = next({'i', 4}), triangles = next({'i', 4});
    if(vertices < 0. || triangles < 0.)
      fail(m_name, "a count is negative");
    check_size(vertices * 12. + triangles * 12.);
    read_points(static_cast<std::size_t>(vertices), {'f', 4}, 1.);
    for(double i = 0.; i < triangles; ++i)
      append_triangle({next({'i', 4}), next({'i', 4}), next({'i', 4})});
  }

  // Coordinates are divided by `scale`.
  void read_quads(Number_type coordinate, double scale)
  {
    const double vertices = next({'u', 3}), quads = next({'u', 3});
    check_size(vertices * 3. * static_cast<double>(coordinate.size) + quads * 12.);
    read_points(static_cast<std::size_t>(vertices), coordinate, scale);
    for(double i = 0.; i < quads; ++i)
    {
      std::array<double, 4> q;
      for(double& corner : q)
        corner = next({'u', 3});
      // FreeSurfer splits quads by this rule.
      const bool is_even = static_cast<std::uint32_t>(q[0]) % 2 == 0;
      append_triangle({q[0], q[1], q[is_even ? 3 : 2]});
      append_triangle({q[is_even ? 2 : 0], q[is_even ? 3 : 2], q[is_even ? 1 : 3]});
    }
  }

  void check_size(double size) const
  {
    if(size > static_cast<double>(m_rest.size()))
      fail(m_name, "the file is too short for the counts in its header");
  }

  void read_points(std::size_t count, Number_type type, double scale)
  {
    m_surface.points.resize(count);
    for(Point& point : m_surface.points)
      for(double& x : point)
        x = next(type) / scale;
  }

  void append_triangle(const Point& triangle)
  {
    for(const double corner : triangle)
      append_corner(m_surface, corner);
    end_polygon(m_surface);
  }

  double next(Number_type type)
  {
    if(m_rest.size() < type.size)
      fail(m_name, "it is truncated");
    const double result = to_value(bits_at(m_rest, type.size, true), type);
    m_rest.remove_prefix(type.size);
    return result;
  }

  std::string_view m_rest;
  std::string m_name;
  Surface_file m_surface;
};

} // namespace

bool is_freesurfer(std::string_view bytes)
{
  const std::uint64_t magic = magic_number(bytes);
  return magic == triangle_magic || magic == quad_magic || magic == new_quad_magic;
}

Surface_file read_freesurfer(std::string_view bytes, const std::string& name)
{
  return Freesurfer_reader(bytes, name).read();
}

} // namespace program
