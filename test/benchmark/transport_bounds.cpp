// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares earth mover's distances with exact distances between random pairs of vertices, on all
// models of 2,500 to 40,000 vertices. Between surfels of a sphere, compares them with great
// circles. --quick: one pair per model; --refine N: refine surfaces N times instead of by default.
#include "Array_surface.h"
#include "clouds.h"
#include "models.h"
#include "report.h"

#include <CGAL/Geodesic_processing/internal/transport/Multilevel_transport_solver.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;
using namespace benchmarks;

std::set<std::string> medium_model_names()
{
  std::set<std::string> result;
  const std::filesystem::path folder = std::filesystem::path(GEODESIC_PROCESSING_DATA) / "meshes";
  if(exists(folder))
    for(const auto& entry : std::filesystem::directory_iterator(folder))
      result.insert(entry.path().stem().string());
  return result;
}

Cloud spiral_sphere(std::size_t n)
{
  Cloud result;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double z = 1. - (2. * double(i) + 1.) / double(n), r = std::sqrt(1. - z * z);
    const double turn = pi * (3. - std::sqrt(5.)) * double(i);
    const Vec3 p = {r * std::cos(turn), r * std::sin(turn), z};
    result.add(p, p);
  }
  return result;
}

// Measures random pairs of surfels at a distance of at least 0.3.
void measure_cloud(const std::string& name, const Cloud& clean, double noise, std::size_t pairs,
                   std::optional<unsigned> refinements, Table& table)
{
  Cloud cloud = clean;
  std::mt19937 random;
  std::normal_distribution<double> normal;
  for(Vec3& p : cloud.points)
    p = (1. + noise * normal(random)) * p;
  const Surfel_arrays surfels = build_surfel_arrays(cloud.points, cloud.normals);
  const Multilevel_transport_solver solver(
      std::make_shared<const Surface_arrays>(surfels.arrays),
      refinements.value_or(default_number_of_refinements(surfels.arrays)));
  Mean_and_max error, estimate;
  while(error.count < pairs)
  {
    const std::size_t from = random() % cloud.size(), to = random() % cloud.size();
    const double exact = great_circle(clean.points[from], clean.points[to]);
    if(exact < 0.3)
      continue;
    Mass_distribution before, after;
    before.at_locations = {{{none, surfels.internal_vertex[from], {}}, 1.}};
    after.at_locations = {{{none, surfels.internal_vertex[to], {}}, 1.}};
    const Transport_result found = solver.solve(before, after);
    error.add(std::abs(found.value / exact - 1.));
    estimate.add(std::abs(found.estimate / exact - 1.));
  }
  table.add({name, format_fixed(100. * noise, 1), std::to_string(pairs), error.percent(3),
             estimate.percent(3)});
}

} // namespace

int main(int argc, char* argv[])
{
  std::size_t pairs = 40; // on 25 models: a thousand in total
  std::optional<unsigned> refinements;
  for(int i = 1; i < argc; ++i)
    if(std::string(argv[i]) == "--quick")
      pairs = 1;
    else if(std::string(argv[i]) == "--refine" && i + 1 < argc)
      refinements = unsigned(std::atoi(argv[++i]));
  Table table("bounds on models",
              {"model", "vertices", "pairs", "lower above exact", "upper_continuous below exact",
               "value below exact % (mean / max)", "estimate error %", "upper_continuous excess %",
               "maximum iterations"});
  std::size_t number_of_pairs = 0;
  for(const std::string& name : medium_model_names())
  {
    const auto mesh = load_model(name);
    if(!mesh || num_vertices(*mesh) < 2500 || num_vertices(*mesh) > 40000)
      continue;
    const Array_surface surface(triangulation_of(*mesh));
    const auto [component, number_of_components] = components(surface.t());
    const Multilevel_transport_solver solver(
        surface.triangles(), refinements.value_or(default_number_of_refinements(surface.t())));
    Transport_options options;
    options.tolerance = 1e-3;
    options.do_bound_from_above = true;
    Window_propagation windows(surface.triangles());
    std::mt19937 random;
    Mean_and_max relative_loss, error, excess;
    std::size_t number_above = 0, number_below = 0;
    unsigned iterations = 0;
    while(relative_loss.count < pairs)
    {
      const Index from = random() % surface.size(), to = random() % surface.size();
      if(from == to || component[surface.vertex(from)] != component[surface.vertex(to)])
        continue;
      windows.run({surface.source(from)});
      const double exact = surface.scale() * windows.distance(surface.vertex(to));
      Mass_distribution before, after;
      before.at_locations = {{surface.at(from), 1.}};
      after.at_locations = {{surface.at(to), 1.}};
      const Transport_result found = solver.solve(before, after, options);
      number_above += found.lower > exact * (1. + 1e-9); // round-off errors
      number_below += found.upper_continuous < exact * (1. - 1e-9);
      relative_loss.add(1. - found.value / exact);
      error.add(std::abs(found.estimate / exact - 1.));
      excess.add(found.upper_continuous / exact - 1.);
      iterations = std::max(iterations, found.number_of_iterations);
    }
    number_of_pairs += pairs;
    table.add({name, std::to_string(surface.size()), std::to_string(pairs),
               std::to_string(number_above), std::to_string(number_below), relative_loss.percent(3),
               error.percent(3), excess.percent(1), std::to_string(iterations)});
  }
  table.print();
  std::printf(
      "%zu pairs. Targets: no invalid bound; value 0.4 / 1 %% below exact on bunny_37k, kitten_9k, "
      "eight_5k,\nelephant_2k8, both fandisks, knot1_3k and fsaverage5_inflated_left_10k, mean of "
      "0.11 %% after two refinements;\n25 iterations.\n",
      number_of_pairs);

  Table clouds("bounds on surfels", {"5,000 surfels of a sphere", "noise %", "pairs",
                                     "value error % (mean / max)", "estimate error %"});
  for(const double noise : {0., 0.005})
  {
    measure_cloud("spiral", spiral_sphere(5000), noise, 4 * pairs, refinements, clouds);
    measure_cloud("random", random_sphere(5000), noise, 4 * pairs, refinements, clouds);
  }
  clouds.print();
  std::printf("Targets: 0.5 / 1 %%, with noise 1 %%.\n");
}
