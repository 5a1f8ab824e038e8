// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output_file.h"
#include "Picture.h"
#include "Scanner.h"
#include "commands.h"
#include "densities.h"
#include "errors.h"

#include <algorithm>

namespace program {

namespace {

struct Remesh_options
{
  std::size_t number = 0;
  std::size_t lloyd = 0;
  double sharp_angle = 180.;
  Density_options densities;
};

struct Result
{
  Surface_file file;
  std::string text; // where each vertex is: the lines of --values
  std::size_t added = 0;
};

// The library's part: the mesh, and where its vertices lie.
Result find_mesh(const Mesh& surface, const Remesh_options& options, Job& job)
{
  const auto domain = GP::make_domain(surface, GP::parameters::threads(job.threads()));
  const std::vector<double> speed = speeds(domain, options.densities, job);
  job.stage("query");
  Mesh mesh;
  const auto locations =
      mesh.add_property_map<Mesh::Vertex_index, GP::Location<Mesh>>("v:location").first;
  const auto goal = GP::parameters::random_seed(job.seed())
                        .number_of_relaxation_steps(options.lloyd)
                        .sharp_angle(options.sharp_angle)
                        .location_map(locations)
                        .callback(job.progress("vertices"));
  Result result;
  with_speeds<Mesh::Vertex_index>(
      speed, goal,
      [&](const auto& np)
      { result.added = GP::geodesic_delaunay_remeshing(domain, options.number, mesh, np).added; });
  for(const auto v : mesh.vertices())
  {
    const auto& p = mesh.point(v);
    result.file.points.push_back({p.x(), p.y(), p.z()});
    if(!job.values().empty())
      result.text += place_text(surface, get(locations, v)) + '\n';
  }
  for(const auto f : mesh.faces())
  {
    for(const auto v : vertices_around_face(mesh.halfedge(f), mesh))
      result.file.corners.push_back(v);
    result.file.first.push_back(result.file.corners.size());
  }
  return result;
}

void run_remesh(Job& job, const Remesh_options& options)
{
  check(options.densities);
  const Surface& surface = job.read();
  if(!surface.is_mesh())
    fail(surface.name, "a cloud cannot be remeshed, that needs a mesh");

  job.stage("prepare");
  const Result result = find_mesh(make_mesh(surface), options, job);
  job.result()["vertices_out"] = result.file.points.size();
  job.result()["faces_out"] = result.file.number_of_polygons();
  job.result()["added"] = result.added;
  job.say("vertices        " + std::to_string(result.file.points.size()));
  job.say("faces           " + std::to_string(result.file.number_of_polygons()));
  if(result.added > 0)
    job.say("added           " + std::to_string(result.added));

  job.stage("write");
  job.write_values(result.text);
  if(!job.picture().empty())
  {
    Picture picture{&result.file};
    picture.with_sides = true;
    draw(job.picture(), picture);
  }
  if(!job.output().empty())
    write_surface_file(job.output(), result.file);
  job.finish();
}

} // namespace

void add_remesh(CLI::App& program)
{
  CLI::App* const command =
      program.add_subcommand("remesh", "a mesh of the same surface with even triangles");
  const auto job = std::make_shared<Job>(*command);
  const auto options = std::make_shared<Remesh_options>();
  command->add_option("--number", options->number, "of vertices; more come where it takes them")
      ->type_name("N")
      ->check(not_negative())
      ->required();
  command
      ->add_option("--lloyd", options->lloyd,
                   "how often vertices move to the middle of their cells")
      ->type_name("K")
      ->check(not_negative());
  command
      ->add_option("--keep-sharp", options->sharp_angle,
                   "edges at which the surface bends by so many degrees or more are kept")
      ->type_name("ANGLE")
      ->check(CLI::Range(0., 180.));
  add_density_options(*command, options->densities);
  command->callback([job, options] { run_remesh(*job, *options); });
}

} // namespace program
