// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/exits.h"

#include <algorithm>
#include <map>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns the exits with the given indices, in units of the moved mass.
Exit_group scaled_group(const std::vector<Exit>& exits, const std::vector<std::size_t>& indices,
                        double moved_mass)
{
  Exit_group result = {0, 0., {}};
  for(const std::size_t i : indices)
    result.exits.push_back(
        {exits[i].vertex, exits[i].capacity / moved_mass, exits[i].price * moved_mass});
  return result;
}

double surplus(const std::vector<Index>& component, const Vector& masses, Index label)
{
  double result = 0.;
  for(std::size_t vertex = 0; vertex < component.size(); ++vertex)
    if(component[vertex] == label)
      result -= masses[Eigen::Index(vertex)];
  return result;
}

// Returns the outflow of an exit if each unit gains `gain` before the price is paid.
double optimal_outflow(const Exit& exit, double gain)
{
  return gain <= 0.        ? 0.
         : exit.price > 0. ? std::min(gain / exit.price, exit.capacity)
                           : exit.capacity;
}

// The dual function at a marginal cost.
double dual_value(const Exit_group& group, const Vector& potential, double marginal_cost)
{
  double result = marginal_cost * group.mass;
  for(const Exit& exit : group.exits)
    if(const double x = optimal_outflow(exit, marginal_cost - potential[exit.vertex]); x > 0.)
      result += x * (0.5 * exit.price * x + potential[exit.vertex] - marginal_cost);
  return result;
}

} // namespace

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
    Exit_group group = scaled_group(exits, indices, moved_mass);
    group.component = label;
    group.mass = surplus(component, masses, label);
    if(!(group.mass > 1e-12)) // round-off errors of a component that is balanced without exits
      continue;
    double total_capacity = 0.;
    for(const Exit& exit : group.exits)
      total_capacity += exit.capacity;
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

Exit_cost dual_exit_cost(const Exit_group& group, const Vector& potential)
{
  double low = infinity, high = -infinity, limit = infinity;
  for(const Exit& exit : group.exits)
  {
    low = std::min(low, potential[exit.vertex]);
    high = std::max(high, potential[exit.vertex] + exit.price * group.mass);
    // Above the potential of a free exit without limit the dual function is minus infinity.
    if(exit.price == 0. && exit.capacity == infinity)
      limit = std::min(limit, potential[exit.vertex]);
  }
  high = std::min(high, limit);
  for(double midpoint; midpoint = 0.5 * (low + high), low < midpoint && midpoint < high;)
  {
    double sum = 0.;
    for(const Exit& exit : group.exits)
      sum += optimal_outflow(exit, midpoint - potential[exit.vertex]);
    (sum < group.mass ? low : high) = midpoint;
  }
  const double cost_at_low = dual_value(group, potential, low),
               cost_at_high = dual_value(group, potential, high);
  return cost_at_low > cost_at_high ? Exit_cost{cost_at_low, low} : Exit_cost{cost_at_high, high};
}

double full_marginal_cost(const Exit_group& full, const Vector& potential)
{
  double result = -infinity;
  for(const Exit& exit : full.exits)
    result = std::max(result, potential[exit.vertex] + exit.price * exit.capacity);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
