// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the times of tables 1 and 2 of Solomon, Rustamov, Guibas and Butscher 2014, next to the
// numbers of the paper. Times are processor seconds of one thread with all set-up, the median of
// three runs if one takes less than a second. --quick: small meshes only. The arguments table-1,
// basis and table-2 select one table.
#include "Array_surface.h"
#include "Gradient_family.h"
#include "models.h"
#include "report.h"

#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/distances/heat.h>
#include <CGAL/Geodesic_processing/internal/transport/Transport_solver.h>
#include <CGAL/Geodesic_processing/internal/transport/biharmonic.h>
#include <CGAL/Geodesic_processing/internal/transport/spectral_transport.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Geodesic_processing::internal;
using namespace benchmarks;

using Triangles = std::shared_ptr<const Surface_arrays>;

constexpr double tolerance = 1e-3; // gap between the bounds

// Returns the processor time of f(), the median of three runs if the first takes less than a
// second.
template <typename Function>
double median_seconds(Function f)
{
  std::vector<double> seconds = {cpu_seconds(f)};
  while(seconds[0] < 1. && seconds.size() < 3)
    seconds.push_back(cpu_seconds(f));
  return median(seconds);
}

std::string cell(double ours, double theirs)
{
  return format_significant(ours) + " (" + format_significant(theirs) + ")";
}

Triangles triangles_of(const Mesh& mesh)
{
  return CGAL::Geodesic_processing::test::Array_surface(triangulation_of(mesh)).triangles();
}

Surface_location vertex_location(Index vertex) { return {none, vertex, {}}; }

Front_source source(const Surface_location& location) { return {{location}, 0., 0}; }

// Table 1: the distances of all vertices from one vertex.

struct One_to_all
{
  std::string paper; // the paper's model and number of vertices
  double marching, heat, biharmonic, spectral, basis_100;
  std::string ours; // without harmonic fields
};

std::vector<One_to_all> one_to_all_rows(bool is_quick)
{
  std::vector<One_to_all> rows = {
      {"bearing 3182", 0.050, 0.002, 3.52, 3.86, 41.4, "alligator_3k"},
      {"dog 3716", 0.056, 0.002, 4.66, 3.27, 59.8, "retinal_3k6"},
      {"teapot 3900", 0.063, 0.002, 6.25, 3.87, 57.9, "dino_4k"},
      {"david 5197", 0.096, 0.003, 10.09, 6.18, 121.2, "disk_5k"},
      {"man 10050", 0.18, 0.006, 42.2, 23.2, 511.9, "fsaverage5_inflated_left_10k"}};
  if(is_quick)
    rows.resize(1);
  return rows;
}

void print_one_to_all(bool is_quick)
{
  Table table("table 1 of the paper",
              {"one to all: seconds (paper)", "vertices", "model of the paper", "exact (marching)",
               "heat", "biharmonic", "k = 0", "all flows", "mean error of all flows %"});
  for(const One_to_all& row : one_to_all_rows(is_quick))
    if(const auto mesh = load_model(row.ours))
    {
      const Triangles t = triangles_of(*mesh);
      const Index n = Index(t->number_of_vertices());
      const Masses from = masses_at(*t, {vertex_location(0)});
      std::vector<double> truth(n);
      const double windows = median_seconds(
          [&]
          {
            Window_propagation propagation(t);
            propagation.run({source(vertex_location(0))});
            for(Index i = 0; i < n; ++i)
              truth[i] = propagation.distance(i);
          });
      const double heat = median_seconds([&] { Heat_solver(t).run({source(vertex_location(0))}); });
      const double biharmonic =
          median_seconds([&] { Biharmonic_distances(*t).one_to_all(from, 1); });
      const double spectral = median_seconds(
          [&] { Spectral_transport(t, 0, Particular_field::gradient).one_to_all(from, {}); });
      // The uniform distribution is transported to the source. The potential is then the distance
      // to it.
      Vector potential;
      const double all_flows = median_seconds(
          [&]
          {
            const Transport_solver solver(operators(*t));
            const Vector area = lumped_mass(solver.operators());
            potential = solver.solve(Vector(from.col(0)) - area / area.sum()).potential;
          });
      Mean_and_max error;
      for(Index i = 1; i < n; ++i)
        error.add(std::abs((potential[0] - potential[i]) / truth[i] - 1.));
      table.add({row.ours, std::to_string(n), row.paper, cell(windows, row.marching),
                 cell(heat, row.heat), cell(biharmonic, row.biharmonic),
                 cell(spectral, row.spectral), format_significant(all_flows),
                 format_fixed(100. * error.mean, 1)});
    }
  table.print();
}

