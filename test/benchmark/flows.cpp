// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares streamlines with shortest paths between their endpoints, both as traced and after
// shortening. Compares the cost of the assignment of their endpoints with the earth mover's
// distance. Also measures the distance from a point to shrinking balls. Masses are points, or
// Gaussians with a width of a tenth of the distance between them. --quick: fewer lines and models.
#include "Array_surface.h"
#include "clouds.h"
#include "models.h"
#include "report.h"

#include <CGAL/Geodesic_processing/internal/transport/Multilevel_transport_solver.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;
using namespace benchmarks;

// Returns a Gaussian density with standard deviation `width`, from the distances to its center.
Mass_distribution gaussian_mass(const std::vector<double>& distance, const Array_surface& surface,
                                double width)
{
  Mass_distribution result;
  result.density = Vector::Zero(surface.size());
  for(Index i = 0; i < surface.size(); ++i)
    result.density[surface.vertex(i)] = std::exp(-0.5 * std::pow(distance[i] / width, 2.));
  return result;
}

Mass_distribution point_mass(const Array_surface& surface, Index i)
{
  Mass_distribution result;
  result.at_locations = {{surface.at(i), 1.}};
  return result;
}

std::string name_of(bool are_points) { return are_points ? "points" : "Gaussians"; }

double potential(const Transport_result& found, const Surface_arrays& t,
                 const Surface_location& location)
{
  if(location.triangle == none)
    return found.potential[location.vertex];
  double result = 0.;
  for(std::size_t k = 0; k < 3; ++k)
    result += location.barycentric[k] * found.potential[t.corner[3 * location.triangle + k]];
  return result;
}

// Traces and shortens streamlines, and compares their lengths with distance(from, to) between their
// endpoints, in the caller's unit.
template <typename Distance>
void measure_lines(const std::string& name, const std::shared_ptr<const Surface_arrays>& triangles,
                   const Multilevel_transport_solver& solver, const Mass_distribution& before,
                   const Mass_distribution& after, std::size_t lines, Distance distance,
                   Table& table)
{
  const Surface_arrays& t = *triangles;
  Transport_options options;
  options.do_normalize = true;
  const Transport_result found = solver.solve(before, after, options);
  std::vector<Streamline> traced;
  std::vector<std::vector<Surface_location>> shortened_lines;
  const double time = cpu_seconds(
      [&]
      {
        const Streamlines streamlines = solver.streamlines(found);
        for(const Streamline_seed& seed : streamlines.seeds(lines))
          traced.push_back(streamlines(seed));
      });
  const double shortening_time = cpu_seconds(
      [&]
      {
        Line_shortener shorten(triangles);
        for(const Streamline& line : traced)
          shortened_lines.push_back(
              shorten(line.locations, (potential(found, t, line.locations.back()) -
                                       potential(found, t, line.locations.front())) /
                                          t.scale));
      });
  Mean_and_max traced_excess, shortened_excess;
  double cost = 0.;
  std::size_t number_not_arrived = 0, number_too_long = 0;
  for(std::size_t i = 0; i < lines; ++i)
  {
    number_not_arrived += !traced[i].has_arrived;
    const double shortest = distance(shortened_lines[i].front(), shortened_lines[i].back());
    cost += shortest / double(lines);
    if(shortest == 0.)
      continue;
    traced_excess.add(t.scale * polyline_length(t, traced[i].locations) / shortest - 1.);
    shortened_excess.add(t.scale * polyline_length(t, shortened_lines[i]) / shortest - 1.);
    number_too_long += t.scale * polyline_length(t, shortened_lines[i]) > 1.01 * shortest;
  }
  table.add({name, std::to_string(t.number_of_vertices()), name_of(before.density.size() == 0),
             std::to_string(number_not_arrived), traced_excess.percent(2),
             shortened_excess.percent(2),
             std::to_string(number_too_long) + " of " + std::to_string(lines),
             format_fixed(100. * (cost / found.value - 1.), 2), format_fixed(time, 2),
             format_fixed(shortening_time, 2)});
}

