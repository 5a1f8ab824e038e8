// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_INPUT_ERROR_H
#define GEODESIC_PROGRAM_READERS_INPUT_ERROR_H

#include <stdexcept>

namespace program {

// Thrown if a file cannot be read. Contains one sentence that names the file and the reason.
struct Input_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

} // namespace program

#endif // GEODESIC_PROGRAM_READERS_INPUT_ERROR_H
