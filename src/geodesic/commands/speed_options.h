// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_COMMANDS_SPEED_OPTIONS_H
#define GEODESIC_PROGRAM_COMMANDS_SPEED_OPTIONS_H

#include "io/colors.h"
#include "commands/command_utilities.h"

#include <optional>

namespace program {

// Options of all commands that use speeds, which also determine the sampling density.
struct Speed_options
{
  std::string speed; // the name of a predefined speed or of a property
  std::string image; // the file name
  std::optional<double> strength;

  bool is_given() const { return !speed.empty() || !image.empty(); }
};

void add_speed_options(Command& command, Speed_options& options);

// Throws Usage_error if the options are inconsistent.
void check(const Speed_options& options);

// Throws Usage_error if there is a speed that the method of distances does not support.
void check(const Speed_options& options, const std::string& method);

// Returns V if the speed is "curvature-like-V".
std::optional<std::size_t> similar_vertex(const Speed_options& options);

// Returns the colors of the vertices: those of the file, or the image sampled at each vertex.
// Throws Input_error. Size: #vertices.
std::vector<Color> vertex_colors(const Surface& surface, const Speed_options& options);

// Returns the speed of each vertex, or an empty array if the speed is 1 everywhere.
template <typename Domain>
std::vector<double> compute_speeds(const Domain& domain, const Speed_options& options,
                                   const Job& job);

} // namespace program

#endif // GEODESIC_PROGRAM_COMMANDS_SPEED_OPTIONS_H
