// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_textured.h"

#include "io/Output_file.h"
#include "io/errors.h"
#include "io/write_surface_file.h"

#include <filesystem>

namespace program {

namespace {

void write_textured_obj(const std::string& filename, const Surface_file& surface,
                        const Image& texture)
{
  // Returns a path in the same directory. NAME.png is avoided, because it may be the --picture
  // file.
  const auto sibling = [&](const char* end)
  { return std::filesystem::path(filename).replace_extension().string() + end; };
  const auto name = [](const std::string& path)
  { return std::filesystem::path(path).filename().string(); };
  const std::string image = sibling("_texture.png"), material = sibling(".mtl");
  write_image(image, texture);
  write_file(material,
             "newmtl texture\nKa 1 1 1\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd " + name(image) + "\n");
  Surface_file file = surface;
  file.material = name(material);
  write_surface_file(filename, file);
}

} // namespace

void write_textured(const std::string& filename, const Surface_file& surface, const Image& texture)
{
  const std::string extension = file_extension(filename);
  if(extension == "obj")
    write_textured_obj(filename, surface, texture);
  else if(extension == "gltf")
    write_file(filename, to_gltf(filename, surface, to_png(filename, texture)));
  else
    write_file(filename, to_glb(filename, surface, to_png(filename, texture)));
}

} // namespace program
