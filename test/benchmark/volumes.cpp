// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures distances between points in space: the precision of mean value coordinates, the time and
// error of distances on planar slices, and intersections of paths with the surface. --quick: small
// slices.
#include "Array_surface.h"
#include "report.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/transport/volumetric.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;
using namespace benchmarks;

// Reads a model of the data folder. Returns an empty triangulation if the file is missing.
Triangulation load_model(const std::string& name)
{
  return read_off(
      (std::filesystem::path(GEODESIC_PROCESSING_DATA) / "meshes" / (name + ".off")).string());
}

struct Box
{
  Vec3 low, high;

  explicit Box(const Triangulation& shape) : low(shape.points[0]), high(low)
  {
    for(const Point& p : shape.points)
      for(std::size_t c = 0; c < 3; ++c)
      {
        low[c] = std::min(low[c], p[c]);
        high[c] = std::max(high[c], p[c]);
      }
  }
  double size() const { return norm(high - low); }
  Vec3 random_point(std::mt19937& random, double scale = 1.) const
  {
    std::uniform_real_distribution<double> uniform(0.5 - 0.5 * scale, 0.5 + 0.5 * scale);
    Vec3 result;
    for(std::size_t c = 0; c < 3; ++c)
      result[c] = low[c] + uniform(random) * (high[c] - low[c]);
    return result;
  }
  // Returns an n x n grid of points on the central plane perpendicular to the last axis. The grid
  // exceeds the box, so that some points are outside.
  std::vector<Vec3> slice(int n) const
  {
    std::vector<Vec3> result;
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < n; ++j)
      {
        const auto at = [&](std::size_t c, int k)
        { return low[c] + (1.1 * (k + 0.5) / n - 0.05) * (high[c] - low[c]); };
        result.push_back({at(0, i), at(1, j), 0.501 * low[2] + 0.499 * high[2]});
      }
    return result;
  }
};

void add_coordinates_row(const std::string& name, const Triangulation& shape, Table& table)
{
  const Array_surface surface(shape);
  const Mean_value_coordinates coordinates(surface.triangles());
  const Box box(shape);
  std::mt19937 random(1);
  std::vector<std::string> row = {name, std::to_string(surface.size())};
  constexpr int number_of_points = 100;
  for(const double scale : {1., 20.})
  {
    double error = 0.;
    const double time = cpu_seconds(
        [&]
        {
          for(int i = 0; i < number_of_points; ++i)
          {
            const Vec3 point = box.random_point(random, scale);
            const Vector found = coordinates(point);
            Vec3 sum = {0., 0., 0.};
            for(Index k = 0; k < surface.size(); ++k)
              sum = sum + found[surface.vertex(k)] * surface.point(k);
            error = std::max(error, norm(sum - point) / box.size());
          }
        });
    row.push_back(format_significant(error));
    if(scale == 1.)
      row.push_back(benchmarks::format_fixed(1e3 * time / number_of_points, 2));
  }
  table.add(row);
}

void add_slice_row(const std::string& name, const Triangulation& shape, int resolution,
                   Table& table)
{
  const Array_surface surface(shape);
  const Volumetric_distances distances(surface.triangles(), 0);
  const std::vector<Vec3> points = Box(shape).slice(resolution);
  const Vec3 from = points[std::size_t(resolution / 3 * resolution + resolution / 2)];
  Volumetric_options options;
  options.number_of_threads = 2;
  std::vector<Volumetric_bounds> found;
  double watch = 0.;
  const double processor = cpu_seconds(
      [&] { watch = wall_seconds([&] { found = distances.one_to_many(from, points, options); }); });
  double gap = 0., error = 0.;
  std::size_t solved = 0;
  Transport_options precise;
  precise.tolerance = 1e-4;
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    if(found[i].upper == 0.)
      continue;
    gap = std::max(gap, 1. - found[i].lower / found[i].upper);
    solved += found[i].is_solved;
    if(i % (points.size() / 37) == 5)
    {
      const double value = distances.cost(from, points[i], precise).value;
      error = std::max(error, std::abs(0.5 * (found[i].lower + found[i].upper) / value - 1.));
    }
  }
  table.add({name, std::to_string(surface.size()), std::to_string(points.size()),
             benchmarks::format_fixed(processor, 0), benchmarks::format_fixed(watch, 0),
             std::to_string(solved), benchmarks::format_fixed(100. * gap, 2),
             benchmarks::format_fixed(100. * error, 2)});
}

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 to_point(const Vec3& p) { return {p[0], p[1], p[2]}; }

