// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/transport.h>

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
constexpr unsigned splitting_steps = 10;

class Splitting_iteration : public Transport_iteration
{
public:
  Splitting_iteration(const Transport_problem& problem, Splitting::State start)
      : Transport_iteration(problem),
        m_splitting(
            operators(), [this](const Field& field) { return projected(field); }, std::move(start))
  {
    keep_flow(m_splitting.flow());
  }

  bool advance() override
  {
    m_splitting.advance(splitting_steps);
    keep_flow(m_splitting.flow());
    keep_potential(problem().solver.solve(divergence(operators(), m_splitting.slope())));
    return true;
  }

  const Splitting::State& state() const { return m_splitting.state(); }

private:
  Field projected(const Field& field) const
  {
    Field result = field;
    const Field correction = gradient(
        operators(), problem().solver.solve(problem().masses - divergence(operators(), field)));
    for(std::size_t f = 0; f < result.size(); ++f)
      result[f] = field[f] + correction[f];
    return result;
  }

  Splitting m_splitting;
};

// Exits by component.  Where there is no more room than is needed each is filled, and nothing is left to be
// found out.
struct Grouped_exits
{
  std::vector<Exit_group> open, full;
  std::vector<std::size_t> order; // of the open ones, one group after another, among all
  std::vector<double> leaving;    // #exits: through those that are full
  double cost = 0.;               // of filling them
};

// masses  as parts of all that is moved
Grouped_exits grouped(const std::vector<Exit>& exits, const std::vector<Index>& component,
                      const Vector& masses, double moved)
{
  Grouped_exits result;
  result.leaving.assign(exits.size(), 0.);
  std::map<Index, std::vector<std::size_t>> exits_of;
  for(std::size_t i = 0; i < exits.size(); ++i)
    exits_of[component[exits[i].site]].push_back(i);
  for(const auto& [label, those] : exits_of)
  {
    Exit_group group = {label, 0., {}};
    for(std::size_t site = 0; site < component.size(); ++site)
      if(component[site] == label)
        group.mass -= masses[Eigen::Index(site)];
    double room = 0.;
    for(const std::size_t i : those)
    {
      group.exits.push_back({exits[i].site, exits[i].capacity / moved, exits[i].price * moved});
      room += group.exits.back().capacity;
    }
    if(!(group.mass > 1e-12)) // none is left to leave
      continue;
    if(group.mass * (1. + 1e-9) < room)
    {
      result.open.push_back(std::move(group));
      result.order.insert(result.order.end(), those.begin(), those.end());
      continue;
    }
    for(std::size_t i = 0; i < those.size(); ++i)
    {
      const double leaving = group.exits[i].capacity * (group.mass / room);
      result.leaving[those[i]] = leaving;
      result.cost += 0.5 * group.exits[i].price * leaving * leaving;
    }
    result.full.push_back(std::move(group));
  }
  return result;
}

// The price at which the last mass leaves.
double last_price(const Exit_group& full, const Vector& potential)
{
  double result = -infinity;
  for(const Exit& exit : full.exits)
    result = std::max(result, potential[exit.site] + exit.price * exit.capacity);
  return result;
}

} // namespace

// By duality: for a price of the last mass that leaves, each exit takes what it takes for less.
std::pair<double, double> least_cost(const Exit_group& group, const Vector& price)
{
  double low = infinity, high = -infinity, limit = infinity;
  for(const Exit& exit : group.exits)
  {
    low = std::min(low, price[exit.site]);
    high = std::max(high, price[exit.site] + exit.price * group.mass);
    if(exit.price == 0. && exit.capacity == infinity)
      limit = std::min(limit, price[exit.site]);
  }
  high = std::min(high, limit);
  const auto leaves = [](const Exit& exit, double gain)
  {
    return gain <= 0.        ? 0.
           : exit.price > 0. ? std::min(gain / exit.price, exit.capacity)
                             : exit.capacity;
  };
  const auto cost = [&](double last)
  {
    double result = last * group.mass;
    for(const Exit& exit : group.exits)
      if(const double x = leaves(exit, last - price[exit.site]); x > 0.)
        result += x * (0.5 * exit.price * x + price[exit.site] - last);
    return result;
  };
  for(double middle; middle = 0.5 * (low + high), low < middle && middle < high;)
  {
    double sum = 0.;
    for(const Exit& exit : group.exits)
      sum += leaves(exit, middle - price[exit.site]);
    (sum < group.mass ? low : high) = middle;
  }
  const double at_low = cost(low), at_high = cost(high);
  return at_low > at_high ? std::make_pair(at_low, low) : std::make_pair(at_high, high);
}

