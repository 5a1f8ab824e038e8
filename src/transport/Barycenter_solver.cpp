// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/Barycenter_solver.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "transport/Spanning_forest.h"
#include "transport/convergence.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The number of steps between two updates of the upper bound, which cost as much as one step.
constexpr unsigned steps_per_check = 10;

// The initial threshold relative to the root mean square of the least squares flows. Between
// points, the optimal flow is nonzero in few triangles, and some tens of times as large there.
constexpr double threshold_factor = 20.;

// Thresholds change at every 16th update of the upper bound, up to the 64th.
constexpr unsigned checks_between_updates = 16, last_update = 64;

// The stiffness relative to the area. The number of steps does not depend on it from half to
// twice this value; at ten times the value it increases.
constexpr double stiffness_factor = 2e-4;

double max_squared_length(const Operators& o, const Field& field)
{
  double result = 0.;
  for(std::size_t f = 0; f < field.size(); ++f)
    if(o.area[f] > 0.)
      result = std::max(result, dot(field[f], field[f]));
  return result;
}

// Replaces a field by the z that minimizes (integral of |z|)^2 + (integral of |z - field|^2) /
// factor. All vectors become shorter by the threshold factor * (integral of |z|).
//
// Newton's method finds the threshold in a few steps from any start, since the equation is
// concave and piecewise linear. `threshold` is the start, and receives the result.
void shrink(const Operators& o, double factor, double& threshold, Field& field)
{
  std::vector<double> size(field.size());
  for(std::size_t f = 0; f < field.size(); ++f)
    size[f] = norm(field[f]);
  for(bool has_iterated = false;; has_iterated = true)
  {
    double length = 0., area = 0.;
    for(std::size_t f = 0; f < field.size(); ++f)
      if(size[f] > threshold)
      {
        length += o.area[f] * size[f];
        area += o.area[f];
      }
    const double next = factor * length / (1. + factor * area);
    if(has_iterated && !(next > threshold))
      break;
    threshold = next;
  }
  for(std::size_t f = 0; f < field.size(); ++f)
    field[f] = size[f] > threshold ? (1. - threshold / size[f]) * field[f] : Vec2{0., 0.};
}

} // namespace

// Douglas-Rachford splitting of the flows J_i and the masses m. Distances of flows are measured
// by w_i |J_i|^2, those of masses by stiffness * m^2 / lumped mass. Weights and masses must sum
// to one.
class Barycenter_solver::Admm
{
public:
  Admm(const Barycenter_solver& solver, const std::vector<Vector>& masses,
       const std::vector<double>& weights, Barycenter_state start)
      : m_solver(solver), m_operators(solver.m_operators), m_masses(masses), m_weights(weights),
        m_total(solver.m_number_of_components, 0.), m_threshold(masses.size(), 0.),
        m_state(std::move(start))
  {
    const std::size_t k = masses.size();
    for(std::size_t vertex = 0; vertex < solver.m_component.size(); ++vertex)
      m_total[solver.m_component[vertex]] += masses[0][vertex];
    Vector mean = Vector::Zero(masses[0].size());
    for(std::size_t i = 0; i < k; ++i)
      mean += weights[i] * masses[i];
    const Field zero(m_operators.number_of_triangles(), Vec2{0., 0.});
    update_upper_bound(mean, std::vector<Field>(k, zero));
    m_potentials = Columns::Zero(mean.size(), Eigen::Index(k));
    double square = 0.;
    for(std::size_t i = 0; i < k; ++i)
      square += weights[i] * inner_product(m_operators, m_flows[i], m_flows[i]);
    if(m_state.shrunk_flows.empty())
      m_state = {m_flows, std::vector<Field>(k, zero), mean, Vector::Zero(mean.size()),
                 m_upper > 0. ? threshold_factor * std::sqrt(square / solver.m_area / m_upper)
                              : 0.};
  }

