// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the relative errors of the distance methods, their convergence orders, and the lengths
// of paths. The argument --paths selects the paths.
#include <CGAL/Geodesic_processing.h>

#include "Error_plot.h"
#include "Cgal_heat_solver.h"
#include "Path_comparison.h"
#include "Two_distance_front.h"
#include "models.h"
#include "report.h"

#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace benchmarks;
namespace GP = CGAL::Geodesic_processing;

// With more vertices, the factorizations of the heat methods take minutes.
constexpr std::size_t max_vertices_for_heat = 200000;

const std::vector<std::string> methods = {"Dijkstra", "Fast_marching", "Euclidean_front",
                                          "Heat",     "CGAL heat",     "two distances"};
enum
{
  dijkstra,
  marching,
  front,
  heat,
  cgal_heat,
  two_distances
};

struct Errors
{
  double mean = std::nan(""), maximum = std::nan(""); // relative
};

// Computes the mean and maximum relative error over the vertices with at least 5 % of the largest
// distance. Closer to the source, relative errors depend on the first triangle rather than on the
// method.
template <typename Distance>
Errors errors(const std::vector<double>& reference, Distance distance)
{
  const double min_distance = 0.05 * *std::max_element(reference.begin(), reference.end());
  Errors result{0., 0.};
  std::size_t number = 0;
  for(std::size_t i = 0; i < reference.size(); ++i)
    if(reference[i] >= min_distance)
    {
      const double error =
          std::fabs(distance(Vertex(Mesh::size_type(i))) - reference[i]) / reference[i];
      result.mean += error;
      result.maximum = std::max(result.maximum, error);
      ++number;
    }
  result.mean /= double(number);
  return result;
}

// Solvers of all methods on one mesh.
class Prepared_solvers
{
public:
  explicit Prepared_solvers(Mesh& mesh)
      : m_domain(GP::make_domain(mesh)), m_dijkstra(m_domain), m_marching(m_domain),
        m_front(m_domain), m_two_distances(*m_domain.triangles())
  {
    if(num_vertices(mesh) <= max_vertices_for_heat)
    {
      m_heat = std::make_unique<Solver<GP::Heat>>(m_domain);
      m_cgal_heat = std::make_unique<Cgal_heat_solver>(mesh);
    }
  }

  // Returns the errors of the distances from `source`, in the order of `methods`. If a solver is
  // absent, its errors are nan.
  std::vector<Errors> errors(Vertex source, const std::vector<double>& reference)
  {
    std::vector<Errors> result;
    const auto run = [&](auto* solver)
    {
      if(!solver)
      {
        result.push_back({});
        return;
      }
      solver->compute(source);
      result.push_back(::errors(reference, [&](Vertex v) { return solver->distance(v); }));
    };
    run(&m_dijkstra);
    run(&m_marching);
    run(&m_front);
    run(m_heat.get());
    run(m_cgal_heat.get());
    m_two_distances.compute(m_domain.index(source));
    result.push_back(::errors(
        reference, [&](Vertex v)
        { return m_domain.triangles()->scale * m_two_distances.distance(m_domain.index(v)); }));
    return result;
  }

private:
  template <typename Method>
  using Solver = GP::Geodesic_distance_solver<Mesh, Method>;
  GP::Mesh_domain<Mesh> m_domain;
  Solver<GP::Dijkstra> m_dijkstra;
  Solver<GP::Fast_marching> m_marching;
  Solver<GP::Euclidean_front> m_front;
  std::unique_ptr<Solver<GP::Heat>> m_heat;
  std::unique_ptr<Cgal_heat_solver> m_cgal_heat;
  Two_distance_front m_two_distances;
};

std::string percent(const Errors& e)
{
  return std::isnan(e.mean)
             ? "-"
             : format_significant(100. * e.mean) + " / " + format_significant(100. * e.maximum);
}

// Table of errors with one row per source. add() returns the errors of each method over the
// sources: the mean of the means, the maximum of the maxima.
class Accuracy_table
{
public:
  explicit Accuracy_table(const char* title) : m_table(title, table_header()) {}

