// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the time of queries, compared with CGAL's heat method on the same mesh.
#include <CGAL/Geodesic_processing.h>

#include "Cgal_heat_solver.h"
#include "models.h"
#include "report.h"

#include <cstring>
#include <functional>
#include <memory>
#include <random>

namespace {

using namespace benchmarks;
namespace GP = CGAL::Geodesic_processing;

using Domain = GP::Mesh_domain<Mesh>;
template <typename Method>
using Solver = GP::Geodesic_distance_solver<Mesh, Method>;

// Selects if CGAL's heat method is run. On large regular meshes (icospheres, grids) its
// factorization takes minutes and gigabytes, because the fill-in is largest.
enum class Cgal_comparison
{
  always,
  never
};

struct Named_mesh
{
  std::string name;
  std::function<std::optional<Mesh>()> make;
  Cgal_comparison cgal_heat = Cgal_comparison::always;
};

std::string milliseconds(double seconds)
{
  return format_fixed(1000. * seconds, seconds < 0.01 ? 2 : 1);
}

std::vector<Vertex> random_vertices(std::size_t number_of_vertices, std::size_t number)
{
  std::mt19937 random(1);
  std::vector<Vertex> result;
  for(std::size_t i = 0; i < number; ++i)
    result.push_back(Vertex(Mesh::size_type(random() % number_of_vertices)));
  return result;
}

// Queries over the whole mesh.

class Query_tables
{
public:
  void add(const std::string& name, Mesh& mesh, Cgal_comparison comparison)
  {
    const std::size_t n = num_vertices(mesh);
    const int repetitions = n < 200000 ? 9 : 5;

    // Measures the memory of the domain, and the peak while it is created.
    reset_peak_memory();
    const double peak_before = peak_memory(), before = allocated_bytes();
    std::optional<Domain> domain;
    std::vector<double> domain_times = {cpu_seconds([&] { domain = GP::make_domain(mesh); })};
    const double domain_bytes = allocated_bytes() - before;
    const double peak = peak_memory() - peak_before;
    for(int i = 1; i < repetitions; ++i)
    {
      std::optional<Domain> new_domain; // destroyed outside the measurement
      domain_times.push_back(cpu_seconds([&] { new_domain = GP::make_domain(mesh); }));
    }

    const auto sources = three_sources(n);
    Solver<GP::Dijkstra> dijkstra(*domain);
    dijkstra.compute(sources[0]);
    std::optional<Solver<GP::Fast_marching>> marching;
    const double before_marching = allocated_bytes();
    const double prepare_marching = cpu_seconds([&] { marching.emplace(*domain); });
    marching->compute(sources[0]);
    const double marching_bytes = allocated_bytes() - before_marching;
    std::optional<Solver<GP::Euclidean_front>> front;
    const double before_front = allocated_bytes();
    const double prepare_front = cpu_seconds([&] { front.emplace(*domain); });
    front->compute(sources[0]);
    const double front_bytes = allocated_bytes() - before_front;
    std::unique_ptr<Cgal_heat_solver> cgal_heat;
    const double prepare_cgal =
        comparison == Cgal_comparison::always
            ? cpu_seconds([&] { cgal_heat = std::make_unique<Cgal_heat_solver>(mesh); })
            : std::nan("");

    // Methods take turns, so that other load on the machine affects all of them equally.
    const auto map = mesh.add_property_map<Vertex, double>("v:benchmark", 0.).first;
    std::vector<double> dijkstra_times, marching_times, front_times, write_times, cgal_times;
    for(int i = 0; i < repetitions; ++i)
    {
      const Vertex source = sources[std::size_t(i) % 3];
      dijkstra_times.push_back(cpu_seconds([&] { dijkstra.compute(source); }));
      marching_times.push_back(cpu_seconds([&] { marching->compute(source); }));
      front_times.push_back(cpu_seconds([&] { front->compute(source); }));
      write_times.push_back(cpu_seconds([&] { front->write_distances(map); }));
      if(cgal_heat)
        cgal_times.push_back(cpu_seconds([&] { cgal_heat->compute(source); }));
    }
    std::size_t number_unset = 0;
    if(cgal_heat)
      for(const Vertex v : mesh.vertices())
        number_unset += std::isfinite(cgal_heat->distance(v)) ? 0 : 1;

    m_queries.add(
        {name, std::to_string(n), format_fixed(100. * obtuse_face_ratio(mesh), 0),
         milliseconds(median(dijkstra_times)), milliseconds(median(marching_times)),
         milliseconds(median(front_times)), milliseconds(median(write_times)),
         milliseconds(median(cgal_times)), cgal_heat ? std::to_string(number_unset) : "-",
         format_fixed(median(front_times) / median(marching_times), 2),
         format_fixed(median(cgal_times) / median(marching_times), 2),
         format_fixed(median(cgal_times) / (median(marching_times) + median(write_times)), 2),
         format_fixed(median(cgal_times) / median(front_times), 2)});
    m_domains.add({name, std::to_string(n), milliseconds(median(domain_times)),
                   milliseconds(prepare_marching), milliseconds(prepare_front),
                   format_fixed(prepare_cgal, 1), format_fixed(domain_bytes / double(n), 0),
                   format_fixed(peak / double(n), 0), format_fixed(marching_bytes / double(n), 0),
                   format_fixed(front_bytes / double(n), 0)});
  }

