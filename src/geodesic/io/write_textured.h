// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_IO_WRITE_TEXTURED_H
#define GEODESIC_PROGRAM_IO_WRITE_TEXTURED_H

#include "io/Image.h"
#include "readers/Surface_file.h"

#include <string>

namespace program {

// Writes triangles with their corner_uv and a texture. NAME.obj is written with NAME.mtl and
// NAME_texture.png in the same directory. NAME.gltf and NAME.glb contain everything in one file.
// Each file is written completely or not at all. Throws Output_error, and Usage_error without PNG
// support.
void write_textured(const std::string& filename, const Surface_file& surface, const Image& texture);

// Returns glTF 2.0 as text or as binary (GLB), in single precision. The buffer contains the PNG
// file. Throws Output_error if a coordinate exceeds the range of float; `filename` is used in the
// message.
std::string to_gltf(const std::string& filename, const Surface_file& surface,
                    const std::string& png);
std::string to_glb(const std::string& filename, const Surface_file& surface,
                   const std::string& png);

} // namespace program

#endif // GEODESIC_PROGRAM_IO_WRITE_TEXTURED_H
