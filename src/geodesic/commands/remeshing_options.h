// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_REMESHING_OPTIONS_H
#define GEODESIC_PROGRAM_REMESHING_OPTIONS_H

#include "commands/queries.h"

#include <cstddef>
#include <string>

namespace program {

// What the commands that make a mesh of samples share.
struct Remeshing_options
{
  std::size_t number = 0;
  std::size_t lloyd = 0;
  double sharp_angle = 180.;
};

// vertices, edges: what these are called in sentences.
inline void add_remeshing_options(Command& command, Remeshing_options& options,
                                  const std::string& vertices, const std::string& edges)
{
  command.add("--number", options.number, "N", "of " + vertices + "; more come where it takes them")
      .required();
  command.add("--lloyd", options.lloyd, "K",
              "how often " + vertices + " move to the middle of their cells");
  command
      .add("--keep-sharp", options.sharp_angle, "ANGLE",
           edges + " at which the surface bends by so many degrees or more")
      .between(0., 180.);
}

inline auto remeshing_parameters(const Remeshing_options& options, Job& job)
{
  return GP::parameters::random_seed(job.seed())
      .number_of_relaxation_steps(options.lloyd)
      .sharp_angle(options.sharp_angle)
      .callback(job.progress("vertices"));
}

} // namespace program

#endif // GEODESIC_PROGRAM_REMESHING_OPTIONS_H