void measure_model(const std::string& name, const Mesh& mesh, std::size_t lines, Table& table,
                   Table& balls)
{
  const Array_surface surface(triangulation_of(mesh));
  const Multilevel_transport_solver solver(surface.triangles(),
                                           default_number_of_refinements(surface.t()));
  Window_propagation windows(surface.triangles());
  const Index from = 0, to = surface.size() / 2;
  windows.run({surface.source(from)});
  const std::vector<double> distances_from = surface.distances(windows);
  windows.run({surface.source(to)});
  const std::vector<double> distances_to = surface.distances(windows);
  const double exact = distances_from[to];
  const auto distance = [&](const Surface_location& p, const Surface_location& q)
  {
    windows.run({surface.source(p)});
    return surface.scale() * windows.distance(q);
  };
  measure_lines(name, surface.triangles(), solver, point_mass(surface, from),
                point_mass(surface, to), lines, distance, table);
  measure_lines(name, surface.triangles(), solver,
                gaussian_mass(distances_from, surface, 0.1 * exact),
                gaussian_mass(distances_to, surface, 0.1 * exact), lines, distance, table);

  std::vector<std::string> row = {name};
  for(const double radius : {0.4, 0.2, 0.1, 0.05})
  {
    Mass_distribution ball;
    ball.density = Vector::Zero(surface.size());
    for(Index i = 0; i < surface.size(); ++i)
      if(distances_to[i] <= radius * exact)
        ball.density[surface.vertex(i)] = 1.;
    Transport_options options;
    options.do_normalize = true;
    const Transport_result found = solver.solve(point_mass(surface, from), ball, options);
    row.push_back(format_fixed(100. * (found.value / exact - 1.), 2) + ", " +
                  format_fixed(100. * (radius + (found.upper - found.lower) / exact), 1));
  }
  balls.add(row);
}

void measure_cloud(std::size_t n, std::size_t lines, Table& table)
{
  Cloud cloud;
  for(std::size_t i = 0; i < n; ++i)
    cloud.add(on_spiral(i, n), on_spiral(i, n));
  const Surfel_arrays surfels = build_surfel_arrays(cloud.points, cloud.normals);
  const auto t = std::make_shared<const Surface_arrays>(surfels.arrays);
  const Multilevel_transport_solver solver(t, default_number_of_refinements(*t));
  const auto distance = [&](const Surface_location& p, const Surface_location& q)
  { return great_circle(coordinates(*t, p), coordinates(*t, q)); };
  const std::array<std::size_t, 2> centers = {n / 10, n / 2};
  std::array<Mass_distribution, 2> points, blobs;
  for(std::size_t k = 0; k < 2; ++k)
  {
    points[k].at_locations = {{{none, surfels.internal_vertex[centers[k]], {}}, 1.}};
    blobs[k].density = Vector::Zero(Eigen::Index(n));
    for(std::size_t i = 0; i < n; ++i)
    {
      const double d = great_circle(cloud.points[i], cloud.points[centers[k]]) / 0.15;
      blobs[k].density[surfels.internal_vertex[i]] = std::exp(-0.5 * d * d);
    }
  }
  measure_lines("surfels of a sphere", t, solver, points[0], points[1], lines, distance, table);
  measure_lines("surfels of a sphere", t, solver, blobs[0], blobs[1], lines, distance, table);
}

} // namespace

int main(int argc, char* argv[])
{
  const bool quick = argc > 1 && std::string(argv[1]) == "--quick";
  Table table("streamlines", {"model", "vertices", "masses", "incomplete",
                              "excess length % (mean / max)", "shortened %", "more than 1 %",
                              "assignment excess %", "tracing [s]", "shortening [s]"}),
      balls("balls", {"model", "radius 0.4 d: error %, bound %", "0.2 d", "0.1 d", "0.05 d"});
  std::vector<std::string> names = {"fandisk_6k5", "kitten_9k"};
  if(!quick)
    names.insert(names.end(), {"camel_10k", "nefertiti_35k", "bunny_37k"});
  const std::size_t lines = quick ? 20 : 200;
  for(const std::string& name : names)
    if(const auto mesh = load_model(name))
      measure_model(name, *mesh, lines, table, balls);
  measure_cloud(5000, lines, table);
  table.print();
  std::printf("Targets: shortened lines at most 1 %% longer than the shortest path between their "
              "endpoints; excess\nof the assignment at most 2 %%.\n\n");
  balls.print();
}
