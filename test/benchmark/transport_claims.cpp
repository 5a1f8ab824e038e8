// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What Solomon, Rustamov, Guibas and Butscher 2014 say of earth mover's distances, measured: their tables of
// seconds, and that distances only fall with k, are metrics where those by heat are none, bear noise, bending
// and other triangles, are even and the same in all directions.  --quick: small meshes only; table-1, table-2,
// fall, metrics, stability, evenness, isotropy or discs: this alone.
#include <CGAL/Geodesic_processing.h>

#include "models.h"
#include "report.h"

#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/transport/biharmonic.h>
#include "transport/flat_refinement.h"
#include <CGAL/Geodesic_processing/internal/distances/heat.h>
#include "mesh/intrinsic_delaunay.h"
#include <CGAL/Geodesic_processing/internal/transport/transport.h>
#include <CGAL/Geodesic_processing/internal/transport/transport_family.h>

#include <CGAL/Polygon_mesh_processing/border.h>
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
using Triangles = std::shared_ptr<const Glued_triangles>;
using Pair = std::array<Location, 2>;

constexpr double tolerance = 1e-3; // between the bounds

Location at(Index site) { return {none, site, {}}; }

Source source(const Location& place) { return {{place}, 0., 0}; }

double mean(const std::vector<double>& values)
{
  double sum = 0.;
  for(const double x : values)
    sum += x / double(values.size());
  return sum;
}

std::string mean_and_largest(const std::vector<double>& values, int decimals)
{
  return number(mean(values), decimals) + " / " +
         number(*std::max_element(values.begin(), values.end()), decimals);
}

// The heat method with a time step of so many squares of the mean length of a side.
class Heat
{
public:
  Heat(const Triangles& triangles, double squares) : m_triangles(triangles)
  {
    Glued_triangles t = *triangles;
    double mean = 0.;
    for(const double length : t.length)
      mean += length / double(t.length.size());
    flip_to_delaunay(t);
    m_operators = operators(t);
    const Laplacian laplacian(m_operators);
    Sparse_matrix poisson = laplacian.matrix(m_operators);
    Sparse_matrix heat = squares * mean * mean * poisson;
    heat.diagonal() += lumped_mass(m_operators);
    m_heat = std::make_unique<Sparse_solver>(heat);
    laplacian.hold(poisson);
    m_poisson = std::make_unique<Sparse_solver>(poisson);
  }
  // Of all sites.
  Vector distances(const Location& from) const
  {
    const Vector start = masses_at(*m_triangles, {from}).col(0);
    Field way = gradient(m_operators, m_heat->solve(start));
    for(Planar& v : way)
      v = norm(v) > 0. ? (-1. / norm(v)) * v : v;
    const Vector result = m_poisson->solve(divergence(m_operators, way));
    return result.array() - start.dot(result);
  }

private:
  Triangles m_triangles;
  Operators m_operators;
  std::unique_ptr<Sparse_solver> m_heat, m_poisson;
};

// Distances of pairs of places, in the caller's unit.
struct Measure
{
  std::string name;
  std::function<std::vector<Bounds>(const std::vector<Pair>&)> bounds;

  std::vector<double> values(const std::vector<Pair>& pairs) const
  {
    std::vector<double> result;
    for(const Bounds& b : bounds(pairs))
      result.push_back(0.5 * (b.lower + b.upper));
    return result;
  }
};

// From what finds the distances of all pairs one by one.
template <typename Function>
Measure one_by_one(const std::string& name, Function distance)
{
  return {name, [distance](const std::vector<Pair>& pairs)
          {
            std::vector<Bounds> result;
            for(const Pair& pair : pairs)
            {
              const double d = distance(pair);
              result.push_back({d, d});
            }
            return result;
          }};
}

Measure exact(const Triangles& t)
{
  const auto windows = std::make_shared<Window_propagation>(t);
  return one_by_one("exact",
                    [=](const Pair& pair)
                    {
                      windows->run({source(pair[0])});
                      return t->scale * windows->distance(pair[1]);
                    });
}

Measure heat(const Triangles& t, double squares)
{
  const auto solver = std::make_shared<const Heat>(t, squares);
  return one_by_one("heat " + digits(squares) + " h2",
                    [=](const Pair& pair)
                    {
                      const Vector to = masses_at(*t, {pair[1]}).col(0);
                      return t->scale * to.dot(solver->distances(pair[0]));
                    });
}

