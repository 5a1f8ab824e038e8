// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What do farthest points cost, in fronts over the whole mesh?
#include <CGAL/Geodesic_processing.h>

#include "models.h"
#include "report.h"

#include <cstring>
#include <functional>
#include <iterator>

namespace {

using namespace benchmarks;
namespace GP = CGAL::Geodesic_processing;

struct Task
{
  std::string name;
  std::function<std::optional<Mesh>()> make;
  std::size_t samples;
};

std::optional<Mesh> cut(const std::string& name, unsigned times)
{
  auto mesh = model(name);
  for(unsigned i = 0; mesh && i < times; ++i)
    mesh = refined(*mesh);
  return mesh;
}

template <typename Method>
void add(Table& table, const std::string& name, const Mesh& mesh, std::size_t number_of_samples,
         const std::string& method)
{
  const auto domain = GP::make_domain(mesh);
  using Solver = GP::Geodesic_distance_solver<Mesh, Method>;
  const auto sources = three_sources(num_vertices(mesh));
  std::vector<double> fronts, samplings, tenths, fronts_alone, samplings_alone;
  std::vector<GP::Location<Mesh>> samples;
  std::vector<double> radii;
  const auto sample = [&](std::size_t number)
  {
    samples.clear();
    radii.clear();
    GP::farthest_point_sampling<Method>(
        domain, number, std::back_inserter(samples),
        GP::parameters::covering_radius_output(std::back_inserter(radii)));
  };
  // In turns, so that whatever else the machine does falls on all alike.
  for(int round = 0; round < 3; ++round)
  {
    fronts_alone.push_back(seconds([&] { Solver(domain).compute(sources[round]); }));
    samplings_alone.push_back(seconds([&] { sample(number_of_samples); }));
    Solver solver(domain);
    for(const Vertex source : sources)
      fronts.push_back(seconds([&] { solver.compute(source); }));
    tenths.push_back(seconds([&] { sample(number_of_samples / 10); }));
    samplings.push_back(seconds([&] { sample(number_of_samples); }));
  }
  const double front = median(fronts), all = median(samplings), tenth = median(tenths);
  const double each = double(number_of_samples) / 10.; // of the first tenth
  table.add({name, std::to_string(num_vertices(mesh)), method, std::to_string(samples.size()),
             number(1000. * front, 1), number(all, 3), number(all / front, 1),
             number(median(samplings_alone) / median(fronts_alone), 1),
             digits(1000. * tenth / each), digits(1000. * (all - tenth) / (9. * each)),
             digits(radii.back() / mean_edge(mesh))});
}

} // namespace

// sampling [--quick]
int main(int argc, char* argv[])
{
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  std::printf("Farthest points: processor time of one thread, medians of three rounds.\n\n");
  std::vector<Task> tasks = {
      {"icosphere 5", [] { return icosphere(5); }, 200},
      {"bunny_37k", [] { return model("bunny_37k"); }, 200},
  };
  if(!quick)
    tasks = {
        {"icosphere 7", [] { return icosphere(7); }, 5000},
        {"bunny_37k once", [] { return cut("bunny_37k", 1); }, 5000},
        {"mni152_grey_matter_533k", [] { return model("mni152_grey_matter_533k"); }, 1000},
    };
  Table table({"mesh", "vertices", "method", "samples", "one front [ms]", "all samples [s]",
               "in fronts", "alone", "one of the first tenth [ms]", "one of the rest [ms]",
               "covering radius [edges]"});
  for(const Task& task : tasks)
    if(const auto mesh = task.make())
    {
      add<GP::Euclidean_front>(table, task.name, *mesh, task.samples, "Euclidean_front");
      add<GP::Fast_marching>(table, task.name, *mesh, task.samples, "Fast_marching");
    }
  table.print();
  std::printf("Bar: at most 8 fronts for 1,000 samples of half a million vertices and for 5,000 of "
              "134,000;\none of the rest cheaper than one of the first tenth.\n");
}
