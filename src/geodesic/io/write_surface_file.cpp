// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_surface_file.h"

#include "io/Output_file.h"
#include "io/errors.h"

namespace program {

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
