// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Job.h"
#include "io/Output_file.h"
#include "io/write_surface_file.h"
#include "picture/Picture.h"
#include "readers/Scanner.h"
#include "app/commands.h"
#include "commands/command_utilities.h"
#include "io/errors.h"

#include <algorithm>
#include <cmath>

namespace program {

namespace {

// Not public: No function returns the connected components of vertices, or the angles of triangles.
using GP::internal::components;
using GP::internal::Surface_arrays;

struct Mesh_quality
{
  double area = 0.;                        // in the file's unit squared
  double min_angle = 180., max_angle = 0.; // degrees, of triangles with positive area
};

Point difference(const Point& p, const Point& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }

double dot(const Point& u, const Point& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

double cross_product_length(const Point& u, const Point& v)
{
  return std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                    u[0] * v[1] - u[1] * v[0]);
}

Mesh_quality compute_quality(const Surface_arrays& triangles)
{
  constexpr double degrees_per_radian = 57.295779513082323;
  Mesh_quality quality;
  for(std::size_t f = 0; f < triangles.number_of_triangles(); ++f)
  {
    Point edge[3]; // from corner k to corner k + 1
    for(std::size_t k = 0; k < 3; ++k)
      edge[k] = difference(triangles.point[triangles.corner[3 * f + (k + 1) % 3]],
                           triangles.point[triangles.corner[3 * f + k]]);
    const double twice_area = cross_product_length(edge[0], edge[1]);
    if(twice_area == 0.)
      continue;
    quality.area += twice_area / 2.;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const double angle =
          degrees_per_radian * std::atan2(twice_area, -dot(edge[k], edge[(k + 2) % 3]));
      quality.min_angle = std::min(quality.min_angle, angle);
      quality.max_angle = std::max(quality.max_angle, angle);
    }
  }
  quality.area *= triangles.scale * triangles.scale;
  return quality;
}

// Returns the connected component of each vertex. vertex[i] is the internal index of vertex i of
// the file.
std::vector<long long> component_labels(const Surface_arrays& triangles,
                                        const std::vector<std::uint32_t>& vertex)
{
  const std::vector<std::uint32_t> label = components(triangles).first;
  std::vector<long long> result(vertex.size());
  std::transform(vertex.begin(), vertex.end(), result.begin(),
                 [&](std::uint32_t s) { return static_cast<long long>(label[s]); });
  return result;
}

// Regions that the picture shows in different colors
struct Picture_regions
{
  std::vector<long long> labels;
  std::vector<std::uint32_t> triangles; // of a cloud
};

Picture_regions report_mesh(Job& job)
{
  const auto& domain = *job.surface().domain;
  const GP::Soup_report& report = domain.report();
  const Surface_arrays& triangles = *domain.triangles(); // Not public: for angles and components.
  job.begin_stage("query");
  const Mesh_quality quality = compute_quality(triangles);
  Json_object result = job.result();
  result["components"] = report.number_of_components;
  result["boundary_loops"] = report.number_of_boundary_cycles;
  result["genus"] = report.genus;
  result["manifold"] = report.is_manifold();
  result["area"] = json_number(quality.area);
  const bool has_angles = quality.max_angle > 0.;
  result["min_angle"] = json_number(has_angles ? quality.min_angle : INFINITY);
  result["max_angle"] = json_number(has_angles ? quality.max_angle : INFINITY);
  result["degenerate_faces"] = report.number_of_triangles_without_area;

  job.print_line("components      " + std::to_string(report.number_of_components));
  job.print_line("boundary loops  " + std::to_string(report.number_of_boundary_cycles));
  job.print_line("genus           " + std::to_string(report.genus));
  job.print_line(std::string("manifold        ") + (report.is_manifold() ? "yes" : "no"));
  if(has_angles)
    job.print_line("angles          " + rounded_text(quality.min_angle) + " to " +
                   rounded_text(quality.max_angle) + " degrees");
  job.print_line("area            " + rounded_text(quality.area));
  job.print_line("degenerate      " + std::to_string(report.number_of_triangles_without_area) +
                 " faces");
  if(report.number_of_components < 2 || job.picture().empty())
    return {};
  std::vector<std::uint32_t> vertex;
  for(const Mesh::Vertex_index v : domain.mesh().vertices())
    vertex.push_back(domain.index(v));
  return {component_labels(triangles, vertex), {}};
}

// Reports connected components of the surfel graph: surfels without a connecting path are
// unreachable.
Picture_regions report_cloud(Job& job)
{
  const Cloud_domain domain = make_domain(make_cloud(job.surface()), job);
  const auto& surfels = domain.surfels(); // Not public: components() needs these arrays.
  job.begin_stage("query");
  const std::size_t number_of_components = components(surfels.arrays).second;
  job.result()["components"] = number_of_components;
  job.print_line("components      " + std::to_string(number_of_components));
  if(job.picture().empty())
    return {};
  Picture_regions regions = {{}, picture_triangles(domain)};
  if(number_of_components > 1)
    regions.labels = component_labels(surfels.arrays, surfels.internal_vertex);
  return regions;
}

void report_bounding_box(Job& job)
{
  Point low = job.surface().file.points[0], high = low;
  for(const Point& p : job.surface().file.points)
    for(std::size_t c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], p[c]);
      high[c] = std::max(high[c], p[c]);
    }
  job.result()["bounding_box"] = std::vector<Point>{low, high};
  job.print_line("bounding box    " + rounded_text(low[0]) + " " + rounded_text(low[1]) + " " +
                 rounded_text(low[2]) + " to " + rounded_text(high[0]) + " " +
                 rounded_text(high[1]) + " " + rounded_text(high[2]));
  const double diagonal = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  job.result()["diagonal"] = json_number(diagonal);
  job.print_line("diagonal        " + rounded_text(diagonal));
}

