// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the claims of Solomon, Rustamov, Guibas and Butscher 2014 on earth mover's distances.
// Tables verify that distances decrease with k and that they are metrics, unlike heat distances.
// Others measure stability under noise, bending and remeshing, evenness and isotropy. Each table
// with k > 0 has the family of the paper, without harmonic fields, and the default of
// Transport_metric. --quick: small meshes only. The arguments basis-sizes, monotonicity, metrics,
// stability, evenness, isotropy and disks select one table. An argument FILE.svg receives a plot of
// the distance of two densities by the basis size.
#include "Error_plot.h"
#include "Gradient_family.h"
#include "models.h"
#include "operators/harmonic_fields.h"
#include "report.h"

#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>
#include <CGAL/Geodesic_processing/geodesic_delaunay_remeshing.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/transport/biharmonic.h>
#include <CGAL/Geodesic_processing/internal/transport/Transport_solver.h>
#include <CGAL/Geodesic_processing/internal/transport/spectral_transport.h>

#include <CGAL/Surface_mesh_deformation.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Geodesic_processing::internal;
using namespace benchmarks;
namespace GP = CGAL::Geodesic_processing;

using Domain = GP::Mesh_domain<Mesh>;
using Triangles = std::shared_ptr<const Surface_arrays>;
using Pair = std::array<Surface_location, 2>;

constexpr double tolerance = 1e-3; // gap between the bounds

Surface_location vertex_location(Index vertex) { return {none, vertex, {}}; }

Front_source source(const Surface_location& location) { return {{location}, 0., 0}; }

double mean(const std::vector<double>& values)
{
  double sum = 0.;
  for(const double x : values)
    sum += x / double(values.size());
  return sum;
}

std::string mean_and_largest(const std::vector<double>& values, int decimals)
{
  return format_fixed(mean(values), decimals) + " / " +
         format_fixed(*std::max_element(values.begin(), values.end()), decimals);
}

// Computes distances by the heat method with a time step of `squares` times the squared mean edge
// length.
GP::Geodesic_distance_solver<Mesh, GP::Heat> heat_solver(const Domain& domain, double squares)
{
  return GP::Geodesic_distance_solver<Mesh, GP::Heat>(domain,
                                                      GP::parameters::heat_time_step(squares));
}

// Returns the distances of all vertices from a vertex.
Vector heat_distances(const Domain& domain, GP::Geodesic_distance_solver<Mesh, GP::Heat>& solver,
                      Index from)
{
  solver.compute(domain.vertex(from));
  Vector result(Eigen::Index(domain.number_of_vertices()));
  for(Index i = 0; i < domain.number_of_vertices(); ++i)
    result[i] = solver.distance(domain.vertex(i));
  return result;
}

// Computes bounds of the distances of pairs of locations, in the caller's unit.
struct Distance_method
{
  std::string name;
  std::function<std::vector<Transport_bounds>(const std::vector<Pair>&)> bounds;

  std::vector<double> values(const std::vector<Pair>& pairs) const
  {
    std::vector<double> result;
    for(const Transport_bounds& b : bounds(pairs))
      result.push_back(0.5 * (b.lower + b.upper));
    return result;
  }
};

// Returns a method that calls distance(pair) for each pair, with equal lower and upper bounds.
template <typename Function>
Distance_method from_pairwise(const std::string& name, Function distance)
{
  return {name, [distance](const std::vector<Pair>& pairs)
          {
            std::vector<Transport_bounds> result;
            for(const Pair& pair : pairs)
            {
              const double d = distance(pair);
              result.push_back({d, d});
            }
            return result;
          }};
}

Distance_method exact(const Triangles& t)
{
  const auto windows = std::make_shared<Window_propagation>(t);
  return from_pairwise("exact",
                       [=](const Pair& pair)
                       {
                         windows->run({source(pair[0])});
                         return t->scale * windows->distance(pair[1]);
                       });
}

Distance_method heat(const Domain& domain, double squares)
{
  const auto solver =
      std::make_shared<GP::Geodesic_distance_solver<Mesh, GP::Heat>>(heat_solver(domain, squares));
  return from_pairwise("heat " + format_significant(squares) + " h2",
                       [=](const Pair& pair)
                       {
                         solver->compute(domain.outer(pair[0]));
                         return solver->distance(domain.outer(pair[1]));
                       });
}

Distance_method biharmonic(const Triangles& t)
{
  const auto distances = std::make_shared<const Biharmonic_distances>(*t);
  return from_pairwise(
      "biharmonic",
      [=](const Pair& pair) {
        return t->scale * distances->all_pairs(masses_at(*t, {pair[0], pair[1]}))(0, 1);
      });
}

// Returns the differences of the unit masses at both locations of each pair.
Masses differences(const Triangles& t, const std::vector<Pair>& pairs)
{
  std::vector<Surface_location> from, to;
  for(const Pair& pair : pairs)
  {
    from.push_back(pair[0]);
    to.push_back(pair[1]);
  }
  return masses_at(*t, to) - masses_at(*t, from);
}

