// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_SURFACE_FILE_H
#define GEODESIC_PROGRAM_READERS_SURFACE_FILE_H

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

// A parser of a format. `name` is the file name in error messages. Memory is proportional to the
// number of bytes, independent of the counts in a header. Throws Input_error.
using Reader = Surface_file (*)(std::string_view bytes, const std::string& name);

Surface_file read_ply(std::string_view bytes, const std::string& name);
Surface_file read_off(std::string_view bytes, const std::string& name);
Surface_file read_obj(std::string_view bytes, const std::string& name);
Surface_file read_stl(std::string_view bytes, const std::string& name);
Surface_file read_xyz(std::string_view bytes, const std::string& name);
Surface_file read_pwn(std::string_view bytes, const std::string& name);
Surface_file read_vtp(std::string_view bytes, const std::string& name);
Surface_file read_gltf(std::string_view bytes, const std::string& name); // also GLB
Surface_file read_gifti(std::string_view bytes, const std::string& name);
Surface_file read_freesurfer(std::string_view bytes, const std::string& name);

// Return the same as the functions without number_of_threads. Large files are read by several
// threads.
Surface_file read_ply_in_parallel(std::string_view bytes, const std::string& name,
                                  unsigned number_of_threads);
Surface_file read_off_in_parallel(std::string_view bytes, const std::string& name,
                                  unsigned number_of_threads);
Surface_file read_obj_in_parallel(std::string_view bytes, const std::string& name,
                                  unsigned number_of_threads);
Surface_file read_stl_in_parallel(std::string_view bytes, const std::string& name,
                                  unsigned number_of_threads);
Surface_file read_xyz_in_parallel(std::string_view bytes, const std::string& name,
                                  unsigned number_of_threads);

// Returns whether the first bytes are those of a FreeSurfer surface.
bool is_freesurfer(std::string_view bytes);

// Reads a file. The extension selects one of the formats above or of `more_readers`, whose keys are
// extensions without the dot. If the file is compressed by gzip, .gz follows the extension. A
// FreeSurfer surface is recognized by its content, unless it is compressed. The data is neither
// repaired nor validated beyond the needs of the reader, see check(). The result does not depend on
// the number of threads. Throws Input_error.
Surface_file read_surface_file(const std::string& filename,
                               const std::map<std::string, Reader>& more_readers = {},
                               unsigned number_of_threads = 1);

// Throws Input_error if there are no points, a coordinate is not finite, or an index of a face or
// edge is out of range.
void check(const Surface_file& surface, const std::string& name);

// Returns the extension of a file name in lower case, without the dot.
std::string file_extension(const std::string& filename);

} // namespace program

#endif // GEODESIC_PROGRAM_READERS_SURFACE_FILE_H
