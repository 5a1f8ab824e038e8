// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/splitting.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Steps longer than one save two of five.
constexpr double over_relaxation = 1.7;

} // namespace

Splitting::Splitting(const Operators& operators, Projection projection, State start)
    : m_operators(operators), m_projection(std::move(projection)), m_state(std::move(start))
{
  const std::size_t n = operators.number_of_triangles();
  m_least = m_projection(Field(n, Planar{0., 0.}));
  const double area = std::accumulate(operators.area.begin(), operators.area.end(), 0.);
  // Between points a flow is some tens of times as strong where it is not zero as that of least squares.
  m_threshold = 20. * std::sqrt(inner_product(operators, m_least, m_least) / area);
  if(m_state.short_flow.empty())
    m_state = {m_least, Field(n, Planar{0., 0.})};
  m_slope.assign(n, Planar{0., 0.});
  keep_flow(m_least);
}

void Splitting::advance(unsigned steps)
{
  auto& [z, u] = m_state;
  Field x(z.size());
  for(unsigned step = 0; step < steps; ++step)
  {
    for(std::size_t f = 0; f < x.size(); ++f)
      x[f] = z[f] - u[f];
    const Field flow = m_projection(x);
    keep_flow(flow);
    for(std::size_t f = 0; f < x.size(); ++f)
    {
      const Planar w = over_relaxation * flow[f] + (1. - over_relaxation) * z[f] + u[f];
      const double size = norm(w);
      z[f] = size > m_threshold ? (1. - m_threshold / size) * w : Planar{0., 0.};
      u[f] = w - z[f];
    }
  }
  keep_slope();
}

void Splitting::keep_flow(const Field& flow)
{
  double upper = 0.;
  for(std::size_t f = 0; f < flow.size(); ++f)
    upper += m_operators.area[f] * norm(flow[f]);
  if(!(upper < m_upper))
    return;
  m_upper = upper;
  m_flow = flow;
}

// The excess less its part along the set, over its largest length.
void Splitting::keep_slope()
{
  Field slope = m_projection(m_state.excess);
  double square = 0.;
  for(std::size_t f = 0; f < slope.size(); ++f)
  {
    slope[f] = m_state.excess[f] - slope[f] + m_least[f];
    if(m_operators.area[f] > 0.)
      square = std::max(square, dot(slope[f], slope[f]));
  }
  if(!(square > 0.))
    return;
  for(Planar& vector : slope)
    vector = (1. / std::sqrt(square)) * vector;
  const double lower = inner_product(m_operators, slope, m_least);
  if(!(lower > m_lower))
    return;
  m_lower = lower;
  m_slope = std::move(slope);
}

} // namespace CGAL::Geodesic_processing::internal
