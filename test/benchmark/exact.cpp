// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares the cost of exact distances with CGAL's exact algorithm and with approximate methods.
#include <CGAL/Geodesic_processing.h>

#include "Error_plot.h"
#include "Cgal_heat_solver.h"
#include "models.h"
#include "report.h"

#include <cstdlib>
#include <cstring>
#include <functional>
#include <iterator>
#include <memory>
#include <random>

namespace {

using namespace benchmarks;
namespace GP = CGAL::Geodesic_processing;

template <typename Method>
using Solver = GP::Geodesic_distance_solver<Mesh, Method>;

// Selects if CGAL's exact algorithm is run. It takes seconds on models of 40,000 vertices. On
// larger meshes it takes minutes and gigabytes.
enum class Cgal_comparison
{
  always,
  if_patient,
  never
};

struct Named_mesh
{
  std::string name;
  std::function<std::optional<Mesh>()> make;
  Cgal_comparison cgal;
};

std::optional<Mesh> subdivided_model(const std::string& name, unsigned times)
{
  auto mesh = load_model(name);
  for(unsigned i = 0; mesh && i < times; ++i)
    mesh = refined(*mesh);
  return mesh;
}

// Returns a sphere scaled to an eighth along the z-axis. Its triangles are up to eight times as
// long as wide.
Mesh flattened_sphere(unsigned level)
{
  auto surface = CGAL::Geodesic_processing::test::icosphere(level);
  for(auto& p : surface.points)
    p[2] /= 8.;
  return mesh_of(surface);
}

std::vector<Vertex> random_vertices(const Mesh& mesh, std::size_t number)
{
  std::mt19937 random(1);
  std::vector<Vertex> result;
  for(std::size_t i = 0; i < number; ++i)
    result.push_back(Vertex(Mesh::size_type(random() % num_vertices(mesh))));
  return result;
}

struct Cost
{
  std::vector<double> times;
  double peak = 0.; // growth in bytes
};

// Calls f and records its processor time and its peak memory.
template <typename Function>
void measure(Cost& cost, Function f)
{
  reset_peak_memory();
  const double before = peak_memory();
  cost.times.push_back(cpu_seconds(f));
  cost.peak = std::max(cost.peak, peak_memory() - before);
}

// Measures the total cost of one source, from the mesh to the distances of all vertices, including
// set-up.
class Single_source_table
{
public:
  void add(const std::string& name, const Mesh& mesh, bool with_cgal)
  {
    Cost front, exact, cgal;
    double difference = with_cgal ? 0. : std::nan("");
    // Methods take turns, so that other load on the machine affects all of them equally.
    for(const Vertex source : three_sources(num_vertices(mesh)))
    {
      measure(front, [&] { Solver<GP::Euclidean_front>(mesh).compute(source); });
      std::vector<double> ours(num_vertices(mesh)), theirs;
      measure(exact,
              [&]
              {
                Solver<GP::Exact> solver(mesh);
                solver.compute(source);
                for(const Vertex v : mesh.vertices())
                  ours[std::size_t(v)] = solver.distance(v);
              });
      if(!with_cgal)
        continue;
      measure(cgal, [&] { theirs = exact_distances(mesh, source); });
      for(std::size_t i = 0; i < ours.size(); ++i)
        if(theirs[i] > 0.)
          difference = std::max(difference, std::fabs(ours[i] / theirs[i] - 1.));
    }
    const auto megabytes = [](const Cost& cost)
    { return cost.times.empty() ? "-" : format_fixed(cost.peak / 1e6, 0); };
    m_table.add({name, std::to_string(num_vertices(mesh)), format_fixed(median(front.times), 3),
                 format_fixed(median(exact.times), 3), format_fixed(median(cgal.times), 2),
                 format_fixed(median(exact.times) / median(front.times), 1),
                 format_fixed(median(cgal.times) / median(exact.times), 1), megabytes(exact),
                 megabytes(cgal), format_significant(difference)});
  }
  void print() const
  {
    std::printf(
        "Distances from one source to all vertices, including set-up: time and peak memory\n");
    m_table.print();
    std::printf("Target: CGAL/Exact at least 30 at 35,000 to 400,000 vertices.\n\n");
  }

private:
  Table m_table{"one source",
                {"mesh", "vertices", "Euclidean [s]", "Exact [s]", "CGAL exact [s]",
                 "Exact/Euclidean", "CGAL/Exact", "Exact [MB]", "CGAL [MB]",
                 "maximum relative difference"}};
};

// Measures the speed-up of a distance matrix with two threads.
template <typename Method>
void add_parallel(Table& table, const std::string& name, const Mesh& mesh, std::size_t sources,
                  bool to_all)
{
  const auto domain = GP::make_domain(mesh);
  const auto source_vertices = random_vertices(mesh, sources);
  const std::vector<Vertex> targets =
      to_all ? std::vector<Vertex>(mesh.vertices().begin(), mesh.vertices().end())
             : source_vertices;
  std::vector<double> one_thread_times, two_thread_times;
  for(int i = 0; i < 3; ++i)
    for(const unsigned number_of_threads : {1u, 2u})
      (number_of_threads == 1 ? one_thread_times : two_thread_times)
          .push_back(wall_seconds(
              [&]
              {
                GP::geodesic_distance_matrix<Method, CGAL::Parallel_tag>(
                    domain, source_vertices,
                    GP::parameters::number_of_threads(number_of_threads).targets(targets));
              }));
  // The minimum is the run with the least interference by other processes.
  const double one_thread_time =
      *std::min_element(one_thread_times.begin(), one_thread_times.end());
  const double two_thread_time =
      *std::min_element(two_thread_times.begin(), two_thread_times.end());
  table.add({name, std::to_string(sources), std::to_string(targets.size()),
             format_fixed(one_thread_time, 2), format_fixed(two_thread_time, 2),
             format_fixed(one_thread_time / two_thread_time, 2)});
}

// Measures queries with a maximum distance of 18 mean edge lengths. In the plane this contains
// about a thousand vertices.
void add_bounded(Table& table, const std::string& name, const Mesh& mesh)
{
  const auto domain = GP::make_domain(mesh);
  Solver<GP::Exact> exact(domain);
  Solver<GP::Euclidean_front> front(domain);
  const double bound = 18. * mean_edge_length(mesh);
  std::vector<double> exact_times, front_times, reached;
  for(const Vertex source : random_vertices(mesh, 101))
  {
    front_times.push_back(
        cpu_seconds([&] { front.compute(source, GP::parameters::maximum_distance(bound)); }));
    exact_times.push_back(
        cpu_seconds([&] { exact.compute(source, GP::parameters::maximum_distance(bound)); }));
    reached.push_back(double(exact.reached().size()));
  }
  table.add({name, std::to_string(num_vertices(mesh)), format_fixed(median(reached), 0),
             format_fixed(1000. * median(front_times), 2),
             format_fixed(1000. * median(exact_times), 2),
             format_fixed(1000. * *std::max_element(exact_times.begin(), exact_times.end()), 2)});
}

// Measures queries with a relative tolerance, and compares their bounds with exact distances.
void add_tolerances(Table& table, const std::string& name, const Mesh& mesh)
{
  const auto domain = GP::make_domain(mesh);
  const std::size_t n = num_vertices(mesh);
  Solver<GP::Euclidean_front> front(domain);
  Solver<GP::Exact> exact(domain);
  constexpr double tolerances[] = {0., 1e-5, 1e-4, 1e-3, 1e-2};
  std::vector<double> front_times, times[std::size(tolerances)];
  double gap[std::size(tolerances)] = {}, error[std::size(tolerances)] = {};
  std::size_t number_of_violations = 0;
  for(const Vertex source : three_sources(n))
  {
    std::vector<double> distances(n);
    front_times.push_back(cpu_seconds([&] { front.compute(source); }));
    for(std::size_t i = 0; i < std::size(tolerances); ++i)
    {
      times[i].push_back(cpu_seconds(
          [&] { exact.compute(source, GP::parameters::relative_tolerance(tolerances[i])); }));
      for(const Vertex v : mesh.vertices())
      {
        double& distance = distances[std::size_t(v)];
        if(i == 0)
          distance = exact.distance(v);
        if(!(distance > 0.))
          continue;
        const double lower = exact.lower(v), upper = exact.upper(v);
        // Round-off errors are smaller.
        if(lower > distance * (1. + 1e-11) || upper < distance * (1. - 1e-11))
          ++number_of_violations;
        gap[i] = std::max(gap[i], upper / lower - 1.);
        error[i] = std::max(error[i], std::fabs(exact.distance(v) / distance - 1.));
      }
    }
  }
  for(std::size_t i = 0; i < std::size(tolerances); ++i)
    table.add({name, std::to_string(n), format_significant(tolerances[i]),
               format_fixed(1e6 * median(times[i]) / double(n), 2),
               format_fixed(median(times[i]) / median(front_times), 1),
               format_fixed(median(times[i]) / median(times[0]), 2), format_significant(gap[i]),
               format_significant(error[i]), std::to_string(number_of_violations)});
}

// Plots the mean error of each method over its time: of a query, and of the first query with
// set-up.
class Error_time_trade_off
{
public:
  Error_time_trade_off(const std::string& name, Mesh& mesh)
      : m_panel{name + ", " + std::to_string(num_vertices(mesh)) + " vertices",
                "seconds per source, without and with set-up",
                {}},
        m_mesh(mesh)
  {
    m_sources = three_sources(num_vertices(mesh));
    std::vector<double> times;
    for(const Vertex source : m_sources)
      times.push_back(cpu_seconds([&] { m_reference.push_back(exact_distances(mesh, source)); }));
    add_method<GP::Dijkstra>("Dijkstra");
    add_method<GP::Fast_marching>("Fast_marching");
    add_method<GP::Euclidean_front>("Euclidean_front");
    add_method<GP::Heat>("Heat");
    std::unique_ptr<Cgal_heat_solver> heat;
    add(
        "CGAL heat", [&] { heat = std::make_unique<Cgal_heat_solver>(mesh); },
        [&](Vertex source) { heat->compute(source); }, [&](Vertex v) { return heat->distance(v); });
    add_method<GP::Exact>("Exact");
    add_point("CGAL exact", median(times), 0., 0.);
  }

