// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_IO_WRITE_SURFACE_FILE_H
#define GEODESIC_PROGRAM_IO_WRITE_SURFACE_FILE_H

#include "readers/Surface_file.h"

namespace program {

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

} // namespace program

#endif // GEODESIC_PROGRAM_IO_WRITE_SURFACE_FILE_H
