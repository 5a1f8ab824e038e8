// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_utilities.h"

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <unordered_map>

namespace program {

std::string to_obj(const Surface_file& surface)
{
  const bool normals = !surface.normals.empty(), corner_uv = !surface.corner_uv.empty(),
             uv = corner_uv || !surface.uv.empty();
  std::string text;
  if(!surface.material.empty())
    text = "mtllib " + surface.material + "\nusemtl texture\n";
  const auto line = [&text](const char* keyword, const auto& numbers)
  {
    text += keyword;
    append_numbers(text, numbers);
    text += '\n';
  };
  // Colors are omitted if there are texture coordinates, because many programs multiply both.
  const bool colors =
      !uv && std::all_of(color_names.begin(), color_names.end(),
                         [&](auto name) { return surface.properties.count(name) > 0; });
  const auto write_vertex = [&](const Point& point, auto channel_of)
  {
    text += 'v';
    append_numbers(text, point);
    for(std::size_t c = 0; colors && c < 3; ++c)
      append_numbers(text, std::array<double, 1>{channel_of(color_names[c])});
    text += '\n';
  };
  for(std::size_t i = 0; i < surface.points.size(); ++i)
    write_vertex(surface.points[i],
                 [&](const char* name) { return surface.properties.at(name)[i] / 255.; });
  for(const std::vector<Point>& polyline : surface.polylines)
    for(const Point& point : polyline)
      write_vertex(point, [](const char*) { return 0.; });
  // Each distinct texture coordinate of the corners is written once.
  std::unordered_map<std::array<double, 2>, std::size_t, boost::hash<std::array<double, 2>>>
      texture_index;
  for(const std::array<double, 2>& coordinates : corner_uv ? surface.corner_uv : surface.uv)
    if(!corner_uv || texture_index.try_emplace(coordinates, texture_index.size() + 1).second)
      line("vt", coordinates);
  for(const Point& normal : surface.normals)
    line("vn", normal);
  for(std::size_t f = 0; f < surface.number_of_polygons(); ++f)
  {
    text += 'f';
    for(std::size_t c = surface.polygon_begin[f]; c < surface.polygon_begin[f + 1]; ++c)
    {
      const std::string index = std::to_string(surface.corners[c] + 1);
      text += ' ' + index;
      if(uv || normals)
        text += '/' + (corner_uv ? std::to_string(texture_index.at(surface.corner_uv[c]))
                       : uv      ? index
                                 : std::string());
      if(normals)
        text += '/' + index;
    }
    text += '\n';
  }
  std::size_t next = surface.points.size() + 1;
  for(const std::vector<Point>& polyline : surface.polylines)
  {
    if(polyline.empty())
      continue;
    text += 'l';
    for(std::size_t i = 0; i < polyline.size(); ++i)
      text += ' ' + std::to_string(next++);
    text += '\n';
  }
  return text;
}

} // namespace program
