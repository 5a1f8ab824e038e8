// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/base64.h"
#include "io/write_surface_file.h"
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

// Cells of one kind: the indices of their points, concatenated, and the end of each cell.
struct Cells
{
  std::vector<std::int64_t> points, offsets;
};

std::string cell_section(const char* section, const Cells& cells)
{
  return std::string("      <") + section + ">\n" +
         data_array("connectivity", "Int64", 1, cells.points) +
         data_array("offsets", "Int64", 1, cells.offsets) + "      </" + section + ">\n";
}

// The points of the polylines follow those of the surface.
Cells polyline_cells(const Surface_file& surface)
{
  Cells lines;
  auto next = static_cast<std::int64_t>(surface.points.size());
  for(const std::vector<Point>& polyline : surface.polylines)
  {
    for(std::size_t i = 0; i < polyline.size(); ++i)
      lines.points.push_back(next++);
    lines.offsets.push_back(static_cast<std::int64_t>(lines.points.size()));
  }
  return lines;
}

// Most viewers show points without polygons only if each point is a cell.
Cells point_cells(const Surface_file& surface)
{
  Cells cells;
  if(surface.number_of_polygons() == 0)
    for(std::size_t i = 0; i < surface.points.size(); ++i)
    {
      cells.points.push_back(static_cast<std::int64_t>(i));
      cells.offsets.push_back(static_cast<std::int64_t>(i) + 1);
    }
  return cells;
}

// Returns the data of the points. The points of polylines have the value zero.
std::string point_data(const Surface_file& surface, std::size_t number_of_points)
{
  std::string text = "      <PointData>\n";
  if(!surface.normals.empty())
  {
    std::vector<Point> normals = surface.normals;
    normals.resize(number_of_points, Point{0., 0., 0.});
    text += data_array("Normals", "Float64", 3, flatten(normals));
  }
  if(!surface.uv.empty())
  {
    std::vector<std::array<double, 2>> uv = surface.uv;
    uv.resize(number_of_points, std::array<double, 2>{0., 0.});
    text += data_array("uv", "Float64", 2, flatten(uv));
  }
  for(const auto& [name, property] : surface.properties)
  {
    std::vector<double> values = property;
    values.resize(number_of_points, 0.);
    text += data_array(name, "Float64", 1, values);
  }
  return text + "      </PointData>\n";
}

// Returns the data of the cells, or an empty text if there are none. The point and line cells
// precede the polygons and have the value zero.
std::string cell_data(const Surface_file& surface, std::size_t number_of_other_cells)
{
  if(surface.vectors.empty() && surface.face_numbers.empty())
    return {};
  std::string text = "      <CellData>\n";
  for(const auto& [name, vectors] : surface.vectors)
  {
    std::vector<Point> values(number_of_other_cells, Point{0., 0., 0.});
    values.insert(values.end(), vectors.begin(), vectors.end());
    text += data_array(name, "Float64", 3, flatten(values));
  }
  for(const auto& [name, numbers] : surface.face_numbers)
  {
    std::vector<double> values(number_of_other_cells, 0.);
    values.insert(values.end(), numbers.begin(), numbers.end());
    text += data_array(name, "Float64", 1, values);
  }
  return text + "      </CellData>\n";
}

} // namespace

std::string to_vtp(const Surface_file& surface)
{
  const Cells verts = point_cells(surface), lines = polyline_cells(surface),
              polys = {{surface.corners.begin(), surface.corners.end()},
                       {surface.polygon_begin.begin() + 1, surface.polygon_begin.end()}};
  std::vector<Point> points = surface.points;
  for(const std::vector<Point>& polyline : surface.polylines)
    points.insert(points.end(), polyline.begin(), polyline.end());
  const auto count = [](const Cells& cells) { return std::to_string(cells.offsets.size()); };

  return "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\""
         " header_type=\"UInt64\">\n  <PolyData>\n    <Piece NumberOfPoints=\"" +
         std::to_string(points.size()) + "\" NumberOfVerts=\"" + count(verts) +
         "\" NumberOfLines=\"" + count(lines) + "\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
         count(polys) + "\">\n" + point_data(surface, points.size()) +
         cell_data(surface, verts.offsets.size() + lines.offsets.size()) + "      <Points>\n" +
         data_array("Points", "Float64", 3, flatten(points)) + "      </Points>\n" +
         cell_section("Verts", verts) + cell_section("Lines", lines) +
         cell_section("Polys", polys) + "    </Piece>\n  </PolyData>\n</VTKFile>\n";
}

} // namespace program
