// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_APP_RUN_H
#define GEODESIC_PROGRAM_APP_RUN_H

namespace program {

// Runs the program on a command line and returns its exit code.
int run(int argc, char** argv);

} // namespace program

#endif // GEODESIC_PROGRAM_APP_RUN_H