Measure biharmonic(const Triangles& t)
{
  const auto distances = std::make_shared<const Biharmonic_distances>(*t);
  return one_by_one(
      "biharmonic",
      [=](const Pair& pair) {
        return t->scale * distances->all_pairs(masses_at(*t, {pair[0], pair[1]}))(0, 1);
      });
}

Measure family(const Triangles& t, std::size_t k, Particular_field kind)
{
  const auto metric = std::make_shared<const Transport_family>(t, k, kind);
  return {"k = " + std::to_string(k), [=](const std::vector<Pair>& pairs)
          {
            std::vector<Location> from, to;
            for(const Pair& pair : pairs)
            {
              from.push_back(pair[0]);
              to.push_back(pair[1]);
            }
            Family_options options;
            options.tolerance = tolerance;
            std::vector<Bounds> result =
                metric->distances(masses_at(*t, to) - masses_at(*t, from), options);
            for(Bounds& b : result)
              b = {t->scale * b.lower, t->scale * b.upper};
            return result;
          }};
}

// As Transport_metric chooses.
Measure family(const Triangles& t, std::size_t k)
{
  return family(t, k, k == 0 ? Particular_field::gradient : Particular_field::raviart_thomas);
}

Measure complete(const Triangles& t)
{
  const auto solver = std::make_shared<const Transport_solver>(operators(*t));
  return {"complete", [=](const std::vector<Pair>& pairs)
          {
            std::vector<Bounds> result;
            for(const Pair& pair : pairs)
            {
              Transport_options options;
              options.tolerance = tolerance;
              const Masses m = masses_at(*t, {pair[0], pair[1]});
              const Transport found = solver->solve(Vector(m.col(1)) - Vector(m.col(0)), options);
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
    const Index p = random() % domain.number_of_sites(), q = random() % domain.number_of_sites();
    if(p != q)
      result.push_back({at(p), at(q)});
  }
  return result;
}

void for_each_model(const std::vector<std::string>& names,
                    const std::function<void(const std::string&, Mesh&)>& use)
{
  for(const std::string& name : names)
    if(auto mesh = model(name))
      use(name, *mesh);
}

// Table 1: seconds of the distances of all vertices to one, with everything that is prepared.

struct One_to_all
{
  std::string paper; // its model, of about as many vertices
  double fronts, heat, biharmonic, spectral, hundred;
  std::string ours;
};

void print_one_to_all(bool is_quick)
{
  std::vector<One_to_all> rows = {
      {"bearing 3182", 0.050, 0.002, 3.52, 3.86, 41.4, "knot1_3k"},
      {"dog 3716", 0.056, 0.002, 4.66, 3.27, 59.8, "dino_4k"},
      {"teapot 3900", 0.063, 0.002, 6.25, 3.87, 57.9, "femur_3k9"},
      {"david 5197", 0.096, 0.003, 10.09, 6.18, 121.2, "eight_5k"},
      {"man 10050", 0.18, 0.006, 42.2, 23.2, 511.9, "fsaverage5_inflated_left_10k"}};
  if(is_quick)
    rows.resize(1);
  Table table({"one to all: s (paper's)", "vertices", "paper's model", "exact (marching)", "heat",
               "biharmonic", "k = 0", "k = 100", "complete", "off exact %"});
  for(const One_to_all& row : rows)
    for_each_model(
        {row.ours},
        [&](const std::string& name, Mesh& mesh)
        {
          const Triangles t = Domain(mesh).triangles();
          const Index n = Index(t->number_of_sites());
          const Masses from = masses_at(*t, {at(0)});
          const auto cell = [](double ours, double theirs)
          { return number(ours, 2) + " (" + digits(theirs) + ")"; };
          std::vector<double> truth(n);
          const double windows = seconds(
              [&]
              {
                Window_propagation windows(t);
                windows.run({source(at(0))});
                for(Index i = 0; i < n; ++i)
                  truth[i] = windows.distance(i);
              });
          const double warm = seconds([&] { Heat_solver(t).run({source(at(0))}); });
          const double by_waves = seconds([&] { Biharmonic_distances(*t).one_to_all(from, 1); });
          const double spectral = seconds(
              [&] { Transport_family(t, 0, Particular_field::gradient).one_to_all(from, {}); });
          const double hundred = seconds(
              [&]
              { Transport_family(t, 100, Particular_field::raviart_thomas).one_to_all(from, {}); });
          // All there is moves to the source: the potential is the distance to it.
          Vector potential;
          const double whole = seconds(
              [&]
              {
                const Transport_solver solver(operators(*t));
                const Vector area = lumped_mass(solver.operators());
                potential = solver.solve(Vector(from.col(0)) - area / area.sum()).potential;
              });
          std::vector<double> error;
          for(Index i = 1; i < n; ++i)
            error.push_back(100. * std::abs((potential[0] - potential[i]) / truth[i] - 1.));
          table.add({name, std::to_string(n), row.paper, cell(windows, row.fronts),
                     cell(warm, row.heat), cell(by_waves, row.biharmonic),
                     cell(spectral, row.spectral), cell(hundred, row.hundred), number(whole, 2),
                     number(mean(error), 1)});
        });
  table.print();
}

// Table 2: seconds of the distances of all pairs of samples, likewise.

struct All_pairs
{
  std::string paper;                                        // so many vertices
  std::array<double, 2> marching, heat, by_waves, spectral; // of 2 and of 100 samples
  std::string ours;
  unsigned refinements;
};

void print_all_pairs(bool is_quick)
{
  std::vector<All_pairs> rows = {
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
  if(is_quick)
    rows.resize(2);
  Table table({"all pairs: s (paper's)", "vertices", "paper's", "samples", "exact (marching)",
               "heat", "biharmonic", "k = 0", "k = 100", "complete"});
  for(const All_pairs& row : rows)
    for_each_model(
        {row.ours},
        [&](const std::string& name, Mesh& mesh)
        {
          for(unsigned i = 0; i < row.refinements; ++i)
            mesh = refined(mesh);
          const Triangles t = Domain(mesh).triangles();
          const Index n = Index(t->number_of_sites());
          for(const std::size_t samples : {2, 100})
          {
            const bool is_pair = samples == 2;
            std::vector<Location> places;
            for(std::size_t j = 0; j < samples; ++j)
              places.push_back(at(Index(j * n / samples)));
            const Masses masses = masses_at(*t, places);
            const auto cell = [&](double ours, const std::array<double, 2>& theirs)
            { return number(ours, 2) + " (" + digits(theirs[is_pair ? 0 : 1]) + ")"; };
            double windows = std::nan("");
            if(is_pair || n < 20000)
              windows = seconds(
                  [&]
                  {
                    Window_propagation propagation(t);
                    for(const Location& place : places)
                      propagation.run({source(place)});
                  });
            const double warm = seconds(
                [&]
                {
                  Heat_solver solver(t);
                  for(const Location& place : places)
                    solver.run({source(place)});
                });
            const double by_waves = seconds([&] { Biharmonic_distances(*t).all_pairs(masses); });
            const double spectral = seconds(
                [&] { Transport_family(t, 0, Particular_field::gradient).all_pairs(masses, {}); });
            double hundred = std::nan(""), whole = hundred;
            if(is_pair && n < 20000)
              hundred = seconds(
                  [&]
                  {
                    Transport_family(t, 100, Particular_field::raviart_thomas)
                        .all_pairs(masses, {1e-2, 5000, 1, {}});
                  });
            if(is_pair)
              whole = seconds([&] { complete(t).values({{places[0], places[1]}}); });
            table.add({name, std::to_string(n), row.paper, std::to_string(samples),
                       cell(windows, row.marching), cell(warm, row.heat),
                       cell(by_waves, row.by_waves), cell(spectral, row.spectral),
                       number(hundred, 2), number(whole, 2)});
          }
        });
  table.print();
}

// Distances never grow with k, and come down towards geodesic ones.
void print_fall(bool is_quick)
{
  const std::vector<std::size_t> sizes = {0, 10, 30, 100};
  Table table({"falling with k", "vertices", "borders", "flow", "pairs", "grew",
               "above exact %: k = 0", "10", "30", "100", "complete"});
  for_each_model(
      is_quick ? std::vector<std::string>{"pig_468", "hemisphere_2k"}
               : std::vector<std::string>{"pig_468", "hemisphere_2k", "elephant_2k8",
                                          "mech_holes_shark_5k", "plane_holes_8k5"},
      [&](const std::string& name, Mesh& mesh)
      {
        const Domain domain(mesh);
        const Triangles& t = domain.triangles();
        std::vector<Mesh::Halfedge_index> borders;
        CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(borders));
        const std::size_t n = domain.number_of_sites();
        // A thousand in all.
        const std::size_t number_of_pairs = is_quick   ? 20
                                            : n < 1000 ? 400
                                            : n < 3000 ? 200
                                            : n < 6000 ? 150
                                                       : 50;
        std::mt19937 random;
        const std::vector<Pair> pairs = random_pairs(domain, number_of_pairs, random);
        const std::vector<double> truth = exact(t).values(pairs);
        const auto above = [&](const std::vector<double>& values)
        {
          std::vector<double> result;
          for(std::size_t j = 0; j < values.size(); ++j)
            result.push_back(100. * (values[j] / truth[j] - 1.));
          return number(mean(result), 1);
        };
        const Measure whole = complete(t);
        const std::vector<Bounds> least = whole.bounds(pairs);
        const std::string of_whole = above(whole.values(pairs));
        for(const Particular_field kind :
            {Particular_field::gradient, Particular_field::raviart_thomas})
        {
          const bool is_gradient = kind == Particular_field::gradient;
          if(!is_gradient && n >= 3000) // takes minutes
            continue;
          std::vector<std::string> row = {
              name, std::to_string(domain.number_of_sites()), std::to_string(borders.size()),
              is_gradient ? "gradient" : "balanced", std::to_string(pairs.size())};
          std::vector<std::string> means;
          std::size_t grew = 0;
          std::vector<Bounds> before(pairs.size(), {infinity, infinity});
          for(const std::size_t k : sizes)
          {
            const std::vector<Bounds> bounds = family(t, k, kind).bounds(pairs);
            std::vector<double> values;
            for(std::size_t j = 0; j < bounds.size(); ++j)
            {
              grew += bounds[j].lower > before[j].upper * (1. + 1e-9); // rounding
              // The complete flows are more than those of any k.
              grew += is_gradient && k == sizes.back() && least[j].lower > bounds[j].upper;
              values.push_back(0.5 * (bounds[j].lower + bounds[j].upper));
            }
            before = bounds;
            means.push_back(above(values));
          }
          row.push_back(std::to_string(grew));
          row.insert(row.end(), means.begin(), means.end());
          row.push_back(of_whole);
          table.add(row);
        }
      });
  table.print();
}

// Figure 9: triangle inequality and symmetry, on random triples and for one pair with every vertex.
void print_metrics(bool is_quick)
{
  Table table({"of 1,000 triples", "model", "longer than a detour", "by more than the gaps",
               "most %", "not symmetric, most %", "of vertices between two %"});
  for_each_model(
      is_quick ? std::vector<std::string>{"pig_468"}
               : std::vector<std::string>{"elephant_2k8", "hemisphere_2k"},
      [&](const std::string& name, Mesh& mesh)
      {
        const Domain domain(mesh);
        const Triangles& t = domain.triangles();
        constexpr Index samples = 24;
        std::mt19937 random;
        std::vector<Location> place;
        for(Index i = 0; i < samples; ++i)
          place.push_back(at(Index(i * domain.number_of_sites() / samples)));
        std::vector<Pair> pairs;
        for(const Location& p : place)
          for(const Location& q : place)
            pairs.push_back({p, q});
        std::vector<std::array<Index, 3>> triples;
        while(triples.size() < 1000)
        {
          const Index p = random() % samples, q = random() % samples, r = random() % samples;
          if(p != q && q != r && r != p)
            triples.push_back({p, q, r});
        }
        const auto add = [&](const Measure& measure, const std::function<Vector(Location)>& all)
        {
          const std::vector<Bounds> found = measure.bounds(pairs);
          const auto value = [&](Index p, Index q)
          { return 0.5 * (found[p * samples + q].lower + found[p * samples + q].upper); };
          std::size_t longer = 0, certain = 0;
          double most = 0., turned = 0.;
          for(const auto& [p, q, r] : triples)
          {
            const double detour = value(p, q) + value(q, r);
            // By more than rounding.
            longer += value(p, r) > detour * (1. + 1e-9);
            certain += found[p * samples + r].lower >
                       (found[p * samples + q].upper + found[q * samples + r].upper) * (1. + 1e-9);
            most = std::max(most, value(p, r) / detour - 1.);
            turned = std::max(turned, std::abs(value(p, r) / value(r, p) - 1.));
          }
          std::string between = "-";
          if(all)
          {
            std::size_t shorter = 0;
            for(Index i = 0; i < 5; ++i)
            {
              const Vector p = all(place[i]), q = all(place[i + 5]);
              const double d = 0.5 * (p[place[i + 5].site] + q[place[i].site]);
              for(Index s = 0; s < p.size(); ++s)
                shorter += p[s] + q[s] < d * (1. - 1e-6); // one to all sums in floats
            }
            between = number(100. * double(shorter) / (5. * double(domain.number_of_sites())), 1);
          }
          table.add({measure.name, name, std::to_string(longer), std::to_string(certain),
                     digits(100. * most), digits(100. * turned), between});
        };
        const auto one_to_all = [&](const auto& distances)
        { return [&](const Location& p) { return distances(masses_at(*t, {p})); }; };
        const Biharmonic_distances waves(*t);
        const Transport_family spectral(t, 0, Particular_field::gradient);
        for(const double squares : {1., 10., 100.})
        {
          const Heat solver(t, squares);
          add(heat(t, squares), [&](const Location& p) { return solver.distances(p); });
        }
        add(biharmonic(t),
            one_to_all([&](const Masses& from) { return waves.one_to_all(from, 1); }));
        add(family(t, 0),
            one_to_all([&](const Masses& from) { return spectral.one_to_all(from, {}); }));
        add(family(t, 10), {});
        add(family(t, 100), {});
        add(complete(t), {});
      });
  table.print();
}

// Figure 8.

Mesh with_noise(Mesh mesh, double edges)
{
  std::mt19937 random;
  std::normal_distribution<double> normal(0., edges * mean_edge(mesh));
  for(const Vertex v : mesh.vertices())
  {
    const double x = normal(random), y = normal(random), z = normal(random);
    mesh.point(v) = mesh.point(v) + Kernel::Vector_3(x, y, z);
  }
  return mesh;
}

// A sheet of three by one of quads in planes, which bend where columns meet: lengths are the same, up to
// rounding, on the way to a roll of so many radians.
Mesh sheet(int rows, double angle)
{
  Mesh mesh;
  const double side = 1. / rows, turn = angle / (3. * rows);
  std::vector<std::array<double, 2>> line = {{0., 0.}};
  for(int i = 0; i < 3 * rows; ++i)
    line.push_back(
        {line.back()[0] + side * std::cos(turn * i), line.back()[1] + side * std::sin(turn * i)});
  CGAL::make_grid(
      3 * rows, rows, mesh,
      [&](int i, int j) { return Kernel::Point_3(line[i][0], side * j, line[i][1]); }, true);
  return mesh;
}

// What is within a tenth of the longest extent at one end of it, turned against the other half by
// forty degrees, and all between as rigid as possible.
Mesh bent(Mesh mesh)
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
  std::vector<Vertex> turned;
  for(const Vertex v : mesh.vertices())
  {
    const double place = (mesh.point(v)[longest] - low[longest]) / (high[longest] - low[longest]);
    if(place < 0.1)
      turned.push_back(v);
    if(place < 0.1 || place > 0.5)
      deformation.insert_control_vertex(v);
  }
  const double angle = CGAL_PI / 4.5;
  std::array<double, 3> middle;
  for(int c = 0; c < 3; ++c)
    middle[c] = 0.5 * (low[c] + high[c]);
  middle[longest] = low[longest] + 0.3 * (high[longest] - low[longest]);
  const int a = longest, b = (longest + 1) % 3;
  for(const Vertex v : turned)
  {
    std::array<double, 3> p = {mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]};
    const double x = p[a] - middle[a], y = p[b] - middle[b];
    p[a] = middle[a] + std::cos(angle) * x - std::sin(angle) * y;
    p[b] = middle[b] + std::sin(angle) * x + std::cos(angle) * y;
    deformation.set_target_position(v, {p[0], p[1], p[2]});
  }
  deformation.deform(20, 0.);
  return mesh;
}

