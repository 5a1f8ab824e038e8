// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/Picture.h"
#include "readers/Scanner.h"
#include "app/commands.h"
#include "commands/command_utilities.h"
#include "io/errors.h"

namespace program {

namespace {

struct Curve_options
{
  std::string points;                 // "V,V,..."
  std::vector<std::string> points_at; // "x,y,z" each
  bool is_spline = false, is_closed = false;
  unsigned degree = 3;
  unsigned number_of_subdivisions = 6;
};

void check(const Curve_options& options)
{
  std::size_t number = options.points_at.size();
  if(!options.points.empty())
    number += parse_indices(options.points, "--points").size();
  if(number < 2)
    throw Usage_error("curve: at least two --points or --point-at are required.");
  for(const std::string& point : options.points_at)
    parse_point(point, "--point-at");
  if(options.is_closed && !options.is_spline)
    throw Usage_error("--closed: this option needs --spline.");
  if(options.degree == 0)
    throw Usage_error("--degree: the degree must be positive.");
  if(options.number_of_subdivisions > 20)
    throw Usage_error("--subdivisions: the number must be at most 20.");
}

void run_curve(Job& job, const Curve_options& options)
{
  check(options);
  const Surface& surface = job.read({"vtp", "ply", "obj"});
  if(!surface.is_mesh())
    fail(surface.name, "curves need a mesh, because paths on a cloud end at projections");
  if(!options.points.empty())
    for(const std::size_t vertex : parse_indices(options.points, "--points"))
      check_vertex(surface, vertex);

  job.begin_stage("prepare");
  const Mesh_domain& domain = *surface.domain;
  std::vector<Mesh_domain::Location> control_points;
  if(!options.points.empty())
    for(const std::size_t vertex : parse_indices(options.points, "--points"))
    {
      // Not public: No public function returns the location of a vertex.
      control_points.push_back(domain.outer(domain.inner_vertex(vertex_at<Mesh>(vertex))));
      if(control_points.back().first == Mesh::null_face())
        fail(surface.name, "vertex " + std::to_string(vertex) + " has no face");
    }
  for(const std::string& point : options.points_at)
    control_points.push_back(locate(domain, point, "--point-at"));

  job.begin_stage("query");
  const auto np = GP::parameters::number_of_subdivisions(options.number_of_subdivisions)
                      .degree(options.degree)
                      .is_closed(options.is_closed)
                      .callback(job.progress_callback("curve"));
  const GP::Surface_path<Mesh> curve = options.is_spline
                                           ? GP::geodesic_spline(domain, control_points, np)
                                           : GP::geodesic_bezier_curve(domain, control_points, np);
  const std::vector<Point> points = coordinates_of(curve.points);
  job.result()["length"] = json_number(curve.length);
  job.result()["points"] = points.size();
  job.print_line("length          " + rounded_text(curve.length));
  job.print_line("points          " + std::to_string(points.size()));

  job.begin_stage("write");
  job.write_values([&] { return points_text(points); });
  if(!job.picture().empty())
  {
    Picture picture{&surface.file};
    picture.polylines = {points};
    // The control polygon.
    GP::Geodesic_path_finder<Mesh> finder(domain);
    for(std::size_t i = 0; i < control_points.size(); ++i)
    {
      picture.markers.push_back(location_point(domain, control_points[i]));
      if(i > 0 || options.is_closed)
      {
        const auto& previous = i > 0 ? control_points[i - 1] : control_points.back();
        picture.thin_polylines.push_back(
            coordinates_of(finder(previous, control_points[i]).points));
      }
    }
    draw(job.picture(), picture);
  }
  write_polylines(job, {points});
  job.finish();
}

} // namespace

void add_curve(CLI::App& program)
{
  Command command(program, "curve", "compute a Bezier curve or a B-spline on a mesh");
  const auto job = std::make_shared<Job>(command);
  command.describe("--output", "write the curve: .ply .obj .vtp");
  const auto options = std::make_shared<Curve_options>();
  command.add("--points", options->points, "V[,V...]", "control points: indices of vertices");
  command.add("--point-at", options->points_at, "x,y,z",
              "control point at the location closest to a point; can be repeated");
  command.add_flag("--spline", options->is_spline,
                   "compute a uniform B-spline (default: a Bezier curve)");
  command.add("--degree", options->degree, "P", "degree of the spline").shows_default();
  command.add_flag("--closed", options->is_closed, "compute a closed spline");
  command.add("--subdivisions", options->number_of_subdivisions, "K", "number of subdivisions")
      .shows_default();
  command.set_callback([job, options] { run_curve(*job, *options); });
}

} // namespace program