  // Iterates until the gap is within the tolerance. Returns bounds, masses, flows and potentials
  // for masses and weights that sum to one each.
  Barycenter_result run(const Barycenter_options& options)
  {
    // Costs below this one are zero up to round-off errors.
    const double negligible_cost = 1e-20 * m_solver.m_area;
    const auto gap = [&] { return m_upper > negligible_cost ? 1. - m_lower / m_upper : 0.; };
    const unsigned max_iterations =
        options.maximum_iterations > 0 ? options.maximum_iterations : 5000;
    Barycenter_result result;
    for(; gap() > options.tolerance && result.number_of_iterations < max_iterations &&
          !is_cancelled(options.callback, gap(), options.tolerance);
        result.number_of_iterations += steps_per_check)
      advance();
    result.is_converged = gap() <= options.tolerance;
    result.lower = m_lower;
    result.upper = m_upper;
    result.distances = m_distances;
    result.masses = m_barycenter;
    result.flows = std::move(m_flows);
    for(Eigen::Index i = 0; i < m_potentials.cols(); ++i)
      result.potentials.push_back(m_potentials.col(i));
    result.state = std::move(m_state);
    return result;
  }

private:
  // One column for each of the masses.
  using Columns = Eigen::MatrixXd;

  void advance()
  {
    for(unsigned step = 0; step < steps_per_check; ++step)
      this->step();
    update_upper_bound(m_state.masses, m_state.shrunk_flows);
    ++m_number_of_checks;
    if(m_number_of_checks % checks_between_updates == 0 && m_number_of_checks <= last_update)
      update_thresholds();
  }

  std::size_t size() const { return m_masses.size(); }

  // Computes an iteration. This projects x = z - u and the masses m - mass_dual. The projection
  // of the flows is x plus the gradients of `potentials`.
  void step()
  {
    // Over-relaxation close to 2 converges fastest. 1.7 takes a tenth more steps.
    constexpr double relaxation_factor = 1.9;
    auto& [z, u, m, mass_dual, factor] = m_state;
    for(std::size_t i = 0; i < size(); ++i)
      for(std::size_t f = 0; f < z[i].size(); ++f)
        z[i][f] = z[i][f] - u[i][f];
    Columns potentials(m.size(), Eigen::Index(size()));
    const Vector projected_masses = project(z, m - mass_dual, potentials);

    double square = 0.;
    for(std::size_t i = 0; i < size(); ++i)
    {
      gradient(m_operators, potentials.col(Eigen::Index(i)), m_gradient);
      square += m_weights[i] * max_squared_length(m_operators, m_gradient);
      // The relaxed iterate plus u, where z holds x.
      for(std::size_t f = 0; f < z[i].size(); ++f)
      {
        z[i][f] = z[i][f] + u[i][f] + relaxation_factor * m_gradient[f] +
                  (1. - relaxation_factor) * u[i][f];
        u[i][f] = z[i][f];
      }
      shrink(m_operators, factor, m_threshold[i], z[i]);
      for(std::size_t f = 0; f < z[i].size(); ++f)
        u[i][f] = u[i][f] - z[i][f];
    }
    update_lower_bound(potentials, square);

    const Vector relaxed_masses =
        relaxation_factor * projected_masses + (1. - relaxation_factor) * m + mass_dual;
    m = project_masses(relaxed_masses);
    mass_dual = relaxed_masses - m;
  }

  // Finds the flows and masses closest to the given ones that satisfy divergence(J_i) = m_i - m.
  // Returns m and the potentials whose gradients are to be added to the flows.
  Vector project(const std::vector<Field>& flows, const Vector& target_masses,
                 Columns& potentials) const
  {
    Vector sum = -target_masses;
    for(std::size_t i = 0; i < size(); ++i)
    {
      potentials.col(Eigen::Index(i)) = m_masses[i] - minus_divergence(m_operators, flows[i]);
      sum += m_weights[i] * potentials.col(Eigen::Index(i));
    }
    const Vector result =
        target_masses + m_solver.m_lumped_mass.cwiseProduct(m_solver.m_damped_solver->solve(sum)) /
                            m_solver.m_stiffness;
    potentials.colwise() -= result;
    m_solver.m_solver->solve_columns(potentials);
    return result;
  }

