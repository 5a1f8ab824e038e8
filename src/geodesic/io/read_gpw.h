// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_IO_READ_GPW_H
#define GEODESIC_PROGRAM_IO_READ_GPW_H

#include "readers/Surface_file.h"

namespace program {

// Reads a progressive wavelet stream. Memory is bounded by a constant. Throws Input_error.
Surface_file read_gpw(std::string_view bytes, const std::string& name);

} // namespace program

#endif // GEODESIC_PROGRAM_IO_READ_GPW_H
