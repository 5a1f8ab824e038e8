// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/Transport_iteration.h>

#include <algorithm>
#include <cmath>
#include <limits>
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

} // namespace

void Transport_iteration::keep_flow(const Field& flow)
{
  double upper = 0.;
  for(std::size_t f = 0; f < flow.size(); ++f)
    upper += operators().area[f] * norm(flow[f]);
  if(!(upper < m_upper))
    return;
  m_upper = upper;
  m_flow = flow;
}

void Transport_iteration::keep_potential(const Vector& potential)
{
  double square = 0.;
  for(const Planar& slope : gradient(operators(), potential))
    square = std::max(square, dot(slope, slope));
  const double lower = m_problem.masses.dot(potential) / std::sqrt(square);
  if(!(lower > m_lower))
    return;
  m_lower = lower;
  m_potential = potential / std::sqrt(square);
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

void Transport_solver::check(const Vector& masses) const
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
  for(std::size_t i = 0; i < m_components; ++i)
    if(std::abs(sum[i]) > 1e-9 * size[i])
      throw Invalid_argument_error(
          m_components == 1
              ? "The masses to be moved sum to " + std::to_string(sum[i]) + " instead of zero."
              : "The masses to be moved sum to " + std::to_string(sum[i]) +
                    " instead of zero on a component of the surface, and none can leave it.");
}

Transport Transport_solver::solve(const Vector& masses, const Transport_options& options) const
{
  check(masses);
  if(!(options.tolerance > 0.))
    throw Invalid_argument_error("The tolerance is not positive.");
  Transport result;
  result.potential = Vector::Zero(masses.size());
  result.flow.assign(m_operators.number_of_triangles(), Planar{0., 0.});
  const double moved = 0.5 * masses.lpNorm<1>();
  if(moved == 0.)
  {
    result.converged = true;
    return result;
  }
  const Vector unit = masses / moved;
  const Transport_problem problem = {m_operators, m_laplacian, m_matrix, *m_solver, unit};
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

  const auto gap = [&] { return 1. - iteration->lower() / iteration->upper(); };
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
  result.lower = moved * iteration->lower();
  result.upper = moved * iteration->upper();
  result.value = 0.5 * (result.lower + result.upper);
  result.potential = iteration->potential();
  result.flow = iteration->flow();
  result.residual = (divergence(m_operators, result.flow) - unit).lpNorm<Eigen::Infinity>();
  for(Planar& vector : result.flow)
    vector = moved * vector;
  if(splitting)
    result.state = splitting->state();
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
