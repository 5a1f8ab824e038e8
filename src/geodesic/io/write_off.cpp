// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/colours.h"
#include "io/write.h"

namespace program {

std::string to_off(const Surface_file& surface, const std::string& colour_of)
{
  const auto property = surface.properties.find(colour_of);
  const bool colours = property != surface.properties.end(), normals = !surface.normals.empty();
  std::string text = std::string(colours ? "C" : "") + (normals ? "N" : "") + "OFF\n" +
                     std::to_string(surface.points.size()) + ' ' +
                     std::to_string(surface.number_of_polygons()) + " 0\n";
  std::vector<std::array<double, 3>> colour;
  if(colours)
    colour = colours_of(property->second);
  for(std::size_t i = 0; i < surface.points.size(); ++i)
  {
    std::string line;
    append_numbers(line, surface.points[i]);
    if(normals)
      append_numbers(line, surface.normals[i]);
    if(colours)
    {
      for(const double part : colour[i])
        line += ' ' + std::to_string(static_cast<int>(part * 255. + 0.5));
      line += " 255";
    }
    text.append(line, 1, std::string::npos) += "\n";
  }
  for(std::size_t f = 0; f < surface.number_of_polygons(); ++f)
  {
    text += std::to_string(surface.first[f + 1] - surface.first[f]);
    for(std::size_t c = surface.first[f]; c < surface.first[f + 1]; ++c)
      text += ' ' + std::to_string(surface.corners[c]);
    text += '\n';
  }
  return text;
}

} // namespace program
