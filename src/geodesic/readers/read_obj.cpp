// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Scanner.h"
#include "readers/Surface_file.h"
#include "readers/append_polygon.h"
#include "readers/count_lines.h"
#include "readers/parse_chunks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace program {

namespace {

constexpr std::size_t no_texture_index = std::numeric_limits<std::size_t>::max();

// Returns the 0-based texture index of a corner "v/vt" or "v/vt/vn". Negative indices count from
// the end of the coordinates read so far. Returns no_texture_index if the corner has no valid
// index.
std::size_t texture_index(std::string_view word, std::size_t count)
{
  const std::size_t slash = word.find('/');
  if(slash == std::string_view::npos)
    return no_texture_index;
  const std::string_view rest = word.substr(slash + 1);
  const long long index = to_integer(rest.substr(0, rest.find('/'))).value_or(0);
  const bool is_valid = index > 0 || index >= -static_cast<long long>(count);
  return index == 0 || !is_valid
             ? no_texture_index
             : static_cast<std::size_t>(index > 0 ? index - 1
                                                  : static_cast<long long>(count) + index);
}

// Reads the optional vertex color: three numbers after the coordinates.
std::optional<std::array<double, 3>> read_color(Scanner& scanner)
{
  if(scanner.is_line_empty())
    return std::nullopt;
  std::array<double, 3> color;
  for(double& channel : color)
  {
    const std::optional<double> number = to_number(scanner.word());
    if(!number)
      return std::nullopt;
    channel = *number;
  }
  return color;
}

// Stores the colors as bytes, like other formats. Most programs write color channels in [0, 1].
void set_colors(const std::vector<std::array<double, 3>>& colors, Surface_file& surface)
{
  double largest = 0.;
  for(const auto& color : colors)
    largest = std::max({largest, color[0], color[1], color[2]});
  for(std::size_t c = 0; c < 3; ++c)
  {
    std::vector<double>& values = surface.properties[color_names[c]];
    for(const auto& color : colors)
      values.push_back(largest > 1. ? color[c] : std::round(255. * color[c]));
  }
}

template <typename T>
void append_to(std::vector<T>& values, const std::vector<T>& more)
{
  values.insert(values.end(), more.begin(), more.end());
}

class Obj_reader
{
public:
  // Reserves memory for the lines of another text, to which this one belongs.
  Obj_reader(std::string_view bytes, const std::string& name, std::string_view whole_text)
      : m_scanner(bytes, name, '#')
  {
    const std::size_t max_vertices = max_number_of_lines(whole_text, 8, 'v'),
                      max_faces = max_number_of_lines(whole_text, 8, 'f');
    m_surface.points.reserve(max_vertices);
    m_surface.corners.reserve(3 * max_faces);
    m_surface.polygon_begin.reserve(max_faces + 1);
  }

  void parse()
  {
    while(m_scanner.next_line())
    {
      const std::string_view keyword = m_scanner.word();
      if(keyword == "v")
        read_vertex();
      else if(keyword == "vt")
        read_texture_coordinates();
      else if(keyword == "f")
        read_face();
    }
  }

  // Returns whether the content of this chunk does not depend on others.
  bool is_independent() const { return m_is_independent; }

  void append(const Obj_reader& next)
  {
    append_to(m_surface.points, next.m_surface.points);
    append_polygons(m_surface, next.m_surface);
    append_to(m_texture_coordinates, next.m_texture_coordinates);
    append_to(m_corner_texture_index, next.m_corner_texture_index);
    append_to(m_colors, next.m_colors);
    m_has_uv = m_has_uv && next.m_has_uv;
  }

  Surface_file finish()
  {
    set_uv();
    if(!m_colors.empty() && m_colors.size() == m_surface.points.size())
      set_colors(m_colors, m_surface);
    return std::move(m_surface);
  }

private:
  void read_vertex()
  {
    Point& point = m_surface.points.emplace_back();
    for(double& x : point)
      x = m_scanner.coordinate();
    if(const auto color = read_color(m_scanner))
      m_colors.push_back(*color);
  }