// By how much pairs change from one surface to another, mean and largest, in percent.
void add_change(Table& table, const std::string& name, const Triangles& one,
                const std::vector<Pair>& pairs, const Triangles& other,
                const std::vector<Pair>& same_pairs)
{
  std::vector<std::string> row = {name, std::to_string(one->number_of_sites()) + " to " +
                                            std::to_string(other->number_of_sites())};
  const auto measures = [](const Triangles& t)
  {
    return std::vector<Measure>{exact(t),     heat(t, 1.),    biharmonic(t),
                                family(t, 0), family(t, 100), complete(t)};
  };
  const std::vector<Measure> before = measures(one), after = measures(other);
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
  Table table({"change %, mean / largest", "vertices", "exact", "heat", "biharmonic", "k = 0",
               "k = 100", "complete"});
  // Pairs of vertices that two meshes share.
  const auto add = [&](const std::string& name, const Mesh& one, const Mesh& other)
  {
    const Domain a(one), b(other);
    std::mt19937 random;
    const std::vector<Pair> pairs = random_pairs(a, number_of_pairs, random);
    std::vector<Pair> same;
    for(const auto& [p, q] : pairs)
      same.push_back({at(b.index(a.site(p.site))), at(b.index(a.site(q.site)))});
    add_change(table, name, a.triangles(), pairs, b.triangles(), same);
  };
  const int rows = is_quick ? 10 : 24;
  add("sheet, rolled up", sheet(rows, 0.), sheet(rows, 1.5 * CGAL_PI));
  for_each_model(
      is_quick ? std::vector<std::string>{"pig_468"}
               : std::vector<std::string>{"elephant_2k8", "cow_2k9"},
      [&](const std::string& name, Mesh& mesh)
      {
        add(name + ", noise of 0.1 edges", mesh, with_noise(mesh, 0.1));
        add(name + ", noise of 0.3 edges", mesh, with_noise(mesh, 0.3));
        add(name + ", bent", mesh, bent(mesh));
        if(num_vertices(mesh) < 2800) // that is slow
          add(name + ", faces cut in four", mesh, refined(mesh));
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
            for(Location& p : pair)
              p = domain.inner(location[other.site(p.site)]);
          add_change(table, name + ", remeshed", domain.triangles(), pairs, other.triangles(),
                     same);
        }
      });
  table.print();
}

