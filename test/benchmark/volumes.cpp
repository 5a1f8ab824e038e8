// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances between points in space: how precise coordinates are, what slices take and how wrong they are, and
// whether paths stay inside.  --quick: small slices.
#include "Glued_surface.h"
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

// Empty when the model is not there.
Triangulation model(const std::string& name)
{
  return read_off(
      (std::filesystem::path(GEODESIC_PROCESSING_DATA) / "meshes" / (name + ".off")).string());
}

struct Box
{
  Spatial low, high;

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
  Spatial random_point(std::mt19937& random, double enlarged = 1.) const
  {
    std::uniform_real_distribution<double> share(0.5 - 0.5 * enlarged, 0.5 + 0.5 * enlarged);
    Spatial result;
    for(std::size_t c = 0; c < 3; ++c)
      result[c] = low[c] + share(random) * (high[c] - low[c]);
    return result;
  }
  // So many times so many on the plane in the middle across the last axis, some outside.
  std::vector<Spatial> slice(int n) const
  {
    std::vector<Spatial> result;
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

void coordinates_row(const std::string& name, const Triangulation& shape, Table& table)
{
  const Glued_surface surface(shape);
  const Mean_value_coordinates coordinates(surface.triangles());
  const Box box(shape);
  std::mt19937 random(1);
  std::vector<std::string> row = {name, std::to_string(surface.size())};
  constexpr int number = 100;
  for(const double enlarged : {1., 20.})
  {
    double error = 0.;
    const double time = seconds(
        [&]
        {
          for(int i = 0; i < number; ++i)
          {
            const Spatial point = box.random_point(random, enlarged);
            const Vector found = coordinates(point);
            Spatial sum = {0., 0., 0.};
            for(Index k = 0; k < surface.size(); ++k)
              sum = sum + found[surface.site(k)] * surface.point(k);
            error = std::max(error, norm(sum - point) / box.size());
          }
        });
    row.push_back(digits(error));
    if(enlarged == 1.)
      row.push_back(benchmarks::number(1e3 * time / number, 2));
  }
  table.add(row);
}

void slice_row(const std::string& name, const Triangulation& shape, int resolution, Table& table)
{
  const Glued_surface surface(shape);
  const Volumetric_distances distances(surface.triangles(), 0);
  const std::vector<Spatial> points = Box(shape).slice(resolution);
  const Spatial from = points[std::size_t(resolution / 3 * resolution + resolution / 2)];
  Volumetric_options options;
  options.threads = 2;
  std::vector<Volumetric_bounds> found;
  double watch = 0.;
  const double processor = seconds(
      [&] {
        watch = seconds_on_a_watch([&] { found = distances.one_to_many(from, points, options); });
      });
  double gap = 0., error = 0.;
  std::size_t solved = 0;
  Earth_movers_options precise;
  precise.transport.tolerance = 1e-4;
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
             benchmarks::number(processor, 0), benchmarks::number(watch, 0), std::to_string(solved),
             benchmarks::number(100. * gap, 2), benchmarks::number(100. * error, 2)});
}

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 to_point(const Spatial& p) { return {p[0], p[1], p[2]}; }

std::size_t crossings(const std::vector<Spatial>& path, const Triangulation& shape)
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

// Between random pairs of points inside.
void path_row(const std::string& name, const Triangulation& shape, int pairs, Table& table)
{
  const Glued_surface surface(shape);
  const Volumetric_distances distances(surface.triangles(), 0);
  const Box box(shape);
  std::mt19937 random(3);
  const Spatial outside = box.high + (box.high - box.low);
  const auto inside = [&]
  {
    for(;;)
      if(const Spatial p = box.random_point(random);
         !distances.coordinates().are_on_one_side(p, outside))
        return p;
  };
  std::size_t arrived = 0, crossed = 0, solutions = 0;
  double longer = 0.;
  const double time = seconds(
      [&]
      {
        for(int i = 0; i < pairs; ++i)
        {
          const Spatial from = inside(), to = inside();
          const Volumetric_path path = distances.path(from, to, 1000);
          arrived += path.arrives;
          solutions += path.solutions;
          crossed += crossings(path.points, shape);
          double length = 0.;
          for(std::size_t k = 1; k < path.points.size(); ++k)
            length += norm(path.points[k] - path.points[k - 1]);
          longer = std::max(longer, length / norm(to - from));
        }
      });
  table.add({name, std::to_string(surface.size()), std::to_string(pairs), std::to_string(arrived),
             std::to_string(crossed), benchmarks::number(longer, 2),
             std::to_string(solutions / std::size_t(pairs)), benchmarks::number(time / pairs, 1)});
}

} // namespace

int main(int argc, char* argv[])
{
  const bool quick = argc > 1 && std::string(argv[1]) == "--quick";
  const std::vector<std::pair<std::string, Triangulation>> shapes = {
      {"icosphere 5", icosphere(5)}, {"turbine", model("turbine_9k")}};

  Table coordinates({"coordinates", "vertices", "linear error in the box, diameters", "ms each",
                     "in 20 times the box"});
  for(const auto& [name, shape] : shapes)
    if(!shape.points.empty())
      coordinates_row(name, shape, coordinates);
  coordinates.print();
  std::printf("To reach: 1e-9.\n\n");

  Table slices({"a slice, 2 threads", "vertices", "points", "processor s", "watch s", "solved",
                "largest gap %", "largest error %"});
  for(const auto& [name, shape] : shapes)
    if(!shape.points.empty())
      slice_row(name, shape, quick ? 20 : 100, slices);
  slices.print();
  std::printf("To reach: 60 s on two cores, 1 %%.\n\n");

  Table paths({"paths inside", "vertices", "pairs", "arrive", "segments that cross",
               "longest over straight", "solutions each", "s each"});
  for(const char* const name : {"elephant_2k8", "knot1_3k", "femur_3k9", "cow_2k9"})
    if(const Triangulation shape = model(name); !shape.points.empty())
      path_row(name, shape, quick ? 2 : 10, paths);
  paths.print();
  std::printf("To reach: none crosses.\n");
}
