// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_DENSITIES_H
#define GEODESIC_PROGRAM_DENSITIES_H

#include "io/colours.h"
#include "commands/queries.h"

#include <optional>

namespace program {

// How fast fronts are, and so how dense samples: what the commands that take speeds share.
struct Density_options
{
  std::string speed; // a word, or the name of a property
  std::string image; // the name of a file
  std::optional<double> strength;

  bool are_given() const { return !speed.empty() || !image.empty(); }
};

void add_density_options(Command& command, Density_options& options);

// Throws Usage_error.
void check(const Density_options& options);

// The V of a speed "curvature-like-V".
std::optional<std::size_t> similar_vertex(const Density_options& options);

// #vertices: the colours of the vertices, or those of an image where it is seen.  Throws Input_error.
std::vector<Colour> colours_on(const Surface& surface, const Density_options& options);

// #vertices: the speeds that are asked for; empty where they are 1 everywhere.
template <typename Domain>
std::vector<double> speeds(const Domain& domain, const Density_options& options, const Job& job)
{
  if(!options.are_given())
    return {};
  using Site = typename Domain::Site;
  std::vector<double> result(domain.number_of_sites());
  const Value_map<Site> map{&result};
  const auto make = [&](const auto& np)
  {
    if(options.speed == "curvature-attractive")
      GP::curvature_speeds<GP::Edge_attractive, CGAL::Parallel_tag>(domain, map, np);
    else if(options.speed == "curvature-repulsive")
      GP::curvature_speeds<GP::Edge_repulsive, CGAL::Parallel_tag>(domain, map, np);
    else if(const auto vertex = similar_vertex(options))
    {
      check_vertex(job.surface(), *vertex);
      GP::similar_curvature_speeds<CGAL::Parallel_tag>(domain, Site(*vertex), map, np);
    }
    else if(options.speed == "colours" || !options.image.empty())
    {
      const std::vector<Colour> colours = colours_on(job.surface(), options);
      GP::image_speeds(domain, Property_map<Site, Colour>{&colours}, map, np);
    }
    else
      result = property(job.surface(), options.speed);
  };
  const auto np = GP::parameters::threads(job.threads());
  if(options.strength)
    make(np.strength(*options.strength));
  else
    make(np);
  return result;
}

} // namespace program

#endif // GEODESIC_PROGRAM_DENSITIES_H