// How even level sets are: the coefficient of variation of the slope, a twentieth of the largest distance
// away from the source.
void print_evenness(bool is_quick)
{
  Table table({"unevenness", "vertices", "exact", "heat", "biharmonic", "k = 0", "k = 10",
               "k = 100", "k = 0 / biharmonic"});
  for_each_model(
      is_quick ? std::vector<std::string>{"hemisphere_2k"}
               : std::vector<std::string>{"hemisphere_2k", "elephant_2k8", "cow_2k9", "dino_4k",
                                          "knot1_3k"},
      [&](const std::string& name, Mesh& mesh)
      {
        const Triangles t = Domain(mesh).triangles();
        const Index n = Index(t->number_of_sites());
        const Operators o = operators(*t);
        const std::vector<Index> sources = {0, n / 2};
        std::vector<std::vector<double>> all(6);
        const Heat solver(t, 1.);
        const Biharmonic_distances waves(*t);
        std::vector<std::unique_ptr<Transport_family>> families;
        for(const std::size_t k : {0, 10, 100})
          families.push_back(std::make_unique<Transport_family>(
              t, k, k == 0 ? Particular_field::gradient : Particular_field::raviart_thomas));
        for(const Index from : sources)
        {
          Window_propagation windows(t);
          windows.run({source(at(from))});
          Vector truth(n);
          for(Index i = 0; i < n; ++i)
            truth[i] = windows.distance(i);
          const double near = 0.05 * truth.maxCoeff();
          const auto unevenness = [&](const Vector& function)
          {
            double area = 0., sum = 0., squares = 0.;
            const Field slope = gradient(o, function);
            for(std::size_t f = 0; f < slope.size(); ++f)
            {
              const Index* corner = &o.corner[3 * f];
              if(std::min({truth[corner[0]], truth[corner[1]], truth[corner[2]]}) < near)
                continue;
              area += o.area[f];
              sum += o.area[f] * norm(slope[f]);
              squares += o.area[f] * dot(slope[f], slope[f]);
            }
            return std::sqrt(squares * area / (sum * sum) - 1.);
          };
          const Masses mass = masses_at(*t, {at(from)});
          all[0].push_back(unevenness(truth));
          all[1].push_back(unevenness(solver.distances(at(from))));
          all[2].push_back(unevenness(waves.one_to_all(mass, 1)));
          for(std::size_t i = 0; i < families.size(); ++i)
            all[3 + i].push_back(unevenness(families[i]->one_to_all(mass, {})));
        }
        std::vector<std::string> row = {name, std::to_string(n)};
        for(const auto& values : all)
          row.push_back(number(mean(values), 2));
        row.push_back(number(mean(all[3]) / mean(all[2]), 2));
        table.add(row);
      });
  table.print();
}

