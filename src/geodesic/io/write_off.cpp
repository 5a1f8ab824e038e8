// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/colors.h"
#include "io/write_surface_file.h"
#include "io/write_utilities.h"

namespace program {

std::string to_off(const Surface_file& surface, const std::string& color_property)
{
  const auto property = surface.properties.find(color_property);
  const bool has_colors = property != surface.properties.end(),
             has_normals = !surface.normals.empty();
  std::string text = std::string(has_colors ? "C" : "") + (has_normals ? "N" : "") + "OFF\n" +
                     std::to_string(surface.points.size()) + ' ' +
                     std::to_string(surface.number_of_polygons()) + " 0\n";
  std::vector<std::array<double, 3>> colors;
  if(has_colors)
    colors = colors_of(property->second);
  std::string line;
  for(std::size_t i = 0; i < surface.points.size(); ++i)
  {
    line.clear();
    append_numbers(line, surface.points[i]);
    if(has_normals)
      append_numbers(line, surface.normals[i]);
    if(has_colors)
    {
      for(const double channel : colors[i])
        line += ' ' + std::to_string(static_cast<int>(channel * 255. + 0.5));
      line += " 255";
    }
    text.append(line, 1, std::string::npos) += '\n';
  }
  for(std::size_t f = 0; f < surface.number_of_polygons(); ++f)
  {
    append_index(text, surface.polygon_begin[f + 1] - surface.polygon_begin[f]);
    for(std::size_t c = surface.polygon_begin[f]; c < surface.polygon_begin[f + 1]; ++c)
    {
      text += ' ';
      append_index(text, surface.corners[c]);
    }
    text += '\n';
  }
  return text;
}

} // namespace program