struct Info_options
{
  std::string property;
  bool show_edges = false;
};

void run_info(Job& job, const Info_options& options)
{
  const std::string& property_name = options.property;
  if(!property_name.empty() && job.picture().empty())
    throw Usage_error("--property: this option requires --picture.");
  if(options.show_edges && job.picture().empty())
    throw Usage_error("--sides: this option requires --picture.");
  const Surface& surface = job.read();
  if(options.show_edges && !surface.is_mesh())
    throw Usage_error("--sides: a cloud has no edges.");
  if(!property_name.empty())
    property(surface, property_name);
  job.print_line(std::string("kind            ") + (surface.is_mesh() ? "mesh" : "cloud"));
  job.print_line("vertices        " + std::to_string(surface.file.points.size()));
  job.begin_stage("prepare");
  if(surface.is_mesh())
    job.print_line("faces           " + std::to_string(surface.file.number_of_polygons()));
  Picture_regions regions = surface.is_mesh() ? report_mesh(job) : report_cloud(job);
  job.begin_stage("query");
  report_bounding_box(job);

  job.begin_stage("write");
  if(!job.output().empty())
    write_surface_file(job.output(), surface.file);
  job.write_values([&] { return points_text(surface.file.points); });
  if(!job.picture().empty())
  {
    Picture picture{&surface.file, {}, "", regions.labels, {}, {}, regions.triangles};
    for(const auto& [a, b] : surface.file.edges)
      picture.polylines.push_back({surface.file.points[a], surface.file.points[b]});
    if(!property_name.empty())
    {
      picture.values = property(surface, property_name);
      picture.title = property_name;
      picture.labels.clear();
    }
    picture.show_edges = options.show_edges;
    draw(job.picture(), picture);
  }
  job.finish();
}

} // namespace

void add_info(CLI::App& program)
{
  Command command(program, "info",
                  "report size, topology and defects; with -o, convert the format");
  const auto job = std::make_shared<Job>(command);
  const auto options = std::make_shared<Info_options>();
  command.add("--property", options->property, "NAME",
              "property of the vertices to draw (default: the connected components)");
  command.add_flag("--sides", options->show_edges, "draw the edges of triangles in the picture");
  command.set_callback([job, options] { run_info(*job, *options); });
}

} // namespace program
