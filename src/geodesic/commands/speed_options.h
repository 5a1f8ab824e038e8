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
                                   const Job& job)
{
  if(!options.is_given())
    return {};
  using Vertex = typename Domain::Vertex;
  std::vector<double> result(domain.number_of_vertices());
  const Value_map<Vertex> map{&result};
  const auto compute = [&](const auto& np)
  {
    if(options.speed == "curvature-attractive")
      GP::curvature_speeds<GP::Edge_attractive, CGAL::Parallel_tag>(domain, map, np);
    else if(options.speed == "curvature-repulsive")
      GP::curvature_speeds<GP::Edge_repulsive, CGAL::Parallel_tag>(domain, map, np);
    else if(const auto vertex = similar_vertex(options))
    {
      check_vertex(job.surface(), *vertex);
      GP::similar_curvature_speeds<CGAL::Parallel_tag>(domain, Vertex(*vertex), map, np);
    }
    else if(options.speed == "colours" || !options.image.empty())
    {
      const std::vector<Color> colors = vertex_colors(job.surface(), options);
      GP::image_speeds(domain, Property_map<Vertex, Color>{&colors}, map, np);
    }
    else
      result = property(job.surface(), options.speed);
  };
  const auto np = GP::parameters::threads(job.threads());
  if(options.strength)
    compute(np.strength(*options.strength));
  else
    compute(np);
  return result;
}

} // namespace program

#endif // GEODESIC_PROGRAM_COMMANDS_SPEED_OPTIONS_H
