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

#include <CGAL/Geodesic_processing/internal/Earth_movers.h>
#include <CGAL/Geodesic_processing/internal/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/path_locations.h>
#include <CGAL/Geodesic_processing/internal/path_to_sources.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;
using namespace benchmarks;

struct Sum
{
  double mean = 0., largest = 0.;
  std::size_t number = 0;

  void add(double x)
  {
    mean += (x - mean) / double(++number);
    largest = std::max(largest, x);
  }
  std::string percent() const
  {
    return benchmarks::number(100. * mean, 2) + " / " + benchmarks::number(100. * largest, 2);
  }
};

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

void measure(const std::string& name, const Mesh& mesh, std::size_t lines, Table& table)
{
  const Glued_surface surface(triangulation_of(mesh));
  const Earth_movers kernel(surface.triangles(), usual_refinements(surface.t()));
  Window_propagation windows(surface.triangles());
  const Index from = 0;
  windows.run({surface.source(from)});
  const std::vector<double> near_from = surface.distances(windows);
  const Index to = surface.size() / 2;
  windows.run({surface.source(to)});
  const std::vector<double> near_to = surface.distances(windows);
  const double exact = near_from[to];

  for(const bool are_points : {true, false})
  {
    Earth_movers_options options;
    options.do_normalize = true;
    const Mass_distribution before = are_points ? point(surface, from)
                                                : blob(near_from, surface, 0.1 * exact),
                            after = are_points ? point(surface, to)
                                               : blob(near_to, surface, 0.1 * exact);
    const Earth_movers_result found = kernel.solve(before, after, options);
    std::vector<Streamline> traced;
    Sum excess, taut;
    double cost = 0., rough = 0.;
    std::size_t lost = 0;
    const double time = seconds(
        [&]
        {
          const Streamlines streamlines = kernel.streamlines(found);
          for(const Grain& grain : streamlines.grains(lines))
            traced.push_back(streamlines(grain));
        });
    for(const Streamline& line : traced)
    {
      lost += !line.has_arrived;
      windows.run({surface.source(line.locations.front())});
      const double least = surface.scale() * windows.distance(line.locations.back());
      const double length = surface.scale() * path_length(surface.t(), line.locations);
      const double pulled =
          surface.scale() *
          path_length(surface.t(), shortened(surface.t(), line.locations));
      cost += least / double(lines);
      rough += length / double(lines);
      if(least == 0.)
        continue;
      excess.add(length / least - 1.);
      taut.add(pulled / least - 1.);
    }
    table.add({name, std::to_string(surface.size()), are_points ? "points" : "blobs",
               std::to_string(lost), excess.percent(), taut.percent(),
               number(100. * (cost / found.value - 1.), 2),
               number(100. * (rough / found.value - 1.), 2), number(time, 2)});
  }
}

} // namespace

int main(int argc, char* argv[])
{
  const bool quick = argc > 1 && std::string(argv[1]) == "--quick";
  Table table({"model", "vertices", "masses", "lines lost", "longer as traced % (mean / largest)",
               "pulled taut %", "assignment above value %", "lines above value %", "s"});
  std::vector<std::string> names = {"fandisk_6k5", "kitten_9k"};
  if(!quick)
    names.insert(names.end(), {"camel_10k", "bunny_37k"});
  for(const std::string& name : names)
    if(const auto mesh = model(name))
      measure(name, *mesh, quick ? 20 : 100, table);
  table.print();
}