// One family of table 1, with k = 100.
struct Basis_measurement
{
  double clusters = std::nan(""), minimized = std::nan(""); // seconds
  Mean_and_max error; // of the upper bounds by clusters, relative to lower bounds
};

// Computes bounds of the distances from vertex 0 to `targets`.
std::vector<Transport_bounds> minimized(const Triangles& t, Particular_field kind,
                                        const std::vector<Surface_location>& targets,
                                        double max_gap)
{
  Masses differences = masses_at(*t, targets);
  differences -= masses_at(*t, std::vector<Surface_location>(targets.size(), vertex_location(0)));
  Spectral_transport_options options;
  options.tolerance = max_gap;
  return Spectral_transport(t, 100, kind).distances(differences, options);
}

// Below 4,000 vertices, the time is measured in which the distance of each vertex is minimized to a
// gap of 1 %. The error of the upper bounds is measured at 48 random vertices.
Basis_measurement measure_basis(const Triangles& t, Particular_field kind)
{
  const Index n = Index(t->number_of_vertices());
  Basis_measurement result;
  Vector upper;
  result.clusters = median_seconds(
      [&] {
        upper =
            Spectral_transport(t, 100, kind).one_to_all(masses_at(*t, {vertex_location(0)}), {});
      });
  std::vector<Surface_location> targets;
  std::mt19937 random(1);
  while(targets.size() < 48)
    targets.push_back(vertex_location(1 + Index(random() % (n - 1))));
  const std::vector<Transport_bounds> bounds = minimized(t, kind, targets, tolerance);
  for(std::size_t j = 0; j < targets.size(); ++j)
    result.error.add(upper[targets[j].vertex] / bounds[j].lower - 1.);
  if(n >= 4000)
    return result;
  targets.clear();
  for(Index i = 1; i < n; ++i)
    targets.push_back(vertex_location(i));
  result.minimized = cpu_seconds([&] { minimized(t, kind, targets, 1e-2); });
  return result;
}

// The column k = 100 of table 1, for the family of the paper and for the default of
// Transport_metric. The models have no harmonic fields.
void print_basis(bool is_quick)
{
  Table table("k = 100",
              {"k = 100, seconds", "vertices", "paper", "paper's flow: clusters",
               "paper's flow: error %", "paper's flow: minimized", "default flow: clusters",
               "default flow: error %", "default flow: minimized"});
  for(const One_to_all& row : one_to_all_rows(is_quick))
    if(const auto mesh = load_model(row.ours))
    {
      const Triangles t = triangles_of(*mesh);
      std::vector<std::string> cells = {row.ours, std::to_string(t->number_of_vertices()),
                                        format_significant(row.basis_100)};
      for(const Particular_field kind :
          {Particular_field::gradient, Particular_field::raviart_thomas})
      {
        const Basis_measurement found = measure_basis(t, kind);
        cells.insert(cells.end(), {format_significant(found.clusters), found.error.percent(2),
                                   format_significant(found.minimized)});
      }
      table.add(cells);
    }
  table.print();
}

// Table 2: the distances of all pairs of samples.

struct All_pairs
{
  std::string paper;                                          // number of vertices
  std::array<double, 2> marching, heat, biharmonic, spectral; // for 2 and 100 samples
  std::string ours;
  unsigned refinements;
};

std::vector<All_pairs> all_pairs_rows()
{
  return {
      {"2k", {0.06, 2.60}, {0.03, 0.23}, {0.03, 0.58}, {0.03, 1.22}, "mushroom_2k", 0},
      {"4k", {0.13, 6.25}, {0.05, 0.45}, {0.06, 1.42}, {0.06, 2.84}, "dino_4k", 0},
      {"8k", {0.24, 11.76}, {0.10, 0.97}, {0.14, 4.97}, {0.14, 7.33}, "plane_holes_8k5", 0},
      {"16k", {0.70, 34.93}, {0.20, 1.97}, {0.33, 13.07}, {0.34, 18.45}, "fandisk_16k", 0},
      {"53k",
       {2.74, 121.94},
       {0.71, 10.36},
       {1.03, 51.99},
       {0.97, 68.53},
       "mannequin_devil_13k",
       1},
      {"111k", {8.06, 432.26}, {2.04, 15.14}, {10.91, 289.02}, {11., 322.11}, "armadillo_26k", 1}};
}

