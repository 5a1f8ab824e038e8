// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_APP_RUN_H
#define GEODESIC_PROGRAM_APP_RUN_H

namespace program {

// The whole program: its exit code for a command line.
int run(int argc, char** argv);

} // namespace program

#endif // GEODESIC_PROGRAM_APP_RUN_H
