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

void Transport_iteration::update_upper_bound(const Field& flow, const Vector& outflow)
{
  double upper = 0.;
  Eigen::Index i = 0;
  for(const Exit_group& group : m_problem.exits)
    for(const Exit& exit : group.exits)
    {
      const double x = outflow[i++];
      if(!(x >= 0. && x <= exit.capacity))
        return;
      upper += 0.5 * exit.price * x * x;
    }
  upper = integrated_length(operators(), flow, upper);
  if(!(upper < m_best.upper))
    return;
  m_best.upper = upper;
  m_best.flow = flow;
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