std::vector<Transport_bounds> scaled(std::vector<Transport_bounds> bounds, double scale)
{
  for(Transport_bounds& b : bounds)
    b = {scale * b.lower, scale * b.upper};
  return bounds;
}

// Gradient flows are the default of Transport_metric if k is zero.
Particular_field default_flow(std::size_t k)
{
  return k == 0 ? Particular_field::gradient : Particular_field::raviart_thomas;
}

// The default of Transport_metric.
Distance_method family(const Triangles& t, std::size_t k)
{
  const auto metric = std::make_shared<const Spectral_transport>(t, k, default_flow(k));
  return {"k = " + std::to_string(k), [=](const std::vector<Pair>& pairs)
          {
            Spectral_transport_options options;
            options.tolerance = tolerance;
            return scaled(metric->distances(differences(t, pairs), options), t->scale);
          }};
}

// The family of the paper, without harmonic fields.
Distance_method paper_family(const Triangles& t, std::size_t k)
{
  const auto metric = std::make_shared<const Gradient_family>(t, k);
  return {"k = " + std::to_string(k) + ", paper", [=](const std::vector<Pair>& pairs)
          { return scaled(metric->distances(differences(t, pairs), tolerance), t->scale); }};
}

Distance_method complete(const Triangles& t)
{
  const auto solver = std::make_shared<const Transport_solver>(operators(*t));
  return {"complete", [=](const std::vector<Pair>& pairs)
          {
            std::vector<Transport_bounds> result;
            for(const Pair& pair : pairs)
            {
              Transport_options options;
              options.tolerance = tolerance;
              const Masses m = masses_at(*t, {pair[0], pair[1]});
              const Transport_result found =
                  solver->solve(Vector(m.col(1)) - Vector(m.col(0)), options);
              result.push_back({t->scale * found.lower, t->scale * found.upper});
            }
            return result;
          }};
}

std::vector<Pair> random_pairs(const Domain& domain, std::size_t number, std::mt19937& random)
{
  std::vector<Pair> result;
  while(result.size() < number)
  {
    const Index p = random() % domain.number_of_vertices(),
                q = random() % domain.number_of_vertices();
    if(p != q)
      result.push_back({vertex_location(p), vertex_location(q)});
  }
  return result;
}

void for_each_model(const std::vector<std::string>& names,
                    const std::function<void(const std::string&, Mesh&)>& visit)
{
  for(const std::string& name : names)
    if(auto mesh = load_model(name))
      visit(name, *mesh);
}

// Returns the difference of two densities exp(-(d / r)^2), each with a total mass of one. Here d is
// the distance from a vertex, and r a tenth of the largest distance D from the first vertex. The
// vertices are the first one and one at a distance of about D / 2. Around opposite poles of a
// sphere, the gradient flow would already follow geodesics.
Masses density_difference(const Domain& domain, const Vector& area)
{
  const Triangles& t = domain.triangles();
  const Index n = Index(t->number_of_vertices());
  Window_propagation windows(t);
  const auto distances = [&](Index center)
  {
    windows.run({source(vertex_location(center))});
    Vector result{Eigen::Index(n)};
    for(Index i = 0; i < n; ++i)
      result[i] = windows.distance(i);
    return result;
  };
  const Index first = domain.index(Vertex(0));
  const Vector from_first = distances(first);
  const double largest = from_first.maxCoeff();
  Eigen::Index second = 0;
  (from_first.array() - 0.5 * largest).abs().minCoeff(&second);
  const auto density = [&](const Vector& distance)
  {
    const Vector mass = area.array() * (-(distance / (0.1 * largest)).array().square()).exp();
    return Vector(mass / mass.sum());
  };
  return Masses((density(distances(Index(second))) - density(from_first)).sparseView());
}

// Returns the basis size and the distance of the densities, in scaled units.
std::array<double, 2> distance_by_basis(const Triangles& t, std::size_t k, bool is_paper,
                                        const Masses& difference)
{
  if(is_paper)
  {
    const Gradient_family metric(t, k);
    return {double(metric.basis_size()), metric.distances(difference, tolerance)[0].value()};
  }
  const Spectral_transport metric(t, k, default_flow(k));
  Spectral_transport_options options;
  options.tolerance = tolerance;
  return {double(metric.basis_size()), metric.distances(difference, options)[0].value()};
}

