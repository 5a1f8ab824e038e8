// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "io/write_surface_file.h"
#include "picture/Picture.h"
#include "readers/Scanner.h"
#include "app/commands.h"
#include "commands/speed_options.h"
#include "io/errors.h"
#include "commands/remeshing_options.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

namespace program {

namespace {

struct Remesh_options : Remeshing_options
{
  double curve_spacing = 0.;
  double max_deviation = std::numeric_limits<double>::infinity();
  bool does_fit = false;
  bool allow_self_intersections = false;
  std::optional<std::size_t> max_hole_edges; // longest hole to be filled
  Speed_options speed_options;
};

struct Remesh_result
{
  Surface_file file;
  std::string text; // location of each vertex: the lines of --values
  GP::Remeshing_result found;
};

// Returns the maximum number of edges of a hole. If the text is empty, the number is unlimited.
std::size_t parse_hole_edges(const std::string& text)
{
  if(text.empty())
    return std::numeric_limits<std::size_t>::max();
  const std::optional<long long> number = to_integer(text);
  if(!number || *number < 3)
    throw Usage_error("--fill-holes " + printable(text) +
                      ": the number of edges must be an integer of at least 3.");
  return static_cast<std::size_t>(*number);
}

// Fills holes and reports how many were filled and how many are left open.
void fill_and_report(Mesh& mesh, std::size_t max_edges, Job& job)
{
  const GP::Hole_filling_result holes = GP::fill_holes(
      mesh,
      GP::parameters::maximum_number_of_edges(max_edges).callback(job.progress_callback("holes")));
  job.result()["holes_filled"] = holes.number_of_filled;
  job.result()["holes_left"] = holes.number_of_failed;
  job.print_line("holes filled    " + std::to_string(holes.number_of_filled));
  if(holes.number_of_failed > 0)
    job.print_warning(std::to_string(holes.number_of_failed) +
                      (holes.number_of_failed == 1 ? " hole is left open: it has"
                                                   : " holes are left open: they have") +
                      " too many edges, or no valid triangulation was found");
}

// Computes the mesh and the locations of its vertices.
template <typename Domain>
Remesh_result find_mesh(const Domain& domain, const Remesh_options& options, Job& job)
{
  const std::vector<double> speed = compute_speeds(domain, options.speed_options, job);
  job.release_file(); // a tenth of the memory
  job.begin_stage("query");
  Mesh mesh;
  const auto locations =
      mesh.add_property_map<Mesh::Vertex_index, typename Domain::Location>("v:location").first;
  const auto parameters = remeshing_parameters(options, job)
                              .curve_spacing(options.curve_spacing)
                              .maximum_deviation(options.max_deviation)
                              .do_fit(options.does_fit)
                              .do_avoid_self_intersections(!options.allow_self_intersections)
                              .location_map(locations)
                              .speed_map(speed_map<typename Domain::Vertex>(speed));
  Remesh_result result;
  result.found = GP::geodesic_delaunay_remeshing(domain, options.number, mesh, parameters);
  if(!job.values().empty())
    for(const auto v : mesh.vertices())
      result.text += location_text(domain, get(locations, v)) + '\n';
  result.file = to_file(mesh);
  return result;
}

void run_remesh(Job& job, const Remesh_options& options)
{
  check(options.speed_options);
  if(!(options.max_deviation > 0.))
    throw Usage_error("--maximum-deviation: the deviation must be positive.");
  if(!(options.curve_spacing >= 0.) || std::isinf(options.curve_spacing))
    throw Usage_error("--curve-spacing: the spacing must be finite and not negative.");
  const Surface& surface = job.read();
  if(!surface.is_mesh() && options.max_hole_edges)
    fail(surface.name, "--fill-holes needs a mesh, but the input is a cloud");

  job.begin_stage("prepare");
  Remesh_result result;
  if(options.max_hole_edges)
  {
    Mesh mesh = surface.domain->mesh();
    fill_and_report(mesh, *options.max_hole_edges, job);
    result = find_mesh(Mesh_domain(mesh), options, job);
  }
  else
    visit_domain(job, [&](const auto& domain) { result = find_mesh(domain, options, job); });
  job.result()["vertices_out"] = result.file.points.size();
  job.result()["faces_out"] = result.file.number_of_polygons();
  job.result()["added"] = result.found.number_of_added_vertices;
  if(!options.allow_self_intersections)
    job.result()["self_intersections"] = result.found.number_of_self_intersections;
  job.print_line("vertices        " + std::to_string(result.file.points.size()));
  job.print_line("faces           " + std::to_string(result.file.number_of_polygons()));
  if(result.found.number_of_added_vertices > 0)
    job.print_line("added           " + std::to_string(result.found.number_of_added_vertices));
  if(const std::size_t pairs = result.found.number_of_self_intersections; pairs > 0)
    job.print_warning(std::to_string(pairs) +
                      (pairs == 1 ? " pair of faces intersects" : " pairs of faces intersect") +
                      ", because the input intersects itself or nearly does so");

  job.begin_stage("write");
  job.write_values([&] { return result.text; });
  if(!job.picture().empty())
  {
    Picture picture{&result.file};
    picture.show_edges = true;
    draw(job.picture(), picture);
  }
  if(!job.output().empty())
    write_surface_file(job.output(), result.file);
  job.finish();
}

} // namespace

void add_remesh(CLI::App& program)
{
  Command command(program, "remesh",
                  "remesh with triangles of even size, or reconstruct a mesh from a clean cloud");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Remesh_options>();
  add_remeshing_options(command, *options, "vertices", "preserve edges");
  command.add("--curve-spacing", options->curve_spacing, "D",
              "approximate maximum distance between adjacent vertices on boundaries and "
              "preserved edges, in the unit of the coordinates");
  command.add_flag("--fit", options->does_fit,
                   "move vertices off the surface, so that the faces approximate it better");
  command.add(
      "--maximum-deviation", options->max_deviation, "D",
      "maximum distance between input and result at their vertices and at the edge midpoints "
      "and face centroids of the result, in the unit of the coordinates; vertices are added "
      "if it is exceeded");
  command.add_flag("--allow-self-intersections", options->allow_self_intersections,
                   "do not add vertices to remove self-intersections of the result");
  const std::function<void(const std::string&)> set_hole_edges = [options](const std::string& text)
  { options->max_hole_edges = parse_hole_edges(text); };
  command
      .add("--fill-holes", set_hole_edges, "[N]",
           "first fill the holes with at most N edges, or without N all holes. The outer "
           "boundary of an open surface is also a hole, so use N to keep it open")
      .value_is_optional();
  add_speed_options(command, options->speed_options);
  command.set_callback([job, options] { run_remesh(*job, *options); });
}

} // namespace program
