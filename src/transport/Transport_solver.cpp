// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/Transport_solver.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "transport/Spanning_forest.h"
#include "transport/Transport_iteration.h"
#include "transport/convergence.h"
#include "transport/exits.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Iterates until the gap is within the tolerance. Returns bounds that include `fixed_cost`, and
// whether they converged.
Transport_result iterate(Transport_iteration& iteration, double fixed_cost,
                         const Transport_options& options)
{
  const unsigned max_iterations = options.maximum_iterations > 0
                                      ? options.maximum_iterations
                                      : iteration.default_max_iterations();
  const auto gap = [&]
  { return 1. - (iteration.best().lower + fixed_cost) / (iteration.best().upper + fixed_cost); };
  unsigned iterations = 0;
  while(gap() > options.tolerance && iterations < max_iterations &&
        !is_cancelled(options.callback, gap(), options.tolerance) && iteration.advance())
    iterations += iteration.iterations_per_advance();
  const bool has_converged = gap() <= options.tolerance;
  Transport_result result = iteration.take_best();
  result.lower += fixed_cost;
  result.upper += fixed_cost;
  result.number_of_iterations = iterations;
  result.is_converged = has_converged;
  return result;
}

} // namespace

Transport_solver::Transport_solver(Operators operators)
    : m_operators(std::move(operators)), m_laplacian(m_operators),
      m_matrix(m_laplacian.matrix(m_operators))
{
  if(std::none_of(m_operators.area.begin(), m_operators.area.end(),
                  [](double area) { return area > 0.; }))
    throw Unsupported_surface_error("No triangle of the surface has an area.");
  std::tie(m_component, m_number_of_components) = components(m_operators);
  m_laplacian.pin(m_matrix);
  m_solver = std::make_unique<Sparse_solver>(m_matrix, Elimination_order::low_fill);
  m_forest = std::make_shared<const Spanning_forest>(m_operators);
}

void Transport_solver::check_input(const Vector& masses, const std::vector<Exit>& exits) const
{
  if(masses.size() != Eigen::Index(m_operators.number_of_vertices))
    throw Invalid_argument_error("There are " + std::to_string(masses.size()) + " masses for " +
                                 std::to_string(m_operators.number_of_vertices) + " vertices.");
  if(!masses.allFinite())
    throw Invalid_argument_error("A mass is not a finite number.");
  check_totals(masses, exits);
}

void Transport_solver::check_totals(const Vector& masses, const std::vector<Exit>& exits) const
{
  std::vector<double> sum(m_number_of_components, 0.), size(m_number_of_components, 0.);
  for(std::size_t vertex = 0; vertex < m_component.size(); ++vertex)
  {
    sum[m_component[vertex]] += masses[vertex];
    size[m_component[vertex]] += std::abs(masses[vertex]);
  }
  std::vector<double> total_capacity(m_number_of_components, -1.);
  for(const Exit& exit : exits)
  {
    if(!(exit.capacity > 0.) || !(exit.price >= 0.) || !std::isfinite(exit.price))
      throw Invalid_argument_error(
          "A capacity is not positive, or a price is negative or not finite.");
    double& value = total_capacity[m_component[exit.vertex]];
    value = std::max(value, 0.) + exit.capacity;
  }
  for(std::size_t i = 0; i < m_number_of_components; ++i)
    if(total_capacity[i] > 0. && -sum[i] > total_capacity[i] * (1. + 1e-9))
      throw Invalid_argument_error("A mass of " + std::to_string(-sum[i]) +
                                   " exceeds the capacity of the exits, " +
                                   std::to_string(total_capacity[i]) + ".");
    else if(!(total_capacity[i] > 0. && sum[i] <= 0.) && std::abs(sum[i]) > 1e-9 * size[i])
      throw Invalid_argument_error(
          m_number_of_components == 1
              ? "The total masses before and after differ by " + std::to_string(sum[i]) + "."
              : "The total masses before and after differ by " + std::to_string(sum[i]) +
                    " on a component of the surface.");
}

Field Transport_solver::least_squares_flow(const Vector& masses) const
{
  return gradient(m_operators, m_solver->solve(masses));
}

Transport_result Transport_solver::zero_result(std::size_t number_of_exits) const
{
  Transport_result result;
  result.potential = Vector::Zero(Eigen::Index(m_operators.number_of_vertices));
  result.flow.assign(m_operators.number_of_triangles(), Vec2{0., 0.});
  result.outflow = Vector::Zero(Eigen::Index(number_of_exits));
  result.is_converged = true;
  return result;
}

void Transport_solver::shift_to_marginal_cost(const Exit_groups& groups, Vector& potential) const
{
  const auto subtract = [&](Index component, double value)
  {
    for(std::size_t vertex = 0; vertex < m_component.size(); ++vertex)
      if(m_component[vertex] == component)
        potential[Eigen::Index(vertex)] -= value;
  };
  for(const Exit_group& group : groups.open)
    subtract(group.component, dual_exit_cost(group, potential).marginal_cost);
  for(const Exit_group& group : groups.full)
    subtract(group.component, full_marginal_cost(group, potential));
}

Transport_result Transport_solver::solve(const Vector& masses, const Transport_options& options,
                                         const std::vector<Exit>& exits) const
{
  check_input(masses, exits);
  if(!(options.tolerance > 0.))
    throw Invalid_argument_error("The tolerance is not positive.");
  const double moved_mass = exits.empty() ? 0.5 * masses.lpNorm<1>() : masses.lpNorm<1>();
  if(moved_mass == 0.)
    return zero_result(exits.size());
  Vector normalized_masses = masses / moved_mass;
  const Exit_groups groups = group_exits(exits, m_component, normalized_masses, moved_mass);
  if(!groups.open.empty() && options.method != Transport_method::interior_point)
    throw Invalid_argument_error("Only the interior point method supports capacities and prices.");
  Vector outflow(Eigen::Index(exits.size()));
  for(std::size_t i = 0; i < exits.size(); ++i)
    normalized_masses[exits[i].vertex] += outflow[Eigen::Index(i)] = groups.outflow[i];
  const Transport_problem problem = {m_operators, m_laplacian,       m_matrix,   *m_solver,
                                     *m_forest,   normalized_masses, groups.open};
  Transport_result result = iterate(*make_iteration(problem, options), groups.cost, options);

  for(std::size_t i = 0; i < groups.order.size(); ++i)
  {
    const std::size_t exit = groups.order[i];
    normalized_masses[exits[exit].vertex] += outflow[Eigen::Index(exit)] =
        result.outflow[Eigen::Index(i)];
  }
  shift_to_marginal_cost(groups, result.potential);
  result.residual =
      (minus_divergence(m_operators, result.flow) - normalized_masses).lpNorm<Eigen::Infinity>();
  // If both bounds are the cost itself, round-off errors can exchange them.
  result.lower = moved_mass * std::min(result.lower, result.upper);
  result.upper *= moved_mass;
  result.remaining_cost *= moved_mass;
  result.value = result.estimate = 0.5 * (result.lower + result.upper);
  result.outflow = moved_mass * outflow;
  for(Vec2& vector : result.flow)
    vector = moved_mass * vector;
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