  void print() const
  {
    std::printf("Distances from one vertex to all vertices: times in milliseconds\n");
    m_queries.print();
    std::printf(
        "Targets: Euclidean/marching at most 1.5; solve/marching at least 1.5 at 130,000 to "
        "530,000 vertices.\n\"write\" copies the distances to the mesh; CGAL's solve includes "
        "this step. \"unset\" is the number of\nvertices to which CGAL's solve assigns no "
        "distance.\n\n");
    std::printf("Set-up of domains and solvers: times in milliseconds, memory in bytes per vertex "
                "(of a\nsolver: after a query)\n");
    m_domains.print();
    std::printf("Targets: make_domain below 500 ms at a million vertices; at most 200 bytes per "
                "vertex.\n\n");
  }

private:
  Table m_queries{"queries",
                  {"mesh", "vertices", "obtuse %", "Dijkstra", "marching", "Euclidean", "write",
                   "CGAL solve", "unset", "Euclidean/marching", "solve/marching",
                   "solve/(marching+write)", "solve/Euclidean"}};
  Table m_domains{"set-up and memory",
                  {"mesh", "vertices", "make_domain", "marching solver", "Euclidean solver",
                   "CGAL heat set-up [s]", "domain [B]", "peak of make_domain [B]",
                   "marching solver [B]", "Euclidean solver [B]"}};
};

// Queries with a maximum distance that contains about a thousand vertices.

// Returns the smallest radius around the source that contains `count` vertices. Returns nan if
// the component of the source has fewer vertices.
double radius_of_count(Solver<GP::Euclidean_front>& front, Vertex source, std::size_t count,
                       double first_guess)
{
  std::size_t reached = 0;
  for(double radius = first_guess;; radius *= 1.5)
  {
    front.compute(source, GP::parameters::maximum_distance(radius));
    std::vector<double> distances;
    for(const Vertex v : front.reached())
      distances.push_back(front.distance(v));
    if(distances.size() >= count)
    {
      const auto last = distances.begin() + std::ptrdiff_t(count - 1);
      std::nth_element(distances.begin(), last, distances.end());
      return *last;
    }
    if(distances.size() == reached)
      return std::nan("");
    reached = distances.size();
  }
}

void measure_bounded(const std::string& name, const Mesh& mesh)
{
  const auto domain = GP::make_domain(mesh);
  Solver<GP::Fast_marching> marching(domain);
  Solver<GP::Euclidean_front> front(domain);

  const double first_guess =
      20. * mean_edge_length(mesh); // in the plane, slightly more than a thousand vertices
  std::vector<double> marching_times, front_times, reached;
  for(const Vertex source : random_vertices(num_vertices(mesh), 201))
  {
    const double bound = radius_of_count(front, source, 1000, first_guess);
    if(std::isnan(bound))
      continue;
    marching_times.push_back(
        cpu_seconds([&] { marching.compute(source, GP::parameters::maximum_distance(bound)); }));
    front_times.push_back(
        cpu_seconds([&] { front.compute(source, GP::parameters::maximum_distance(bound)); }));
    reached.push_back(double(front.reached().size()));
  }
  Table table("bounded queries", {"bounded query", "vertices", "reached vertices", "marching [ms]",
                                  "Euclidean [ms]", "Euclidean, maximum [ms]"});
  if(!front_times.empty())
    table.add({name, std::to_string(num_vertices(mesh)), format_fixed(median(reached), 0),
               milliseconds(median(marching_times)), milliseconds(median(front_times)),
               milliseconds(*std::max_element(front_times.begin(), front_times.end()))});
  table.print();
  std::printf("Medians over %zu random sources. Target: below 1 ms.\n\n", front_times.size());
}

// Paths between two vertices of a prepared mesh.

struct Path_method
{
  std::string name;
  double prepare; // seconds
  std::function<double(Vertex, Vertex)> length;
};

// Measures paths on `mesh`, a refinement of `coarse` whose first vertices are those of `coarse`.
// The exact distances are computed on `coarse`.
void measure_paths(const std::string& name, const Mesh& mesh, const Mesh& coarse)
{
  const auto domain = GP::make_domain(mesh);

  std::vector<Path_method> methods;
  methods.push_back({"geodesic_path(domain)", 0.,
                     [&](Vertex p, Vertex q) { return GP::geodesic_path(domain, p, q).length; }});
  methods.push_back({"geodesic_path<Euclidean_front>(domain)", 0., [&](Vertex p, Vertex q) {
                       return GP::geodesic_path<GP::Euclidean_front>(domain, p, q).length;
                     }});
  Solver<GP::Euclidean_front> front(domain);
  methods.push_back({"Geodesic_distance_solver, targets", 0.,
                     [&](Vertex p, Vertex q)
                     {
                       front.compute(q, GP::parameters::targets(p));
                       return front.path(p).length;
                     }});
  for(const unsigned landmarks : {0u, 16u})
  {
    std::shared_ptr<GP::Geodesic_path_finder<Mesh>> path_finder;
    const double prepare = cpu_seconds(
        [&]
        {
          path_finder = std::make_shared<GP::Geodesic_path_finder<Mesh>>(domain);
          path_finder->add_landmarks(landmarks);
        });
    const std::string finder_name =
        "Geodesic_path_finder, " + std::to_string(landmarks) + " landmarks, ";
    methods.push_back({finder_name + "shortest", prepare,
                       [path_finder](Vertex p, Vertex q) { return (*path_finder)(p, q).length; }});
    methods.push_back({finder_name + "locally shortest", prepare,
                       [path_finder](Vertex p, Vertex q)
                       { return path_finder->locally_shortest_path(p, q).length; }});
  }

  // Each method runs on the pairs twice. The first round is reported separately, because it fills
  // caches.
  constexpr std::size_t number_of_pairs = 200;
  const auto endpoints = random_vertices(num_vertices(mesh), 2 * number_of_pairs);

  const auto sources = three_sources(num_vertices(coarse));
  std::vector<std::vector<double>> exact;
  for(const Vertex source : sources)
    exact.push_back(exact_distances(coarse, source));
  const auto targets = random_vertices(num_vertices(coarse), 3 * 100);

  Table table("paths",
              {"path between random vertices", "set-up [ms]", "median [ms]", "90th percentile [ms]",
               "maximum [ms]", "first round, median [ms]", "mean excess %", "median", "maximum"});
  for(const Path_method& method : methods)
  {
    std::vector<double> first_round, second_round, excess;
    for(auto* times : {&first_round, &second_round})
      for(std::size_t i = 0; i < number_of_pairs; ++i)
        times->push_back(
            cpu_seconds([&] { method.length(endpoints[2 * i], endpoints[2 * i + 1]); }));
    double sum = 0.;
    for(std::size_t i = 0; i < targets.size(); ++i)
    {
      const double shortest = exact[i % 3][std::size_t(targets[i])];
      if(!(shortest > 0.))
        continue;
      excess.push_back(100. * (method.length(sources[i % 3], targets[i]) / shortest - 1.));
      sum += excess.back();
    }
    std::sort(second_round.begin(), second_round.end());
    table.add({method.name, milliseconds(method.prepare), milliseconds(median(second_round)),
               milliseconds(second_round[second_round.size() * 9 / 10]),
               milliseconds(second_round.back()), milliseconds(median(first_round)),
               format_significant(sum / double(excess.size())), format_significant(median(excess)),
               format_significant(*std::max_element(excess.begin(), excess.end()))});
  }
  std::printf("%s, %zu vertices\n", name.c_str(), std::size_t(num_vertices(mesh)));
  table.print();
  std::printf(
      "Excess: length relative to CGAL's exact distance. Target: median time below 10 ms.\n\n");
}

} // namespace

