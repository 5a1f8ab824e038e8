// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/Transport_solver.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "transport/Transport_iteration.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Steps of the splitting between two looks at its bounds, which cost as much as two.
constexpr unsigned admm_steps = 10;

class Admm_iteration : public Transport_iteration
{
public:
  Admm_iteration(const Transport_problem& problem, Admm::State start)
      : Transport_iteration(problem),
        m_admm(
            operators(), [this](const Field& field) { return project(field); }, std::move(start))
  {
    update_upper_bound(m_admm.flow());
  }

  bool advance() override
  {
    m_admm.advance(admm_steps);
    update_upper_bound(m_admm.flow());
    update_lower_bound(problem().solver.solve(minus_divergence(operators(), m_admm.dual_field())));
    return true;
  }

  const Admm::State& state() const { return m_admm.state(); }

private:
  Field project(const Field& field) const
  {
    Field result = field;
    const Field correction =
        gradient(operators(),
                 problem().solver.solve(problem().masses - minus_divergence(operators(), field)));
    for(std::size_t f = 0; f < result.size(); ++f)
      result[f] = field[f] + correction[f];
    return result;
  }

  Admm m_admm;
};

// Exits by component.  Where there is no more room than is needed each is filled, and nothing is left to be
// found out.
struct Exit_groups
{
  std::vector<Exit_group> open, full;
  std::vector<std::size_t> order; // of the open ones, one group after another, among all
  std::vector<double> outflow;    // #exits: through those that are full
  double cost = 0.;               // of filling them
};

// masses  as parts of all that is moved
Exit_groups group_exits(const std::vector<Exit>& exits, const std::vector<Index>& component,
                        const Vector& masses, double moved_mass)
{
  Exit_groups result;
  result.outflow.assign(exits.size(), 0.);
  std::map<Index, std::vector<std::size_t>> exits_of;
  for(std::size_t i = 0; i < exits.size(); ++i)
    exits_of[component[exits[i].vertex]].push_back(i);
  for(const auto& [label, indices] : exits_of)
  {
    Exit_group group = {label, 0., {}};
    for(std::size_t vertex = 0; vertex < component.size(); ++vertex)
      if(component[vertex] == label)
        group.mass -= masses[Eigen::Index(vertex)];
    double total_capacity = 0.;
    for(const std::size_t i : indices)
    {
      group.exits.push_back(
          {exits[i].vertex, exits[i].capacity / moved_mass, exits[i].price * moved_mass});
      total_capacity += group.exits.back().capacity;
    }
    if(!(group.mass > 1e-12)) // none is left to leave
      continue;
    if(group.mass * (1. + 1e-9) < total_capacity)
    {
      result.open.push_back(std::move(group));
      result.order.insert(result.order.end(), indices.begin(), indices.end());
      continue;
    }
    for(std::size_t i = 0; i < indices.size(); ++i)
    {
      const double outflow = group.exits[i].capacity * (group.mass / total_capacity);
      result.outflow[indices[i]] = outflow;
      result.cost += 0.5 * group.exits[i].price * outflow * outflow;
    }
    result.full.push_back(std::move(group));
  }
  return result;
}

// The price at which the last mass leaves.
double marginal_exit_cost(const Exit_group& full, const Vector& potential)
{
  double result = -infinity;
  for(const Exit& exit : full.exits)
    result = std::max(result, potential[exit.vertex] + exit.price * exit.capacity);
  return result;
}

} // namespace

