// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/Transport_iteration.h"

#include <cmath>
#include <numeric>

namespace CGAL::Geodesic_processing::internal {

namespace {

class Weiszfeld : public Transport_iteration
{
public:
  explicit Weiszfeld(const Transport_problem& problem)
      : Transport_iteration(problem), m_matrix(problem.matrix), m_solver(problem.solver)
  {
    const Vector potential = m_solver.solve(problem.masses);
    m_flow = gradient(operators(), potential);
    const std::vector<double>& area = operators().area;
    m_regularization = std::sqrt(inner_product(operators(), m_flow, m_flow) /
                                 std::accumulate(area.begin(), area.end(), 0.));
    m_tensor.resize(m_flow.size());
    update_upper_bound(m_flow);
    update_lower_bound(potential);
  }

  bool advance() override
  {
    for(std::size_t f = 0; f < m_flow.size(); ++f)
    {
      const double length = std::hypot(norm(m_flow[f]), m_regularization);
      m_tensor[f] = {length, 0., length};
    }
    m_regularization *= 0.7; // keeps the weights finite where the flow vanishes
    problem().laplacian.assemble(operators(), m_tensor, m_matrix);
    problem().laplacian.pin(m_matrix);
    if(!m_solver.factorize(m_matrix))
      return false;
    const Vector potential = m_solver.solve(problem().masses);
    gradient(operators(), potential, m_flow);
    for(std::size_t f = 0; f < m_flow.size(); ++f)
      m_flow[f] = m_tensor[f][0] * m_flow[f];
    update_upper_bound(m_flow);
    update_lower_bound(potential);
    return true;
  }

private:
  Sparse_matrix m_matrix;
  Sparse_solver m_solver;
  double m_regularization = 0.;
  Field m_flow;
  std::vector<Metric_tensor> m_tensor;
};

} // namespace

std::unique_ptr<Transport_iteration> weiszfeld(const Transport_problem& problem)
{
  return std::make_unique<Weiszfeld>(problem);
}

} // namespace CGAL::Geodesic_processing::internal
