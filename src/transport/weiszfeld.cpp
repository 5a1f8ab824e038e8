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
    m_least = std::sqrt(inner_product(operators(), m_flow, m_flow) /
                        std::accumulate(area.begin(), area.end(), 0.));
    m_tensor.resize(m_flow.size());
    keep_flow(m_flow);
    keep_potential(potential);
  }

  bool advance() override
  {
    for(std::size_t f = 0; f < m_flow.size(); ++f)
    {
      const double length = std::hypot(norm(m_flow[f]), m_least);
      m_tensor[f] = {length, 0., length};
    }
    m_least *= 0.7; // so that no weight is infinite
    problem().laplacian.assemble(operators(), m_tensor, m_matrix);
    problem().laplacian.hold(m_matrix);
    if(!m_solver.factorize(m_matrix))
      return false;
    const Vector potential = m_solver.solve(problem().masses);
    gradient(operators(), potential, m_flow);
    for(std::size_t f = 0; f < m_flow.size(); ++f)
      m_flow[f] = m_tensor[f][0] * m_flow[f];
    keep_flow(m_flow);
    keep_potential(potential);
    return true;
  }

private:
  Sparse_matrix m_matrix;
  Sparse_solver m_solver;
  double m_least = 0.;
  Field m_flow;
  std::vector<Tensor> m_tensor;
};

} // namespace

std::unique_ptr<Transport_iteration> weiszfeld(const Transport_problem& problem)
{
  return std::make_unique<Weiszfeld>(problem);
}

} // namespace CGAL::Geodesic_processing::internal