// Figure 3: the distance between two densities decreases with the basis size. Both families are
// compared with the cost of all flows.
void print_basis_sizes(bool is_quick, const std::string& plot_file)
{
  const std::vector<std::size_t> basis_sizes =
      is_quick ? std::vector<std::size_t>{0, 10, 30}
               : std::vector<std::size_t>{0, 10, 20, 50, 100, 200, 300, 400};
  std::vector<std::string> header = {"distance of two densities", "vertices", "family",
                                     "all flows"};
  for(const std::size_t k : basis_sizes)
    header.push_back("k = " + std::to_string(k));
  Table table("basis sizes", header);
  std::vector<Panel> panels;
  const auto add = [&](const std::string& name, const Mesh& mesh)
  {
    const Domain domain(mesh);
    const Triangles& t = domain.triangles();
    const Transport_solver solver(operators(*t));
    const Masses difference = density_difference(domain, lumped_mass(solver.operators()));
    Transport_options options;
    options.tolerance = tolerance;
    const double all_flows = solver.solve(Vector(difference.col(0)), options).value;
    Panel panel{"distance of two densities, " + name.substr(0, name.find('_')),
                "basis size",
                {},
                Axes::linear};
    panel.series.push_back({"all flows", 0, std::nan(""), {}});
    for(const bool is_paper : {true, false})
    {
      Series series{is_paper ? "paper: gradient flow, curl fields"
                             : "default: balanced flow, curl and harmonic fields",
                    is_paper ? 1u : 2u,
                    std::nan(""),
                    {}};
      std::vector<std::string> row = {name, std::to_string(mesh.number_of_vertices()),
                                      is_paper ? "paper" : "default",
                                      format_fixed(t->scale * all_flows, 4)};
      for(const std::size_t k : basis_sizes)
      {
        const auto [size, distance] = distance_by_basis(t, k, is_paper, difference);
        row.push_back(format_fixed(t->scale * distance, 4) + " (+" +
                      format_fixed(100. * (distance / all_flows - 1.), 1) + " %)");
        series.points.push_back({size, t->scale * distance});
      }
      table.add(row);
      panel.series.push_back(series);
    }
    for(const auto& point : {panel.series[1].points.front(), panel.series[1].points.back()})
      panel.series[0].points.push_back({point[0], t->scale * all_flows});
    panels.push_back(panel);
  };
  add("sphere", icosphere(is_quick ? 3 : 4));
  for_each_model({is_quick ? "pig_468" : "elephant_2k8"}, add);
  table.print();
  if(!plot_file.empty() && !write_error_plot(plot_file, panels))
    std::printf("%s cannot be written.\n", plot_file.c_str());
}

// Verifies that distances never increase with k, and measures their excess over geodesic distances.
void print_monotonicity(bool is_quick)
{
  const std::vector<std::size_t> basis_sizes = {0, 10, 30, 100};
  Table table("monotonicity",
              {"monotonicity in k", "vertices", "harmonic fields", "family", "pairs", "increases",
               "from k = 0", "above exact %: k = 0", "k = 10", "k = 30", "k = 100", "complete"});
  for_each_model(
      is_quick ? std::vector<std::string>{"pig_468", "hemisphere_2k"}
               : std::vector<std::string>{"pig_468", "hemisphere_2k", "elephant_2k8",
                                          "mech_holes_shark_5k", "plane_holes_8k5"},
      [&](const std::string& name, Mesh& mesh)
      {
        const Domain domain(mesh);
        const Triangles& t = domain.triangles();
        const std::size_t n = domain.number_of_vertices();
        // The sum over the five models is a thousand pairs.
        const std::size_t number_of_pairs = is_quick   ? 20
                                            : n < 1000 ? 400
                                            : n < 3000 ? 200
                                            : n < 6000 ? 150
                                                       : 50;
        std::mt19937 random;
        const std::vector<Pair> pairs = random_pairs(domain, number_of_pairs, random);
        const std::vector<double> truth = exact(t).values(pairs);
        const auto mean_excess = [&](const std::vector<double>& values)
        {
          std::vector<double> result;
          for(std::size_t j = 0; j < values.size(); ++j)
            result.push_back(100. * (values[j] / truth[j] - 1.));
          return format_fixed(mean(result), 1);
        };
        const Distance_method complete_method = complete(t);
        const std::vector<Transport_bounds> complete_bounds = complete_method.bounds(pairs);
        const std::string complete_excess = mean_excess(complete_method.values(pairs));
        for(const bool is_paper : {true, false})
        {
          std::vector<std::string> row = {name, std::to_string(domain.number_of_vertices()),
                                          std::to_string(number_of_harmonic_fields(*t)),
                                          is_paper ? "paper" : "default",
                                          std::to_string(pairs.size())};
          std::vector<std::string> means;
          std::size_t number_of_increases = 0, increases_from_0 = 0;
          std::vector<Transport_bounds> previous_bounds(pairs.size(), {infinity, infinity});
          for(const std::size_t k : basis_sizes)
          {
            const Distance_method method = is_paper ? paper_family(t, k) : family(t, k);
            const std::vector<Transport_bounds> bounds = method.bounds(pairs);
            std::vector<double> values;
            for(std::size_t j = 0; j < bounds.size(); ++j)
            {
              // After k = 0, the default changes from gradient to balanced flows.
              if(bounds[j].lower > previous_bounds[j].upper * (1. + 1e-9)) // round-off
                ++(k == basis_sizes[1] ? increases_from_0 : number_of_increases);
              // The complete flows contain the gradients of every k. Their distance must therefore
              // not be longer.
              number_of_increases +=
                  is_paper && k == basis_sizes.back() && complete_bounds[j].lower > bounds[j].upper;
              values.push_back(0.5 * (bounds[j].lower + bounds[j].upper));
            }
            previous_bounds = bounds;
            means.push_back(mean_excess(values));
          }
          row.push_back(std::to_string(number_of_increases));
          row.push_back(std::to_string(increases_from_0));
          row.insert(row.end(), means.begin(), means.end());
          row.push_back(complete_excess);
          table.add(row);
        }
      });
  table.print();
}

