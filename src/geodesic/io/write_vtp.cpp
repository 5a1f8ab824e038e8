// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/base64.h"
#include "io/write_utilities.h"

namespace program {

namespace {

// Returns a data array in base64, preceded by its length in bytes.
template <typename Value>
std::string data_array(const std::string& name, const char* type, std::size_t components,
                       const std::vector<Value>& values)
{
  std::string bytes;
  bytes.reserve(8 + values.size() * sizeof(Value));
  append_little_endian(bytes, static_cast<std::uint64_t>(values.size() * sizeof(Value)));
  for(const Value value : values)
    append_little_endian(bytes, value);
  return "        <DataArray type=\"" + std::string(type) + "\" Name=\"" + to_identifier(name) +
         "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"binary\">" +
         to_base64(bytes) + "</DataArray>\n";
}

template <std::size_t N>
std::vector<double> flatten(const std::vector<std::array<double, N>>& rows)
{
  std::vector<double> values;
  values.reserve(N * rows.size());
  for(const std::array<double, N>& row : rows)
    values.insert(values.end(), row.begin(), row.end());
  return values;
}

std::string cell_section(const char* section, const std::vector<std::int64_t>& corners,
                         const std::vector<std::int64_t>& offsets)
{
  return std::string("      <") + section + ">\n" +
         data_array("connectivity", "Int64", 1, corners) +
         data_array("offsets", "Int64", 1, offsets) + "      </" + section + ">\n";
}

} // namespace

std::string to_vtp(const Surface_file& surface)
{
  std::vector<Point> points = surface.points, normals = surface.normals;
  std::vector<std::int64_t> verts, vert_offsets, lines, line_offsets;
  for(const std::vector<Point>& polyline : surface.polylines)
  {
    for(const Point& point : polyline)
    {
      lines.push_back(static_cast<std::int64_t>(points.size()));
      points.push_back(point);
    }
    line_offsets.push_back(static_cast<std::int64_t>(lines.size()));
  }
  // Most viewers show points without polygons only if each point is a cell.
  if(surface.number_of_polygons() == 0)
    for(std::size_t i = 0; i < surface.points.size(); ++i)
    {
      verts.push_back(static_cast<std::int64_t>(i));
      vert_offsets.push_back(static_cast<std::int64_t>(i) + 1);
    }
  const std::vector<std::int64_t> corners(surface.corners.begin(), surface.corners.end());
  const std::vector<std::int64_t> offsets(surface.polygon_begin.begin() + 1,
                                          surface.polygon_begin.end());

  std::string text = "<?xml version=\"1.0\"?>\n"
                     "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\""
                     " header_type=\"UInt64\">\n  <PolyData>\n    <Piece NumberOfPoints=\"" +
                     std::to_string(points.size()) + "\" NumberOfVerts=\"" +
                     std::to_string(vert_offsets.size()) + "\" NumberOfLines=\"" +
                     std::to_string(line_offsets.size()) +
                     "\" NumberOfStrips=\"0\" NumberOfPolys=\"" + std::to_string(offsets.size()) +
                     "\">\n      <PointData>\n";
  if(!normals.empty())
  {
    normals.resize(points.size(), Point{0., 0., 0.});
    text += data_array("Normals", "Float64", 3, flatten(normals));
  }
  if(!surface.uv.empty())
  {
    std::vector<std::array<double, 2>> uv = surface.uv;
    uv.resize(points.size(), std::array<double, 2>{0., 0.});
    text += data_array("uv", "Float64", 2, flatten(uv));
  }
  for(const auto& [name, property] : surface.properties)
  {
    std::vector<double> values = property;
    values.resize(points.size(), 0.);
    text += data_array(name, "Float64", 1, values);
  }
  text += "      </PointData>\n";
  if(!surface.vectors.empty() || !surface.face_numbers.empty())
  {
    // Cell data begin with the point and line cells, which precede the polygons.
    text += "      <CellData>\n";
    for(const auto& [name, vectors] : surface.vectors)
    {
      std::vector<Point> values(vert_offsets.size() + line_offsets.size(), Point{0., 0., 0.});
      values.insert(values.end(), vectors.begin(), vectors.end());
      text += data_array(name, "Float64", 3, flatten(values));
    }
    for(const auto& [name, numbers] : surface.face_numbers)
    {
      std::vector<double> values(vert_offsets.size() + line_offsets.size(), 0.);
      values.insert(values.end(), numbers.begin(), numbers.end());
      text += data_array(name, "Float64", 1, values);
    }
    text += "      </CellData>\n";
  }
  text += "      <Points>\n" + data_array("Points", "Float64", 3, flatten(points)) +
          "      </Points>\n" + cell_section("Verts", verts, vert_offsets) +
          cell_section("Lines", lines, line_offsets) + cell_section("Polys", corners, offsets) +
          "    </Piece>\n  </PolyData>\n</VTKFile>\n";
  return text;
}

} // namespace program
