// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/heat.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/numerics/Sparse_solver.h>
#include <CGAL/Geodesic_processing/internal/mesh/glue.h>
#include "mesh/intrinsic_delaunay.h"
#include <CGAL/Geodesic_processing/internal/operators/operators.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/planar.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// How many square roots of the time step the surface may be wide: exp(-600) is about 1e-260.
constexpr double widest = 600.;

// A bound on the width of the widest component: twice the longest distance from one of its sites.
double width_of(const std::shared_ptr<const Glued_triangles>& triangles,
                const std::vector<Index>& component, std::size_t components)
{
  std::vector<bool> has_seed(components, false);
  std::vector<Source> seeds;
  for(Index site = 0; site < component.size(); ++site)
    if(!has_seed[component[site]])
    {
      has_seed[component[site]] = true;
      seeds.push_back({{Location{none, site, {}}}, 0., 0});
    }
  Front front(triangles, Front_kind::arcs);
  front.run(seeds);
  double longest = 0.;
  for(const Index site : front.reached())
    longest = std::max(longest, front.distance(site));
  return 2. * longest;
}

// The direction in which a function falls in each triangle, or zero where it has none.
Field unit_descent(const Operators& operators, const Vector& function)
{
  Field result(operators.number_of_triangles(), Planar{0., 0.});
  for(std::size_t f = 0; f < result.size(); ++f)
  {
    const Index* corner = &operators.corner[3 * f];
    const std::array<double, 3> value = {function[corner[0]], function[corner[1]],
                                         function[corner[2]]};
    // Divided by the largest first: heat far away is below what squares can hold.
    const double largest = std::max({std::abs(value[0]), std::abs(value[1]), std::abs(value[2])});
    const double first = (value[1] - value[0]) / largest, second = (value[2] - value[0]) / largest;
    // Opposite to the source of a symmetric surface there is no direction, only rounding.
    if(!(std::max(std::abs(first), std::abs(second)) >= 1e-13))
      continue;
    const Planar way = first * operators.hat[3 * f + 1] + second * operators.hat[3 * f + 2];
    const double size = norm(way);
    if(size > 0.)
      result[f] = (-1. / size) * way;
  }
  return result;
}

} // namespace

struct Heat_solver::Systems
{
  Operators operators;          // of the triangulation that carries the heat
  std::vector<Index> component; // #sites
  std::size_t components = 0;
  double step = 0.; // square root of the time step
  std::unique_ptr<Sparse_solver> heat, poisson;
};

Heat_solver::Heat_solver(std::shared_ptr<const Glued_triangles> triangles)
    : m_triangles(triangles), m_arcs(triangles, Front_kind::arcs),
      m_distance(triangles->number_of_sites(), infinity)
{
  auto systems = std::make_shared<Systems>();
  Glued_triangles t = *m_triangles;
  std::tie(systems->component, systems->components) = components(t);

  double mean = 0.;
  for(const double length : t.length)
    mean += length / double(t.length.size());
  // A millionth of a side's length keeps the cotangents below a million (Sharp and Crane 2020).
  mollify(t, 1e-6 * (mean > 0. ? mean : 1.));
  if(!t.is_cloud())
    flip_to_delaunay(t);

  const double width = width_of(m_triangles, systems->component, systems->components);
  systems->step = std::max(mean, width / widest);

  systems->operators = operators(t);
  const Laplacian laplacian(systems->operators);
  Sparse_matrix poisson = laplacian.matrix(systems->operators);
  Sparse_matrix heat = systems->step * systems->step * poisson;
  const Vector mass = lumped_mass(systems->operators);
  heat.diagonal() += (mass.array() > 0.).select(mass, 1.);
  systems->heat = std::make_unique<Sparse_solver>(heat);
  // A shift small enough to change nothing on a long strip would be lost in rounding.
  laplacian.hold(poisson);
  systems->poisson = std::make_unique<Sparse_solver>(poisson);

  m_systems = std::move(systems);
}

bool Heat_solver::run(const std::vector<Source>& sources, const Front_limits& limits)
{
  if(limits.slowness)
    throw Unsupported_surface_error("The heat method takes no speeds: use fast marching.");
  for(const Index site : m_reached)
    m_distance[site] = infinity;
  m_reached.clear();
  const auto is_cancelled = [&](double fraction)
  { return limits.callback && !limits.callback(fraction); };
  if(is_cancelled(0.))
  {
    m_arcs.run({});
    return false;
  }
  m_arcs.run(sources);

  const Glued_triangles& t = *m_triangles;
  const Systems& s = *m_systems;
  const Index n = static_cast<Index>(m_distance.size());

  // Heat, and its mean offset, given to the sites around each source: points by their barycentric
  // coordinates, segments half at each end.
  double lowest = infinity;
  for(const Source& source : sources)
    lowest = std::min(lowest, source.offset);
  Vector heat = Vector::Zero(n);
  std::vector<std::pair<Index, double>> given; // sites and heat, in order
  std::vector<double> offset;                  // of each of those
  const auto give = [&](const Location& location, double amount, double at)
  {
    for(int k = 0; k < (location.triangle == none ? 1 : 3); ++k)
    {
      const Index site =
          location.triangle == none ? location.site : t.corner[3 * location.triangle + k];
      const double part = location.triangle == none ? amount : amount * location.barycentric[k];
      if(part <= 0.)
        continue;
      heat[site] += part * std::exp(-(at - lowest) / s.step);
      given.emplace_back(site, part);
      offset.push_back(at);
    }
  };
  for(const Source& source : sources)
  {
    if(source.polyline.size() == 1)
      give(source.polyline[0], 1., source.offset);
    for(std::size_t i = 1; i < source.polyline.size(); ++i)
    {
      const double length =
          polyline_length(t, {source.polyline[i - 1], source.polyline[i]}) / s.step;
      give(source.polyline[i - 1], 0.5 * length, source.offset);
      give(source.polyline[i], 0.5 * length, source.offset);
    }
  }
  const Vector u = s.heat->solve(heat);
  if(is_cancelled(0.5))
  {
    m_arcs.run({});
    return false;
  }

  // Away from the sources, so that distances grow along it.
  const Vector potential = s.poisson->solve(divergence(s.operators, unit_descent(s.operators, u)));

  std::vector<double> shift(s.components, 0.), amount(s.components, 0.);
  for(std::size_t i = 0; i < given.size(); ++i)
  {
    const auto [site, part] = given[i];
    shift[s.component[site]] += part * (offset[i] - potential[site]);
    amount[s.component[site]] += part;
  }
  for(const Index site : m_arcs.reached())
  {
    const Index component = s.component[site];
    const double distance =
        std::max(potential[site] + shift[component] / amount[component], lowest);
    if(distance > limits.maximum_distance)
      continue;
    m_distance[site] = distance;
    m_reached.push_back(site);
  }
  return true;
}

double Heat_solver::distance(const Location& location) const
{
  if(location.triangle == none)
    return m_distance[location.site];
  double result = 0.;
  for(int k = 0; k < 3; ++k)
    if(location.barycentric[k] > 0.)
      result +=
          location.barycentric[k] * m_distance[m_triangles->corner[3 * location.triangle + k]];
  return result;
}

Index Heat_solver::predecessor(Index site) const { return m_arcs.predecessor(site); }

} // namespace CGAL::Geodesic_processing::internal
