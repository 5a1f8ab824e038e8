// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How long does a query take, beside one of CGAL's heat method on the same mesh?
#include <CGAL/Geodesic_processing.h>

#include "Heat_peer.h"
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

// CGAL's factorization takes minutes and gigabytes on large meshes as regular as icospheres and
// grids, where it has the most to fill in.
enum class Peer
{
  beside,
  left_out
};

struct Named_mesh
{
  std::string name;
  std::function<std::optional<Mesh>()> make;
  Peer peer = Peer::beside;
};

std::string milliseconds(double seconds) { return number(1000. * seconds, seconds < 0.01 ? 2 : 1); }

std::vector<Vertex> random_vertices(std::size_t number_of_vertices, std::size_t number)
{
  std::mt19937 random(1);
  std::vector<Vertex> result;
  for(std::size_t i = 0; i < number; ++i)
    result.push_back(Vertex(Mesh::size_type(random() % number_of_vertices)));
  return result;
}

// Whole queries.

class Query_tables
{
public:
  void add(const std::string& name, Mesh& mesh, Peer with)
  {
    const std::size_t n = num_vertices(mesh);
    const int repetitions = n < 200000 ? 9 : 5;

    // What the domain takes, and how much is needed while it is made.
    forget_peak();
    const double peak_before = peak_bytes(), before = bytes_in_use();
    std::optional<Domain> domain;
    std::vector<double> make = {seconds([&] { domain = GP::make_domain(mesh); })};
    const double domain_bytes = bytes_in_use() - before;
    const double peak = peak_bytes() - peak_before;
    for(int i = 1; i < repetitions; ++i)
    {
      std::optional<Domain> again; // destroyed outside the measure
      make.push_back(seconds([&] { again = GP::make_domain(mesh); }));
    }

    const auto sources = three_sources(n);
    Solver<GP::Dijkstra> dijkstra(*domain);
    dijkstra.compute(sources[0]);
    std::optional<Solver<GP::Fast_marching>> marching;
    const double before_marching = bytes_in_use();
    const double prepare_marching = seconds([&] { marching.emplace(*domain); });
    marching->compute(sources[0]);
    const double marching_bytes = bytes_in_use() - before_marching;
    std::optional<Solver<GP::Euclidean_front>> front;
    const double before_front = bytes_in_use();
    const double prepare_front = seconds([&] { front.emplace(*domain); });
    front->compute(sources[0]);
    const double front_bytes = bytes_in_use() - before_front;
    std::unique_ptr<Heat_peer> peer;
    const double prepare_peer = with == Peer::beside
                                    ? seconds([&] { peer = std::make_unique<Heat_peer>(mesh); })
                                    : std::nan("");

    // In turns, so that whatever else the machine does falls on all alike.
    const auto map = mesh.add_property_map<Vertex, double>("v:benchmark", 0.).first;
    std::vector<double> arcs, planar, euclidean, write, solve;
    for(int i = 0; i < repetitions; ++i)
    {
      const Vertex source = sources[std::size_t(i) % 3];
      arcs.push_back(seconds([&] { dijkstra.compute(source); }));
      planar.push_back(seconds([&] { marching->compute(source); }));
      euclidean.push_back(seconds([&] { front->compute(source); }));
      write.push_back(seconds([&] { front->write_distances(map); }));
      if(peer)
        solve.push_back(seconds([&] { peer->compute(source); }));
    }
    std::size_t unset = 0;
    if(peer)
      for(const Vertex v : mesh.vertices())
        unset += std::isfinite(peer->distance(v)) ? 0 : 1;

    m_queries.add({name, std::to_string(n), number(100. * part_of_obtuse_faces(mesh), 0),
                   milliseconds(median(arcs)), milliseconds(median(planar)),
                   milliseconds(median(euclidean)), milliseconds(median(write)),
                   milliseconds(median(solve)), peer ? std::to_string(unset) : "-",
                   number(median(euclidean) / median(planar), 2),
                   number(median(solve) / median(planar), 2),
                   number(median(solve) / (median(planar) + median(write)), 2),
                   number(median(solve) / median(euclidean), 2)});
    m_domains.add({name, std::to_string(n), milliseconds(median(make)),
                   milliseconds(prepare_marching), milliseconds(prepare_front),
                   number(prepare_peer, 1), number(domain_bytes / double(n), 0),
                   number(peak / double(n), 0), number(marching_bytes / double(n), 0),
                   number(front_bytes / double(n), 0)});
  }

