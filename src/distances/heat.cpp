// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/heat.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>
#include "mesh/intrinsic_delaunay.h"
#include <CGAL/Geodesic_processing/internal/operators/Poisson_solver.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// How many square roots of the time step the surface may be wide: exp(-600) is about 1e-260.
constexpr double max_width = 600.;

// A bound on the width of the widest component: twice the longest distance from one of its sites.
double component_width(const std::shared_ptr<const Surface_arrays>& triangles,
                       const std::vector<Index>& component, std::size_t number_of_components)
{
  std::vector<bool> has_seed(number_of_components, false);
  std::vector<Front_source> seeds;
  for(Index vertex = 0; vertex < component.size(); ++vertex)
    if(!has_seed[component[vertex]])
    {
      has_seed[component[vertex]] = true;
      seeds.push_back({{Surface_location{none, vertex, {}}}, 0., 0});
    }
  Front front(triangles, Front_kind::dijkstra);
  front.run(seeds);
  double max_distance = 0.;
  for(const Index vertex : front.reached())
    max_distance = std::max(max_distance, front.distance(vertex));
  return 2. * max_distance;
}

// The direction in which a function falls in each triangle, or zero where it has none.
Field unit_descent_directions(const Operators& operators, const Vector& function)
{
  Field result(operators.number_of_triangles(), Vec2{0., 0.});
  for(std::size_t f = 0; f < result.size(); ++f)
  {
    const Index* corner = &operators.corner[3 * f];
    const std::array<double, 3> value = {function[corner[0]], function[corner[1]],
                                         function[corner[2]]};
    // Divided by the largest first: heat far away is below what squares can hold.
    const double max_value = std::max({std::abs(value[0]), std::abs(value[1]), std::abs(value[2])});
    const double difference_1 = (value[1] - value[0]) / max_value,
                 difference_2 = (value[2] - value[0]) / max_value;
    // Opposite to the source of a symmetric surface there is no direction, only rounding.
    if(!(std::max(std::abs(difference_1), std::abs(difference_2)) >= 1e-13))
      continue;
    const Vec2 gradient = difference_1 * operators.hat_gradient[3 * f + 1] +
                          difference_2 * operators.hat_gradient[3 * f + 2];
    const double size = norm(gradient);
    if(size > 0.)
      result[f] = (-1. / size) * gradient;
  }
  return result;
}

} // namespace

struct Heat_solver::Systems
{
  Operators operators;          // of the triangulation that carries the heat
  std::vector<Index> component; // #sites
  std::size_t number_of_components = 0;
  double diffusion_length = 0.; // square root of the time step
  std::unique_ptr<Sparse_solver> heat;
  std::unique_ptr<Poisson_solver> poisson;
};

Heat_solver::Heat_solver(std::shared_ptr<const Surface_arrays> triangles)
    : m_triangles(triangles), m_dijkstra(triangles, Front_kind::dijkstra),
      m_distance(triangles->number_of_vertices(), infinity)
{
  auto systems = std::make_shared<Systems>();
  Surface_arrays t = *m_triangles;
  std::tie(systems->component, systems->number_of_components) = components(t);

  double mean = 0.;
  for(const double length : t.length)
    mean += length / double(t.length.size());
  // A millionth of a side's length keeps the cotangents below a million (Sharp and Crane 2020).
  mollify(t, 1e-6 * (mean > 0. ? mean : 1.));
  if(!t.is_cloud())
    flip_to_delaunay(t);

  const double width =
      component_width(m_triangles, systems->component, systems->number_of_components);
  systems->diffusion_length = std::max(mean, width / max_width);

  systems->operators = operators(t);
  const Laplacian laplacian(systems->operators);
  const Sparse_matrix matrix = laplacian.matrix(systems->operators);
  Sparse_matrix heat = systems->diffusion_length * systems->diffusion_length * matrix;
  const Vector mass = lumped_mass(systems->operators);
  heat.diagonal() += (mass.array() > 0.).select(mass, 1.);
  systems->heat = std::make_unique<Sparse_solver>(heat);
  // A shift small enough to change nothing on a long strip would be lost in rounding.
  systems->poisson = std::make_unique<Poisson_solver>(laplacian, matrix);

  m_systems = std::move(systems);
}

