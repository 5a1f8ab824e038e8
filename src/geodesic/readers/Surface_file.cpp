// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Surface_file.h"

#include "readers/Scanner.h"
#include "readers/decompress.h"
#include "readers/read_bytes.h"

#include <cmath>
#include <filesystem>

namespace program {

std::string file_extension(const std::string& filename)
{
  std::string result = std::filesystem::path(filename).extension().string();
  if(!result.empty())
    result.erase(0, 1);
  for(char& c : result)
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return result;
}

Surface_file read_surface_file(const std::string& filename,
                               const std::map<std::string, Reader>& more_readers,
                               unsigned number_of_threads)
{
  std::map<std::string, Reader> readers = {
      {"ply", read_ply},  {"off", read_off},  {"obj", read_obj}, {"stl", read_stl},
      {"xyz", read_xyz},  {"pwn", read_pwn},  {"vtp", read_vtp}, {"gltf", read_gltf},
      {"glb", read_gltf}, {"gii", read_gifti}};
  readers.insert(more_readers.begin(), more_readers.end());
  const Bytes file = read_bytes(filename, number_of_threads);
  const std::string_view bytes = file;
  const bool is_compressed = file_extension(filename) == "gz";
  const std::string extension =
      file_extension(is_compressed ? std::filesystem::path(filename).stem().string() : filename);
  const auto reader = readers.find(extension);
  if(reader == readers.end() && is_freesurfer(bytes))
    return read_freesurfer(bytes, filename);
  if(reader == readers.end())
  {
    std::string extensions;
    for(const auto& [known, read] : readers)
      extensions += " ." + known;
    fail(filename, "the extension must be one of" + extensions +
                       ", and .gz after it if the file is compressed");
  }
  if(bytes.empty())
    fail(filename, "it is empty");
  if(is_compressed)
    return reader->second(inflate(bytes, filename), filename);
  if(extension == "ply")
    return read_ply_in_parallel(bytes, filename, number_of_threads);
  if(extension == "off")
    return read_off_in_parallel(bytes, filename, number_of_threads);
  if(extension == "obj")
    return read_obj_in_parallel(bytes, filename, number_of_threads);
  if(extension == "stl")
    return read_stl_in_parallel(bytes, filename, number_of_threads);
  if(extension == "xyz")
    return read_xyz_in_parallel(bytes, filename, number_of_threads);
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

} // namespace program
