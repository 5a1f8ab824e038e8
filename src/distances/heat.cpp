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

// The maximum width of a component in square roots of the time step: exp(-600) is about 1e-260,
// close to underflow.
constexpr double max_width = 600.;

// The maximum square root of the time step in widths. The gradient of the heat then differs from
// its limit by a hundredth, and is far above round-off errors.
constexpr double max_diffusion_ratio = 10.;

// Returns an upper bound of the largest diameter of a connected component: twice the largest
// distance from one of its vertices along edges.
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

// Returns the unit vector of the negative gradient of a function in each triangle, or zero if it is
// constant. function: #vertices.
Field unit_descent_directions(const Operators& operators, const Vector& function)
{
  Field result(operators.number_of_triangles(), Vec2{0., 0.});
  for(std::size_t f = 0; f < result.size(); ++f)
  {
    const Index* corner = &operators.corner[3 * f];
    const std::array<double, 3> value = {function[corner[0]], function[corner[1]],
                                         function[corner[2]]};
    // Scaled by the largest value: far from the sources the squares of heat values underflow.
    const double max_value = std::max({std::abs(value[0]), std::abs(value[1]), std::abs(value[2])});
    const double difference_1 = (value[1] - value[0]) / max_value,
                 difference_2 = (value[2] - value[0]) / max_value;
    // Opposite to the source of a symmetric surface the gradient consists of round-off errors.
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

// A portion of the heat of a source, at one vertex.
struct Deposit
{
  Index vertex;
  double weight;
  double offset; // of its source
};

// Distributes the heat of the sources to vertices. A point has heat 1, divided by its barycentric
// coordinates. A segment has half of its length, in units of `diffusion_length`, at each end. A
// polyline of length zero is a point.
std::vector<Deposit> deposits_of(const Surface_arrays& t, double diffusion_length,
                                 const std::vector<Front_source>& sources)
{
  std::vector<Deposit> result;
  const auto deposit = [&](const Surface_location& location, double total_weight, double offset)
  {
    for(int k = 0; k < (location.triangle == none ? 1 : 3); ++k)
    {
      const Index vertex =
          location.triangle == none ? location.vertex : t.corner[3 * location.triangle + k];
      const double weight =
          location.triangle == none ? total_weight : total_weight * location.barycentric[k];
      if(weight > 0.)
        result.push_back({vertex, weight, offset});
    }
  };
  for(const Front_source& source : sources)
  {
    if(!source.polyline.empty() && !(polyline_length(t, source.polyline) > 0.))
      deposit(source.polyline[0], 1., source.offset);
    for(std::size_t i = 1; i < source.polyline.size(); ++i)
    {
      const double length =
          polyline_length(t, {source.polyline[i - 1], source.polyline[i]}) / diffusion_length;
      deposit(source.polyline[i - 1], 0.5 * length, source.offset);
      deposit(source.polyline[i], 0.5 * length, source.offset);
    }
  }
  return result;
}

// Returns the number to be added to the potential in each connected component. After that the
// weighted mean of the potential over the sources in the component equals that of their offsets.
// Not a number if the component has no source.
std::vector<double> component_shifts(const std::vector<Index>& component,
                                     std::size_t number_of_components,
                                     const std::vector<Deposit>& deposits, const Vector& potential)
{
  std::vector<double> shift(number_of_components, 0.), total_weight(number_of_components, 0.);
  for(const Deposit& deposit : deposits)
  {
    shift[component[deposit.vertex]] +=
        deposit.weight * (deposit.offset - potential[deposit.vertex]);
    total_weight[component[deposit.vertex]] += deposit.weight;
  }
  for(std::size_t i = 0; i < shift.size(); ++i)
    shift[i] /= total_weight[i];
  return shift;
}

} // namespace

struct Heat_solver::Systems
{
  Operators operators;          // of the intrinsic triangulation
  std::vector<Index> component; // #vertices
  std::size_t number_of_components = 0;
  double diffusion_length = 0.; // square root of the time step
  std::unique_ptr<Sparse_solver> heat;
  std::unique_ptr<Poisson_solver> poisson;
};

Heat_solver::Heat_solver(std::shared_ptr<const Surface_arrays> triangles, double time_step,
                         const std::function<bool(double)>& callback)
    : m_triangles(triangles), m_dijkstra(triangles, Front_kind::dijkstra),
      m_distance(triangles->number_of_vertices(), infinity)
{
  const auto begin_step = [&]
  {
    if(callback)
      callback(0.);
  };
  auto systems = std::make_shared<Systems>();
  Surface_arrays t = *m_triangles;
  std::tie(systems->component, systems->number_of_components) = components(t);

  double mean = 0.;
  for(const double length : t.length)
    mean += length / double(t.length.size());
  begin_step();
  // Mollification by 1e-6 of the mean edge length bounds the cotangents by about 1e6 (Sharp and
  // Crane 2020).
  mollify(t, 1e-6 * (mean > 0. ? mean : 1.));
  if(!t.is_cloud())
    flip_to_delaunay(t);

  begin_step();
  const double width =
      component_width(m_triangles, systems->component, systems->number_of_components);
  // No edge is longer than the width: the default time step is not decreased.
  systems->diffusion_length =
      std::max(std::min(std::sqrt(time_step) * mean, std::max(mean, max_diffusion_ratio * width)),
               width / max_width);

  begin_step();
  systems->operators = operators(t);
  const Laplacian laplacian(systems->operators);
  const Sparse_matrix matrix = laplacian.matrix(systems->operators);
  Sparse_matrix heat = systems->diffusion_length * systems->diffusion_length * matrix;
  const Vector mass = lumped_mass(systems->operators);
  heat.diagonal() += (mass.array() > 0.).select(mass, 1.);
  begin_step();
  systems->heat = std::make_unique<Sparse_solver>(heat);
  begin_step();
  // The solver pins one vertex of each component. A diagonal shift of the singular matrix that is
  // small enough for a long strip would be lost in round-off errors.
  systems->poisson = std::make_unique<Poisson_solver>(laplacian, matrix);

  m_systems = std::move(systems);
}

void Heat_solver::check_speeds(const Front_limits& limits)
{
  if(limits.slowness)
    throw Unsupported_surface_error(
        "The heat method does not support speeds; use the default method.");
}

bool Heat_solver::run(const std::vector<Front_source>& sources, const Front_limits& limits)
{
  check_speeds(limits);
  for(const Index vertex : m_reached)
    m_distance[vertex] = infinity;
  m_reached.clear();
  // Its last sources must not remain if the callback returns false or throws an exception.
  m_dijkstra.run({});
  const auto is_cancelled = [&](double fraction)
  { return limits.callback && !limits.callback(fraction); };
  if(is_cancelled(0.))
    return false;
  m_dijkstra.run(sources);

  const Systems& s = *m_systems;
  const std::vector<Deposit> deposits = deposits_of(*m_triangles, s.diffusion_length, sources);
  double min_offset = infinity;
  for(const Front_source& source : sources)
    min_offset = std::min(min_offset, source.offset);
  Vector heat = Vector::Zero(Eigen::Index(m_distance.size()));
  for(const Deposit& deposit : deposits)
    heat[deposit.vertex] +=
        deposit.weight * std::exp(-(deposit.offset - min_offset) / s.diffusion_length);
  const Vector u = s.heat->solve(heat);
  if(is_cancelled(0.5))
  {
    m_dijkstra.run({});
    return false;
  }

  // The directions point away from the sources: distances increase along them.
  const Vector potential =
      s.poisson->solve(minus_divergence(s.operators, unit_descent_directions(s.operators, u)));
  const std::vector<double> shift =
      component_shifts(s.component, s.number_of_components, deposits, potential);
  for(const Index vertex : m_dijkstra.reached())
  {
    const double distance = std::max(potential[vertex] + shift[s.component[vertex]], min_offset);
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