  std::vector<Errors> add(const std::string& name, Mesh& mesh, const std::vector<Vertex>& sources,
                          const std::vector<std::vector<double>>& reference)
  {
    Prepared_solvers solvers(mesh);
    std::vector<Errors> means(methods.size(), Errors{0., 0.});
    for(std::size_t s = 0; s < sources.size(); ++s)
    {
      const auto found = solvers.errors(sources[s], reference[s]);
      std::vector<std::string> row = {name, std::to_string(num_vertices(mesh)),
                                      std::to_string(std::size_t(sources[s]))};
      for(std::size_t m = 0; m < methods.size(); ++m)
      {
        row.push_back(percent(found[m]));
        means[m].mean += found[m].mean / double(sources.size());
        means[m].maximum = std::max(means[m].maximum, found[m].maximum);
      }
      row.push_back(format_significant(found[cgal_heat].mean / found[front].mean));
      row.push_back(format_significant(found[marching].mean / found[front].mean));
      m_table.add(row);
    }
    return means;
  }
  void print() const { m_table.print(); }

private:
  static std::vector<std::string> table_header()
  {
    std::vector<std::string> result = {"mesh", "vertices", "source"};
    result.insert(result.end(), methods.begin(), methods.end());
    result.insert(result.end(), {"CGAL heat/front", "marching/front"});
    return result;
  }
  Table m_table;
};

// Mean errors of each method for several edge lengths.
class Convergence
{
public:
  void add(double edge, const std::vector<Errors>& means)
  {
    for(std::size_t m = 0; m < methods.size(); ++m)
      if(std::isfinite(means[m].mean))
        m_points[m].push_back({edge, means[m].mean});
  }

  // Returns the slope of the least-squares line of log error over log edge length, for the last
  // three edge lengths that were added. Returns nan if there are fewer than three.
  double order(std::size_t method) const
  {
    const auto found = m_points.find(method);
    if(found == m_points.end() || found->second.size() < 3)
      return std::nan("");
    double x = 0., y = 0., xx = 0., xy = 0.;
    for(auto p = found->second.end() - 3; p != found->second.end(); ++p)
    {
      const double u = std::log((*p)[0]), v = std::log((*p)[1]);
      x += u / 3.;
      y += v / 3.;
      xx += u * u / 3.;
      xy += u * v / 3.;
    }
    return (xy - x * y) / (xx - x * x);
  }

  void print(const char* title) const
  {
    std::vector<std::string> header = {"errors"}, row = {"order"};
    for(std::size_t m = 0; m < methods.size(); ++m)
    {
      header.push_back(methods[m]);
      row.push_back(format_fixed(order(m), 2));
    }
    Table table(title, header);
    table.add(row);
    table.print();
  }

  Panel panel(const std::string& title) const
  {
    Panel result{title, "mean edge length", {}};
    for(const auto& [method, points] : m_points)
      if(method != two_distances)
        result.series.push_back({methods[method], method, order(method), points});
    return result;
  }

private:
  std::map<std::size_t, std::vector<std::array<double, 2>>> m_points;
};

std::vector<std::vector<double>>
reference_distances(const Mesh& mesh, const std::vector<Vertex>& sources,
                    const std::function<std::vector<double>(const Mesh&, Vertex)>& distances)
{
  std::vector<std::vector<double>> result;
  for(const Vertex source : sources)
    result.push_back(distances(mesh, source));
  return result;
}

// Compares the methods with great circle distances on unit spheres.
Convergence print_spheres(bool quick)
{
  std::printf("Unit sphere, compared with great circles\n");
  Convergence result;
  Accuracy_table table("errors on spheres, %");
  for(unsigned level = 3; level <= (quick ? 5u : 8u); ++level)
  {
    Mesh mesh = icosphere(level);
    const auto sources = three_sources(num_vertices(mesh));
    result.add(mean_edge_length(mesh),
               table.add("icosphere " + std::to_string(level), mesh, sources,
                         reference_distances(mesh, sources, great_circle_distances)));
  }
  table.print();
  std::printf(
      "Targets for the mean of Euclidean_front: 0.15 at 10242 and 0.037 at 163842 vertices.\n");
  result.print("order on spheres");
  return result;
}

// Compares the methods with straight lines on flat squares.
void print_squares(bool quick)
{
  std::printf("Flat square (jittered grid, random diagonals), compared with straight lines\n");
  Accuracy_table table("errors on squares, %");
  double obtuse_ratio = 0.;
  for(const std::size_t n :
      quick ? std::vector<std::size_t>{101} : std::vector<std::size_t>{101, 301, 1001})
  {
    Mesh mesh = jittered_square(n);
    obtuse_ratio = obtuse_face_ratio(mesh);
    const auto sources = three_sources(num_vertices(mesh));
    table.add("square " + std::to_string(n) + "^2", mesh, sources,
              reference_distances(mesh, sources, euclidean_distances));
  }
  table.print();
  std::printf("Target for the maximum of Euclidean_front: 1e-4 percent. %.0f %% of the faces are "
              "obtuse.\n\n",
              100. * obtuse_ratio);
}