bool Heat_solver::run(const std::vector<Front_source>& sources, const Front_limits& limits)
{
  if(limits.slowness)
    throw Unsupported_surface_error("The heat method takes no speeds: use fast marching.");
  for(const Index vertex : m_reached)
    m_distance[vertex] = infinity;
  m_reached.clear();
  const auto is_cancelled = [&](double fraction)
  { return limits.callback && !limits.callback(fraction); };
  if(is_cancelled(0.))
  {
    m_dijkstra.run({});
    return false;
  }
  m_dijkstra.run(sources);

  const Surface_arrays& t = *m_triangles;
  const Systems& s = *m_systems;
  const Index n = static_cast<Index>(m_distance.size());

  // Heat, and its mean offset, given to the sites around each source: points by their barycentric
  // coordinates, segments half at each end.
  double min_offset = infinity;
  for(const Front_source& source : sources)
    min_offset = std::min(min_offset, source.offset);
  Vector heat = Vector::Zero(n);
  std::vector<std::pair<Index, double>> deposits; // sites and heat, in order
  std::vector<double> offset;                     // of each of those
  const auto deposit =
      [&](const Surface_location& location, double total_weight, double source_offset)
  {
    for(int k = 0; k < (location.triangle == none ? 1 : 3); ++k)
    {
      const Index vertex =
          location.triangle == none ? location.vertex : t.corner[3 * location.triangle + k];
      const double weight =
          location.triangle == none ? total_weight : total_weight * location.barycentric[k];
      if(weight <= 0.)
        continue;
      heat[vertex] += weight * std::exp(-(source_offset - min_offset) / s.diffusion_length);
      deposits.emplace_back(vertex, weight);
      offset.push_back(source_offset);
    }
  };
  for(const Front_source& source : sources)
  {
    if(source.polyline.size() == 1)
      deposit(source.polyline[0], 1., source.offset);
    for(std::size_t i = 1; i < source.polyline.size(); ++i)
    {
      const double length =
          polyline_length(t, {source.polyline[i - 1], source.polyline[i]}) / s.diffusion_length;
      deposit(source.polyline[i - 1], 0.5 * length, source.offset);
      deposit(source.polyline[i], 0.5 * length, source.offset);
    }
  }
  const Vector u = s.heat->solve(heat);
  if(is_cancelled(0.5))
  {
    m_dijkstra.run({});
    return false;
  }

  // Away from the sources, so that distances grow along it.
  const Vector potential =
      s.poisson->solve(minus_divergence(s.operators, unit_descent_directions(s.operators, u)));

  std::vector<double> shift(s.number_of_components, 0.), total_weight(s.number_of_components, 0.);
  for(std::size_t i = 0; i < deposits.size(); ++i)
  {
    const auto [vertex, weight] = deposits[i];
    shift[s.component[vertex]] += weight * (offset[i] - potential[vertex]);
    total_weight[s.component[vertex]] += weight;
  }
  for(const Index vertex : m_dijkstra.reached())
  {
    const Index component = s.component[vertex];
    const double distance =
        std::max(potential[vertex] + shift[component] / total_weight[component], min_offset);
    if(distance > limits.maximum_distance)
      continue;
    m_distance[vertex] = distance;
    m_reached.push_back(vertex);
  }
  return true;
}

double Heat_solver::distance(const Surface_location& location) const
{
  if(location.triangle == none)
    return m_distance[location.vertex];
  double result = 0.;
  for(int k = 0; k < 3; ++k)
    if(location.barycentric[k] > 0.)
      result +=
          location.barycentric[k] * m_distance[m_triangles->corner[3 * location.triangle + k]];
  return result;
}

Index Heat_solver::predecessor(Index vertex) const { return m_dijkstra.predecessor(vertex); }

} // namespace CGAL::Geodesic_processing::internal
