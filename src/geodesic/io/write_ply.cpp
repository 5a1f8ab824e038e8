// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
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

} // namespace

std::string to_ply(const Surface_file& surface)
{
  std::size_t polyline_points = 0, edges = surface.edges.size();
  for(const std::vector<Point>& polyline : surface.polylines)
  {
    polyline_points += polyline.size();
    edges += polyline.empty() ? 0 : polyline.size() - 1;
  }
  // The number of corners is a byte, which all readers accept. The program writes only triangles.
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                      std::to_string(surface.points.size() + polyline_points) +
                      "\nproperty double x\nproperty double y\nproperty double z\n";
  if(!surface.normals.empty())
    bytes += "property double nx\nproperty double ny\nproperty double nz\n";
  std::vector<bool> is_byte_property;
  for(const auto& property : surface.properties)
  {
    is_byte_property.push_back(is_byte_color(property));
    bytes += (is_byte_property.back() ? "property uchar " : "property double ") +
             to_identifier(property.first) + "\n";
  }
  const auto append_properties = [&](auto value_of)
  {
    std::size_t k = 0;
    for(const auto& property : surface.properties)
      if(const double value = value_of(property.second); is_byte_property[k++])
        append_little_endian(bytes, static_cast<std::uint8_t>(value));
      else
        append_little_endian(bytes, value);
  };
  if(surface.number_of_polygons() > 0)
  {
    bytes += "element face " + std::to_string(surface.number_of_polygons()) +
             "\nproperty list uchar int vertex_indices\n";
    for(const auto& [name, vectors] : surface.vectors)
      for(const char* axis : {"_x", "_y", "_z"})
        bytes += "property double " + to_identifier(name) + axis + "\n";
    for(const auto& [name, numbers] : surface.face_numbers)
      bytes += "property uint " + to_identifier(name) + "\n";
  }
  if(edges > 0)
    bytes +=
        "element edge " + std::to_string(edges) + "\nproperty int vertex1\nproperty int vertex2\n";
  bytes += "end_header\n";

  for(std::size_t i = 0; i < surface.points.size(); ++i)
  {
    for(const double x : surface.points[i])
      append_little_endian(bytes, x);
    if(!surface.normals.empty())
      for(const double x : surface.normals[i])
        append_little_endian(bytes, x);
    append_properties([i](const std::vector<double>& values) { return values[i]; });
  }
  for(const std::vector<Point>& polyline : surface.polylines)
    for(const Point& point : polyline)
    {
      for(const double x : point)
        append_little_endian(bytes, x);
      for(std::size_t k = 0; k < 3 && !surface.normals.empty(); ++k)
        append_little_endian(bytes, 0.);
      append_properties([](const std::vector<double>&) { return 0.; });
    }
  for(std::size_t f = 0; f < surface.number_of_polygons(); ++f)
  {
    append_little_endian(
        bytes, static_cast<std::uint8_t>(surface.polygon_begin[f + 1] - surface.polygon_begin[f]));
    for(std::size_t c = surface.polygon_begin[f]; c < surface.polygon_begin[f + 1]; ++c)
      append_little_endian(bytes, surface.corners[c]);
    for(const auto& [name, vectors] : surface.vectors)
      for(const double x : vectors[f])
        append_little_endian(bytes, x);
    for(const auto& [name, numbers] : surface.face_numbers)
      append_little_endian(bytes, numbers[f]);
  }
  for(const auto& edge : surface.edges)
    for(const std::uint32_t end : edge)
      append_little_endian(bytes, end);
  std::size_t begin = surface.points.size();
  for(const std::vector<Point>& polyline : surface.polylines)
  {
    for(std::size_t i = 0; i + 1 < polyline.size(); ++i)
    {
      append_little_endian(bytes, static_cast<std::uint32_t>(begin + i));
      append_little_endian(bytes, static_cast<std::uint32_t>(begin + i + 1));
    }
    begin += polyline.size();
  }
  return bytes;
}

} // namespace program