  const Panel& panel() const { return m_panel; }
  void print() const
  {
    std::printf("%s\n", m_panel.title.c_str());
    m_table.print();
  }

private:
  // Zero cannot be drawn on a logarithmic axis. Exact methods are drawn at this error.
  static constexpr double error_floor = 1e-6;

  template <typename Method>
  void add_method(const char* name)
  {
    std::unique_ptr<Solver<Method>> solver;
    add(
        name, [&] { solver = std::make_unique<Solver<Method>>(m_mesh); },
        [&](Vertex source) { solver->compute(source); },
        [&](Vertex v) { return solver->distance(v); });
  }

  template <typename Prepare, typename Compute, typename Distance>
  void add(const char* name, Prepare prepare, Compute compute, Distance distance)
  {
    const double setup = cpu_seconds(prepare);
    std::vector<double> times;
    double sum = 0.;
    std::size_t count = 0;
    for(int round = 0; round < 2; ++round) // the first round warms up
      for(std::size_t s = 0; s < m_sources.size(); ++s)
      {
        times.push_back(cpu_seconds([&] { compute(m_sources[s]); }));
        const double min_distance =
            0.05 * *std::max_element(m_reference[s].begin(), m_reference[s].end());
        for(const Vertex v : m_mesh.vertices())
          if(const double reference = m_reference[s][std::size_t(v)]; reference >= min_distance)
          {
            sum += std::fabs(distance(v) / reference - 1.);
            ++count;
          }
      }
    add_point(name, median(times), setup, sum / double(count));
  }