// Whether distances depend on the direction: on a sphere those of vertices at about the same great circle
// from a pole, less what falls linearly within the band; on a square those of places that its
// symmetries take to each other.
void print_isotropy(bool is_quick)
{
  Table table({"differing with the direction %", "vertices", "biharmonic", "k = 0", "k = 5",
               "k = 10", "k = 100", "functions taken for 5, 10, 100"});
  const auto add = [&](const std::string& name, const Mesh& mesh, Vertex from,
                       const std::function<double(const Domain&, const Vector&)>& spread)
  {
    const Domain domain(mesh);
    const Triangles& t = domain.triangles();
    const Masses mass = masses_at(*t, {at(domain.index(from))});
    std::vector<std::string> row = {name, std::to_string(domain.number_of_sites())};
    std::string taken;
    row.push_back(number(100. * spread(domain, Biharmonic_distances(*t).one_to_all(mass, 1)), 2));
    for(const std::size_t k : {0, 5, 10, 100})
    {
      const Transport_family family(t, k, Particular_field::gradient);
      row.push_back(number(100. * spread(domain, family.one_to_all(mass, {})), 2));
      if(k > 0)
        taken += (taken.empty() ? "" : ", ") + std::to_string(family.basis_size());
    }
    row.push_back(taken);
    table.add(row);
  };
  const Mesh ball = icosphere(is_quick ? 3 : 4);
  add("sphere", ball, Vertex(0),
      [&](const Domain& domain, const Vector& d)
      {
        const std::vector<double> angle = great_circles(ball, Vertex(0));
        double worst = 0.;
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
          worst = std::max(worst, std::sqrt(std::max(0., (syy - sxy * sxy / sxx) / n)) / (y / n));
        }
        return worst;
      });
  const int n = is_quick ? 20 : 40;
  const Mesh plane = mesh_of(CGAL::Geodesic_processing::test::square(std::size_t(n)));
  const auto point = [=](int i, int j) { return Vertex(Mesh::size_type(i + (n + 1) * j)); };
  add("square", plane, point(n / 2, n / 2),
      [&](const Domain& domain, const Vector& d)
      {
        double worst = 0.;
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
            worst = std::max(worst, high / low - 1.);
          }
        return worst;
      });
  table.print();
}