  void read_texture_coordinates()
  {
    const std::optional<double> u = to_number(m_scanner.word()), v = to_number(m_scanner.word());
    m_texture_coordinates.push_back({u.value_or(0.), v.value_or(0.)});
  }

  void read_face()
  {
    for(long long index = 0; !m_scanner.is_line_empty();)
    {
      if(m_scanner.take_plain_integer(index))
      {
        add_corner(index, no_texture_index);
        continue;
      }
      // A backslash at the end of a line continues the face on the next line.
      const std::string_view word = m_scanner.word();
      if(word != "\\")
      {
        read_corner(word);
        continue;
      }
      m_is_independent = false;
      if(!m_scanner.next_line())
        break;
    }
    end_polygon(m_surface);
  }

  void read_corner(std::string_view word)
  {
    const long long index = m_scanner.parse_integer(word.substr(0, word.find('/')));
    m_is_independent = m_is_independent && word.find('-') == std::string_view::npos;
    add_corner(index,
               m_has_uv ? texture_index(word, m_texture_coordinates.size()) : no_texture_index);
  }

  // Appends the vertex of a 1-based or negative index. A face may refer to vertices that follow it,
  // so indices are checked after all vertices are read.
  void add_corner(long long index, std::size_t texture)
  {
    const auto count = static_cast<long long>(m_surface.points.size());
    // Negative indices count from the end of the vertices and texture coordinates read so far.
    m_is_independent = m_is_independent && index > 0;
    if(index == 0 || index < -count)
      m_scanner.fail("a face has the invalid vertex index " + std::to_string(index));
    append_corner(m_surface, index > 0 ? index - 1 : count + index);
    if(!m_has_uv)
      return;
    m_corner_texture_index.push_back(texture);
    m_has_uv = texture != no_texture_index;
  }

  // A vertex gets the texture coordinates of its first corner. If any corner has none, all are
  // discarded.
  void set_uv()
  {
    if(!m_has_uv || m_corner_texture_index.empty() ||
       *std::max_element(m_corner_texture_index.begin(), m_corner_texture_index.end()) >=
           m_texture_coordinates.size())
      return;
    m_surface.uv.resize(m_surface.points.size());
    for(std::size_t c = m_corner_texture_index.size(); c-- > 0;)
      if(m_surface.corners[c] < m_surface.uv.size())
        m_surface.uv[m_surface.corners[c]] = m_texture_coordinates[m_corner_texture_index[c]];
  }

  Scanner m_scanner;
  Surface_file m_surface;
  std::vector<std::array<double, 2>> m_texture_coordinates; // in an image
  bool m_is_independent = true;
  bool m_has_uv = true; // as long as all corners have texture coordinates
  std::vector<std::size_t> m_corner_texture_index; // #corners, if they have: index of these
  std::vector<std::array<double, 3>> m_colors;
};

} // namespace

Surface_file read_obj(std::string_view bytes, const std::string& name)
{
  Obj_reader reader(bytes, name, bytes);
  reader.parse();
  return reader.finish();
}

Surface_file read_obj_in_parallel(std::string_view bytes, const std::string& name,
                                  unsigned number_of_threads)
{
  const std::vector<std::string_view> chunks =
      split_lines(bytes, number_of_chunks(bytes.size(), number_of_threads));
  std::vector<std::unique_ptr<Obj_reader>> readers(chunks.size());
  const bool is_parsed =
      chunks.size() > 1 && parse_chunks(chunks.size(), number_of_threads,
                                        [&](std::size_t i)
                                        {
                                          readers[i] = std::make_unique<Obj_reader>(
                                              chunks[i], name, i == 0 ? bytes : chunks[i]);
                                          readers[i]->parse();
                                          return readers[i]->is_independent();
                                        });
  if(!is_parsed)
    return read_obj(bytes, name);
  for(std::size_t i = 1; i < readers.size(); ++i)
    readers[0]->append(*readers[i]);
  return readers[0]->finish();
}

} // namespace program