using Triple = std::array<Index, 3>;

// Returns triples of different indices below `size`.
std::vector<Triple> random_triples(std::size_t number, Index size, std::mt19937& random)
{
  std::vector<Triple> result;
  while(result.size() < number)
  {
    const Index p = random() % size, q = random() % size, r = random() % size;
    if(p != q && q != r && r != p)
      result.push_back({p, q, r});
  }
  return result;
}

// Deviations of a matrix of distances from a metric, over triples of its rows.
struct Metric_deviations
{
  std::size_t number_longer = 0, number_certain = 0; // violations by values, and by the bounds
  double max_excess = 0., asymmetry = 0.;            // relative
};

// Computes the deviations of `bounds`, a row-major matrix of `size` rows.
Metric_deviations metric_deviations(const std::vector<Transport_bounds>& bounds, Index size,
                                    const std::vector<Triple>& triples)
{
  const auto at = [&](Index p, Index q) -> const Transport_bounds& { return bounds[p * size + q]; };
  const auto value = [&](Index p, Index q) { return 0.5 * (at(p, q).lower + at(p, q).upper); };
  Metric_deviations result;
  for(const auto& [p, q, r] : triples)
  {
    const double detour = value(p, q) + value(q, r);
    // The factor admits round-off errors.
    result.number_longer += value(p, r) > detour * (1. + 1e-9);
    result.number_certain += at(p, r).lower > (at(p, q).upper + at(q, r).upper) * (1. + 1e-9);
    result.max_excess = std::max(result.max_excess, value(p, r) / detour - 1.);
    result.asymmetry = std::max(result.asymmetry, std::abs(value(p, r) / value(r, p) - 1.));
  }
  return result;
}

// Computes the distances of all vertices to a vertex.
using One_to_all_function = std::function<Vector(Surface_location)>;

// Returns the fraction of vertices over which a detour is shorter than the distance, for five pairs
// of vertices.
double shorter_detour_ratio(const std::vector<Surface_location>& locations,
                            const One_to_all_function& one_to_all)
{
  std::size_t number_shorter = 0, number_of_detours = 0;
  for(Index i = 0; i < 5; ++i)
  {
    const Vector p = one_to_all(locations[i]), q = one_to_all(locations[i + 5]);
    const double d = 0.5 * (p[locations[i + 5].vertex] + q[locations[i].vertex]);
    for(Index s = 0; s < p.size(); ++s)
      number_shorter += p[s] + q[s] < d * (1. - 1e-6); // sums are single precision
    number_of_detours += std::size_t(p.size());
  }
  return double(number_shorter) / double(number_of_detours);
}

void add_metric_rows(Table& table, const std::string& name, const Mesh& mesh)
{
  const Domain domain(mesh);
  const Triangles& t = domain.triangles();
  constexpr Index samples = 24;
  std::mt19937 random;
  std::vector<Surface_location> locations;
  for(Index i = 0; i < samples; ++i)
    locations.push_back(vertex_location(Index(i * domain.number_of_vertices() / samples)));
  std::vector<Pair> pairs;
  for(const Surface_location& p : locations)
    for(const Surface_location& q : locations)
      pairs.push_back({p, q});
  const std::vector<Triple> triples = random_triples(1000, samples, random);
  const auto add = [&](const Distance_method& method, const One_to_all_function& one_to_all)
  {
    const Metric_deviations found = metric_deviations(method.bounds(pairs), samples, triples);
    table.add(
        {method.name, name, std::to_string(found.number_longer),
         std::to_string(found.number_certain), format_significant(100. * found.max_excess),
         format_significant(100. * found.asymmetry),
         one_to_all ? format_fixed(100. * shorter_detour_ratio(locations, one_to_all), 1) : "-"});
  };
  const auto mass = [&](const Surface_location& p) { return masses_at(*t, {p}); };
  const Biharmonic_distances biharmonic_distances(*t);
  const Spectral_transport spectral(t, 0, Particular_field::gradient);
  for(const double squares : {1., 10., 100.})
  {
    auto solver = heat_solver(domain, squares);
    add(heat(domain, squares),
        [&](const Surface_location& p) { return heat_distances(domain, solver, p.vertex); });
  }
  add(biharmonic(t),
      [&](const Surface_location& p) { return biharmonic_distances.one_to_all(mass(p), 1); });
  add(family(t, 0), [&](const Surface_location& p) { return spectral.one_to_all(mass(p), {}); });
  for(const std::size_t k : {10, 100})
  {
    add(paper_family(t, k), {});
    add(family(t, k), {});
  }
  add(complete(t), {});
}

