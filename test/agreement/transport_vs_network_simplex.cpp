// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares earth mover's distances by flows in triangles with the linear program over all pairs of
// vertices, whose costs are exact distances.
#include <CGAL/Geodesic_processing/internal/transport/Multilevel_transport_solver.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>

#include "Array_surface.h"

#include <lemon/list_graph.h>
#include <lemon/network_simplex.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace transport_vs_network_simplex {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Returns the minimum cost of moving the negative masses to the positive ones along shortest
// paths. LEMON uses integers: masses in units of 1e-6, lengths in units of 1e-9.
double optimal_cost(const Array_surface& surface, const std::vector<long long>& masses)
{
  lemon::ListDigraph graph;
  std::vector<lemon::ListDigraph::Node> node;
  for(std::size_t i = 0; i < masses.size(); ++i)
    node.push_back(graph.addNode());
  lemon::ListDigraph::NodeMap<long long> supply(graph);
  lemon::ListDigraph::ArcMap<long long> length(graph);
  Window_propagation windows(surface.triangles());
  for(Index from = 0; from < masses.size(); ++from)
  {
    supply[node[from]] = -masses[from];
    if(masses[from] >= 0)
      continue;
    windows.run({surface.source(from)});
    for(Index to = 0; to < masses.size(); ++to)
      if(masses[to] > 0)
        length[graph.addArc(node[from], node[to])] =
            std::llround(1e9 * surface.scale() * windows.distance(surface.vertex(to)));
  }
  lemon::NetworkSimplex<lemon::ListDigraph, long long> simplex(graph);
  simplex.supplyMap(supply).costMap(length);
  EXPECT_EQ(simplex.run(), simplex.OPTIMAL);
  return 1e-15 * simplex.totalCost<double>();
}

// Returns masses at `number` random vertices and at as many random targets.
std::vector<long long> random_masses(Index size, std::size_t number)
{
  std::mt19937 random;
  std::vector<long long> result(size, 0);
  for(std::size_t i = 0; i < number; ++i)
  {
    const long long mass = 1 + static_cast<long long>(random() % 1000000);
    result[random() % size] -= mass;
    result[random() % size] += mass;
  }
  return result;
}

// Returns Gaussian masses around the first and the last vertex. Their width is a quarter of the
// distance between them.
std::vector<long long> gaussian_masses(const Array_surface& surface)
{
  const Index last = surface.size() - 1;
  const double width = 0.25 * test::distance(surface.point(0), surface.point(last));
  std::vector<long long> result(surface.size(), 0);
  for(const bool is_source : {true, false})
  {
    std::vector<double> mass(surface.size());
    for(Index i = 0; i <= last; ++i)
    {
      const double d =
          test::distance(surface.point(i), surface.point(is_source ? 0 : last)) / width;
      mass[i] = std::exp(-d * d);
    }
    const double sum = std::accumulate(mass.begin(), mass.end(), 0.);
    for(Index i = 0; i <= last; ++i)
      result[i] += (is_source ? -1 : 1) * std::llround(1e6 * double(last) * mass[i] / sum);
  }
  // Compensates the round-off error of the sum.
  result[last] -= std::accumulate(result.begin(), result.end(), 0ll);
  return result;
}

Transport_result transport_cost(const Array_surface& surface, const std::vector<long long>& masses,
                                unsigned refinements)
{
  Mass_distribution from, to;
  from.at_vertices = Vector::Zero(surface.size());
  to.at_vertices = from.at_vertices;
  for(Index i = 0; i < surface.size(); ++i)
    (masses[i] < 0 ? from : to).at_vertices[surface.vertex(i)] =
        1e-6 * double(std::llabs(masses[i]));
  Transport_options options;
  options.tolerance = 1e-4;
  options.do_bound_from_above = true;
  return Multilevel_transport_solver(surface.triangles(), refinements).solve(from, to, options);
}

TEST(transport, bounds_enclose_optimal_cost)
{
  for(const Triangulation& shape : {jittered(icosphere(3), 0.015), torus(36, 18), square(20, 0.24),
                                    double_torus(2), cylinder(24, 12, 1., 2.)})
  {
    const Array_surface surface(shape);
    const auto few_masses = random_masses(surface.size(), 3),
               many_masses = random_masses(surface.size(), 100);
    const auto smooth_masses = gaussian_masses(surface);
    for(const auto* masses : {&few_masses, &many_masses, &smooth_masses})
    {
      const double exact = optimal_cost(surface, *masses);
      double error = infinity;
      for(const unsigned refinements : {0u, 1u})
      {
        const Transport_result found = transport_cost(surface, *masses, refinements);
        // Lengths are rounded to 1e-9, and sums have round-off errors.
        EXPECT_LE(found.lower, exact * (1. + 1e-6));
        EXPECT_GE(found.upper_continuous, exact * (1. - 1e-6));
        // Each refinement halves the error approximately. Duality gaps are added.
        EXPECT_LT(exact - found.value, 0.75 * error + 2e-4 * exact);
        error = exact - found.value;
        // Around a point mass, the error is a fraction of an edge length, and some masses move
        // only a few edges. Gaussian masses are wide.
        EXPECT_LT(error, (masses == &smooth_masses ? 0.02 : 0.1) * exact);
      }
    }
  }
}

} // namespace transport_vs_network_simplex