  // Raises the thresholds to a third of the mean length of the vectors, weighted by the mass that
  // they carry. Flows between points are larger in smaller triangles. At 40,000 vertices this
  // saves half of the steps.
  void update_thresholds()
  {
    double mean_flow = 0., threshold = 0.;
    for(std::size_t i = 0; i < size(); ++i)
    {
      const Field& flow = m_state.shrunk_flows[i];
      const double length = integrated_length(m_operators, flow);
      if(length > 0.)
        mean_flow += m_weights[i] * inner_product(m_operators, flow, flow) / length;
      threshold += m_weights[i] * m_threshold[i];
    }
    const double change = threshold > 0. ? std::clamp(mean_flow / (3. * threshold), 1., 4.) : 1.;
    m_state.factor *= change;
    m_state.mass_dual *= change;
    for(Field& scaled_dual : m_state.scaled_duals)
      for(Vec2& vector : scaled_dual)
        vector = change * vector;
  }

  // Returns the masses max(0, target - c lumped_mass), with one constant c for each component,
  // whose sums are m_total: the closest masses that are not negative, measured by their
  // densities.
  Vector project_masses(const Vector& target_masses) const
  {
    const std::vector<double> density = density_shift(target_masses);
    const std::vector<Index>& component = m_solver.m_component;
    Vector result(target_masses.size());
    std::vector<double> mass(m_total.size(), 0.);
    for(Eigen::Index vertex = 0; vertex < target_masses.size(); ++vertex)
    {
      const Index c = component[vertex];
      result[vertex] =
          std::max(0., target_masses[vertex] - density[c] * m_solver.m_lumped_mass[vertex]);
      mass[c] += result[vertex];
    }
    for(Eigen::Index vertex = 0; vertex < target_masses.size(); ++vertex)
      if(const Index c = component[vertex]; mass[c] > 0.)
        result[vertex] *= m_total[c] / mass[c];
    return result;
  }

  // #components: the constants c of project_masses(), by Newton's method from below.
  std::vector<double> density_shift(const Vector& target_masses) const
  {
    std::vector<double> density(m_total.size(), -infinity), mass, area;
    for(bool has_converged = false; !has_converged;)
    {
      mass.assign(m_total.size(), 0.);
      area.assign(m_total.size(), 0.);
      for(Eigen::Index vertex = 0; vertex < target_masses.size(); ++vertex)
        if(const Index c = m_solver.m_component[vertex];
           target_masses[vertex] > density[c] * m_solver.m_lumped_mass[vertex])
        {
          mass[c] += target_masses[vertex];
          area[c] += m_solver.m_lumped_mass[vertex];
        }
      has_converged = true;
      for(std::size_t c = 0; c < m_total.size(); ++c)
        if(area[c] > 0.)
        {
          const double next = (mass[c] - m_total[c]) / area[c];
          has_converged = has_converged && next <= density[c];
          density[c] = std::max(density[c], next);
        }
    }
    return density;
  }

  // Corrects flows, by least squares, such that they move the given masses to the input masses.
  // Keeps masses and flows if they cost less than the best ones. The cost contains that of moving
  // the error of the divergence along edges.
  void update_upper_bound(const Vector& masses, std::vector<Field> flows)
  {
    Columns rhs(masses.size(), Eigen::Index(size()));
    for(std::size_t i = 0; i < size(); ++i)
      rhs.col(Eigen::Index(i)) = m_masses[i] - masses - minus_divergence(m_operators, flows[i]);
    m_solver.m_solver->solve_columns(rhs);
    double upper = 0.;
    std::vector<double> distances;
    for(std::size_t i = 0; i < size(); ++i)
    {
      gradient(m_operators, rhs.col(Eigen::Index(i)), m_gradient);
      for(std::size_t f = 0; f < m_gradient.size(); ++f)
        flows[i][f] = flows[i][f] + m_gradient[f];
      const Vector error = m_masses[i] - masses - minus_divergence(m_operators, flows[i]);
      const double distance =
          integrated_length(m_operators, flows[i], m_solver.m_forest->cost(error));
      upper += m_weights[i] * distance * distance;
      distances.push_back(distance);
    }
    if(!(upper < m_upper))
      return;
    m_upper = upper;
    m_distances = std::move(distances);
    m_barycenter = masses;
    m_flows = std::move(flows);
  }