// Figure 9: verifies the triangle inequality and symmetry on random triples. The detour over every
// vertex is tested for five pairs.
void print_metrics(bool is_quick)
{
  Table table("triangle inequality",
              {"1,000 triples", "model", "violations", "certified violations",
               "maximum violation %", "maximum asymmetry %", "vertices with shorter detour %"});
  for_each_model(is_quick ? std::vector<std::string>{"pig_468"}
                          : std::vector<std::string>{"elephant_2k8", "hemisphere_2k"},
                 [&](const std::string& name, Mesh& mesh) { add_metric_rows(table, name, mesh); });
  table.print();
}

// Figure 8: stability under noise, bending, refinement and remeshing.

Mesh with_noise(Mesh mesh, double edges)
{
  std::mt19937 random;
  std::normal_distribution<double> normal(0., edges * mean_edge_length(mesh));
  for(const Vertex v : mesh.vertices())
  {
    const double x = normal(random), y = normal(random), z = normal(random);
    mesh.point(v) = mesh.point(v) + Kernel::Vector_3(x, y, z);
  }
  return mesh;
}

// Returns a sheet of 3 x 1, bent to a roll of `angle` radians. Each column of quads is planar, so
// that edge lengths are independent of the angle up to round-off errors.
Mesh sheet(int rows, double angle)
{
  Mesh mesh;
  const double side_length = 1. / rows, angle_step = angle / (3. * rows);
  std::vector<std::array<double, 2>> profile = {{0., 0.}};
  for(int i = 0; i < 3 * rows; ++i)
    profile.push_back({profile.back()[0] + side_length * std::cos(angle_step * i),
                       profile.back()[1] + side_length * std::sin(angle_step * i)});
  CGAL::make_grid(
      3 * rows, rows, mesh,
      [&](int i, int j) { return Kernel::Point_3(profile[i][0], side_length * j, profile[i][1]); },
      true);
  return mesh;
}

// Bends `mesh`. The first tenth along the longest axis is rotated by forty degrees relative to the
// far half. The part between deforms as rigidly as possible.
Mesh bend(Mesh mesh)
{
  std::array<double, 3> low, high;
  low.fill(infinity);
  high.fill(-infinity);
  for(const Vertex v : mesh.vertices())
    for(int c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], mesh.point(v)[c]);
      high[c] = std::max(high[c], mesh.point(v)[c]);
    }
  int longest = 0;
  for(int c = 1; c < 3; ++c)
    if(high[c] - low[c] > high[longest] - low[longest])
      longest = c;
  using Deformation = CGAL::Surface_mesh_deformation<Mesh>;
  Deformation deformation(mesh);
  deformation.insert_roi_vertices(mesh.vertices().begin(), mesh.vertices().end());
  std::vector<Vertex> rotated_vertices;
  for(const Vertex v : mesh.vertices())
  {
    const double fraction =
        (mesh.point(v)[longest] - low[longest]) / (high[longest] - low[longest]);
    if(fraction < 0.1)
      rotated_vertices.push_back(v);
    if(fraction < 0.1 || fraction > 0.5)
      deformation.insert_control_vertex(v);
  }
  const double angle = CGAL_PI / 4.5;
  std::array<double, 3> pivot;
  for(int c = 0; c < 3; ++c)
    pivot[c] = 0.5 * (low[c] + high[c]);
  pivot[longest] = low[longest] + 0.3 * (high[longest] - low[longest]);
  const int a = longest, b = (longest + 1) % 3;
  for(const Vertex v : rotated_vertices)
  {
    std::array<double, 3> p = {mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]};
    const double x = p[a] - pivot[a], y = p[b] - pivot[b];
    p[a] = pivot[a] + std::cos(angle) * x - std::sin(angle) * y;
    p[b] = pivot[b] + std::sin(angle) * x + std::cos(angle) * y;
    deformation.set_target_position(v, {p[0], p[1], p[2]});
  }
  deformation.deform(20, 0.);
  return mesh;
}