  void add_point(const char* name, double query, double setup, double error)
  {
    const double drawn_error = std::max(error, error_floor);
    m_panel.series.push_back({name,
                              m_panel.series.size(),
                              std::nan(""),
                              {{query, drawn_error}, {query + setup, drawn_error}}});
    m_table.add(
        {name, format_fixed(setup, 3), format_fixed(query, 3), format_significant(100. * error)});
  }

  Panel m_panel;
  Mesh& m_mesh;
  std::vector<Vertex> m_sources;
  std::vector<std::vector<double>> m_reference;
  Table m_table{m_panel.title, {"method", "set-up [s]", "query [s]", "mean error %"}};
};

std::vector<Named_mesh> single_source_meshes(bool quick)
{
  if(quick)
    return {
        {"icosphere 4", [] { return icosphere(4); }, Cgal_comparison::always},
        {"elephant_2k8", [] { return load_model("elephant_2k8"); }, Cgal_comparison::always},
    };
  return {
      {"bunny_37k", [] { return load_model("bunny_37k"); }, Cgal_comparison::always},
      {"nefertiti_35k", [] { return load_model("nefertiti_35k"); }, Cgal_comparison::always},
      {"icosphere 6", [] { return icosphere(6); }, Cgal_comparison::if_patient},
      {"square 201^2", [] { return jittered_square(201); }, Cgal_comparison::if_patient},
      {"flattened sphere 6", [] { return flattened_sphere(6); }, Cgal_comparison::if_patient},
      {"bunny_37k, refined once", [] { return subdivided_model("bunny_37k", 1); },
       Cgal_comparison::if_patient},
      {"icosphere 7", [] { return icosphere(7); }, Cgal_comparison::never},
      {"flattened sphere 7", [] { return flattened_sphere(7); }, Cgal_comparison::never},
      {"square 631^2", [] { return jittered_square(631); }, Cgal_comparison::never},
  };
}

void print_single_source(bool quick, bool patient)
{
  Single_source_table table;
  for(const Named_mesh& named : single_source_meshes(quick))
    if(const auto mesh = named.make())
      table.add(named.name, *mesh,
                named.cgal == Cgal_comparison::always ||
                    (patient && named.cgal == Cgal_comparison::if_patient));
  table.print();
}

void print_speed_ups(const Mesh& mesh)
{
  std::printf(
      "Distance matrices with one and two threads: wall-clock times, valid on an idle machine\n");
  Table table("threads",
              {"distances", "sources", "targets", "1 thread [s]", "2 threads [s]", "speed-up"});
  add_parallel<GP::Exact>(table, "Exact, all pairs", mesh, 24, false);
  add_parallel<GP::Exact>(table, "Exact, all vertices", mesh, 8, true);
  add_parallel<GP::Euclidean_front>(table, "Euclidean_front, all pairs", mesh, 100, false);
  add_parallel<GP::Euclidean_front>(table, "Euclidean_front, all vertices", mesh, 32, true);
  table.print();
  std::printf("Target: speed-up of at least 1.7 on two processors.\n\n");
}

// Measures bounded queries on `mesh` and on two refinements of it.
void print_bounded_queries(const Mesh& mesh)
{
  std::printf(
      "Queries with a maximum distance of 18 mean edge lengths from random vertices, on a mesh "
      "and two refinements\n");
  Table table("bounded queries", {"mesh", "vertices", "reached vertices", "Euclidean [ms]",
                                  "Exact [ms]", "Exact, maximum [ms]"});
  Mesh finer = mesh;
  for(const std::string name : {"input", "refined once", "refined twice"})
  {
    add_bounded(table, name, finer);
    if(name != "refined twice")
      finer = refined(finer);
  }
  table.print();
  std::printf("Target: equal times on all meshes if equally many vertices are reached.\n\n");
}

void print_tolerances(const Mesh& mesh, const std::string& name, bool quick, bool patient)
{
  std::printf("Queries with a relative tolerance\n");
  Table table("relative tolerance",
              {"mesh", "vertices", "tolerance", "microseconds per vertex", "/ Euclidean", "/ exact",
               "largest gap", "largest error", "violations"});
  add_tolerances(table, name, mesh);
  add_tolerances(table, "sphere", icosphere(quick ? 4 : 7));
  if(patient)
    add_tolerances(table, "sphere", icosphere(8));
  table.print();
  std::printf("Target: no violation of the bounds.\n\n");
}

// Prints errors over times on `mesh` and on a sphere. Returns one panel of the plot for each.
std::vector<Panel> print_trade_offs(Mesh& mesh, const std::string& name, unsigned sphere_level)
{
  std::vector<Panel> panels;
  const auto compare = [&panels](const std::string& title, Mesh& surface)
  {
    const Error_time_trade_off trade_off(title, surface);
    trade_off.print();
    panels.push_back(trade_off.panel());
  };
  std::printf("Errors relative to CGAL's exact distances, and processor times\n");
  Mesh sphere = icosphere(sphere_level);
  compare(name, mesh);
  compare("Sphere", sphere);
  return panels;
}

} // namespace