  void print() const
  {
    std::printf("Queries from one vertex over the whole mesh, milliseconds\n");
    m_queries.print();
    std::printf(
        "Bars: Euclidean/marching at most 1.5; solve/marching at least 1.5 at 130,000 to 530,000 "
        "vertices.\n\"write\" is the copy of the distances to the mesh, which is part of CGAL's "
        "solve;\n\"unset\" counts vertices that CGAL's solve left without a distance.\n\n");
    std::printf(
        "Domains and solvers: milliseconds; bytes for each vertex, of solvers after a query\n");
    m_domains.print();
    std::printf("Bars: make_domain below 500 ms at a million vertices; at most 200 bytes for each "
                "vertex.\n\n");
  }

private:
  Table m_queries{{"mesh", "vertices", "obtuse %", "Dijkstra", "marching", "Euclidean", "write",
                   "CGAL solve", "unset", "Euclidean/marching", "solve/marching",
                   "solve/(marching+write)", "solve/Euclidean"}};
  Table m_domains{{"mesh", "vertices", "make_domain", "marching solver", "Euclidean solver",
                   "CGAL heat set-up [s]", "domain [B]", "peak while made [B]",
                   "marching solver [B]", "Euclidean solver [B]"}};
};

// Queries that stop after about a thousand vertices.

