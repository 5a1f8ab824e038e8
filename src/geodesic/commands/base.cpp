// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "io/write_surface_file.h"
#include "picture/Picture.h"
#include "readers/Scanner.h"
#include "app/commands.h"
#include "io/errors.h"
#include "commands/remeshing_options.h"

#include <CGAL/Geodesic_processing/semi_regular_remeshing.h>

#include <functional>
#include <string>

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

// Returns the input mesh, or the mesh reconstructed from a cloud, subdivided along the edges of the
// base mesh. The face number "base_face" stores the base face of each triangle.
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

// Draws each base face in its own color.
void draw_base_mesh(const std::string& filename, const Base_mesh& base, bool show_edges)
{
  Picture picture;
  const Surface_file regions = separate_regions(divided_file(base), base.region, picture.labels);
  picture.surface = &regions;
  picture.show_edges = show_edges;
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

// Computes the base mesh and the location of each vertex or surfel, and writes the results.
template <typename Domain>
void compute_base(const Domain& domain, const Base_options& options, Job& job)
{
  using Surface_type = typename Domain::Surface;
  job.begin_stage("query");
  const GP::Base_parameterization<Surface_type> base(domain, options.number,
                                                     base_parameters(options, job));
  report(job, base.number_of_base_vertices(), base.number_of_base_faces(), base.number_of_flips());
  job.result()["repaired_faces"] = base.number_of_repaired_faces();
  job.print_line("repaired        " + std::to_string(base.number_of_repaired_faces()));

  std::string text;
  for(std::size_t i = 0; i < job.surface().file.points.size(); ++i)
  {
    const auto vertex = vertex_at<Surface_type>(i);
    if constexpr(is_mesh<Surface_type>)
      // Not public: The mesh of a soup, which knows isolated vertices, would be built for this.
      if(domain.outer(domain.inner_vertex(vertex)).first == Mesh::null_face())
      {
        text += "-1 nan nan nan\n";
        continue;
      }
    const GP::Base_location location = base(vertex);
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
}

void run_base(Job& job, const Base_options& options)
{
  job.read();
  job.begin_stage("prepare");
  visit_domain(job, [&](const auto& domain) { compute_base(domain, options, job); });
  job.finish();
}

struct Semi_regular_mesh
{
  Surface_file file;
  std::vector<std::size_t> levels; // #vertices
  GP::Semi_regular_result found;
};

// Computes the mesh and the level of each vertex.
template <typename Domain>
Semi_regular_mesh find_semi_regular_mesh(const Domain& domain, const Base_options& options,
                                         Job& job)
{
  job.begin_stage("query");
  Mesh mesh;
  const auto level = mesh.add_property_map<Mesh::Vertex_index, std::size_t>("v:level").first;
  const auto np = base_parameters(options, job)
                      .level_map(level)
                      .subdivision_scheme(options.use_quads ? GP::Subdivision_scheme::quads
                                                            : GP::Subdivision_scheme::triangles);
  Semi_regular_mesh result;
  result.found = options.max_deviation > 0.
                     ? GP::semi_regular_remeshing(domain, options.number, options.levels, mesh,
                                                  np.maximum_deviation(options.max_deviation))
                     : GP::semi_regular_remeshing(domain, options.number, options.levels, mesh, np);
  result.file = to_file(mesh);
  for(const auto v : mesh.vertices())
    result.levels.push_back(level[v]);
  return result;
}

void run_semiregular(Job& job, const Base_options& options)
{
  if(!(options.max_deviation >= 0.))
    throw Usage_error("--maximum-deviation: the deviation must not be negative.");
  if(options.use_quads && options.max_deviation > 0.)
    throw Usage_error("--maximum-deviation and --quads cannot be combined.");
  job.read();
  job.begin_stage("prepare");
  Semi_regular_mesh result;
  visit_domain(job,
               [&](const auto& domain) { result = find_semi_regular_mesh(domain, options, job); });
  const Surface_file& file = result.file;
  const GP::Semi_regular_result& found = result.found;
  report(job, file.points.size(), file.number_of_polygons(), found.number_of_flips);
  job.result()["levels"] = found.number_of_levels;
  job.result()["base_faces"] = found.number_of_base_faces;
  job.print_line("levels          " + std::to_string(found.number_of_levels));
  if(options.max_deviation > 0.)
    job.report("deviation", found.deviation);

  job.begin_stage("write");
  job.write_values(
      [&]
      {
        std::string text;
        for(const std::size_t level : result.levels)
          text += std::to_string(level) + '\n';
        return text;
      });
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
                  "compute a base mesh of few triangles and the location of each vertex on it; a "
                  "cloud is first reconstructed as a mesh");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Base_options>();
  command.describe("--values",
                   "write the base face and the barycentric coordinates in it, one line "
                   "per vertex or surfel of the input");
  add_base_options(command, *options);
  command.add_flag("--divided", options->is_divided,
                   "write and draw the input or reconstructed mesh, subdivided by the "
                   "base edges; the property base_face is the base face of each face");
  command.set_callback([job, options] { run_base(*job, *options); });
}

void add_semiregular(CLI::App& program)
{
  Command command(program, "semiregular",
                  "remesh by uniform refinement of a base mesh; a cloud is first reconstructed as "
                  "a mesh");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Base_options>();
  add_base_options(command, *options);
  command.add("--levels", options->levels, "J", "number of 1-to-4 refinements (default 3)")
      .in_range(0, 8);
  command.add_flag("--quads", options->use_quads, "first split each base face into three quads");
  command.add("--maximum-deviation", options->max_deviation, "D",
              "stop the refinement once each vertex of the input or reconstructed mesh is within "
              "this distance of the point with the same base coordinates (default 0: all levels)");
  command.set_callback([job, options] { run_semiregular(*job, *options); });
}

} // namespace program
