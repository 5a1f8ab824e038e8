// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_COMMANDS_PARAMETERIZATIONS_H
#define GEODESIC_PROGRAM_COMMANDS_PARAMETERIZATIONS_H

#include "repair/Surface.h"

#include <array>
#include <string>
#include <vector>

namespace program {

// Where CGAL's parameterization of a name, lscm, authalic or arap, puts the vertices of a mesh.  Throws
// Input_error with its own sentence where it cannot.
std::vector<std::array<double, 2>> parameterization(const Surface& surface,
                                                    const std::string& method);

} // namespace program

#endif // GEODESIC_PROGRAM_COMMANDS_PARAMETERIZATIONS_H
