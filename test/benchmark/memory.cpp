// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the memory of domains, solvers and distance matrices, and how the memory and the time of
// a solver change with the number of queries.
#include <CGAL/Geodesic_processing.h>

#include "clouds.h"
#include "models.h"
#include "report.h"

#include <CGAL/Point_set_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace {

namespace GP = CGAL::Geodesic_processing;
using namespace benchmarks;
using Point_set = CGAL::Point_set_3<Kernel::Point_3, Kernel::Vector_3>;

std::string per_vertex(double bytes, std::size_t number_of_vertices)
{
  return format_fixed(bytes / double(number_of_vertices), 0);
}

std::string milliseconds(double seconds) { return format_significant(1000. * seconds); }

// Adds a row with the memory of a solver before and after queries over the whole surface, in
// addition to the domain, and the times of the first and of later queries from one source. No solver
// stores more data after the beginning of the fifth query.
template <typename Method, typename Surface, typename Domain, typename Source>
void add_solver(Table& table, const std::string& name, const std::string& method,
                const Domain& domain, std::size_t n, Source source)
{
  const double before = allocated_bytes();
  const auto bytes = [&] { return per_vertex(allocated_bytes() - before, n); };
  std::optional<GP::Geodesic_distance_solver<Surface, Method>> solver;
  const double setup = cpu_seconds([&] { solver.emplace(domain); });
  std::vector<std::string> row = {name, std::to_string(n), method, bytes()};
  std::vector<double> times;
  for(int i = 0; i < 8; ++i)
  {
    times.push_back(cpu_seconds([&] { solver->compute(source); }));
    if(i == 0 || i == 4)
      row.push_back(bytes());
  }
  for(const double seconds : {setup, times[0], median({times.begin() + 5, times.end()})})
    row.push_back(milliseconds(seconds));
  table.add(row);
}

Table solver_table(const std::string& title)
{
  return Table(title, {"surface", "vertices", "method", "new [bytes per vertex]",
                       "after 1 query [bytes per vertex]", "after 5 queries [bytes per vertex]",
                       "set-up [ms]", "query 1 [ms]", "later queries [ms]"});
}

Table domain_table(const std::string& title)
{
  return Table(title, {"surface", "vertices", "domain [bytes per vertex]",
                       "peak [bytes per vertex]", "make_domain() [s]"});
}

// Returns the domain of a surface, and adds a row with its memory and its time.
template <typename Surface>
auto measured_domain(Table& table, const std::string& name, const Surface& surface, std::size_t n)
{
  reset_peak_memory();
  const double peak_before = peak_memory(), before = allocated_bytes();
  std::optional<decltype(GP::make_domain(surface))> domain;
  const double seconds = cpu_seconds([&] { domain.emplace(GP::make_domain(surface)); });
  table.add({name, std::to_string(n), per_vertex(allocated_bytes() - before, n),
             per_vertex(peak_memory() - peak_before, n), format_significant(seconds)});
  return *domain;
}

void measure_meshes(bool is_quick)
{
  Table domains = domain_table("domains of meshes"), solvers = solver_table("solvers on meshes");
  const auto add = [&](const std::string& name, const Mesh& mesh)
  {
    const std::size_t n = num_vertices(mesh);
    const auto domain = measured_domain(domains, name, mesh, n);
    const Vertex source(Mesh::size_type(n / 3));
    add_solver<GP::Dijkstra, Mesh>(solvers, name, "Dijkstra", domain, n, source);
    add_solver<GP::Fast_marching, Mesh>(solvers, name, "Fast_marching", domain, n, source);
    add_solver<GP::Euclidean_front, Mesh>(solvers, name, "Euclidean_front", domain, n, source);
    add_solver<GP::Exact, Mesh>(solvers, name, "Exact", domain, n, source);
  };
  add("square 101^2", jittered_square(101));
  if(!is_quick)
  {
    add("square 1001^2", jittered_square(1001));
    for(const std::string name :
        {"bunny_37k", "nefertiti_35k", "fandisk_16k", "mni152_grey_matter_533k"})
      if(const auto mesh = load_model(name))
        add(name, *mesh);
  }
  domains.print();
  solvers.print();
}