std::size_t count_intersections(const std::vector<Vec3>& path, const Triangulation& shape)
{
  std::vector<Kernel::Triangle_3> triangles;
  for(std::size_t f = 0; f < shape.corners.size(); f += 3)
    triangles.emplace_back(to_point(shape.points[shape.corners[f]]),
                           to_point(shape.points[shape.corners[f + 1]]),
                           to_point(shape.points[shape.corners[f + 2]]));
  std::size_t result = 0;
  for(std::size_t i = 1; i < path.size(); ++i)
  {
    if(path[i - 1] == path[i])
      continue;
    const Kernel::Segment_3 segment(to_point(path[i - 1]), to_point(path[i]));
    result +=
        std::any_of(triangles.begin(), triangles.end(),
                    [&](const auto& triangle) { return CGAL::do_intersect(segment, triangle); });
  }
  return result;
}

// Measures paths between random pairs of points inside the shape.
void add_path_row(const std::string& name, const Triangulation& shape, int pairs, Table& table)
{
  const Array_surface surface(shape);
  const Volumetric_distances distances(surface.triangles(), 0);
  const Mean_value_coordinates coordinates(surface.triangles());
  const Box box(shape);
  std::mt19937 random(3);
  const Vec3 outside = box.high + (box.high - box.low);
  const auto inside = [&]
  {
    for(;;)
      if(const Vec3 p = box.random_point(random); !coordinates.are_on_same_side(p, outside))
        return p;
  };
  std::size_t arrived = 0, number_of_intersections = 0, solutions = 0;
  double max_length_ratio = 0.;
  const double time = cpu_seconds(
      [&]
      {
        for(int i = 0; i < pairs; ++i)
        {
          const Vec3 from = inside(), to = inside();
          const Volumetric_path path = distances.path(from, to, 1000);
          arrived += path.has_arrived;
          solutions += path.number_of_solutions;
          number_of_intersections += count_intersections(path.points, shape);
          double length = 0.;
          for(std::size_t k = 1; k < path.points.size(); ++k)
            length += norm(path.points[k] - path.points[k - 1]);
          max_length_ratio = std::max(max_length_ratio, length / norm(to - from));
        }
      });
  table.add({name, std::to_string(surface.size()), std::to_string(pairs), std::to_string(arrived),
             std::to_string(number_of_intersections), benchmarks::format_fixed(max_length_ratio, 2),
             std::to_string(solutions / std::size_t(pairs)),
             benchmarks::format_fixed(time / pairs, 1)});
}

} // namespace

int main(int argc, char* argv[])
{
  const bool quick = argc > 1 && std::string(argv[1]) == "--quick";
  const std::vector<std::pair<std::string, Triangulation>> shapes = {
      {"icosphere 5", icosphere(5)}, {"turbine", load_model("turbine_9k")}};

  Table coordinates("coordinates",
                    {"coordinates", "vertices", "linear error [diagonals]", "time per point [ms]",
                     "linear error in a box of 20 times the size"});
  for(const auto& [name, shape] : shapes)
    if(!shape.points.empty())
      add_coordinates_row(name, shape, coordinates);
  coordinates.print();
  std::printf("Target: 1e-9.\n\n");

  Table slices("slices", {"slice, 2 threads", "vertices", "points", "processor [s]",
                          "wall-clock [s]", "solved", "maximum gap %", "maximum error %"});
  for(const auto& [name, shape] : shapes)
    if(!shape.points.empty())
      add_slice_row(name, shape, quick ? 20 : 100, slices);
  slices.print();
  std::printf("Targets: 60 s on two cores, 1 %%.\n\n");

  Table paths("paths",
              {"paths inside", "vertices", "pairs", "complete paths", "intersecting segments",
               "maximum length / straight line", "solutions per path", "time per path [s]"});
  for(const char* const name : {"elephant_2k8", "knot1_3k", "femur_3k9", "cow_2k9"})
    if(const Triangulation shape = load_model(name); !shape.points.empty())
      add_path_row(name, shape, quick ? 2 : 10, paths);
  paths.print();
  std::printf("Target: no intersections.\n");
}