  // Keeps potentials if they prove a higher lower bound than the best ones. `square` is the sum
  // of the weights times the squared slopes.
  void update_lower_bound(const Columns& potentials, double square)
  {
    Vector sum = Vector::Zero(potentials.rows());
    double integral = 0.;
    for(std::size_t i = 0; i < size(); ++i)
    {
      const auto potential = potentials.col(Eigen::Index(i));
      sum += m_weights[i] * potential;
      integral += m_weights[i] * m_masses[i].dot(potential);
    }
    std::vector<double> max_potential(m_total.size(), -infinity);
    for(Eigen::Index vertex = 0; vertex < sum.size(); ++vertex)
    {
      double& max_of_component = max_potential[m_solver.m_component[vertex]];
      max_of_component = std::max(max_of_component, sum[vertex]);
    }
    for(std::size_t c = 0; c < max_potential.size(); ++c)
      integral -= m_total[c] * max_potential[c];
    if(!(integral > 0. && integral * integral > m_lower * square))
      return;
    m_lower = integral * integral / square;
    m_potentials = (integral / square) * potentials;
  }

  const Barycenter_solver& m_solver;
  const Operators& m_operators;
  const std::vector<Vector>& m_masses;
  const std::vector<double>& m_weights;
  std::vector<double> m_total;     // #components
  std::vector<double> m_threshold; // #masses: shrinkage of the last step
  Barycenter_state m_state;
  unsigned m_number_of_checks = 0;
  double m_upper = infinity, m_lower = 0.;
  std::vector<double> m_distances; // #masses: their weighted sum of squares is m_upper
  Vector m_barycenter;
  std::vector<Field> m_flows;
  Columns m_potentials;
  Field m_gradient;
};

Barycenter_solver::Barycenter_solver(Operators operators) : m_operators(std::move(operators))
{
  m_area = std::accumulate(m_operators.area.begin(), m_operators.area.end(), 0.);
  if(!(m_area > 0.))
    throw Unsupported_surface_error("No triangle of the surface has an area.");
  std::tie(m_component, m_number_of_components) = components(m_operators);
  // Mass at a vertex without triangles cannot move, so that any positive area will do.
  m_lumped_mass = lumped_mass(m_operators);
  for(double& lumped : m_lumped_mass)
    if(!(lumped > 0.))
      lumped = m_area / double(m_lumped_mass.size());
  m_stiffness = stiffness_factor * m_area;
  m_forest = std::make_shared<const Spanning_forest>(m_operators);

  const Laplacian laplacian(m_operators);
  Sparse_matrix matrix = laplacian.matrix(m_operators);
  Sparse_matrix damped_matrix = matrix;
  for(Eigen::Index vertex = 0; vertex < m_lumped_mass.size(); ++vertex)
    damped_matrix.coeffRef(vertex, vertex) += m_lumped_mass[vertex] / m_stiffness;
  laplacian.pin(matrix);
  m_solver = std::make_unique<Sparse_solver>(matrix, Elimination_order::low_fill);
  m_damped_solver = std::make_unique<Sparse_solver>(damped_matrix, Elimination_order::low_fill);
}

