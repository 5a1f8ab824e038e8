// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "io/write_surface_file.h"
#include "picture/Picture.h"
#include "readers/Scanner.h"
#include "app/commands.h"
#include "io/errors.h"
#include "commands/transport_utilities.h"

#include <algorithm>
#include <cmath>

namespace program {

namespace {

struct Volume_options : Transport_options
{
  bool path = false;
  std::vector<std::string> slices;
  std::size_t resolution = 60;
  std::optional<double> user_tolerance;
};

// A plane orthogonal to a coordinate axis
struct Slice
{
  std::size_t axis;
  double offset;
};

Slice parse_slice(const std::string& text)
{
  const std::size_t axis = std::string("xyz").find(text.substr(0, 1));
  const std::optional<double> offset = text.size() > 2 && text[1] == ','
                                           ? to_number(std::string_view(text).substr(2))
                                           : std::nullopt;
  if(axis > 2 || !offset || !std::isfinite(*offset))
    throw Usage_error("--slice " + printable(text) +
                      ": a slice must be an axis and a number, like z,0.5.");
  return {axis, *offset};
}

// Returns a grid of points on each plane, 10 % larger than the bounding box on each side. Each
// grid cell is divided into two triangles.
Surface_file slice_grid(const std::vector<Slice>& slices, const Surface_file& file,
                        std::size_t resolution)
{
  Point low = file.points[0], high = low;
  for(const Point& p : file.points)
    for(std::size_t c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], p[c]);
      high[c] = std::max(high[c], p[c]);
    }
  double size = 0.;
  for(std::size_t c = 0; c < 3; ++c)
    size = std::max(size, high[c] - low[c]);
  const double margin = 0.1 * size, step = 1.2 * size / static_cast<double>(resolution - 1);
  Surface_file result;
  for(const Slice& slice : slices)
  {
    const std::size_t u = (slice.axis + 1) % 3, v = (slice.axis + 2) % 3;
    const auto number_of_samples = [&](std::size_t c)
    { return static_cast<std::uint32_t>(std::ceil((high[c] - low[c] + 2. * margin) / step)) + 1; };
    const std::uint32_t columns = number_of_samples(u), rows = number_of_samples(v);
    const auto first_index = static_cast<std::uint32_t>(result.points.size());
    for(std::uint32_t j = 0; j < rows; ++j)
      for(std::uint32_t i = 0; i < columns; ++i)
      {
        Point p;
        p[slice.axis] = slice.offset;
        p[u] = low[u] - margin + step * i;
        p[v] = low[v] - margin + step * j;
        result.points.push_back(p);
        if(i + 1 == columns || j + 1 == rows)
          continue;
        const std::uint32_t a = first_index + j * columns + i, b = a + 1, c = a + columns,
                            d = c + 1;
        result.corners.insert(result.corners.end(), {a, b, d, a, d, c});
        for(int k = 0; k < 2; ++k)
          result.polygon_begin.push_back(result.polygon_begin.back() + 3);
      }
  }
  return result;
}

// Returns the intersection of the planes with the surface, as one segment per triangle.
std::vector<std::vector<Point>> slice_outlines(const std::vector<Slice>& slices,
                                               const Surface_file& file)
{
  std::vector<std::vector<Point>> result;
  for(const Slice& slice : slices)
    for(std::size_t f = 0; f < file.corners.size(); f += 3)
    {
      std::vector<Point> segment;
      for(std::size_t k = 0; k < 3; ++k)
      {
        const Point& p = file.points[file.corners[f + k]];
        const Point& q = file.points[file.corners[f + (k + 1) % 3]];
        const double p_offset = p[slice.axis] - slice.offset,
                     q_offset = q[slice.axis] - slice.offset;
        if((p_offset < 0.) == (q_offset < 0.))
          continue;
        const double t = p_offset / (p_offset - q_offset);
        segment.emplace_back();
        for(std::size_t c = 0; c < 3; ++c)
          segment.back()[c] = p[c] + t * (q[c] - p[c]);
      }
      if(segment.size() == 2)
        result.push_back(segment);
    }
  return result;
}

using Metric = GP::Volumetric_metric<Mesh>;

