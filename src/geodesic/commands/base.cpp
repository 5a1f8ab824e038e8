// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "picture/Picture.h"
#include "io/Scanner.h"
#include "app/commands.h"
#include "io/errors.h"
#include "commands/remeshing_options.h"

#include <CGAL/Geodesic_processing/semi_regular_remeshing.h>

#include <functional>
#include <map>
#include <string>
#include <utility>

namespace program {

namespace {

// Not public: Base_parameterization does not return the paths of base edges, and
// geodesic_base_mesh() would compute the base mesh again to return the divided mesh.
using GP::internal::Base_mesh;
using GP::internal::Surface_arrays;

struct Base_options : Remeshing_options
{
  std::string coordinates = "heron";
  bool is_divided = false;

  // Options of the semi-regular mesh
  unsigned levels = 3;
  bool use_quads = false;
  double max_deviation = 0.; // 0: unlimited
};

const Surface& read_mesh(Job& job, const char* command_name)
{
  const Surface& surface = job.read();
  if(!surface.is_mesh())
    fail(surface.name, std::string(command_name) + " needs a mesh, but the input is a cloud");
  return surface;
}

GP::Base_coordinates parse_coordinates(const std::string& word)
{
  if(word == "heron")
    return GP::Base_coordinates::heron;
  if(word == "mean-value")
    return GP::Base_coordinates::mean_value;
  if(word == "uniform")
    return GP::Base_coordinates::uniform;
  throw Usage_error("--coordinates " + printable(word) +
                    ": the coordinates are heron, mean-value and uniform.");
}

auto base_parameters(const Base_options& options, Job& job)
{
  return remeshing_parameters(options, job)
      .base_coordinates(parse_coordinates(options.coordinates));
}

// Reports the results that both commands have in common.
void report(Job& job, std::size_t vertices, std::size_t faces, std::size_t folds)
{
  job.result()["vertices_out"] = vertices;
  job.result()["faces_out"] = faces;
  job.result()["folds"] = folds;
  job.print_line("vertices        " + std::to_string(vertices));
  job.print_line("faces           " + std::to_string(faces));
  job.print_line("folds           " + std::to_string(folds));
}

Point to_point(const Surface_arrays& triangles, std::uint32_t vertex)
{
  Point result;
  for(std::size_t k = 0; k < 3; ++k)
    result[k] = triangles.origin[k] + triangles.scale * triangles.point[vertex][k];
  return result;
}

Surface_file base_file(const Base_mesh& base)
{
  Surface_file result;
  for(const auto vertex : base.vertex)
    result.points.push_back(to_point(base.fine, vertex));
  for(const auto& triangle : base.triangles)
  {
    result.corners.insert(result.corners.end(), triangle.begin(), triangle.end());
    result.polygon_begin.push_back(result.corners.size());
  }
  return result;
}

// Returns the input mesh subdivided along the edges of the base mesh. The face number "base_face"
// stores the base face of each triangle.
Surface_file divided_file(const Base_mesh& base)
{
  Surface_file result;
  for(std::uint32_t vertex = 0; vertex < base.fine.point.size(); ++vertex)
    result.points.push_back(to_point(base.fine, vertex));
  result.corners = base.fine.corner;
  for(std::size_t f = 0; f < base.region.size(); ++f)
    result.polygon_begin.push_back(3 * (f + 1));
  result.face_numbers["base_face"] = base.region;
  return result;
}

// Draws each base face in its own color. Vertices are duplicated per base face, because colors are
// stored at vertices.
void draw_base_mesh(const std::string& filename, const Base_mesh& base, bool show_edges)
{
  Surface_file regions;
  Picture picture{&regions};
  picture.show_edges = show_edges;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>
      vertex_index; // by base face and vertex
  for(std::size_t corner = 0; corner < base.fine.corner.size(); ++corner)
  {
    const auto face = base.region[corner / 3], vertex = base.fine.corner[corner];
    const auto [entry, is_new] =
        vertex_index.try_emplace({face, vertex}, static_cast<std::uint32_t>(regions.points.size()));
    if(is_new)
    {
      regions.points.push_back(to_point(base.fine, vertex));
      picture.labels.push_back(static_cast<long long>(face));
    }
    regions.corners.push_back(entry->second);
    if(corner % 3 == 2)
      regions.polygon_begin.push_back(regions.corners.size());
  }
  for(const auto& path : base.path)
  {
    picture.thin_polylines.emplace_back();
    for(const auto vertex : path)
      picture.thin_polylines.back().push_back(to_point(base.fine, vertex));
  }
  for(const auto vertex : base.vertex)
    picture.markers.push_back(to_point(base.fine, vertex));
  draw(filename, picture);
}

void run_base(Job& job, const Base_options& options)
{
  const Surface& surface = read_mesh(job, "base");
  job.begin_stage("prepare");
  const Mesh mesh = make_mesh(surface);
  job.begin_stage("query");
  const GP::Base_parameterization<Mesh> base(mesh, options.number, base_parameters(options, job));
  report(job, base.number_of_base_vertices(), base.number_of_base_faces(), base.number_of_flips());
  job.result()["repaired_faces"] = base.number_of_repaired_faces();
  job.print_line("repaired        " + std::to_string(base.number_of_repaired_faces()));

  std::string text;
  for(const auto v : mesh.vertices())
  {
    if(mesh.is_isolated(v))
    {
      text += "-1 nan nan nan\n";
      continue;
    }
    const GP::Base_location location = base(v);
    text += std::to_string(location.face);
    for(const double coordinate : location.barycentric)
      text += ' ' + number_text(coordinate);
    text += '\n';
  }
  job.begin_stage("write");
  job.write_values([&] { return text; });
  const Base_mesh& base_mesh = base.map().base(); // Not public: as for Base_mesh
  if(!job.picture().empty())
    draw_base_mesh(job.picture(), base_mesh, options.is_divided);
  if(!job.output().empty())
    write_surface_file(job.output(),
                       options.is_divided ? divided_file(base_mesh) : base_file(base_mesh));
  job.finish();
}

void run_semiregular(Job& job, const Base_options& options)
{
  if(!(options.max_deviation >= 0.))
    throw Usage_error("--maximum-deviation: the deviation must not be negative.");
  if(options.use_quads && options.max_deviation > 0.)
    throw Usage_error("--maximum-deviation and --quads cannot be combined.");
  const Surface& surface = read_mesh(job, "semiregular");
  job.begin_stage("prepare");
  const Mesh mesh = make_mesh(surface);
  job.begin_stage("query");
  Mesh output;
  const auto level = output.add_property_map<Mesh::Vertex_index, std::size_t>("v:level").first;
  const auto np = base_parameters(options, job)
                      .level_map(level)
                      .subdivision_scheme(options.use_quads ? GP::Subdivision_scheme::quads
                                                            : GP::Subdivision_scheme::triangles);
  const GP::Semi_regular_result result =
      options.max_deviation > 0.
          ? GP::semi_regular_remeshing(mesh, options.number, options.levels, output,
                                       np.maximum_deviation(options.max_deviation))
          : GP::semi_regular_remeshing(mesh, options.number, options.levels, output, np);
  Surface_file file;
  std::string text;
  for(const auto v : output.vertices())
  {
    file.points.push_back(coordinates(output.point(v)));
    text += std::to_string(level[v]) + '\n';
  }
  for(const auto f : output.faces())
  {
    for(const auto v : vertices_around_face(output.halfedge(f), output))
      file.corners.push_back(v);
    file.polygon_begin.push_back(file.corners.size());
  }
  report(job, file.points.size(), file.number_of_polygons(), result.number_of_flips);
  job.result()["levels"] = result.number_of_levels;
  job.result()["base_faces"] = result.number_of_base_faces;
  job.print_line("levels          " + std::to_string(result.number_of_levels));
  if(options.max_deviation > 0.)
    job.report("deviation", result.deviation);

  job.begin_stage("write");
  job.write_values([&] { return text; });
  if(!job.picture().empty())
  {
    // Pictures need triangles, so the edges of quadrilaterals are drawn separately.
    Surface_file triangles;
    triangles.points = file.points;
    Picture picture{&triangles};
    picture.show_edges = !options.use_quads;
    for(std::size_t f = 0; f < file.number_of_polygons(); ++f)
    {
      const std::uint32_t* const corner = &file.corners[file.polygon_begin[f]];
      const std::size_t size = file.polygon_begin[f + 1] - file.polygon_begin[f];
      for(std::size_t k = 2; k < size; ++k)
      {
        triangles.corners.insert(triangles.corners.end(), {corner[0], corner[k - 1], corner[k]});
        triangles.polygon_begin.push_back(triangles.corners.size());
      }
      for(std::size_t k = 0; options.use_quads && k < size; ++k)
        if(corner[k] < corner[(k + 1) % size])
          picture.thin_polylines.push_back(
              {file.points[corner[k]], file.points[corner[(k + 1) % size]]});
    }
    draw(job.picture(), picture);
  }
  if(!job.output().empty())
    write_surface_file(job.output(), file);
  job.finish();
}

void add_base_options(Command& command, Base_options& options)
{
  add_remeshing_options(command, options, "base vertices", "base edges follow edges");
  command.add("--coordinates", options.coordinates, "KIND",
              "barycentric coordinates in base faces: heron (default, from geodesic distances), "
              "mean-value or uniform");
}

} // namespace

void add_base(CLI::App& program)
{
  Command command(program, "base",
                  "compute a base mesh of few triangles and the location of each vertex on it");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Base_options>();
  add_base_options(command, *options);
  command.add_flag("--divided", options->is_divided,
                   "write and draw the input mesh subdivided by the base edges; the property "
                   "base_face is the base face of each face");
  command.set_callback([job, options] { run_base(*job, *options); });
}

void add_semiregular(CLI::App& program)
{
  Command command(program, "semiregular", "remesh by uniform refinement of a base mesh");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Base_options>();
  add_base_options(command, *options);
  command.add("--levels", options->levels, "J", "number of 1-to-4 refinements (default 3)")
      .in_range(0, 8);
  command.add_flag("--quads", options->use_quads, "first split each base face into three quads");
  command.add("--maximum-deviation", options->max_deviation, "D",
              "stop the refinement once each input vertex is within this distance of the point "
              "with the same base coordinates");
  command.set_callback([job, options] { run_semiregular(*job, *options); });
}

} // namespace program
