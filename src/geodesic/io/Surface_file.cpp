// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Surface_file.h"

#include "io/Output_file.h"
#include "io/Scanner.h"
#include "io/decompress.h"
#include "io/errors.h"
#include "io/read_bytes.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace program {

std::string read_bytes(const std::string& filename)
{
  std::error_code error;
  const auto status = std::filesystem::status(filename, error);
  if(!std::filesystem::exists(status))
    fail(filename, "there is no such file");
  if(!std::filesystem::is_regular_file(status))
    fail(filename, "it is not a regular file");
  const auto size = std::filesystem::file_size(filename, error);
  std::ifstream file(filename, std::ios::binary);
  if(error || !file)
    fail(filename, "it cannot be opened for reading");
  std::string bytes(size, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  if(file.bad())
    fail(filename, "it cannot be read");
  return bytes;
}

std::string file_extension(const std::string& filename)
{
  std::string result = std::filesystem::path(filename).extension().string();
  if(!result.empty())
    result.erase(0, 1);
  for(char& c : result)
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

Surface_file read_surface_file(const std::string& filename)
{
  using Reader = Surface_file (*)(std::string_view, const std::string&);
  static const std::map<std::string, Reader> readers = {
      {"ply", read_ply}, {"off", read_off}, {"obj", read_obj}, {"stl", read_stl},
      {"xyz", read_xyz}, {"pwn", read_pwn}, {"vtp", read_vtp}, {"gpw", read_gpw}};
  std::string bytes = read_bytes(filename);
  const bool is_compressed = file_extension(filename) == "gz";
  const std::string extension =
      file_extension(is_compressed ? std::filesystem::path(filename).stem().string() : filename);
  const auto reader = readers.find(extension);
  if(reader == readers.end())
    fail(filename,
         "the extension must be .ply, .off, .obj, .stl, .xyz, .pwn, .vtp or .gpw, and .gz "
         "after it if the file is compressed");
  if(bytes.empty())
    fail(filename, "it is empty");
  if(is_compressed)
    bytes = inflate(bytes, filename);
  return reader->second(bytes, filename);
}

void check(const Surface_file& surface, const std::string& name)
{
  if(surface.points.empty())
    fail(name, "it has no points");
  if(surface.points.size() >= (std::size_t{1} << 31))
    fail(name, "it has more than 2^31 points");
  for(std::size_t i = 0; i < surface.points.size(); ++i)
    for(const double x : surface.points[i])
      if(!std::isfinite(x))
        fail(name, "a coordinate of point " + std::to_string(i) + " is not finite");
  for(const std::uint32_t corner : surface.corners)
    if(corner >= surface.points.size())
      fail(name, "a face refers to vertex " + std::to_string(corner) +
                     ", but the number of vertices is " + std::to_string(surface.points.size()));
  for(const auto& edge : surface.edges)
    for(const std::uint32_t end : edge)
      if(end >= surface.points.size())
        fail(name, "an edge refers to vertex " + std::to_string(end) +
                       ", but the number of vertices is " + std::to_string(surface.points.size()));
}

void check_output_extension(const std::string& filename)
{
  const std::string extension = file_extension(filename);
  if(extension != "ply" && extension != "off" && extension != "obj" && extension != "vtp")
    throw Usage_error("-o " + filename +
                      ": the extension of the output file must be .ply, .off, .obj or .vtp.");
}

void write_surface_file(const std::string& filename, const Surface_file& surface,
                        const std::string& color_property)
{
  check_output_extension(filename);
  const std::string extension = file_extension(filename);
  write_file(filename, extension == "ply"   ? to_ply(surface)
                       : extension == "off" ? to_off(surface, color_property)
                       : extension == "obj" ? to_obj(surface)
                                            : to_vtp(surface));
}

} // namespace program