void Transport_iteration::keep_flow(const Field& flow, const std::vector<double>& leaving)
{
  double upper = 0.;
  std::size_t i = 0;
  for(const Exit_group& group : m_problem.exits)
    for(const Exit& exit : group.exits)
    {
      const double x = leaving[i++];
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
  m_leaving = leaving;
}

void Transport_iteration::keep_potential(const Vector& potential)
{
  double square = 0.;
  for(const Planar& slope : gradient(operators(), potential))
    square = std::max(square, dot(slope, slope));
  const Vector even = potential / std::sqrt(square);
  double lower = m_problem.masses.dot(even);
  for(const Exit_group& group : m_problem.exits)
    lower += least_cost(group, even).first;
  if(!(lower > m_lower))
    return;
  m_lower = lower;
  m_potential = even;
}

Transport_solver::Transport_solver(Operators operators)
    : m_operators(std::move(operators)), m_laplacian(m_operators),
      m_matrix(m_laplacian.matrix(m_operators))
{
  if(std::none_of(m_operators.area.begin(), m_operators.area.end(),
                  [](double area) { return area > 0.; }))
    throw Unsupported_surface_error("The surface has no triangle with an area to move masses on.");
  std::tie(m_component, m_components) = components(m_operators);
  m_laplacian.hold(m_matrix);
  m_solver = std::make_unique<Sparse_solver>(m_matrix, Elimination::sparse);
}

void Transport_solver::check(const Vector& masses, const std::vector<Exit>& exits) const
{
  if(masses.size() != Eigen::Index(m_operators.number_of_sites))
    throw Invalid_argument_error("There are " + std::to_string(masses.size()) + " masses for " +
                                 std::to_string(m_operators.number_of_sites) + " sites.");
  if(!masses.allFinite())
    throw Invalid_argument_error("A mass is not a finite number.");
  std::vector<double> sum(m_components, 0.), size(m_components, 0.);
  for(std::size_t site = 0; site < m_component.size(); ++site)
  {
    sum[m_component[site]] += masses[site];
    size[m_component[site]] += std::abs(masses[site]);
  }
  std::vector<double> room(m_components, -1.);
  for(const Exit& exit : exits)
  {
    if(!(exit.capacity > 0.) || !(exit.price >= 0.) || !std::isfinite(exit.price))
      throw Invalid_argument_error(
          "A capacity is not positive, or a price negative or not finite.");
    double& value = room[m_component[exit.site]];
    value = std::max(value, 0.) + exit.capacity;
  }
  for(std::size_t i = 0; i < m_components; ++i)
    if(room[i] > 0. && -sum[i] > room[i] * (1. + 1e-9))
      throw Invalid_argument_error("There is room for a mass of " + std::to_string(room[i]) +
                                   " where one of " + std::to_string(-sum[i]) + " has to go.");
    else if(!(room[i] > 0. && sum[i] <= 0.) && std::abs(sum[i]) > 1e-9 * size[i])
      throw Invalid_argument_error(
          m_components == 1
              ? "The masses to be moved sum to " + std::to_string(sum[i]) + " instead of zero."
              : "The masses to be moved sum to " + std::to_string(sum[i]) +
                    " instead of zero on a component of the surface, and none can leave it.");
}

Field Transport_solver::least_flow(const Vector& masses) const
{
  return gradient(m_operators, m_solver->solve(masses));
}

Transport Transport_solver::solve(const Vector& masses, const Transport_options& options,
                                  const std::vector<Exit>& exits) const
{
  check(masses, exits);
  if(!(options.tolerance > 0.))
    throw Invalid_argument_error("The tolerance is not positive.");
  Transport result;
  result.potential = Vector::Zero(masses.size());
  result.flow.assign(m_operators.number_of_triangles(), Planar{0., 0.});
  result.leaving = Vector::Zero(Eigen::Index(exits.size()));
  const double moved = exits.empty() ? 0.5 * masses.lpNorm<1>() : masses.lpNorm<1>();
  if(moved == 0.)
  {
    result.converged = true;
    return result;
  }
  Vector unit = masses / moved;
  const Grouped_exits groups = grouped(exits, m_component, unit, moved);
  for(std::size_t i = 0; i < exits.size(); ++i)
    unit[exits[i].site] += result.leaving[Eigen::Index(i)] = groups.leaving[i];
  if(!groups.open.empty() && options.method != Transport_method::interior_point)
    throw Invalid_argument_error("Only the interior point method knows capacities and prices.");
  const Transport_problem problem = {m_operators, m_laplacian, m_matrix,
                                     *m_solver,   unit,        groups.open};
  std::unique_ptr<Transport_iteration> iteration;
  const Splitting_iteration* splitting = nullptr;
  switch(options.method)
  {
  case Transport_method::interior_point:
    iteration = interior_point(problem);
    break;
  case Transport_method::weiszfeld:
    iteration = weiszfeld(problem);
    break;
  case Transport_method::splitting:
    auto made = std::make_unique<Splitting_iteration>(problem, options.start);
    splitting = made.get();
    iteration = std::move(made);
  }
  const unsigned each = splitting ? splitting_steps : 1;
  const unsigned most = options.maximum_iterations > 0 ? options.maximum_iterations
                        : splitting                    ? 5000
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
  while(gap() > options.tolerance && result.iterations < most && !is_cancelled() &&
        iteration->advance())
    result.iterations += each;

  result.converged = gap() <= options.tolerance;
  result.lower = moved * (iteration->lower() + groups.cost);
  result.upper = moved * (iteration->upper() + groups.cost);
  result.value = 0.5 * (result.lower + result.upper);
  result.potential = iteration->potential();
  result.flow = iteration->flow();
  for(std::size_t i = 0; i < groups.order.size(); ++i)
  {
    const std::size_t exit = groups.order[i];
    unit[exits[exit].site] += result.leaving[Eigen::Index(exit)] = iteration->leaving()[i];
  }
  result.leaving *= moved;
  const auto lower = [&](Index component, double change)
  {
    for(std::size_t site = 0; site < m_component.size(); ++site)
      if(m_component[site] == component)
        result.potential[Eigen::Index(site)] -= change;
  };
  for(const Exit_group& group : groups.open)
    lower(group.component, least_cost(group, result.potential).second);
  for(const Exit_group& group : groups.full)
    lower(group.component, last_price(group, result.potential));
  result.residual = (divergence(m_operators, result.flow) - unit).lpNorm<Eigen::Infinity>();
  for(Planar& vector : result.flow)
    vector = moved * vector;
  if(splitting)
    result.state = splitting->state();
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
