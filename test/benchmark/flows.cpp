// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines of flows: how much longer they are than the shortest way between their ends, as they are traced and
// pulled taut, and what the assignment of their ends costs beside the earth mover's distance; and the
// distance from a point to a ball that shrinks.  Masses are points, or Gaussians of a tenth of the distance
// between them.  --quick: fewer lines and models.
#include "Glued_surface.h"
#include "clouds.h"
#include "models.h"
#include "report.h"

#include <CGAL/Geodesic_processing/internal/transport/Earth_movers.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfels.h>

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

// A density that falls off from a place, in the distances given.
Mass_distribution blob(const std::vector<double>& distance, const Glued_surface& surface,
                       double width)
{
  Mass_distribution result;
  result.density = Vector::Zero(surface.size());
  for(Index i = 0; i < surface.size(); ++i)
    result.density[surface.site(i)] = std::exp(-0.5 * std::pow(distance[i] / width, 2.));
  return result;
}

Mass_distribution point(const Glued_surface& surface, Index i)
{
  Mass_distribution result;
  result.at_locations = {{surface.at(i), 1.}};
  return result;
}

std::string name_of(bool are_points) { return are_points ? "points" : "blobs"; }

double potential(const Earth_movers_result& found, const Glued_triangles& t, const Location& place)
{
  if(place.triangle == none)
    return found.potential[place.site];
  double result = 0.;
  for(std::size_t k = 0; k < 3; ++k)
    result += place.barycentric[k] * found.potential[t.corner[3 * place.triangle + k]];
  return result;
}

// Lines, and what they are beside the shortest ways between their ends: distance(from, to), in the
// caller's unit.
template <typename Distance>
void measure_lines(const std::string& name, const std::shared_ptr<const Glued_triangles>& triangles,
                   const Earth_movers& kernel, const Mass_distribution& before,
                   const Mass_distribution& after, std::size_t lines, Distance distance,
                   Table& table)
{
  const Glued_triangles& t = *triangles;
  Earth_movers_options options;
  options.do_normalize = true;
  const Earth_movers_result found = kernel.solve(before, after, options);
  std::vector<Streamline> traced;
  std::vector<std::vector<Location>> taut;
  const double time = seconds(
      [&]
      {
        const Streamlines streamlines = kernel.streamlines(found);
        for(const Grain& grain : streamlines.grains(lines))
          traced.push_back(streamlines(grain));
      });
  const double pulling = seconds(
      [&]
      {
        Line_shortener shorten(triangles);
        for(const Streamline& line : traced)
          taut.push_back(shorten(line.locations, (potential(found, t, line.locations.back()) -
                                                  potential(found, t, line.locations.front())) /
                                                     t.scale));
      });
  Spread as_traced, pulled;
  double cost = 0.;
  std::size_t lost = 0, long_ones = 0;
  for(std::size_t i = 0; i < lines; ++i)
  {
    lost += !traced[i].has_arrived;
    const double least = distance(taut[i].front(), taut[i].back());
    cost += least / double(lines);
    if(least == 0.)
      continue;
    as_traced.add(t.scale * polyline_length(t, traced[i].locations) / least - 1.);
    pulled.add(t.scale * polyline_length(t, taut[i]) / least - 1.);
    long_ones += t.scale * polyline_length(t, taut[i]) > 1.01 * least;
  }
  table.add({name, std::to_string(t.number_of_sites()), name_of(before.density.size() == 0),
             std::to_string(lost), as_traced.percent(2), pulled.percent(2),
             std::to_string(long_ones) + " of " + std::to_string(lines),
             number(100. * (cost / found.value - 1.), 2), number(time, 2), number(pulling, 2)});
}