// exact [--quick] [--patient] [PLOT.svg]
int main(int argc, char* argv[])
{
  bool quick = false, patient = false;
  std::string plot;
  for(int i = 1; i < argc; ++i)
    if(std::strcmp(argv[i], "--quick") == 0)
      quick = true;
    else if(std::strcmp(argv[i], "--patient") == 0)
      patient = true;
    else
      plot = argv[i];

  std::printf("Exact distances: median processor times over three sources\n\n");
  print_single_source(quick, patient);

  // Uses a sphere if the model is missing.
  const auto model = load_model(quick ? "elephant_2k8" : "bunny_37k");
  Mesh mesh = model ? *model : icosphere(quick ? 4 : 6);
  print_speed_ups(mesh);
  print_bounded_queries(mesh);
  print_tolerances(mesh, model ? "scan" : "sphere", quick, patient);
  const std::vector<Panel> panels =
      print_trade_offs(mesh, model ? "Scan" : "Sphere", quick ? 4 : 5);
  if(!plot.empty())
  {
    if(!write_error_plot(plot, panels))
    {
      std::fprintf(stderr, "exact: cannot write %s\n", plot.c_str());
      return EXIT_FAILURE;
    }
    std::printf("The plot of errors over time is in %s\n", plot.c_str());
  }
}
