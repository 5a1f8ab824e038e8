// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz_reader.h"

#include "repair/Surface.h"
#include "io/errors.h"

#include <cmath>
#include <cstdlib>

int fuzz_reader(program::Reader read, const std::uint8_t* data, std::size_t size)
{
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  program::Surface surface;
  try
  {
    // Files that the input refers to do not exist in this folder.
    surface = program::repair(read(bytes, "no folder/input"), "input");
  }
  catch(const program::Input_error&)
  {
    return 0;
  }
  const auto must = [](bool holds)
  {
    if(!holds)
      std::abort();
  };
  const program::Surface_file& file = surface.file;
  must(!file.points.empty());
  for(const program::Point& p : file.points)
    must(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]));
  for(const auto& property : file.properties)
    must(property.second.size() == file.points.size());
  must(file.normals.empty() || file.normals.size() == file.points.size());
  if(!surface.is_mesh())
  {
    must(file.normals.size() == file.points.size());
    for(const program::Point& n : file.normals)
      must(std::abs(std::hypot(n[0], n[1], n[2]) - 1.) < 1e-12); // round-off error of a division
    return 0;
  }
  must(file.corners.size() == 3 * file.number_of_polygons());
  for(const std::uint32_t corner : file.corners)
    must(corner < file.points.size());
  const program::Mesh& mesh = surface.domain->mesh();
  must(mesh.number_of_faces() == file.number_of_polygons());
  for(const auto h : mesh.halfedges())
    must(mesh.prev(mesh.next(h)) == h && mesh.source(mesh.next(h)) == mesh.target(h) &&
         mesh.source(h) != mesh.target(h));
  return 0;
}
