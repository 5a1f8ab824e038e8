// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Scanner.h"
#include "io/Surface_file.h"
#include "io/append_polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace program {

namespace {

// Returns the 0-based texture index of a corner "v/vt" or "v/vt/vn". Negative indices count from
// the end of the coordinates read so far. Returns the maximum value if the corner has no valid
// index.
std::size_t texture_index(std::string_view word, std::size_t count)
{
  const std::size_t slash = std::min(word.find('/'), word.size() - 1);
  const std::string_view rest = word.substr(slash + 1);
  const long long index = to_integer(rest.substr(0, rest.find('/'))).value_or(0);
  const bool is_valid = index > 0 || index >= -static_cast<long long>(count);
  return index == 0 || !is_valid
             ? std::numeric_limits<std::size_t>::max()
             : static_cast<std::size_t>(index > 0 ? index - 1
                                                  : static_cast<long long>(count) + index);
}

// Reads the optional vertex color: three numbers after the coordinates.
std::optional<std::array<double, 3>> read_color(Scanner& scanner)
{
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

} // namespace

Surface_file read_obj(std::string_view bytes, const std::string& name)
{
  Surface_file surface;
  std::vector<std::array<double, 2>> texture_coordinates; // in an image
  std::vector<std::size_t> corner_texture_index; // #corners: index of these; the maximum: none
  std::vector<std::array<double, 3>> colors;
  Scanner scanner(bytes, name, '#');
  // A face may refer to vertices that follow it, so indices are checked after all vertices are
  // read.
  while(scanner.next_line())
  {
    const std::string_view keyword = scanner.word();
    if(keyword == "v")
    {
      Point& point = surface.points.emplace_back();
      for(double& x : point)
        x = scanner.parse_coordinate(scanner.word());
      if(const auto color = read_color(scanner))
        colors.push_back(*color);
    }
    else if(keyword == "vt")
    {
      const std::optional<double> u = to_number(scanner.word()), v = to_number(scanner.word());
      texture_coordinates.push_back({u.value_or(0.), v.value_or(0.)});
    }
    else if(keyword == "f")
    {
      for(std::string_view word = scanner.word(); !word.empty(); word = scanner.word())
      {
        // A backslash at the end of a line continues the face on the next line.
        if(word == "\\")
        {
          if(!scanner.next_line())
            break;
          continue;
        }
        const long long index = scanner.parse_integer(word.substr(0, word.find('/')));
        const auto count = static_cast<long long>(surface.points.size());
        if(index == 0 || index < -count)
          scanner.fail("a face names vertex " + std::to_string(index));
        append_corner(surface, static_cast<double>(index > 0 ? index - 1 : count + index));
        corner_texture_index.push_back(texture_index(word, texture_coordinates.size()));
      }
      end_polygon(surface);
    }
  }
  // A vertex gets the texture coordinates of its first corner. If any corner has none, all are
  // discarded.
  if(!corner_texture_index.empty() &&
     *std::max_element(corner_texture_index.begin(), corner_texture_index.end()) <
         texture_coordinates.size())
  {
    surface.uv.resize(surface.points.size());
    for(std::size_t c = corner_texture_index.size(); c-- > 0;)
      if(surface.corners[c] < surface.uv.size())
        surface.uv[surface.corners[c]] = texture_coordinates[corner_texture_index[c]];
  }
  if(!colors.empty() && colors.size() == surface.points.size())
    set_colors(colors, surface);
  return surface;
}

} // namespace program
