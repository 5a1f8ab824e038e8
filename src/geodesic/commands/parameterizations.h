// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_COMMANDS_PARAMETERIZATIONS_H
#define GEODESIC_PROGRAM_COMMANDS_PARAMETERIZATIONS_H

#include "repair/Surface.h"

#include <array>
#include <string>
#include <vector>

namespace program {

// Computes the UV coordinates of the vertices by CGAL's parameterization lscm, authalic or arap. Only
// the component with the longest boundary cycle gets coordinates; those of other vertices are NaN.
// Throws Input_error if a vertex has several fans of faces, if there is no boundary, or, with
// CGAL's message, if the parameterization fails.
std::vector<std::array<double, 2>> parameterization(const Surface& surface,
                                                    const std::string& method);

} // namespace program

#endif // GEODESIC_PROGRAM_COMMANDS_PARAMETERIZATIONS_H