// Adds a row with the relative changes of distances from one surface to another, mean and largest,
// in percent.
void add_change_row(Table& table, const std::string& name, const Domain& one,
                    const std::vector<Pair>& pairs, const Domain& other,
                    const std::vector<Pair>& same_pairs)
{
  std::vector<std::string> row = {name, std::to_string(one.number_of_vertices()) + " to " +
                                            std::to_string(other.number_of_vertices())};
  const auto methods = [](const Domain& domain)
  {
    const Triangles& t = domain.triangles();
    return std::vector<Distance_method>{exact(t),     heat(domain, 1.),     biharmonic(t),
                                        family(t, 0), paper_family(t, 100), family(t, 100),
                                        complete(t)};
  };
  const std::vector<Distance_method> before = methods(one), after = methods(other);
  for(std::size_t m = 0; m < before.size(); ++m)
  {
    const std::vector<double> a = before[m].values(pairs), b = after[m].values(same_pairs);
    std::vector<double> change;
    for(std::size_t j = 0; j < a.size(); ++j)
      change.push_back(100. * std::abs(b[j] / a[j] - 1.));
    row.push_back(mean_and_largest(change, 1));
  }
  table.add(row);
}

void print_stability(bool is_quick)
{
  const std::size_t number_of_pairs = is_quick ? 5 : 30;
  Table table("stability", {"change %, mean / max", "vertices", "exact", "heat", "biharmonic",
                            "k = 0", "k = 100, paper", "k = 100", "complete"});
  // Adds a row for random pairs of vertices that exist in both meshes.
  const auto add = [&](const std::string& name, const Mesh& one, const Mesh& other)
  {
    const Domain a(one), b(other);
    std::mt19937 random;
    const std::vector<Pair> pairs = random_pairs(a, number_of_pairs, random);
    std::vector<Pair> same;
    for(const auto& [p, q] : pairs)
      same.push_back({vertex_location(b.index(a.vertex(p.vertex))),
                      vertex_location(b.index(a.vertex(q.vertex)))});
    add_change_row(table, name, a, pairs, b, same);
  };
  const int rows = is_quick ? 10 : 24;
  add("sheet, rolled", sheet(rows, 0.), sheet(rows, 1.5 * CGAL_PI));
  for_each_model(
      is_quick ? std::vector<std::string>{"pig_468"}
               : std::vector<std::string>{"elephant_2k8", "cow_2k9"},
      [&](const std::string& name, Mesh& mesh)
      {
        add(name + ", noise of 0.1 edges", mesh, with_noise(mesh, 0.1));
        add(name + ", noise of 0.3 edges", mesh, with_noise(mesh, 0.3));
        add(name + ", bent", mesh, bend(mesh));
        if(num_vertices(mesh) < 2800) // otherwise slow
          add(name + ", refined once", mesh, refined(mesh));
        const Domain domain(mesh);
        for(const std::size_t vertices : {num_vertices(mesh) / 4, num_vertices(mesh) / 2})
        {
          Mesh even;
          auto location = even.add_property_map<Vertex, GP::Location<Mesh>>("v:location").first;
          GP::geodesic_delaunay_remeshing(
              mesh, vertices, even,
              GP::parameters::location_map(location).number_of_relaxation_steps(5));
          const Domain other(even);
          std::mt19937 random;
          std::vector<Pair> pairs = random_pairs(other, number_of_pairs, random), same = pairs;
          for(Pair& pair : pairs)
            for(Surface_location& p : pair)
              p = domain.inner(location[other.vertex(p.vertex)]);
          add_change_row(table, name + ", remeshed", domain, pairs, other, same);
        }
      });
  table.print();
}

// Returns the default of Transport_metric.
One_to_all_function one_to_all(const Triangles& t, std::size_t k)
{
  const auto metric = std::make_shared<const Spectral_transport>(t, k, default_flow(k));
  return [=](const Surface_location& p) { return metric->one_to_all(masses_at(*t, {p}), {}); };
}

// Returns the family of the paper. If the surface has harmonic fields, Spectral_transport is not
// this family, and distances are minimized for each vertex.
One_to_all_function paper_one_to_all(const Triangles& t, std::size_t k)
{
  if(number_of_harmonic_fields(*t) == 0)
  {
    const auto metric =
        std::make_shared<const Spectral_transport>(t, k, Particular_field::gradient);
    return [=](const Surface_location& p) { return metric->one_to_all(masses_at(*t, {p}), {}); };
  }
  const auto metric = std::make_shared<const Gradient_family>(t, k);
  return [=](const Surface_location& p)
  {
    std::vector<Pair> pairs;
    for(Index i = 0; i < t->number_of_vertices(); ++i)
      if(i != p.vertex)
        pairs.push_back({p, vertex_location(i)});
    Vector result = Vector::Zero(Eigen::Index(t->number_of_vertices()));
    // A gap of 1 % is the mean error of Spectral_transport::one_to_all().
    const std::vector<Transport_bounds> bounds = metric->distances(differences(t, pairs), 1e-2);
    for(std::size_t j = 0; j < pairs.size(); ++j)
      result[pairs[j][1].vertex] = bounds[j].value();
    return result;
  };
}

