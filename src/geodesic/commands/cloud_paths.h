// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_COMMANDS_CLOUD_PATHS_H
#define GEODESIC_PROGRAM_COMMANDS_CLOUD_PATHS_H

#include "commands/command_utilities.h"

namespace program {

using Path_finder = GP::Surfel_path_finder<Cloud>;

// Options that connect surfels to a graph and remove noise.
struct Surfel_options
{
  GP::Surfel_graph graph = GP::Surfel_graph::extended_spheres;
  GP::Surfel_noise noise = GP::Surfel_noise::removed_when_found;
};

void add_surfel_options(Command& command, Surfel_options& options);

// Options of paths on a cloud: the surface approximation and the number of control points.
struct Cloud_path_options
{
  Surfel_options surfels;
  GP::Surfel_path_method method = GP::Surfel_path_method::projected_quadrics;
  std::size_t control_points = 75;
};

void add_cloud_path_options(Command& command, Cloud_path_options& options);

// Creates a path finder. Uses the property "radius" of the file as surfel radii if it exists.
Path_finder make_path_finder(const Cloud& cloud, const Cloud_path_options& options, const Job& job);

// Returns the points and normals of the surfels after noise removal by the path finder.
Surface_file denoised_surfels(const Cloud& cloud, const Path_finder& finder);

} // namespace program

#endif // GEODESIC_PROGRAM_COMMANDS_CLOUD_PATHS_H