// By duality: for a price of the last mass that leaves, each exit takes what it takes for less.
std::pair<double, double> dual_exit_cost(const Exit_group& group, const Vector& price)
{
  double low = infinity, high = -infinity, limit = infinity;
  for(const Exit& exit : group.exits)
  {
    low = std::min(low, price[exit.vertex]);
    high = std::max(high, price[exit.vertex] + exit.price * group.mass);
    if(exit.price == 0. && exit.capacity == infinity)
      limit = std::min(limit, price[exit.vertex]);
  }
  high = std::min(high, limit);
  const auto outflow_for = [](const Exit& exit, double gain)
  {
    return gain <= 0.        ? 0.
           : exit.price > 0. ? std::min(gain / exit.price, exit.capacity)
                             : exit.capacity;
  };
  const auto cost = [&](double marginal_cost)
  {
    double result = marginal_cost * group.mass;
    for(const Exit& exit : group.exits)
      if(const double x = outflow_for(exit, marginal_cost - price[exit.vertex]); x > 0.)
        result += x * (0.5 * exit.price * x + price[exit.vertex] - marginal_cost);
    return result;
  };
  for(double midpoint; midpoint = 0.5 * (low + high), low < midpoint && midpoint < high;)
  {
    double sum = 0.;
    for(const Exit& exit : group.exits)
      sum += outflow_for(exit, midpoint - price[exit.vertex]);
    (sum < group.mass ? low : high) = midpoint;
  }
  const double cost_at_low = cost(low), cost_at_high = cost(high);
  return cost_at_low > cost_at_high ? std::make_pair(cost_at_low, low)
                                    : std::make_pair(cost_at_high, high);
}

void Transport_iteration::update_upper_bound(const Field& flow, const std::vector<double>& outflow)
{
  double upper = 0.;
  std::size_t i = 0;
  for(const Exit_group& group : m_problem.exits)
    for(const Exit& exit : group.exits)
    {
      const double x = outflow[i++];
      if(!(x >= 0. && x <= exit.capacity))
        return;
      upper += 0.5 * exit.price * x * x;
    }
  for(std::size_t f = 0; f < flow.size(); ++f)
    upper += operators().area[f] * norm(flow[f]);
  if(!(upper < m_upper))
    return;
  m_upper = upper;
  m_flow = flow;
  m_outflow = outflow;
}

void Transport_iteration::update_lower_bound(const Vector& potential)
{
  double square = 0.;
  for(const Vec2& slope : gradient(operators(), potential))
    square = std::max(square, dot(slope, slope));
  const Vector unit_potential = potential / std::sqrt(square);
  double lower = m_problem.masses.dot(unit_potential);
  for(const Exit_group& group : m_problem.exits)
    lower += dual_exit_cost(group, unit_potential).first;
  if(!(lower > m_lower))
    return;
  m_lower = lower;
  m_potential = unit_potential;
}

Transport_solver::Transport_solver(Operators operators)
    : m_operators(std::move(operators)), m_laplacian(m_operators),
      m_matrix(m_laplacian.matrix(m_operators))
{
  if(std::none_of(m_operators.area.begin(), m_operators.area.end(),
                  [](double area) { return area > 0.; }))
    throw Unsupported_surface_error("The surface has no triangle with an area to move masses on.");
  std::tie(m_component, m_number_of_components) = components(m_operators);
  m_laplacian.pin(m_matrix);
  m_solver = std::make_unique<Sparse_solver>(m_matrix, Elimination_order::low_fill);
}

void Transport_solver::check_input(const Vector& masses, const std::vector<Exit>& exits) const
{
  if(masses.size() != Eigen::Index(m_operators.number_of_vertices))
    throw Invalid_argument_error("There are " + std::to_string(masses.size()) + " masses for " +
                                 std::to_string(m_operators.number_of_vertices) + " sites.");
  if(!masses.allFinite())
    throw Invalid_argument_error("A mass is not a finite number.");
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
          "A capacity is not positive, or a price negative or not finite.");
    double& value = total_capacity[m_component[exit.vertex]];
    value = std::max(value, 0.) + exit.capacity;
  }
  for(std::size_t i = 0; i < m_number_of_components; ++i)
    if(total_capacity[i] > 0. && -sum[i] > total_capacity[i] * (1. + 1e-9))
      throw Invalid_argument_error("There is room for a mass of " +
                                   std::to_string(total_capacity[i]) + " where one of " +
                                   std::to_string(-sum[i]) + " has to go.");
    else if(!(total_capacity[i] > 0. && sum[i] <= 0.) && std::abs(sum[i]) > 1e-9 * size[i])
      throw Invalid_argument_error(
          m_number_of_components == 1
              ? "The masses to be moved sum to " + std::to_string(sum[i]) + " instead of zero."
              : "The masses to be moved sum to " + std::to_string(sum[i]) +
                    " instead of zero on a component of the surface, and none can leave it.");
}

