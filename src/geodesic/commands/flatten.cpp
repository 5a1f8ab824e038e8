// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "io/write_surface_file.h"
#include "picture/Picture.h"
#include "app/commands.h"
#include "picture/procedural_images.h"
#include "io/errors.h"
#include "commands/parameterizations.h"
#include "commands/command_utilities.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace program {

namespace {

using UV = std::array<double, 2>;

struct Flatten_options
{
  std::string method = "glle";
  std::optional<std::size_t> base_points, neighbors;
  std::string start = "best";
  std::size_t rigid_steps = 30;
  bool is_injective = false, draws_plane = false;
};

// Computes the UV coordinates and their distortion.
template <typename Domain>
void flatten_surface(const Domain& domain, const Flatten_options& options, Job& job,
                     std::vector<UV>& uv)
{
  using Surface_type = typename Domain::Surface;
  const Value_map<typename Domain::Vertex, UV> map = {&uv};
  job.begin_stage("query");
  if(options.method == "glle" || options.method == "mds")
  {
    const auto np = GP::parameters::random_seed(job.seed())
                        .callback(job.progress_callback("flattening"))
                        .flattening_start(options.start == "lle"   ? GP::Flattening_start::lle
                                          : options.start == "mds" ? GP::Flattening_start::mds
                                                                   : GP::Flattening_start::best)
                        .number_of_rigid_steps(options.rigid_steps);
    const auto flatten = [&](const auto& parameters)
    {
      const auto base =
          options.method == "mds" ? GP::geodesic_mds(domain, map, parameters)
          : options.neighbors
              ? GP::geodesic_lle(domain, map, parameters.number_of_neighbors(*options.neighbors))
              : GP::geodesic_lle(domain, map, parameters);
      job.result()["base_points"] = base.size();
    };
    if(options.base_points)
      flatten(np.number_of_base_points(*options.base_points));
    else
      flatten(np);
  }
  else
    uv = parameterization(job.surface(), options.method);
  if constexpr(is_mesh<Surface_type>)
  {
    if(options.is_injective)
    {
      const GP::Distortion_minimum found = GP::minimize_distortion(
          domain, map, GP::parameters::callback(job.progress_callback("distortion")));
      job.result()["flips_before"] = found.number_of_flips_before;
      job.result()["steps"] = found.number_of_iterations;
      job.print_line("flips before    " + std::to_string(found.number_of_flips_before));
    }
  }
  const GP::Flattening_distortion found = GP::flattening_distortion(domain, map);
  job.report("flips", found.number_of_flips);
  job.report("conformal", found.conformal);
  job.report("authalic", found.authalic);
  job.report("symmetric_dirichlet", found.symmetric_dirichlet);
  job.report("l2_stretch", found.l2_stretch);
  job.report("linf_stretch", found.linf_stretch);
}

void check(const Flatten_options& options)
{
  if(options.start != "best" && options.start != "lle" && options.start != "mds")
    throw Usage_error("--start: '" + options.start + "' is not a start; use best, lle or mds.");
  if(options.method != "glle" && options.method != "mds" && options.method != "lscm" &&
     options.method != "authalic" && options.method != "arap")
    throw Usage_error("--method " + options.method +
                      ": the methods are glle, mds, lscm, authalic and arap.");
}

// Translates and scales the UV coordinates: their smallest enclosing square becomes the unit
// square. Vertices without coordinates become (0, 0).
std::vector<UV> scale_to_unit_square(const std::vector<UV>& uv)
{
  UV low = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  double size = 0.;
  for(const auto& p : uv)
    if(std::isfinite(p[0]))
      for(int k = 0; k < 2; ++k)
        low[k] = std::min(low[k], p[k]);
  for(const auto& p : uv)
    if(std::isfinite(p[0]))
      size = std::max({size, p[0] - low[0], p[1] - low[1]});
  std::vector<UV> result;
  for(const auto& p : uv)
    result.push_back(std::isfinite(p[0]) && size > 0.
                         ? UV{(p[0] - low[0]) / size, (p[1] - low[1]) / size}
                         : UV{0., 0.});
  return result;
}

// Draws a surface (the input or the flattened surface) with a checkerboard in UV space.
void draw_map(const Job& job, const Surface_file& surface, const std::vector<UV>& unit_uv)
{
  Surface_file file = surface;
  const Image image = checkerboard();
  Picture picture{&file};
  if(file.corners.empty())
    for(const UV& p : unit_uv)
      picture.labels.push_back(checkerboard_cell(p));
  else
  {
    for(const std::uint32_t corner : file.corners)
      file.corner_uv.push_back(unit_uv[corner]);
    picture.texture = &image;
  }
  draw(job.picture(), picture);
}

void run_flatten(Job& job, const Flatten_options& options)
{
  check(options);
  const Surface& surface = job.read();
  const bool is_own_method = options.method == "glle" || options.method == "mds";
  if(!surface.is_mesh() && (options.is_injective || !is_own_method))
    throw Input_error(
        surface.name + ": " +
        (options.is_injective ? "--injective needs" : "--method " + options.method + " needs") +
        " a mesh.");
  job.begin_stage("prepare");
  std::vector<UV> uv(surface.file.points.size());
  visit_domain(job, [&](const auto& domain) { flatten_surface(domain, options, job, uv); });

  job.begin_stage("write");
  job.write_values(
      [&]
      {
        std::string text;
        for(const auto& [u, v] : uv)
          text += number_text(u) + ' ' + number_text(v) + '\n';
        return text;
      });
  const std::vector<UV> unit_uv = scale_to_unit_square(uv);
  Surface_file file = surface.file;
  if(options.draws_plane)
    for(std::size_t i = 0; i < uv.size(); ++i)
    {
      file.points[i] = std::isfinite(uv[i][0]) ? Point{uv[i][0], uv[i][1], 0.} : Point{0., 0., 0.};
      if(!file.normals.empty())
        file.normals[i] = {0., 0., 1.};
    }
  if(!job.picture().empty())
    draw_map(job, file, unit_uv);
  if(!job.output().empty())
  {
    file.uv = unit_uv;
    for(const auto& [u, v] : uv)
    {
      file.properties["u"].push_back(u);
      file.properties["v"].push_back(v);
    }
    write_surface_file(job.output(), file);
  }
  job.finish();
}

} // namespace

void add_flatten(CLI::App& program)
{
  Command command(program, "flatten", "flatten a surface patch into the plane");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Flatten_options>();
  command
      .add("--method", options->method, "NAME",
           "glle (geodesic distances between neighbors) or mds (geodesic distances between "
           "all pairs); for meshes also lscm, authalic or arap of CGAL")
      .shows_default();
  command.add("--base-points", options->base_points, "N",
              "number of base points of glle and mds (default 200; more for glle if the patch "
              "is narrow)");
  command.add("--neighbors", options->neighbors, "K",
              "number of neighbors of each base point of glle (default 10; more if base points "
              "would form disconnected groups)");
  command
      .add("--start", options->start, "NAME",
           "initial embedding of the base points of glle: lle (locally linear), mds (classical "
           "scaling), or best of both")
      .shows_default();
  command
      .add("--rigid-steps", options->rigid_steps, "N",
           "number of steps that make the neighborhoods of base points of glle rigid; 0: initial "
           "embedding")
      .shows_default();
  command.add_flag("--injective", options->is_injective,
                   "remove inverted faces, then minimize the distortion");
  command.add_flag("--flat", options->draws_plane,
                   "write and draw the flattened surface instead of the input");
  command.set_callback([job, options] { run_flatten(*job, *options); });
}

} // namespace program
