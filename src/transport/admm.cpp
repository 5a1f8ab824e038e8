// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/admm.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

Admm::Admm(const Operators& operators, Projection projection, State initial_state)
    : m_operators(operators), m_projection(std::move(projection)), m_state(std::move(initial_state))
{
  const std::size_t n = operators.number_of_triangles();
  m_least_squares_flow = m_projection(Field(n, Vec2{0., 0.}));
  const double area = std::accumulate(operators.area.begin(), operators.area.end(), 0.);
  // Between points, the optimal flow is nonzero in few triangles. There it is some tens of times
  // as large as the root mean square of the least squares flow.
  m_threshold =
      20. * std::sqrt(inner_product(operators, m_least_squares_flow, m_least_squares_flow) / area);
  if(m_state.shrunk_flow.empty())
    m_state = {m_least_squares_flow, Field(n, Vec2{0., 0.})};
  m_dual_field.assign(n, Vec2{0., 0.});
  update_upper_bound(m_least_squares_flow);
}

void Admm::advance(unsigned steps)
{
  // Over-relaxation saves two of five steps compared to 1.
  constexpr double relaxation_factor = 1.7;
  auto& [z, u] = m_state;
  Field x(z.size());
  for(unsigned step = 0; step < steps; ++step)
  {
    for(std::size_t f = 0; f < x.size(); ++f)
      x[f] = z[f] - u[f];
    const Field flow = m_projection(x);
    update_upper_bound(flow);
    for(std::size_t f = 0; f < x.size(); ++f)
    {
      const Vec2 w = relaxation_factor * flow[f] + (1. - relaxation_factor) * z[f] + u[f];
      const double size = norm(w);
      z[f] = size > m_threshold ? (1. - m_threshold / size) * w : Vec2{0., 0.};
      u[f] = w - z[f];
    }
  }
  update_lower_bound();
}

void Admm::update_upper_bound(const Field& flow)
{
  const double upper = integrated_length(m_operators, flow);
  if(!(upper < m_upper))
    return;
  m_upper = upper;
  m_flow = flow;
}

// The component of the scaled dual that is orthogonal to the set, divided by its maximum length.
void Admm::update_lower_bound()
{
  Field dual_field = m_projection(m_state.scaled_dual);
  double square = 0.;
  for(std::size_t f = 0; f < dual_field.size(); ++f)
  {
    dual_field[f] = m_state.scaled_dual[f] - dual_field[f] + m_least_squares_flow[f];
    if(m_operators.area[f] > 0.)
      square = std::max(square, dot(dual_field[f], dual_field[f]));
  }
  if(!(square > 0.))
    return;
  for(Vec2& vector : dual_field)
    vector = (1. / std::sqrt(square)) * vector;
  const double lower = inner_product(m_operators, dual_field, m_least_squares_flow);
  if(!(lower > m_lower))
    return;
  m_lower = lower;
  m_dual_field = std::move(dual_field);
}

} // namespace CGAL::Geodesic_processing::internal