void check_weights(const std::vector<double>& weights, std::size_t number)
{
  if(weights.size() != number)
    throw Invalid_argument_error("There are " + std::to_string(weights.size()) + " weights, but " +
                                 std::to_string(number) + " are required.");
  for(const double weight : weights)
    if(!(weight >= 0. && std::isfinite(weight)))
      throw Invalid_argument_error("A weight is " + std::to_string(weight) +
                                   "; it must be finite and not negative.");
  if(std::all_of(weights.begin(), weights.end(), [](double weight) { return weight == 0.; }))
    throw Invalid_argument_error("All weights are zero.");
}

std::vector<double> Barycenter_solver::component_totals(const Vector& masses) const
{
  std::vector<double> result(m_number_of_components, 0.);
  for(Eigen::Index vertex = 0; vertex < masses.size(); ++vertex)
    result[m_component[vertex]] += masses[vertex];
  return result;
}

void Barycenter_solver::check_masses(const Vector& masses) const
{
  if(masses.size() != Eigen::Index(m_operators.number_of_vertices))
    throw Invalid_argument_error("There are " + std::to_string(masses.size()) + " masses for " +
                                 std::to_string(m_operators.number_of_vertices) + " vertices.");
  if(!masses.allFinite())
    throw Invalid_argument_error("A mass is not a finite number.");
  if(masses.minCoeff() < 0.)
    throw Invalid_argument_error("A mass is negative.");
}

void Barycenter_solver::check_input(const std::vector<Vector>& masses,
                                    const std::vector<double>& weights) const
{
  if(masses.empty())
    throw Invalid_argument_error("There are no mass distributions.");
  check_weights(weights, masses.size());
  std::vector<double> first_totals;
  for(const Vector& distribution : masses)
  {
    check_masses(distribution);
    const std::vector<double> total = component_totals(distribution);
    if(first_totals.empty())
      first_totals = total;
    for(std::size_t c = 0; c < m_number_of_components; ++c)
      if(std::abs(total[c] - first_totals[c]) > 1e-9 * std::max(total[c], first_totals[c]))
        throw Invalid_argument_error(
            "Two mass distributions have total masses " + std::to_string(first_totals[c]) +
            " and " + std::to_string(total[c]) +
            (m_number_of_components == 1 ? "." : " on a component of the surface."));
  }
  if(!(masses[0].sum() > 0.))
    throw Invalid_argument_error("The total mass is zero.");
}

Barycenter_result Barycenter_solver::solve(const std::vector<Vector>& masses,
                                           const std::vector<double>& weights,
                                           const Barycenter_options& options) const
{
  check_input(masses, weights);
  if(!(options.tolerance > 0.))
    throw Invalid_argument_error("The tolerance is not positive.");
  const std::vector<Field>& start = options.warm_start.shrunk_flows;
  if(!start.empty() && start.size() != masses.size())
    throw Invalid_argument_error("There are " + std::to_string(masses.size()) +
                                 " mass distributions, but the initial state has " +
                                 std::to_string(start.size()) + ".");
  const double total = masses[0].sum();
  const double weight = std::accumulate(weights.begin(), weights.end(), 0.);
  std::vector<Vector> normalized_masses;
  std::vector<double> normalized_weights;
  for(std::size_t i = 0; i < masses.size(); ++i)
  {
    normalized_masses.push_back(masses[i] / masses[i].sum());
    normalized_weights.push_back(weights[i] / weight);
  }
  Admm iteration(*this, normalized_masses, normalized_weights, options.warm_start);
  Barycenter_result result = iteration.run(options);
  for(std::size_t i = 0; i < masses.size(); ++i)
  {
    const Vector error =
        minus_divergence(m_operators, result.flows[i]) - normalized_masses[i] + result.masses;
    result.residual = std::max(result.residual, error.lpNorm<Eigen::Infinity>());
    for(Vec2& vector : result.flows[i])
      vector = total * vector;
    result.potentials[i] *= total;
    result.distances[i] *= total;
  }
  result.masses *= total;
  const double scale = weight * total * total;
  result.lower *= scale;
  result.upper *= scale;
  result.value = 0.5 * (result.lower + result.upper);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