// Measures the evenness of level sets by the coefficient of variation of the gradient norm. Faces
// closer to the source than a twentieth of the largest distance are excluded.
void print_evenness(bool is_quick)
{
  Table table("unevenness",
              {"unevenness", "vertices", "exact", "heat", "biharmonic", "k = 0", "k = 10, paper",
               "k = 10", "k = 100, paper", "k = 100", "k = 0 / biharmonic"});
  const auto add = [&](const std::string& name, const Mesh& mesh)
  {
    const Domain domain(mesh);
    const Triangles& t = domain.triangles();
    const Index n = Index(t->number_of_vertices());
    const Operators o = operators(*t);
    const std::vector<Index> sources = {0, n / 2};
    std::vector<std::vector<double>> unevenness_values(8);
    auto solver = heat_solver(domain, 1.);
    const Biharmonic_distances biharmonic_distances(*t);
    std::vector<One_to_all_function> families = {one_to_all(t, 0)};
    for(const std::size_t k : {10, 100})
    {
      families.push_back(paper_one_to_all(t, k));
      families.push_back(one_to_all(t, k));
    }
    for(const Index from : sources)
    {
      Window_propagation windows(t);
      windows.run({source(vertex_location(from))});
      Vector truth(n);
      for(Index i = 0; i < n; ++i)
        truth[i] = windows.distance(i);
      const double min_distance = 0.05 * truth.maxCoeff();
      const auto unevenness = [&](const Vector& function)
      {
        double area = 0., sum = 0., squares = 0.;
        const Field slope = gradient(o, function);
        for(std::size_t f = 0; f < slope.size(); ++f)
        {
          const Index* corner = &o.corner[3 * f];
          if(std::min({truth[corner[0]], truth[corner[1]], truth[corner[2]]}) < min_distance)
            continue;
          area += o.area[f];
          sum += o.area[f] * norm(slope[f]);
          squares += o.area[f] * dot(slope[f], slope[f]);
        }
        return std::sqrt(squares * area / (sum * sum) - 1.);
      };
      const Masses mass = masses_at(*t, {vertex_location(from)});
      unevenness_values[0].push_back(unevenness(truth));
      unevenness_values[1].push_back(unevenness(heat_distances(domain, solver, from)));
      unevenness_values[2].push_back(unevenness(biharmonic_distances.one_to_all(mass, 1)));
      for(std::size_t i = 0; i < families.size(); ++i)
        unevenness_values[3 + i].push_back(unevenness(families[i](vertex_location(from))));
    }
    std::vector<std::string> row = {name, std::to_string(n)};
    for(const auto& values : unevenness_values)
      row.push_back(format_fixed(mean(values), 2));
    row.push_back(format_fixed(mean(unevenness_values[3]) / mean(unevenness_values[2]), 2));
    table.add(row);
  };
  add("torus", mesh_of(CGAL::Geodesic_processing::test::torus(80, 32)));
  for_each_model(is_quick ? std::vector<std::string>{"hemisphere_2k"}
                          : std::vector<std::string>{"hemisphere_2k", "elephant_2k8", "cow_2k9",
                                                     "dino_4k", "knot1_3k", "triceratops_2k8"},
                 add);
  table.print();
}

