// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_IO_WRITE_TEXTURED_H
#define GEODESIC_PROGRAM_IO_WRITE_TEXTURED_H

#include "io/Image.h"
#include "io/Surface_file.h"

#include <string>

namespace program {

// Writes triangles with their corner_uv and an image on them: NAME.obj with NAME.mtl and NAME_texture.png beside
// it, or all in one file, as NAME.gltf or as NAME.glb.  Each file completely or not at all.
// Throws Output_error, and Usage_error where images cannot be written.
void write_textured(const std::string& filename, const Surface_file& surface, const Image& texture);

// glTF 2.0 with a buffer, and in it the bytes of a PNG file: as text, and as bytes.  Single precision.
// Throws Output_error where a coordinate is beyond that; `filename` stands for the file in the sentence.
std::string to_gltf(const std::string& filename, const Surface_file& surface,
                    const std::string& png);
std::string to_glb(const std::string& filename, const Surface_file& surface,
                   const std::string& png);

} // namespace program

#endif // GEODESIC_PROGRAM_IO_WRITE_TEXTURED_H
