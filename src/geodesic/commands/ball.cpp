// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/Picture.h"
#include "readers/Scanner.h"
#include "app/commands.h"
#include "commands/command_utilities.h"
#include "io/errors.h"

#include <cmath>

namespace program {

namespace {

struct Ball_options
{
  std::string source;    // "V,V,..."
  std::string source_at; // "x,y,z"
  double radius = 0.;
};

void check(const Ball_options& options)
{
  if(options.source.empty() && options.source_at.empty())
    throw Usage_error("ball: --source or --source-at is required.");
  if(!options.source.empty())
    parse_indices(options.source, "--source");
  if(!options.source_at.empty())
    parse_point(options.source_at, "--source-at");
  if(!(options.radius > 0. && std::isfinite(options.radius)))
    throw Usage_error("ball: --radius must be a positive number.");
}

// Returns a label for each vertex: 0 if it is a corner of a face of the ball, otherwise -1.
std::vector<long long> ball_labels(const Mesh_domain& domain, const GP::Geodesic_ball<Mesh>& ball,
                                   std::size_t number_of_vertices)
{
  std::vector<long long> result(number_of_vertices, -1);
  for(const auto face : ball.faces)
    for(std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t corner = 3 * std::size_t{domain.triangle(face)} + k;
      // Not public: The mesh of a soup, which knows the corners, would be built for this.
      const auto vertex = domain.vertex(domain.triangles()->corner[corner]);
      result[std::size_t(vertex)] = 0;
    }
  return result;
}

void run_ball(Job& job, const Ball_options& options)
{
  check(options);
  const Surface& surface = job.read({"vtp", "ply", "obj"});
  if(!surface.is_mesh())
    fail(surface.name, "a ball needs a mesh, because the triangles of a cloud overlap");
  std::vector<GP::Source<Mesh>> sources;
  std::vector<Point> markers;
  if(!options.source.empty())
    for(const std::size_t vertex : parse_indices(options.source, "--source"))
    {
      check_vertex(surface, vertex);
      sources.emplace_back(vertex_at<Mesh>(vertex));
      markers.push_back(surface.file.points[vertex]);
    }

  job.begin_stage("prepare");
  const Mesh_domain& domain = *surface.domain;
  if(!options.source_at.empty())
  {
    const auto location = locate(domain, options.source_at, "--source-at");
    sources.emplace_back(location);
    markers.push_back(location_point(domain, location));
  }
  check_memory(job, "exact");
  job.begin_stage("query");
  const GP::Geodesic_ball<Mesh> ball = GP::geodesic_ball(
      domain, sources, options.radius, GP::parameters::callback(job.progress_callback("ball")));
  std::vector<std::vector<Point>> circles;
  double length = 0.;
  for(const auto& circle : ball.circles)
  {
    circles.push_back(coordinates_of(circle.points));
    length += circle.length;
  }
  job.result()["area"] = json_number(ball.area);
  job.result()["faces_inside"] = ball.faces.size();
  job.result()["circles"] = circles.size();
  job.result()["length"] = json_number(length);
  job.print_line("area            " + rounded_text(ball.area));
  job.print_line("faces inside    " + std::to_string(ball.faces.size()));
  job.print_line("circles         " + std::to_string(circles.size()));
  job.print_line("length          " + rounded_text(length));

  job.begin_stage("write");
  job.write_values(
      [&]
      {
        std::string text;
        for(const std::vector<Point>& circle : circles)
          text += points_text(circle);
        return text;
      });
  if(!job.picture().empty())
  {
    Picture picture{&surface.file};
    picture.labels = ball_labels(domain, ball, surface.file.points.size());
    picture.polylines = circles;
    picture.markers = markers;
    draw(job.picture(), picture);
  }
  write_polylines(job, circles);
  job.finish();
}

} // namespace

void add_ball(CLI::App& program)
{
  Command command(program, "ball",
                  "compute a geodesic ball: its area, its faces, and the circle that bounds it");
  const auto job = std::make_shared<Job>(command);
  command.describe("--output", "write the circles: .ply .obj .vtp");
  const auto options = std::make_shared<Ball_options>();
  command.add("--source", options->source, "V[,V...]", "indices of the centers");
  command.add("--source-at", options->source_at, "x,y,z",
              "center at the location closest to a point");
  command.add("--radius", options->radius, "R", "radius, in the unit of the coordinates");
  command.set_callback([job, options] { run_ball(*job, *options); });
}

} // namespace program
