// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_COMMANDS_REMESHING_OPTIONS_H
#define GEODESIC_PROGRAM_COMMANDS_REMESHING_OPTIONS_H

#include "commands/command_utilities.h"

#include <cstddef>
#include <string>

namespace program {

// Options of all commands that create a mesh from samples.
struct Remeshing_options
{
  std::size_t number = 0;
  std::size_t relaxation_steps = 0;
  double sharp_angle = 180.;
};

// Adds the options to a command. The help texts use vertex_term and edge_term for vertices and
// edges.
inline void add_remeshing_options(Command& command, Remeshing_options& options,
                                  const std::string& vertex_term, const std::string& edge_term)
{
  command
      .add("--number", options.number, "N",
           "number of " + vertex_term + "; more are added if the topology requires it")
      .required();
  command.add("--lloyd", options.relaxation_steps, "K",
              "number of relaxation steps, which move " + vertex_term +
                  " to the centroids of their cells");
  command
      .add("--keep-sharp", options.sharp_angle, "ANGLE",
           edge_term + " whose dihedral angle deviates from flat by at least so many degrees")
      .in_range(0., 180.);
}

inline auto remeshing_parameters(const Remeshing_options& options, Job& job)
{
  return GP::parameters::random_seed(job.seed())
      .number_of_relaxation_steps(options.relaxation_steps)
      .sharp_angle(options.sharp_angle)
      .callback(job.progress_callback("vertices"));
}

} // namespace program

#endif // GEODESIC_PROGRAM_COMMANDS_REMESHING_OPTIONS_H
