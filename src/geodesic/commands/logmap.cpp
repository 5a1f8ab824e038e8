// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "io/write_surface_file.h"
#include "picture/Picture.h"
#include "readers/Scanner.h"
#include "app/commands.h"
#include "picture/procedural_images.h"
#include "commands/command_utilities.h"
#include "io/errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace program {

namespace {

struct Logmap_options
{
  std::string base, base_at, up;
  double radius = std::numeric_limits<double>::infinity();
  std::string method = "gradient";
  std::string distances = "euclidean";
  std::size_t smoothing_steps = 0, base_refinements = 0; // of gradient
};

struct Logmap_result
{
  std::vector<std::array<double, 2>> uv; // #vertices, NaN outside of the map
  Point base, normal;
  std::size_t reached = 0, cut = 0, flips = 0;
  std::vector<std::size_t> cut_faces; // of a mesh
};

template <typename Domain>
Logmap_result compute_map(const Domain& domain, const Log_kind& kind, const Logmap_options& options,
                          Job& job)
{
  using Surface_type = typename Domain::Surface;
  GP::Logarithmic_map<Surface_type, Runtime_method> map(domain, kind);
  job.begin_stage("query");
  const auto limits = GP::parameters::maximum_distance(options.radius)
                          .number_of_smoothing_steps(options.smoothing_steps)
                          .number_of_base_refinements(options.base_refinements);
  const auto compute = [&](const auto& base)
  {
    if(options.up.empty())
      return map.compute(base, limits);
    const Point up = parse_point(options.up, "--up");
    map.compute(base, limits.up_direction(Kernel::Vector_3(up[0], up[1], up[2])));
  };
  if(options.base_at.empty())
    compute(vertex_at<Surface_type>(parse_indices(options.base, "--base").front()));
  else
    compute(locate(domain, options.base_at, "--base-at"));
  Logmap_result result;
  for(std::size_t i = 0; i < job.surface().file.points.size(); ++i)
    result.uv.push_back(map(vertex_at<Surface_type>(i)));
  const auto frame = map.frame();
  result.base = coordinates(frame.origin);
  result.normal = coordinates(frame.normal());
  result.reached = map.reached().size();
  result.cut = map.number_of_cut_faces();
  if constexpr(is_mesh<Surface_type>)
    map.for_each_cut_face([&](Mesh::Face_index face) { result.cut_faces.push_back(face); });
  result.flips = map.number_of_flips();
  return result;
}

// Computes the logarithmic map.
template <typename Domain>
Logmap_result find_map(const Domain& domain, const Logmap_options& options, Job& job)
{
  const Log_method method = options.method == "exact" ? Log_method::exact
                            : options.method == "discrete-exponential"
                                ? Log_method::discrete_exponential
                                : Log_method::gradient;
  return compute_map(domain, {method, to_method(options.distances)}, options, job);
}

void check(const Logmap_options& options)
{
  if(options.base.empty() == options.base_at.empty())
    throw Usage_error("logmap: either --base or --base-at is required, but not both.");
  if(!options.base.empty() && parse_indices(options.base, "--base").size() != 1)
    throw Usage_error("--base: exactly one vertex is required.");
  if(!options.base_at.empty())
    parse_point(options.base_at, "--base-at");
  if(!options.up.empty())
    parse_point(options.up, "--up");
  if(!(options.radius >= 0.))
    throw Usage_error("--radius: the radius must not be negative.");
  if(options.method != "gradient" && options.method != "exact" &&
     options.method != "discrete-exponential")
    throw Usage_error("--method " + printable(options.method) +
                      ": the methods are gradient, exact and discrete-exponential.");
  check_method(options.distances, "--distances");
  if(options.smoothing_steps > 0 && options.method != "gradient")
    throw Usage_error("--smoothing-steps requires --method gradient.");
  if(options.base_refinements > 0 && options.method != "gradient")
    throw Usage_error("--base-refinements requires --method gradient.");
}

double largest_radius(const std::vector<std::array<double, 2>>& uv)
{
  double result = 0.;
  for(const auto& [u, v] : uv)
    if(std::isfinite(u))
      result = std::max(result, std::hypot(u, v));
  return result;
}

// Maps UV coordinates to the image of a polar grid, whose disk touches the sides of the unit
// square. Vertices outside of the map are sent to (0, 0), which is transparent.
std::array<double, 2> to_picture_uv(const std::array<double, 2>& uv, double size)
{
  if(!std::isfinite(uv[0]) || !(size > 0.))
    return {0., 0.};
  return {0.5 + 0.5 * uv[0] / size, 0.5 + 0.5 * uv[1] / size};
}

// Draws circles and rays around the base point. On a mesh, only faces that are inside of the map
// and not cut are textured.
void draw_map(const Job& job, const Logmap_result& result)
{
  Surface_file file = job.surface().file;
  const double size = largest_radius(result.uv);
  Picture picture{&file};
  picture.markers = {result.base};
  picture.normals = {result.normal};
  Image grid = polar_grid();
  if(file.corners.empty())
    for(const auto& [u, v] : result.uv)
      picture.labels.push_back(polar_grid_cell(u / size, v / size, 10));
  else
  {
    for(std::size_t i = 0; i < grid.pixels.size(); ++i)
      for(std::size_t c = 0; c < 3; ++c)
        grid.pixels[i][c] =
            grid.opacity[i] * grid.pixels[i][c] + (1. - grid.opacity[i]) * default_color[c];
    for(const std::uint32_t corner : file.corners)
      file.corner_uv.push_back(to_picture_uv(result.uv[corner], size));
    const auto hide_face = [&](std::size_t face)
    {
      std::fill_n(file.corner_uv.begin() + 3 * static_cast<std::ptrdiff_t>(face), 3,
                  std::array<double, 2>{0., 0.});
    };
    for(std::size_t i = 0; i < file.corners.size(); ++i)
      if(!std::isfinite(result.uv[file.corners[i]][0]))
        hide_face(i / 3);
    std::for_each(result.cut_faces.begin(), result.cut_faces.end(), hide_face);
    picture.texture = &grid;
  }
  draw(job.picture(), picture);
}

void run_logmap(Job& job, const Logmap_options& options)
{
  check(options);
  const Surface& surface = job.read();
  check_method(options.method == "exact" ? options.method : options.distances, surface);
  if(!options.base.empty())
    check_vertex(surface, parse_indices(options.base, "--base").front());

  job.begin_stage("prepare");
  Logmap_result result;
  visit_domain(job, [&](const auto& domain) { result = find_map(domain, options, job); });
  job.result()["values"] = result.reached;
  job.result()["cut"] = result.cut;
  job.result()["flips"] = result.flips;
  job.print_line("reached         " + std::to_string(result.reached) + " vertices");
  job.print_line("cut             " + std::to_string(result.cut) + " faces");
  job.print_line("flips           " + std::to_string(result.flips));

  job.begin_stage("write");
  job.write_values(
      [&]
      {
        std::string text;
        for(const auto& [u, v] : result.uv)
          text += number_text(u) + ' ' + number_text(v) + '\n';
        return text;
      });
  if(!job.picture().empty())
    draw_map(job, result);
  if(!job.output().empty())
  {
    Surface_file file = surface.file;
    file.uv.clear();
    const double size = largest_radius(result.uv);
    for(const auto& [u, v] : result.uv)
    {
      file.properties["u"].push_back(u);
      file.properties["v"].push_back(v);
      file.uv.push_back(to_picture_uv({u, v}, size));
    }
    write_surface_file(job.output(), file);
  }
  job.finish();
}

} // namespace

void add_logmap(CLI::App& program)
{
  Command command(program, "logmap", "compute the logarithmic map (normal coordinates) at a base");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Logmap_options>();
  command.add("--base", options->base, "V", "index of the base vertex");
  command.add("--base-at", options->base_at, "x,y,z", "base at the location closest to a point");
  command.add("--radius", options->radius, "R",
              "maximum distance from the base; vertices beyond it are not mapped");
  command.add("--up", options->up, "x,y,z", "direction of the second axis");
  command
      .add("--method", options->method, "NAME",
           "gradient (of squared distances), exact (directions of shortest paths) or "
           "discrete-exponential (along edges)")
      .shows_default();
  command
      .add("--distances", options->distances, "NAME",
           "distances for gradient: automatic, exact, euclidean, fast-marching, dijkstra or heat")
      .shows_default();
  command.add("--smoothing-steps", options->smoothing_steps, "N",
              "steps that smooth the distances for gradient, at most 1000");
  command.add("--base-refinements", options->base_refinements, "N",
              "how many times edges around the base are halved for gradient, at most 8; on a mesh");
  command.set_callback([job, options] { run_logmap(*job, *options); });
}

} // namespace program
