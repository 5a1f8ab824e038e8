// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Job.h"
#include "io/Output_file.h"
#include "picture/Picture.h"
#include "io/Scanner.h"
#include "app/commands.h"
#include "commands/queries.h"

#include <CGAL/Geodesic_processing/internal/mesh/glue.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfels.h>

#include <algorithm>
#include <cmath>

namespace program {

namespace {

namespace internal = GP::internal;

struct Shape
{
  double area = 0.;                        // in the file's unit squared
  double min_angle = 180., max_angle = 0.; // degrees, of triangles with an area
};

Point difference(const Point& p, const Point& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }

double dot(const Point& u, const Point& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

double cross_length(const Point& u, const Point& v)
{
  return std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                    u[0] * v[1] - u[1] * v[0]);
}

Shape shape_of(const internal::Glued_triangles& triangles)
{
  constexpr double degrees = 57.295779513082323;
  Shape shape;
  for(std::size_t f = 0; f < triangles.number_of_triangles(); ++f)
  {
    Point side[3]; // from corner k to corner k + 1
    for(std::size_t k = 0; k < 3; ++k)
      side[k] = difference(triangles.point[triangles.corner[3 * f + (k + 1) % 3]],
                           triangles.point[triangles.corner[3 * f + k]]);
    const double twice_area = cross_length(side[0], side[1]);
    if(twice_area == 0.)
      continue;
    shape.area += twice_area / 2.;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const double angle = degrees * std::atan2(twice_area, -dot(side[k], side[(k + 2) % 3]));
      shape.min_angle = std::min(shape.min_angle, angle);
      shape.max_angle = std::max(shape.max_angle, angle);
    }
  }
  shape.area *= triangles.scale * triangles.scale;
  return shape;
}

// The component of each vertex, whose place among the domain's sites is given.
std::vector<long long> components_of(const internal::Glued_triangles& triangles,
                                     const std::vector<internal::Index>& site)
{
  const std::vector<internal::Index> label = internal::components(triangles).first;
  std::vector<long long> result(site.size());
  std::transform(site.begin(), site.end(), result.begin(),
                 [&](internal::Index s) { return static_cast<long long>(label[s]); });
  return result;
}

// The regions of the picture.
struct Regions
{
  std::vector<long long> labels;
  std::vector<std::uint32_t> triangles; // of a cloud
};

Regions describe_mesh(Job& job)
{
  const Surface& surface = job.surface();
  const Gluing& gluing = surface.gluing;
  const auto glued = internal::glue(surface.file.points, surface.file.corners, gluing.twins);
  job.stage("query");
  const Shape shape = shape_of(glued.triangles);
  const std::size_t faces = surface.file.number_of_polygons();
  auto& result = job.result();
  result["components"] = gluing.components;
  result["boundary_loops"] = gluing.boundary_loops;
  result["genus"] = gluing.genus(faces);
  result["manifold"] = gluing.is_manifold();
  result["area"] = json_number(shape.area);
  const bool has_angles = shape.max_angle > 0.;
  result["min_angle"] = has_angles ? json_number(shape.min_angle) : nullptr;
  result["max_angle"] = has_angles ? json_number(shape.max_angle) : nullptr;
  result["degenerate_faces"] = glued.degenerate;

  job.say("components      " + std::to_string(gluing.components));
  job.say("boundary loops  " + std::to_string(gluing.boundary_loops));
  job.say("genus           " + std::to_string(gluing.genus(faces)));
  job.say(std::string("manifold        ") + (gluing.is_manifold() ? "yes" : "no"));
  if(has_angles)
    job.say("angles          " + readable(shape.min_angle) + " to " + readable(shape.max_angle) +
            " degrees");
  job.say("area            " + readable(shape.area));
  job.say("degenerate      " + std::to_string(glued.degenerate) + " faces");
  if(gluing.components < 2 || job.picture().empty())
    return {};
  return {components_of(glued.triangles, glued.site_of_vertex), {}};
}

// Surfels are joined by arcs: those that no arcs join do not reach each other.
Regions describe_cloud(Job& job)
{
  const Surface_file& file = job.surface().file;
  internal::Surfel_options options;
  options.threads = job.threads();
  const auto surfels = internal::glue_surfels(file.points, file.normals, {}, options);
  job.stage("query");
  const std::size_t components = internal::components(surfels.triangles).second;
  job.result()["components"] = components;
  job.say("components      " + std::to_string(components));
  if(job.picture().empty())
    return {};
  Regions regions = {{}, picture_triangles(surfels)};
  if(components > 1)
    regions.labels = components_of(surfels.triangles, surfels.site_of_surfel);
  return regions;
}

void describe_box(Job& job)
{
  Point low = job.surface().file.points[0], high = low;
  for(const Point& p : job.surface().file.points)
    for(std::size_t c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], p[c]);
      high[c] = std::max(high[c], p[c]);
    }
  job.result()["bounding_box"] = {low, high};
  job.say("bounding box    " + readable(low[0]) + " " + readable(low[1]) + " " + readable(low[2]) +
          " to " + readable(high[0]) + " " + readable(high[1]) + " " + readable(high[2]));
}

struct Shown
{
  std::string property;
  bool has_sides = false;
};

void run_info(Job& job, const Shown& shown)
{
  const std::string& wanted = shown.property;
  if(!wanted.empty() && job.picture().empty())
    throw Usage_error("--property: it is shown in a --picture.");
  if(shown.has_sides && job.picture().empty())
    throw Usage_error("--sides: they are shown in a --picture.");
  const Surface& surface = job.read();
  if(shown.has_sides && !surface.is_mesh())
    throw Usage_error("--sides: points have none.");
  if(!wanted.empty())
    property(surface, wanted);
  job.say(std::string("kind            ") + (surface.is_mesh() ? "mesh" : "cloud"));
  job.say("vertices        " + std::to_string(surface.file.points.size()));
  job.stage("prepare");
  if(surface.is_mesh())
    job.say("faces           " + std::to_string(surface.file.number_of_polygons()));
  Regions regions = surface.is_mesh() ? describe_mesh(job) : describe_cloud(job);
  job.stage("query");
  describe_box(job);

  job.stage("write");
  if(!job.output().empty())
    write_surface_file(job.output(), surface.file);
  job.write_values([&] { return points_text(surface.file.points); });
  if(!job.picture().empty())
  {
    Picture picture{&surface.file, {}, "", regions.labels, {}, {}, regions.triangles};
    for(const auto& [a, b] : surface.file.edges)
      picture.polylines.push_back({surface.file.points[a], surface.file.points[b]});
    if(!wanted.empty())
    {
      picture.values = property(surface, wanted);
      picture.title = wanted;
      picture.labels.clear();
    }
    picture.with_sides = shown.has_sides;
    draw(job.picture(), picture);
  }
  job.finish();
}

} // namespace

void add_info(CLI::App& program)
{
  Command command(program, "info", "sizes, shape and defects; -o converts");
  const auto job = std::make_shared<Job>(command);
  const auto shown = std::make_shared<Shown>();
  command.add("--property", shown->property, "NAME",
              "of the vertices, shown in the picture; else the components are");
  command.add_flag("--sides", shown->has_sides, "show the sides of triangles in the picture");
  command.set_run([job, shown] { run_info(*job, *shown); });
}

} // namespace program