void run_slices(Job& job, const Volume_options& options, const Metric& metric,
                const Kernel::Point_3& from)
{
  const Surface_file& file = job.surface().file;
  std::vector<Slice> slices;
  for(const std::string& text : options.slices)
    slices.push_back(parse_slice(text));
  Surface_file result = slice_grid(slices, file, options.resolution);
  std::vector<Kernel::Point_3> points;
  for(const Point& p : result.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<double> distances;
  double gap = 0.;
  for(const GP::Earth_movers_cost& cost : metric.costs<CGAL::Parallel_tag>(
          from, points,
          GP::parameters::tolerance(options.user_tolerance.value_or(0.02))
              .number_of_threads(job.threads())
              .callback(job.progress_callback("distances on slices"))))
  {
    distances.push_back(cost.value);
    if(cost.upper > 0.)
      gap = std::max(gap, 1. - cost.lower / cost.upper);
  }
  const double largest_distance = *std::max_element(distances.begin(), distances.end());
  job.result()["points"] = points.size();
  job.result()["max"] = json_number(largest_distance);
  job.result()["gap"] = json_number(gap);
  job.print_line("points          " + std::to_string(points.size()));
  job.print_line("farthest        " + rounded_text(largest_distance));

  job.begin_stage("write");
  job.write_values([&] { return number_lines(distances); });
  if(!job.picture().empty())
  {
    Picture picture{&result, distances, "distance"};
    picture.polylines = slice_outlines(slices, file);
    picture.markers = {coordinates(from)};
    draw(job.picture(), picture);
  }
  if(!job.output().empty())
  {
    result.properties["distance"] = distances;
    write_surface_file(job.output(), result, "distance");
  }
}

void run_path(Job& job, const Metric& metric, const Kernel::Point_3& from,
              const Kernel::Point_3& to)
{
  std::vector<Kernel::Point_3> points;
  const bool arrives = metric.write_path(from, to, std::back_inserter(points));
  const std::vector<Point> path = coordinates_of(points);
  double length = 0.;
  for(std::size_t i = 1; i < points.size(); ++i)
    length += std::sqrt(CGAL::squared_distance(points[i - 1], points[i]));
  job.result()["length"] = json_number(length);
  job.result()["points"] = path.size();
  job.result()["arrives"] = arrives;
  job.print_line("length          " + rounded_text(length));
  if(!arrives)
    job.print_warning("the path ends before its target, because the distance does not decrease any "
                      "further");

  job.begin_stage("write");
  job.write_values([&] { return points_text(path); });
  if(!job.picture().empty())
  {
    Picture picture{&job.surface().file};
    picture.is_transparent = true;
    picture.polylines = {path};
    picture.markers = {path.front(), path.back()};
    draw(job.picture(), picture);
  }
  write_polylines(job, {path});
}

void run_volume(Job& job, const Volume_options& options)
{
  const bool is_pair = !options.to.empty();
  if(options.from.empty() || is_pair == !options.slices.empty() || (options.path && !is_pair))
    throw Usage_error(
        "volume: --from is required, and either --to or --slice; --path requires --to.");
  if(options.user_tolerance && !(*options.user_tolerance > 0.))
    throw Usage_error("--tolerance: the tolerance must be positive.");
  const Kernel::Point_3 from = parse_point_3(options.from, "--from");
  const Kernel::Point_3 to = is_pair ? parse_point_3(options.to, "--to") : from;
  for(const std::string& text : options.slices)
    parse_slice(text);
  const Surface& surface =
      job.read(options.path ? std::vector<std::string>{"vtp", "ply", "obj"}
               : is_pair    ? std::vector<std::string>{"ply", "vtp"}
                            : std::vector<std::string>{"ply", "off", "obj", "vtp"});
  if(!surface.is_mesh())
    fail(surface.name, "volume needs a closed mesh, but the input is a cloud");

  job.begin_stage("prepare");
  const Mesh& mesh = surface.domain->mesh();
  std::optional<Metric> metric;
  if(options.refine)
    metric.emplace(mesh, GP::parameters::number_of_refinements(
                             static_cast<unsigned>(std::min<std::size_t>(*options.refine, 30))));
  else
    metric.emplace(mesh);
  job.begin_stage("query");
  if(!is_pair)
    run_slices(job, options, *metric, from);
  else if(options.path)
    run_path(job, *metric, from, to);
  else
  {
    Transport_result result;
    result.potential.resize(surface.file.points.size());
    result.cost = metric->cost(from, to,
                               GP::parameters::tolerance(options.user_tolerance.value_or(1e-3))
                                   .do_bound_from_above(options.bound_above)
                                   .callback(job.progress_callback("transport"))
                                   .potential_map(Value_map<Mesh::Vertex_index>{&result.potential})
                                   .flow_map(vector_map(result.fields["flow"], *surface.domain)));
    report(job, options, result.cost, "distance");
    job.begin_stage("write");
    write_transport(job, result, {});
  }
  job.finish();
}

} // namespace

void add_volume(CLI::App& program)
{
  Command command(program, "volume",
                  "compute distances and paths in space, inside or outside of a closed mesh");
  const auto job = std::make_shared<Job>(command);
  command.describe("--output",
                   "write the result: .ply .vtp; for --path also .obj, for --slice also .off .obj");
  const auto options = std::make_shared<Volume_options>();
  command.add("--from", options->from, "x,y,z", "start point");
  command.add("--to", options->to, "x,y,z", "end point");
  command.add_flag("--path", options->path,
                   "compute a path by gradient descent of the distance, which does not cross the "
                   "surface");
  command.add("--slice", options->slices, "AXIS,OFFSET",
              "instead of --to, compute distances to a grid of points in a plane orthogonal to "
              "x, y or z; can be repeated");
  command
      .add("--resolution", options->resolution, "N",
           "number of grid points along the longest edge of the bounding box, which is "
           "enlarged by 20 %")
      .shows_default()
      .in_range(2., 10000.);
  command.add("--tolerance", options->user_tolerance, "T",
              "maximum gap between lower and upper bound, relative to the upper bound (default "
              "0.001, or 0.02 with --slice)");
  command.add("--refine", options->refine, "N", "number of 1-to-4 refinements, as for emd");
  command.add_flag("--bound-above", options->bound_above,
                   "also compute an upper bound for flows on the surface itself");
  command.set_callback([job, options] { run_volume(*job, *options); });
}

} // namespace program