// Compares the methods with exact distances on models. Returns the convergence on refinements of
// the first model, or nothing if no model is found.
std::optional<Convergence> print_models(bool quick)
{
  const auto names =
      quick ? std::vector<std::string>{"elephant_2k8", "kitten_9k"}
            : std::vector<std::string>{"bunny_37k",    "armadillo_26k",     "nefertiti_35k",
                                       "boot_20k",     "fandisk_6k5",       "kitten_9k",
                                       "camel_10k",    "human_man_7k",      "eight_5k",
                                       "elephant_2k8", "chinese_dragon_10k"};
  Convergence result;
  Accuracy_table table("errors on models, %");
  std::size_t found = 0;
  for(const std::string& name : names)
  {
    auto mesh = load_model(name);
    if(!mesh)
      continue;
    ++found;
    const auto sources = three_sources(num_vertices(*mesh));
    const auto reference = reference_distances(*mesh, sources, exact_distances);
    const auto means = table.add(name, *mesh, sources, reference);
    if(name != names.front())
      continue;
    // Refinement changes neither the surface nor its distances. The reference is therefore reused.
    result.add(mean_edge_length(*mesh), means);
    Mesh finer = *mesh;
    for(const std::string suffix : {", refined once", ", refined twice"})
    {
      finer = refined(finer);
      result.add(mean_edge_length(finer), table.add(name + suffix, finer, sources, reference));
    }
  }
  if(found == 0)
  {
    std::printf("No models: there is no folder %s.\n", GEODESIC_PROCESSING_DATA);
    return std::nullopt;
  }
  std::printf("Models, compared with CGAL's exact algorithm. Refinement splits each face into "
              "four\nand does not change the surface.\n");
  table.print();
  std::printf("Targets for bunny_37k, armadillo_26k and nefertiti_35k: both ratios at least 3, "
              "Euclidean_front\nbelow 0.3 if possible.\n");
  result.print(("order on " + names.front()).c_str());
  return result;
}

// Compares path tracers on distances from three sources with exact distances.
void print_paths(bool quick)
{
  std::printf(
      "Paths from 300 random vertices to three sources: excess of the length over the exact "
      "distance in percent,\nmean / maximum of the paths that arrive. Vertex gradients: "
      "interpolated, fourth-order Runge-Kutta steps\nof 1/4 of the mean edge length (Peyre and "
      "Cohen 2003). Face gradients: the descent of this package.\nShortened: to locally shortest "
      "paths.\n\n");
  std::vector<std::pair<std::string, Mesh>> meshes;
  meshes.emplace_back("icosphere 5", icosphere(5));
  meshes.emplace_back("square 101^2", jittered_square(101));
  for(const std::string name : {"bunny_37k", "nefertiti_35k", "fandisk_6k5", "mech_holes_shark_5k"})
    if(auto mesh = load_model(name); mesh && !(quick && num_vertices(*mesh) > 10000))
      meshes.emplace_back(name, std::move(*mesh));
  Table table("paths", Path_comparison::table_header());
  for(const auto& [name, mesh] : meshes)
    Path_comparison(mesh, 0.25).add_rows(table, name);
  table.print();

  std::printf("Vertex gradients on the sphere, with other steps\n\n");
  Table steps("paths with other steps", Path_comparison::table_header());
  for(const double step : {2., 1., 0.5, 0.125})
    Path_comparison(meshes.front().second, step)
        .add_rows(steps, format_significant(step) + " mean edges", 1);
  steps.print();
}

} // namespace

// accuracy [--quick] [--paths] [PLOT.svg]
int main(int argc, char* argv[])
{
  bool quick = false, only_paths = false;
  std::string plot;
  for(int i = 1; i < argc; ++i)
    if(std::strcmp(argv[i], "--quick") == 0)
      quick = true;
    else if(std::strcmp(argv[i], "--paths") == 0)
      only_paths = true;
    else
      plot = argv[i];
  if(only_paths)
  {
    print_paths(quick);
    return EXIT_SUCCESS;
  }

  std::printf(
      "Accuracy: mean / maximum relative error in percent, from one source vertex. Vertices\n"
      "closer than 5 %% of the maximum distance are excluded.\n\n");
  const Convergence on_sphere = print_spheres(quick);
  print_squares(quick);
  const std::optional<Convergence> on_scan = print_models(quick);
  print_paths(quick);

  if(!plot.empty())
  {
    std::vector<Panel> panels = {on_sphere.panel("Unit sphere, compared with great circles")};
    if(on_scan)
      panels.push_back(on_scan->panel("Scan and refinements, compared with exact distances"));
    if(!write_error_plot(plot, panels))
    {
      std::fprintf(stderr, "accuracy: cannot write %s\n", plot.c_str());
      return EXIT_FAILURE;
    }
    std::printf("The convergence plot is in %s\n", plot.c_str());
  }
}
