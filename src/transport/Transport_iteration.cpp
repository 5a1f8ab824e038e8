// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/Transport_iteration.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The number of ADMM steps between two updates of the bounds, which cost as much as two steps.
constexpr unsigned admm_steps = 10;

// A flow is corrected if its error may cost more than this fraction of its own cost, which is far
// below every tolerance of use. Round-off errors cost less if there are no needles.
constexpr double negligible_error = 1e-10;

// ADMM with the projection to the fields that move the masses: one back substitution each.
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

  unsigned iterations_per_advance() const override { return admm_steps; }
  unsigned default_max_iterations() const override { return 5000; }

  Transport_result take_best() override
  {
    Transport_result result = Transport_iteration::take_best();
    result.state = m_admm.state();
    return result;
  }

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

} // namespace

Transport_iteration::Transport_iteration(const Transport_problem& problem) : m_problem(problem)
{
  m_best.upper = infinity;
  m_best.potential = Vector::Zero(problem.masses.size());
}

double Transport_iteration::price(const Vector& outflow) const
{
  double result = 0.;
  Eigen::Index i = 0;
  for(const Exit_group& group : m_problem.exits)
    for(const Exit& exit : group.exits)
    {
      const double x = outflow[i++];
      if(!(x >= 0. && x <= exit.capacity))
        return infinity;
      result += 0.5 * exit.price * x * x;
    }
  return result;
}

double Transport_iteration::correct(const Vector& outflow, double negligible_cost,
                                    Field& flow) const
{
  Vector masses = m_problem.masses;
  Eigen::Index i = 0;
  for(const Exit_group& group : m_problem.exits)
    for(const Exit& exit : group.exits)
      masses[exit.vertex] += outflow[i++];
  const auto error = [&](const Field& flow) -> Vector
  { return masses - minus_divergence(operators(), flow); };

  double cost = m_problem.forest.cost(error(flow));
  // Iterative refinement. If the matrix is too ill-conditioned, it does not converge.
  while(cost > negligible_cost)
  {
    Field corrected = gradient(operators(), m_problem.solver.solve(error(flow)));
    for(std::size_t f = 0; f < flow.size(); ++f)
      corrected[f] = flow[f] + corrected[f];
    const double next = m_problem.forest.cost(error(corrected));
    if(!(next < 0.5 * cost))
      break;
    cost = next;
    flow = std::move(corrected);
  }
  return cost;
}

void Transport_iteration::update_upper_bound(Field flow, const Vector& outflow)
{
  const double fixed_cost = price(outflow);
  const double cost = integrated_length(operators(), flow, fixed_cost);
  if(!(cost < m_best.upper))
    return;
  const double remaining_cost = correct(outflow, negligible_error * cost, flow);
  const double upper = integrated_length(operators(), flow, fixed_cost) + remaining_cost;
  if(!(upper < m_best.upper))
    return;
  m_best.upper = upper;
  m_best.remaining_cost = remaining_cost;
  m_best.flow = std::move(flow);
  m_best.outflow = outflow;
}

void Transport_iteration::update_lower_bound(const Vector& potential)
{
  double square = 0.;
  for(const Vec2& slope : gradient(operators(), potential))
    square = std::max(square, dot(slope, slope));
  const Vector unit_potential = potential / std::sqrt(square);
  double lower = m_problem.masses.dot(unit_potential);
  for(const Exit_group& group : m_problem.exits)
    lower += dual_exit_cost(group, unit_potential).cost;
  if(!(lower > m_best.lower))
    return;
  m_best.lower = lower;
  m_best.potential = unit_potential;
}

std::unique_ptr<Transport_iteration> make_iteration(const Transport_problem& problem,
                                                    const Transport_options& options)
{
  switch(options.method)
  {
  case Transport_method::admm:
    return std::make_unique<Admm_iteration>(problem, options.warm_start);
  case Transport_method::weiszfeld:
    return weiszfeld(problem);
  default:
    return interior_point(problem);
  }
}

} // namespace CGAL::Geodesic_processing::internal
