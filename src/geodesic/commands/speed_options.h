// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_COMMANDS_SPEED_OPTIONS_H
#define GEODESIC_PROGRAM_COMMANDS_SPEED_OPTIONS_H

#include "io/colors.h"
#include "commands/command_utilities.h"

#include <optional>

namespace program {

// How fast fronts are, and so how dense samples: what the commands that take speeds share.
struct Speed_options
{
  std::string speed; // a word, or the name of a property
  std::string image; // the name of a file
  std::optional<double> strength;

  bool is_given() const { return !speed.empty() || !image.empty(); }
};

void add_speed_options(Command& command, Speed_options& options);

// Throws Usage_error.
void check(const Speed_options& options);

// The V of a speed "curvature-like-V".
std::optional<std::size_t> similar_vertex(const Speed_options& options);

// #vertices: the colours of the vertices, or those of an image where it is seen.  Throws Input_error.
std::vector<Color> vertex_colors(const Surface& surface, const Speed_options& options);

// #vertices: the speeds that are asked for; empty where they are 1 everywhere.
template <typename Domain>
std::vector<double> compute_speeds(const Domain& domain, const Speed_options& options,
                                   const Job& job);

} // namespace program

#endif // GEODESIC_PROGRAM_COMMANDS_SPEED_OPTIONS_H
