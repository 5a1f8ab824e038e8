// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Earth mover's distances by flows in triangles beside the linear program over all pairs of vertices, with
// exact distances as costs.
#include <CGAL/Geodesic_processing/internal/transport/Earth_movers.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>

#include "Glued_surface.h"

#include <lemon/list_graph.h>
#include <lemon/network_simplex.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// The least cost of moving masses, negative ones to positive ones, each pair along its shortest path.
// LEMON counts in integers: masses in parts of 1e6, lengths of 1e9.
double least_cost(const Glued_surface& surface, const std::vector<long long>& masses)
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
            std::llround(1e9 * surface.scale() * windows.distance(surface.site(to)));
  }
  lemon::NetworkSimplex<lemon::ListDigraph, long long> simplex(graph);
  simplex.supplyMap(supply).costMap(length);
  EXPECT_EQ(simplex.run(), simplex.OPTIMAL);
  return 1e-15 * simplex.totalCost<double>();
}

// From some random vertices to as many others.
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

// From a hill around the first vertex to one around the last, each as wide as a quarter of the surface.
std::vector<long long> hills(const Glued_surface& surface)
{
  const Index last = surface.size() - 1;
  const double width = 0.25 * test::distance(surface.point(0), surface.point(last));
  std::vector<long long> result(surface.size(), 0);
  for(const bool is_before : {true, false})
  {
    std::vector<double> mass(surface.size());
    for(Index i = 0; i <= last; ++i)
    {
      const double d =
          test::distance(surface.point(i), surface.point(is_before ? 0 : last)) / width;
      mass[i] = std::exp(-d * d);
    }
    const double sum = std::accumulate(mass.begin(), mass.end(), 0.);
    for(Index i = 0; i <= last; ++i)
      result[i] += (is_before ? -1 : 1) * std::llround(1e6 * double(last) * mass[i] / sum);
  }
  // What rounding left.
  result[last] -= std::accumulate(result.begin(), result.end(), 0ll);
  return result;
}

Earth_movers_result by_flow(const Glued_surface& surface, const std::vector<long long>& parts,
                            unsigned refinements)
{
  Mass_distribution from, to;
  from.at_sites = Vector::Zero(surface.size());
  to.at_sites = from.at_sites;
  for(Index i = 0; i < surface.size(); ++i)
    (parts[i] < 0 ? from : to).at_sites[surface.site(i)] = 1e-6 * double(std::llabs(parts[i]));
  Earth_movers_options options;
  options.transport.tolerance = 1e-4;
  options.do_bound_from_above = true;
  return Earth_movers(surface.triangles(), refinements).solve(from, to, options);
}

TEST(transport, is_enclosed_by_its_bounds)
{
  for(const Triangulation& shape : {shaken(icosphere(3), 0.015), torus(36, 18), square(20, 0.24),
                                    double_ring(2), cylinder(24, 12, 1., 2.)})
  {
    const Glued_surface surface(shape);
    const auto few = random_masses(surface.size(), 3), many = random_masses(surface.size(), 100);
    const auto smooth = hills(surface);
    for(const auto* masses : {&few, &many, &smooth})
    {
      const double exact = least_cost(surface, *masses);
      double loss = infinity;
      for(const unsigned refinements : {0u, 1u})
      {
        const Earth_movers_result found = by_flow(surface, *masses, refinements);
        // Rounding of lengths to 1e-9, and of sums.
        EXPECT_LE(found.lower, exact * (1. + 1e-6));
        EXPECT_GE(found.upper_continuous, exact * (1. - 1e-6));
        // About half as much each time, and the gaps.
        EXPECT_LT(exact - found.value, 0.75 * loss + 2e-4 * exact);
        loss = exact - found.value;
        // Around points a part of a side, and some go no farther than a few sides; the hills are that wide.
        EXPECT_LT(loss, (masses == &smooth ? 0.02 : 0.1) * exact);
      }
    }
  }
}

} // namespace