Field Transport_solver::least_squares_flow(const Vector& masses) const
{
  return gradient(m_operators, m_solver->solve(masses));
}

Transport_result Transport_solver::solve(const Vector& masses, const Transport_options& options,
                                         const std::vector<Exit>& exits) const
{
  check_input(masses, exits);
  if(!(options.tolerance > 0.))
    throw Invalid_argument_error("The tolerance is not positive.");
  Transport_result result;
  result.potential = Vector::Zero(masses.size());
  result.flow.assign(m_operators.number_of_triangles(), Vec2{0., 0.});
  result.outflow = Vector::Zero(Eigen::Index(exits.size()));
  const double moved_mass = exits.empty() ? 0.5 * masses.lpNorm<1>() : masses.lpNorm<1>();
  if(moved_mass == 0.)
  {
    result.converged = true;
    return result;
  }
  Vector normalized_masses = masses / moved_mass;
  const Exit_groups groups = group_exits(exits, m_component, normalized_masses, moved_mass);
  for(std::size_t i = 0; i < exits.size(); ++i)
    normalized_masses[exits[i].vertex] += result.outflow[Eigen::Index(i)] = groups.outflow[i];
  if(!groups.open.empty() && options.method != Transport_method::interior_point)
    throw Invalid_argument_error("Only the interior point method knows capacities and prices.");
  const Transport_problem problem = {m_operators, m_laplacian,       m_matrix,
                                     *m_solver,   normalized_masses, groups.open};
  std::unique_ptr<Transport_iteration> iteration;
  const Admm_iteration* admm = nullptr;
  switch(options.method)
  {
  case Transport_method::interior_point:
    iteration = interior_point(problem);
    break;
  case Transport_method::weiszfeld:
    iteration = weiszfeld(problem);
    break;
  case Transport_method::admm:
    auto admm_iteration = std::make_unique<Admm_iteration>(problem, options.warm_start);
    admm = admm_iteration.get();
    iteration = std::move(admm_iteration);
  }
  const unsigned iterations_per_step = admm ? admm_steps : 1;
  const unsigned max_iterations = options.maximum_iterations > 0 ? options.maximum_iterations
                                  : admm                         ? 5000
                                                                 : 100;

  const auto gap = [&]
  { return 1. - (iteration->lower() + groups.cost) / (iteration->upper() + groups.cost); };
  const auto is_cancelled = [&]
  {
    // From a gap of one, which is what no potential proves, to the tolerance.
    const double fraction =
        options.tolerance < 1. ? std::log(gap()) / std::log(options.tolerance) : 1.;
    return options.callback && !options.callback(std::clamp(fraction, 0., 1.));
  };
  while(gap() > options.tolerance && result.iterations < max_iterations && !is_cancelled() &&
        iteration->advance())
    result.iterations += iterations_per_step;

  result.converged = gap() <= options.tolerance;
  result.lower = moved_mass * (iteration->lower() + groups.cost);
  result.upper = moved_mass * (iteration->upper() + groups.cost);
  result.value = 0.5 * (result.lower + result.upper);
  result.potential = iteration->potential();
  result.flow = iteration->flow();
  for(std::size_t i = 0; i < groups.order.size(); ++i)
  {
    const std::size_t exit = groups.order[i];
    normalized_masses[exits[exit].vertex] += result.outflow[Eigen::Index(exit)] =
        iteration->outflow()[i];
  }
  result.outflow *= moved_mass;
  const auto lower_potential = [&](Index component, double change)
  {
    for(std::size_t vertex = 0; vertex < m_component.size(); ++vertex)
      if(m_component[vertex] == component)
        result.potential[Eigen::Index(vertex)] -= change;
  };
  for(const Exit_group& group : groups.open)
    lower_potential(group.component, dual_exit_cost(group, result.potential).second);
  for(const Exit_group& group : groups.full)
    lower_potential(group.component, marginal_exit_cost(group, result.potential));
  result.residual =
      (minus_divergence(m_operators, result.flow) - normalized_masses).lpNorm<Eigen::Infinity>();
  for(Vec2& vector : result.flow)
    vector = moved_mass * vector;
  if(admm)
    result.state = admm->state();
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
