// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_IO_SURFACE_FILE_H
#define GEODESIC_PROGRAM_IO_SURFACE_FILE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace program {

using Point = std::array<double, 3>;

// The content of a file of any format, as arrays.
struct Surface_file
{
  std::vector<Point> points;
  std::vector<std::uint32_t> corners; // of all polygons, concatenated; < #points
  std::vector<std::size_t> polygon_begin = {
      0}; // #polygons + 1: first corner of each polygon in `corners`, and the end
  std::vector<Point> normals;            // empty or #points
  std::vector<std::array<double, 2>> uv; // empty or #points
  std::vector<std::array<double, 2>>
      corner_uv;        // #corners, instead of uv; written to OBJ, never read
  std::string material; // name of a file with the material "texture"; written to OBJ, never read
  std::vector<std::array<std::uint32_t, 2>> edges;       // segments between points, only in PLY
  std::vector<std::vector<Point>> polylines;             // written, never read
  std::map<std::string, std::vector<double>> properties; // each #points
  std::map<std::string, std::vector<Point>> vectors;     // each #polygons; written, never read
  std::map<std::string, std::vector<std::uint32_t>> face_numbers; // likewise

  std::size_t number_of_polygons() const { return polygon_begin.size() - 1; }
};

// Names of the properties that store a color, as bytes (0 to 255) in most files.
constexpr std::array<const char*, 3> color_names = {"red", "green", "blue"};

// Reads a file; the extension selects the format: .ply, .off, .obj, .stl, .xyz, .pwn, .vtp or
// .gpw, and .gz after it for a file that is compressed by gzip. The data is neither repaired nor validated beyond the needs of the reader, see check().
// Memory is proportional to the size of the file, independent of the counts in its header. For
// .gpw, a progressive wavelet stream, memory is bounded by a constant. Throws Input_error that
// names the file and the reason.
Surface_file read_surface_file(const std::string& filename);

// Throws Input_error if there are no points, a coordinate is not finite, or an index of a face or
// edge is out of range.
void check(const Surface_file& surface, const std::string& name);

// Parsers of single formats. `name` is the file name in error messages.
Surface_file read_ply(std::string_view bytes, const std::string& name);
Surface_file read_off(std::string_view bytes, const std::string& name);
Surface_file read_obj(std::string_view bytes, const std::string& name);
Surface_file read_stl(std::string_view bytes, const std::string& name);
Surface_file read_xyz(std::string_view bytes, const std::string& name);
Surface_file read_pwn(std::string_view bytes, const std::string& name);
Surface_file read_vtp(std::string_view bytes, const std::string& name);
Surface_file read_gpw(std::string_view bytes, const std::string& name);

// Throws Usage_error if no writer supports the extension of the file name.
void check_output_extension(const std::string& filename);

// Writes the file completely or leaves an existing file unchanged: a temporary file is renamed.
// PLY (binary) and VTP store normals, properties, vectors, face numbers and polylines. PLY also
// stores edges, and colors as bytes. OBJ stores texture coordinates or, without them, colors; it
// also stores normals and polylines. OFF stores normals, and colors if `color_property` names a
// property. Throws Output_error if the file cannot be written.
void write_surface_file(const std::string& filename, const Surface_file& surface,
                        const std::string& color_property = "");

std::string to_ply(const Surface_file& surface);
std::string to_off(const Surface_file& surface, const std::string& color_property);
std::string to_obj(const Surface_file& surface);
std::string to_vtp(const Surface_file& surface);

// Returns the extension of a file name in lower case, without the dot.
std::string file_extension(const std::string& filename);

} // namespace program

#endif // GEODESIC_PROGRAM_IO_SURFACE_FILE_H