// Seconds; nan if a method is not run.
struct All_pairs_times
{
  double exact = 0., heat = 0., biharmonic = 0., spectral = 0.;
  double paper_100 = std::nan(""), default_100 = std::nan(""), all_flows = std::nan("");
};

All_pairs_times measure_all_pairs(const Triangles& t,
                                  const std::vector<Surface_location>& locations)
{
  const Masses masses = masses_at(*t, locations);
  All_pairs_times result;
  result.exact = median_seconds(
      [&]
      {
        Window_propagation propagation(t);
        for(const Surface_location& location : locations)
          propagation.run({source(location)});
      });
  result.heat = median_seconds(
      [&]
      {
        Heat_solver solver(t);
        for(const Surface_location& location : locations)
          solver.run({source(location)});
      });
  result.biharmonic = median_seconds([&] { Biharmonic_distances(*t).all_pairs(masses); });
  result.spectral = median_seconds(
      [&] { Spectral_transport(t, 0, Particular_field::gradient).all_pairs(masses, {}); });
  if(locations.size() > 2)
    return result;
  const Masses difference = Masses(masses.col(1)) - Masses(masses.col(0));
  if(t->number_of_vertices() < 20000) // otherwise minutes
  {
    result.paper_100 =
        median_seconds([&] { Gradient_family(t, 100).distances(difference, tolerance); });
    result.default_100 = median_seconds(
        [&]
        {
          Spectral_transport_options options;
          options.tolerance = tolerance;
          Spectral_transport(t, 100, Particular_field::raviart_thomas)
              .distances(difference, options);
        });
  }
  result.all_flows = median_seconds(
      [&]
      {
        Transport_options options;
        options.tolerance = tolerance;
        Transport_solver(operators(*t)).solve(Vector(difference.col(0)), options);
      });
  return result;
}

void print_all_pairs(bool is_quick)
{
  std::vector<All_pairs> rows = all_pairs_rows();
  if(is_quick)
    rows.resize(2);
  Table table("table 2 of the paper",
              {"all pairs: seconds (paper)", "vertices", "paper", "samples", "exact (marching)",
               "heat", "biharmonic", "k = 0", "k = 100, paper's flow", "k = 100, default flow",
               "all flows"});
  for(const All_pairs& row : rows)
    if(auto mesh = load_model(row.ours))
    {
      for(unsigned i = 0; i < row.refinements; ++i)
        *mesh = refined(*mesh);
      const Triangles t = triangles_of(*mesh);
      const Index n = Index(t->number_of_vertices());
      for(const std::size_t samples : {2, 100})
      {
        std::vector<Surface_location> locations;
        for(std::size_t j = 0; j < samples; ++j)
          locations.push_back(vertex_location(Index(j * n / samples)));
        const All_pairs_times times = measure_all_pairs(t, locations);
        const std::size_t i = samples == 2 ? 0 : 1;
        table.add({row.ours, std::to_string(n), row.paper, std::to_string(samples),
                   cell(times.exact, row.marching[i]), cell(times.heat, row.heat[i]),
                   cell(times.biharmonic, row.biharmonic[i]), cell(times.spectral, row.spectral[i]),
                   format_significant(times.paper_100), format_significant(times.default_100),
                   format_significant(times.all_flows)});
      }
    }
  table.print();
}

} // namespace

int main(int argc, char* argv[])
{
  bool is_quick = false;
  std::string selected;
  for(int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if(argument == "--quick")
      is_quick = true;
    else
      selected = argument;
  }
  if(selected.empty() || selected == "table-1")
    print_one_to_all(is_quick);
  if(selected.empty() || selected == "basis")
    print_basis(is_quick);
  if(selected.empty() || selected == "table-2")
    print_all_pairs(is_quick);
  std::printf("Targets: times for k = 0 and by clusters below those of the paper; mean error of "
              "clusters at most 1 %%.\n");
}