void measure(const std::string& name, const Mesh& mesh, std::size_t lines, Table& table,
             Table& balls)
{
  const Glued_surface surface(triangulation_of(mesh));
  const Earth_movers kernel(surface.triangles(), usual_refinements(surface.t()));
  Window_propagation windows(surface.triangles());
  const Index from = 0, to = surface.size() / 2;
  windows.run({surface.source(from)});
  const std::vector<double> near_from = surface.distances(windows);
  windows.run({surface.source(to)});
  const std::vector<double> near_to = surface.distances(windows);
  const double exact = near_from[to];
  const auto distance = [&](const Location& p, const Location& q)
  {
    windows.run({surface.source(p)});
    return surface.scale() * windows.distance(q);
  };
  measure_lines(name, surface.triangles(), kernel, point(surface, from), point(surface, to), lines,
                distance, table);
  measure_lines(name, surface.triangles(), kernel, blob(near_from, surface, 0.1 * exact),
                blob(near_to, surface, 0.1 * exact), lines, distance, table);

  std::vector<std::string> row = {name};
  for(const double radius : {0.4, 0.2, 0.1, 0.05})
  {
    Mass_distribution ball;
    ball.density = Vector::Zero(surface.size());
    for(Index i = 0; i < surface.size(); ++i)
      if(near_to[i] <= radius * exact)
        ball.density[surface.site(i)] = 1.;
    Earth_movers_options options;
    options.do_normalize = true;
    const Earth_movers_result found = kernel.solve(point(surface, from), ball, options);
    row.push_back(number(100. * (found.value / exact - 1.), 2) + " in " +
                  number(100. * (radius + (found.upper - found.lower) / exact), 1));
  }
  balls.add(row);
}

void measure_cloud(std::size_t n, std::size_t lines, Table& table)
{
  Cloud cloud;
  for(std::size_t i = 0; i < n; ++i)
    cloud.add(on_spiral(i, n), on_spiral(i, n));
  const Glued_surfels surfels = glue_surfels(cloud.points, cloud.normals);
  const auto t = std::make_shared<const Glued_triangles>(surfels.triangles);
  const Earth_movers kernel(t, usual_refinements(*t));
  const auto distance = [&](const Location& p, const Location& q)
  { return great_circle(coordinates(*t, p), coordinates(*t, q)); };
  const std::array<std::size_t, 2> middle = {n / 10, n / 2};
  std::array<Mass_distribution, 2> points, blobs;
  for(std::size_t side = 0; side < 2; ++side)
  {
    points[side].at_locations = {{{none, surfels.site_of_surfel[middle[side]], {}}, 1.}};
    blobs[side].density = Vector::Zero(Eigen::Index(n));
    for(std::size_t i = 0; i < n; ++i)
    {
      const double d = great_circle(cloud.points[i], cloud.points[middle[side]]) / 0.15;
      blobs[side].density[surfels.site_of_surfel[i]] = std::exp(-0.5 * d * d);
    }
  }
  measure_lines("surfels of a sphere", t, kernel, points[0], points[1], lines, distance, table);
  measure_lines("surfels of a sphere", t, kernel, blobs[0], blobs[1], lines, distance, table);
}

} // namespace

int main(int argc, char* argv[])
{
  const bool quick = argc > 1 && std::string(argv[1]) == "--quick";
  Table table({"model", "sites", "masses", "do not arrive", "longer as traced % (mean / largest)",
               "pulled taut %", "by more than 1 %", "assignment above value %", "to trace s",
               "to pull s"}),
      balls({"model", "radius 0.4 d: off d by %, of at most", "0.2 d", "0.1 d", "0.05 d"});
  std::vector<std::string> names = {"fandisk_6k5", "kitten_9k"};
  if(!quick)
    names.insert(names.end(), {"camel_10k", "nefertiti_35k", "bunny_37k"});
  const std::size_t lines = quick ? 20 : 200;
  for(const std::string& name : names)
    if(const auto mesh = model(name))
      measure(name, *mesh, lines, table, balls);
  measure_cloud(5000, lines, table);
  table.print();
  std::printf(
      "To reach: lines no more than 1 %% longer than the shortest way between their ends; an "
      "assignment within 2 %%.\n\n");
  balls.print();
}
