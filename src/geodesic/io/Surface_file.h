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

// What a file of any format holds, as plain arrays.
struct Surface_file
{
  std::vector<Point> points;
  std::vector<std::uint32_t> corners; // of all polygons, one after another; < #points
  std::vector<std::size_t> polygon_begin = {
      0};                                // #polygons + 1: where each polygon begins in `corners`
  std::vector<Point> normals;            // empty or #points
  std::vector<std::array<double, 2>> uv; // empty or #points
  std::vector<std::array<double, 2>>
      corner_uv;        // written to OBJ, never read: instead of uv; #corners
  std::string material; // written to OBJ, never read: a file of one, "texture"
  std::vector<std::array<std::uint32_t, 2>> edges;       // lines between points, of PLY alone
  std::vector<std::vector<Point>> polylines;             // written, never read
  std::map<std::string, std::vector<double>> properties; // each #points
  std::map<std::string, std::vector<Point>> vectors;     // each #polygons; written, never read
  std::map<std::string, std::vector<std::uint32_t>> face_numbers; // likewise

  std::size_t number_of_polygons() const { return polygon_begin.size() - 1; }
};

// The properties that are a colour, in bytes as most files have them.
constexpr std::array<const char*, 3> color_names = {"red", "green", "blue"};

// Reads a file of the kind that its ending names: .ply, .off, .obj, .stl, .xyz, .pwn, .vtp or .gpw.
// Nothing is repaired, nor checked beyond what reading needs: see check().
// Memory stays in proportion to the size of the file, whatever its header says; of .gpw, a progressive stream of
// wavelets, below a bound.
// Throws Input_error with a sentence that names the file and the reason.
Surface_file read_surface_file(const std::string& filename);

// Throws Input_error where there are no points, a coordinate is not finite, or a face or an edge
// names a point that is not there.
void check(const Surface_file& surface, const std::string& name);

// Each parses the bytes of one format; `name` stands for the file in sentences.
Surface_file read_ply(std::string_view bytes, const std::string& name);
Surface_file read_off(std::string_view bytes, const std::string& name);
Surface_file read_obj(std::string_view bytes, const std::string& name);
Surface_file read_stl(std::string_view bytes, const std::string& name);
Surface_file read_xyz(std::string_view bytes, const std::string& name);
Surface_file read_pwn(std::string_view bytes, const std::string& name);
Surface_file read_vtp(std::string_view bytes, const std::string& name);
Surface_file read_gpw(std::string_view bytes, const std::string& name);

// Throws Usage_error when no writer belongs to the ending of a file name.
void check_output_extension(const std::string& filename);

// Writes the file completely or not at all: first beside it, then renamed.
// PLY (binary) and VTP carry normals, properties, vectors, numbers of faces and polylines, PLY edges too and colours as bytes; OBJ carries texture coordinates
// or else colours, normals and polylines; OFF carries normals, and colours where `color_property` names a property.
// Throws Output_error when it cannot be written.
void write_surface_file(const std::string& filename, const Surface_file& surface,
                        const std::string& color_property = "");

std::string to_ply(const Surface_file& surface);
std::string to_off(const Surface_file& surface, const std::string& color_property);
std::string to_obj(const Surface_file& surface);
std::string to_vtp(const Surface_file& surface);

// The ending of a file name in lower case, without its dot.
std::string file_extension(const std::string& filename);

} // namespace program

#endif // GEODESIC_PROGRAM_IO_SURFACE_FILE_H