// Proposition 2: a mass that is spread over a disc is as far as its middle, up to the radius and the gap.
void print_discs(bool is_quick)
{
  Table table({"radius / distance", "model", "error / (radius + gap), mean / largest"});
  for_each_model(is_quick ? std::vector<std::string>{"pig_468"}
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
                   for(const double part : {0.4, 0.2, 0.1, 0.05})
                   {
                     std::vector<double> error;
                     for(const auto& [p, q] : pairs)
                     {
                       windows.run({source(q)});
                       const double exact = windows.distance(p.site), radius = part * exact;
                       Vector disc = Vector::Zero(area.size());
                       for(Index i = 0; i < disc.size(); ++i)
                         if(windows.distance(i) <= radius)
                           disc[i] = area[i];
                       const Transport found =
                           solver.solve(disc / disc.sum() - Vector(masses_at(*t, {p}).col(0)));
                       error.push_back(std::abs(found.value - exact) /
                                       (radius + found.upper - found.lower));
                     }
                     table.add({digits(part), name, mean_and_largest(error, 2)});
                   }
                 });
  table.print();
}

} // namespace

int main(int argc, char* argv[])
{
  using Print = void (*)(bool);
  const std::pair<const char*, Print> parts[] = {
      {"table-1", print_one_to_all}, {"table-2", print_all_pairs},   {"fall", print_fall},
      {"metrics", print_metrics},    {"stability", print_stability}, {"evenness", print_evenness},
      {"isotropy", print_isotropy},  {"discs", print_discs}};
  bool is_quick = false;
  std::string only;
  for(int i = 1; i < argc; ++i)
    if(std::string(argv[i]) == "--quick")
      is_quick = true;
    else
      only = argv[i];
  for(const auto& [name, print] : parts)
    if(only.empty() || only == name)
      print(is_quick);
  std::printf(
      "To reach: nothing grew, nothing longer than a detour by more than the gaps but by heat, "
      "all of transport\nsymmetric; errors of discs at most 1.\n");
}
