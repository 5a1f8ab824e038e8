// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the cost of farthest point sampling in units of one front over the whole mesh.
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

std::optional<Mesh> subdivided_model(const std::string& name, unsigned times)
{
  auto mesh = load_model(name);
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
  // Fronts and samplings take turns, so that other load on the machine affects both equally.
  for(int round = 0; round < 3; ++round)
  {
    fronts_alone.push_back(cpu_seconds([&] { Solver(domain).compute(sources[round]); }));
    samplings_alone.push_back(cpu_seconds([&] { sample(number_of_samples); }));
    Solver solver(domain);
    for(const Vertex source : sources)
      fronts.push_back(cpu_seconds([&] { solver.compute(source); }));
    tenths.push_back(cpu_seconds([&] { sample(number_of_samples / 10); }));
    samplings.push_back(cpu_seconds([&] { sample(number_of_samples); }));
  }
  const double front = median(fronts), all = median(samplings), tenth = median(tenths);
  const double samples_per_tenth = double(number_of_samples) / 10.; // number in the first tenth
  table.add({name, std::to_string(num_vertices(mesh)), method, std::to_string(samples.size()),
             format_fixed(1000. * front, 1), format_fixed(all, 3), format_fixed(all / front, 1),
             format_fixed(median(samplings_alone) / median(fronts_alone), 1),
             format_significant(1000. * tenth / samples_per_tenth),
             format_significant(1000. * (all - tenth) / (9. * samples_per_tenth)),
             format_significant(radii.back() / mean_edge_length(mesh))});
}

} // namespace

// sampling [--quick]
int main(int argc, char* argv[])
{
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  std::printf(
      "Farthest point sampling: median processor times of one thread over three rounds\n\n");
  std::vector<Task> tasks = {
      {"icosphere 5", [] { return icosphere(5); }, 200},
      {"bunny_37k", [] { return load_model("bunny_37k"); }, 200},
  };
  if(!quick)
    tasks = {
        {"icosphere 7", [] { return icosphere(7); }, 5000},
        {"bunny_37k, refined once", [] { return subdivided_model("bunny_37k", 1); }, 5000},
        {"mni152_grey_matter_533k", [] { return load_model("mni152_grey_matter_533k"); }, 1000},
    };
  Table table("samples",
              {"mesh", "vertices", "method", "samples", "one front [ms]", "all samples [s]",
               "ratio", "ratio with set-up", "per sample, first tenth [ms]",
               "per sample, others [ms]", "covering radius [edges]"});
  for(const Task& task : tasks)
    if(const auto mesh = task.make())
    {
      add<GP::Euclidean_front>(table, task.name, *mesh, task.samples, "Euclidean_front");
      add<GP::Fast_marching>(table, task.name, *mesh, task.samples, "Fast_marching");
    }
  table.print();
  std::printf("Targets: a ratio of at most 8 for 1,000 samples of half a million vertices and for "
              "5,000 of 134,000;\nother samples cheaper than the first tenth.\n");
}