// Measures the dependence of distances on the direction. On a sphere, vertices at about the same
// great circle distance from a pole are compared, after subtraction of a linear fit in each band.
// On a square, points that its symmetries map to each other are compared.
void print_isotropy(bool is_quick)
{
  Table table("anisotropy", {"anisotropy %", "vertices", "biharmonic", "k = 0", "k = 5, paper",
                             "k = 5", "k = 10, paper", "k = 10", "k = 100, paper", "k = 100",
                             "basis size for 5, 10, 100"});
  const auto add = [&](const std::string& name, const Mesh& mesh, Vertex from,
                       const std::function<double(const Domain&, const Vector&)>& spread)
  {
    const Domain domain(mesh);
    const Triangles& t = domain.triangles();
    const Masses mass = masses_at(*t, {vertex_location(domain.index(from))});
    std::vector<std::string> row = {name, std::to_string(domain.number_of_vertices())};
    std::string basis_sizes;
    row.push_back(
        format_fixed(100. * spread(domain, Biharmonic_distances(*t).one_to_all(mass, 1)), 2));
    const auto add_cell = [&](std::size_t k, Particular_field kind)
    {
      const Spectral_transport family(t, k, kind);
      row.push_back(format_fixed(100. * spread(domain, family.one_to_all(mass, {})), 2));
      return std::to_string(family.basis_size());
    };
    add_cell(0, Particular_field::gradient);
    for(const std::size_t k : {5, 10, 100})
    {
      // Without harmonic fields, gradient flows are the family of the paper.
      add_cell(k, Particular_field::gradient);
      basis_sizes += (basis_sizes.empty() ? "" : ", ") + add_cell(k, default_flow(k));
    }
    row.push_back(basis_sizes);
    table.add(row);
  };
  const Mesh ball = icosphere(is_quick ? 3 : 4);
  add("sphere", ball, Vertex(0),
      [&](const Domain& domain, const Vector& d)
      {
        const std::vector<double> angle = great_circle_distances(ball, Vertex(0));
        double max_deviation = 0.;
        for(int band = 2; band < 18; ++band)
        {
          double n = 0., x = 0., y = 0., xx = 0., xy = 0., yy = 0.;
          for(const Vertex v : ball.vertices())
          {
            const double a = angle[v], b = d[domain.index(v)];
            if(int(a / CGAL_PI * 20.) != band)
              continue;
            n += 1.;
            x += a, y += b, xx += a * a, xy += a * b, yy += b * b;
          }
          const double sxx = xx - x * x / n, sxy = xy - x * y / n, syy = yy - y * y / n;
          max_deviation = std::max(max_deviation,
                                   std::sqrt(std::max(0., (syy - sxy * sxy / sxx) / n)) / (y / n));
        }
        return max_deviation;
      });
  const int n = is_quick ? 20 : 40;
  const Mesh plane = mesh_of(CGAL::Geodesic_processing::test::square(std::size_t(n)));
  const auto point = [=](int i, int j) { return Vertex(Mesh::size_type(i + (n + 1) * j)); };
  add("square", plane, point(n / 2, n / 2),
      [&](const Domain& domain, const Vector& d)
      {
        double max_deviation = 0.;
        for(int i = n / 2 + 4; i <= n; ++i)
          for(int j = n / 2; j <= i; ++j)
          {
            double low = infinity, high = 0.;
            for(const auto& [a, b] : {std::array{i, j}, std::array{j, i}})
              for(const auto& [c, e] : {std::array{a, b}, std::array{n - a, b},
                                        std::array{a, n - b}, std::array{n - a, n - b}})
              {
                low = std::min(low, d[domain.index(point(c, e))]);
                high = std::max(high, d[domain.index(point(c, e))]);
              }
            max_deviation = std::max(max_deviation, high / low - 1.);
          }
        return max_deviation;
      });
  table.print();
}

// Proposition 2: the distance to a uniform mass on a disk differs from the distance to its center
// by at most the radius plus the gap.
void print_disks(bool is_quick)
{
  Table table("disks", {"radius / distance", "model", "error / (radius + gap), mean / max"});
  for_each_model(
      is_quick ? std::vector<std::string>{"pig_468"}
               : std::vector<std::string>{"elephant_2k8", "kitten_9k"},
      [&](const std::string& name, Mesh& mesh)
      {
        const Domain domain(mesh);
        const Triangles& t = domain.triangles();
        const Transport_solver solver(operators(*t));
        const Vector area = lumped_mass(solver.operators());
        Window_propagation windows(t);
        std::mt19937 random;
        const std::vector<Pair> pairs = random_pairs(domain, is_quick ? 3 : 10, random);
        for(const double radius_ratio : {0.4, 0.2, 0.1, 0.05})
        {
          std::vector<double> error;
          for(const auto& [p, q] : pairs)
          {
            windows.run({source(q)});
            const double exact = windows.distance(p.vertex), radius = radius_ratio * exact;
            Vector disk = Vector::Zero(area.size());
            for(Index i = 0; i < disk.size(); ++i)
              if(windows.distance(i) <= radius)
                disk[i] = area[i];
            const Transport_result found =
                solver.solve(disk / disk.sum() - Vector(masses_at(*t, {p}).col(0)));
            error.push_back(std::abs(found.value - exact) / (radius + found.upper - found.lower));
          }
          table.add({format_significant(radius_ratio), name, mean_and_largest(error, 2)});
        }
      });
  table.print();
}

} // namespace

int main(int argc, char* argv[])
{
  using Print = void (*)(bool);
  const std::pair<const char*, Print> sections[] = {
      {"monotonicity", print_monotonicity}, {"metrics", print_metrics},
      {"stability", print_stability},       {"evenness", print_evenness},
      {"isotropy", print_isotropy},         {"disks", print_disks}};
  bool is_quick = false;
  std::string selected, plot_file;
  for(int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if(argument == "--quick")
      is_quick = true;
    else if(argument.find(".svg") != std::string::npos)
      plot_file = argument;
    else
      selected = argument;
  }
  for(const auto& [name, print] : sections)
    if(selected.empty() || selected == name)
      print(is_quick);
  if(selected.empty() || selected == "basis-sizes")
    print_basis_sizes(is_quick, plot_file);
  std::printf("Targets: no increases, from k = 0 only in the default; certified violations of the "
              "triangle inequality only for heat; all "
              "transport distances\nsymmetric; errors of disks at most 1.\n");
}
