// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_IO_ERRORS_H
#define GEODESIC_PROGRAM_IO_ERRORS_H

#include "readers/Input_error.h"

#include <stdexcept>

namespace program {

// Exit codes of the program. Each exception contains one sentence for standard error.
enum Exit_code
{
  success = 0,
  wrong_usage = 1,
  bad_input = 2,
  not_written = 3
};

struct Usage_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

struct Output_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

} // namespace program

#endif // GEODESIC_PROGRAM_IO_ERRORS_H