// speed [--quick]
int main(int argc, char* argv[])
{
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;

  std::printf("Speed: median processor times of one thread\n\n");

  const auto scan = load_model("bunny_37k");
  const auto subdivided_scan = [&](unsigned times) -> std::optional<Mesh>
  {
    if(!scan)
      return std::nullopt;
    Mesh mesh = *scan;
    for(unsigned i = 0; i < times; ++i)
      mesh = refined(mesh);
    return mesh;
  };
  std::vector<Named_mesh> meshes = {
      {"icosphere 5", [] { return icosphere(5); }},
      {"square 101^2", [] { return jittered_square(101); }},
      {"bunny_37k", [&] { return subdivided_scan(0); }},
  };
  if(!quick)
    meshes = {
        {"icosphere 7", [] { return icosphere(7); }},
        {"icosphere 8", [] { return icosphere(8); }, Cgal_comparison::never},
        {"square 1001^2", [] { return jittered_square(1001); }, Cgal_comparison::never},
        {"bunny_37k, refined once", [&] { return subdivided_scan(1); }},
        {"bunny_37k, refined twice", [&] { return subdivided_scan(2); }},
        {"mni152_grey_matter_533k", [] { return load_model("mni152_grey_matter_533k"); }},
    };

  Query_tables queries;
  for(const Named_mesh& named : meshes)
    if(auto mesh = named.make())
      queries.add(named.name, *mesh, named.cgal_heat);
  queries.print();

  // Uses the last mesh that is available: the largest model, otherwise the largest generated mesh.
  for(auto named = meshes.rbegin(); named != meshes.rend(); ++named)
    if(const auto mesh = named->make())
    {
      measure_bounded(named->name, *mesh);
      break;
    }

  if(scan)
    measure_paths(quick ? "bunny_37k" : "bunny_37k, refined once", *subdivided_scan(quick ? 0 : 1),
                  *scan);
  else
  {
    const Mesh coarse = icosphere(quick ? 4 : 5);
    measure_paths(quick ? "icosphere 4, refined twice" : "icosphere 5, refined twice",
                  refined(refined(coarse)), coarse);
  }
}