Point_set random_sphere_cloud(std::size_t n)
{
  Point_set result(true);
  result.reserve(n);
  std::mt19937 random(1);
  std::normal_distribution<double> coordinate;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    const Kernel::Vector_3 normal = Kernel::Vector_3(x, y, z) / std::sqrt(x * x + y * y + z * z);
    result.insert(CGAL::ORIGIN + normal, normal);
  }
  return result;
}

// Measures random surfels of a sphere.
void measure_clouds(bool is_quick)
{
  Table domains = domain_table("domains of clouds"), solvers = solver_table("solvers on clouds"),
        decals("decals of 2,000 surfels", {"surfels", "median [ms]", "maximum [ms]"});
  for(const std::size_t n : is_quick ? std::vector<std::size_t>{10000}
                                     : std::vector<std::size_t>{100000, 1000000, 10000000})
  {
    const std::string name = "sphere " + std::to_string(n);
    const Point_set cloud = random_sphere_cloud(n);
    const auto domain = measured_domain(domains, name, cloud, n);
    const Point_set::Index source(n / 3);
    add_solver<GP::Dijkstra, Point_set>(solvers, name, "Dijkstra", domain, n, source);
    add_solver<GP::Fast_marching, Point_set>(solvers, name, "Fast_marching", domain, n, source);
    add_solver<GP::Euclidean_front, Point_set>(solvers, name, "Euclidean_front", domain, n, source);

    // The first image also accesses the memory of the placer for the first time.
    const double side = std::sqrt(4. * CGAL_PI * 2000. / double(n));
    GP::Decal_placer<Point_set> placer(domain);
    placer.place(source, side, side);
    std::mt19937 random(2);
    std::vector<double> times;
    for(int i = 0; i < 41; ++i)
    {
      const Point_set::Index center(random() % n);
      times.push_back(cpu_seconds([&] { placer.place(center, side, side); }));
    }
    decals.add({std::to_string(n), milliseconds(median(times)),
                milliseconds(*std::max_element(times.begin(), times.end()))});
  }
  domains.print();
  solvers.print();
  decals.print();
}

// Compares a matrix of all pairs in a file with one in memory.
void measure_matrices(bool is_quick)
{
  const auto mesh = is_quick ? std::optional<Mesh>(icosphere(3)) : load_model("man_17k");
  if(!mesh)
    return;
  const std::string name = is_quick ? "icosphere 3" : "man_17k";
  const std::vector<Vertex> vertices(mesh->vertices().begin(), mesh->vertices().end());
  const auto domain = GP::make_domain(*mesh);
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / "geodesic_processing_memory_benchmark.npy";
  Table table("matrices of all pairs, Fast_marching",
              {"mesh", "vertices", "output", "processor time [s]", "peak [MB]"});
  const auto add = [&](const char* output, const std::function<void()>& compute)
  {
    reset_peak_memory();
    const double before = peak_memory(), seconds = cpu_seconds(compute);
    table.add({name, std::to_string(vertices.size()), output, format_significant(seconds),
               format_significant((peak_memory() - before) / 1e6)});
  };
  add("file, float",
      [&]
      {
        GP::write_geodesic_distance_matrix<GP::Fast_marching, CGAL::Sequential_tag, float>(
            domain, vertices, file.string());
      });
  std::filesystem::remove(file);
  add("memory, double", [&]
      { GP::geodesic_distance_matrix<GP::Fast_marching, CGAL::Sequential_tag>(domain, vertices); });
  table.print();
}

} // namespace

// memory [--quick]
int main(int argc, char* argv[])
{
  const bool is_quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  std::printf("Memory of solvers is in addition to the domain and includes the result. Queries are "
              "from one source to all vertices.\n\n");
  measure_meshes(is_quick);
  measure_clouds(is_quick);
  measure_matrices(is_quick);
}