// The distance from the source within which `wanted` vertices are, or nan in a component of fewer.
double reach_of(Solver<GP::Euclidean_front>& front, Vertex source, std::size_t wanted,
                double first_guess)
{
  std::size_t reached = 0;
  for(double radius = first_guess;; radius *= 1.5)
  {
    front.compute(source, GP::parameters::maximum_distance(radius));
    std::vector<double> distances;
    for(const Vertex v : front.reached())
      distances.push_back(front.distance(v));
    if(distances.size() >= wanted)
    {
      const auto last = distances.begin() + std::ptrdiff_t(wanted - 1);
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

  const double first_guess = 20. * mean_edge(mesh); // a thousand vertices of a plane, and some
  std::vector<double> planar, euclidean, reached;
  for(const Vertex source : random_vertices(num_vertices(mesh), 201))
  {
    const double bound = reach_of(front, source, 1000, first_guess);
    if(std::isnan(bound))
      continue;
    planar.push_back(
        seconds([&] { marching.compute(source, GP::parameters::maximum_distance(bound)); }));
    euclidean.push_back(
        seconds([&] { front.compute(source, GP::parameters::maximum_distance(bound)); }));
    reached.push_back(double(front.reached().size()));
  }
  Table table(
      {"Bounded query", "vertices", "reached", "marching [ms]", "Euclidean [ms]", "slowest [ms]"});
  if(!euclidean.empty())
    table.add({name, std::to_string(num_vertices(mesh)), number(median(reached), 0),
               milliseconds(median(planar)), milliseconds(median(euclidean)),
               milliseconds(*std::max_element(euclidean.begin(), euclidean.end()))});
  table.print();
  std::printf("Bar: below 1 ms.  Medians of %zu random sources.\n\n", euclidean.size());
}

// Paths between two vertices of a prepared mesh.

struct Way
{
  std::string name;
  double prepare; // seconds
  std::function<double(Vertex, Vertex)> length;
};

// `coarse` is the same surface, whose vertices come first; exact distances are found there.
void measure_paths(const std::string& name, const Mesh& mesh, const Mesh& coarse)
{
  const auto domain = GP::make_domain(mesh);

  std::vector<Way> ways;
  ways.push_back({"geodesic_path(domain)", 0.,
                  [&](Vertex p, Vertex q) { return GP::geodesic_path(domain, p, q).length; }});
  Solver<GP::Euclidean_front> front(domain);
  ways.push_back({"Geodesic_distance_solver, targets", 0.,
                  [&](Vertex p, Vertex q)
                  {
                    front.compute(q, GP::parameters::targets(p));
                    return front.path(p).length;
                  }});
  for(const unsigned landmarks : {0u, 16u})
  {
    std::shared_ptr<GP::Geodesic_path_finder<Mesh>> find;
    const double prepare = seconds(
        [&]
        {
          find = std::make_shared<GP::Geodesic_path_finder<Mesh>>(domain);
          find->add_landmarks(landmarks);
        });
    ways.push_back({"Geodesic_path_finder, " + std::to_string(landmarks) + " landmarks", prepare,
                    [find](Vertex p, Vertex q) { return (*find)(p, q).length; }});
  }

  // Every way takes the pairs twice: what the first round finds out and keeps is told apart.
  constexpr std::size_t number_of_pairs = 200;
  const auto ends = random_vertices(num_vertices(mesh), 2 * number_of_pairs);

  const auto sources = three_sources(num_vertices(coarse));
  std::vector<std::vector<double>> exact;
  for(const Vertex source : sources)
    exact.push_back(exact_distances(coarse, source));
  const auto targets = random_vertices(num_vertices(coarse), 3 * 100);

  Table table({"Path between random vertices", "prepare [ms]", "median [ms]", "90 % [ms]",
               "slowest [ms]", "first round, median", "excess %, mean", "median", "largest"});
  for(const Way& way : ways)
  {
    std::vector<double> first, again, excess;
    for(auto* times : {&first, &again})
      for(std::size_t i = 0; i < number_of_pairs; ++i)
        times->push_back(seconds([&] { way.length(ends[2 * i], ends[2 * i + 1]); }));
    double sum = 0.;
    for(std::size_t i = 0; i < targets.size(); ++i)
    {
      const double shortest = exact[i % 3][std::size_t(targets[i])];
      if(!(shortest > 0.))
        continue;
      excess.push_back(100. * (way.length(sources[i % 3], targets[i]) / shortest - 1.));
      sum += excess.back();
    }
    std::sort(again.begin(), again.end());
    table.add({way.name, milliseconds(way.prepare), milliseconds(median(again)),
               milliseconds(again[again.size() * 9 / 10]), milliseconds(again.back()),
               milliseconds(median(first)), digits(sum / double(excess.size())),
               digits(median(excess)), digits(*std::max_element(excess.begin(), excess.end()))});
  }
  std::printf("%s, %zu vertices\n", name.c_str(), std::size_t(num_vertices(mesh)));
  table.print();
  std::printf("Bar: median below 10 ms.  The excess is over CGAL's exact distance.\n\n");
}

} // namespace

// speed [--quick]
int main(int argc, char* argv[])
{
  const bool quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;

  std::printf("Speed: processor time of one thread, medians.\n\n");

  const auto scan = model("bunny_37k");
  const auto scan_cut = [&](unsigned times) -> std::optional<Mesh>
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
      {"bunny_37k", [&] { return scan_cut(0); }},
  };
  if(!quick)
    meshes = {
        {"icosphere 7", [] { return icosphere(7); }},
        {"icosphere 8", [] { return icosphere(8); }, Peer::left_out},
        {"square 1001^2", [] { return jittered_square(1001); }, Peer::left_out},
        {"bunny_37k once", [&] { return scan_cut(1); }},
        {"bunny_37k twice", [&] { return scan_cut(2); }},
        {"mni152_grey_matter_533k", [] { return model("mni152_grey_matter_533k"); }},
    };

  Query_tables queries;
  for(const Named_mesh& named : meshes)
    if(auto mesh = named.make())
      queries.add(named.name, *mesh, named.peer);
  queries.print();

  // The last mesh that there is: the largest model, else the largest made here.
  for(auto named = meshes.rbegin(); named != meshes.rend(); ++named)
    if(const auto mesh = named->make())
    {
      measure_bounded(named->name, *mesh);
      break;
    }

  if(scan)
    measure_paths(quick ? "bunny_37k" : "bunny_37k once", *scan_cut(quick ? 0 : 1), *scan);
  else
  {
    const Mesh coarse = icosphere(quick ? 4 : 5);
    measure_paths(quick ? "icosphere 4 twice" : "icosphere 5 twice", refined(refined(coarse)),
                  coarse);
  }
}
