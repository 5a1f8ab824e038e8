// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/Transport_iteration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

namespace {

// A solution of a linear system is accepted if the sum of its residuals is at most this fraction of
// the moved mass. Without needles, the residual after one back substitution is about 1e-13.
constexpr double max_residual = 1e-7;
// Conjugate gradients end after this number of steps that do not halve the residual. There,
// round-off errors of the potential limit the residual.
constexpr unsigned max_slow_steps = 6;

// A vector of the space of the second-order cone scalar >= |vector|.
struct Cone_vector
{
  double scalar;
  Vec2 vector;

  friend Cone_vector operator+(const Cone_vector& x, const Cone_vector& y)
  {
    return {x.scalar + y.scalar, x.vector + y.vector};
  }
  friend Cone_vector operator*(double factor, const Cone_vector& x)
  {
    return {factor * x.scalar, factor * x.vector};
  }
  friend double dot(const Cone_vector& x, const Cone_vector& y)
  {
    return x.scalar * y.scalar + internal::dot(x.vector, y.vector);
  }
  // Returns the cone's determinant: positive inside the cone, zero on its boundary.
  friend double determinant(const Cone_vector& x)
  {
    return x.scalar * x.scalar - internal::dot(x.vector, x.vector);
  }
};

// The Jordan product of the cone, and its inverse: jordan_quotient(b, a) is the x with
// jordan_product(a, x) = b.
Cone_vector jordan_product(const Cone_vector& a, const Cone_vector& b)
{
  return {dot(a, b), a.scalar * b.vector + b.scalar * a.vector};
}
Cone_vector jordan_quotient(const Cone_vector& b, const Cone_vector& a)
{
  const double scalar = (a.scalar * b.scalar - dot(a.vector, b.vector)) / determinant(a);
  return {scalar, (1. / a.scalar) * (b.vector - scalar * a.vector)};
}

// Returns the correction that clamps the two eigenvalues of x to [gap / 10, 10 gap], but
// decreases none by more than 10 gap.
Cone_vector centrality_correction(double gap, const Cone_vector& x)
{
  const auto correction = [&](double eigenvalue)
  { return std::max(std::clamp(eigenvalue, 0.1 * gap, 10. * gap) - eigenvalue, -10. * gap); };
  const double size = norm(x.vector);
  const double high = correction(x.scalar + size), low = correction(x.scalar - size);
  return {0.5 * (high + low), (size > 0. ? 0.5 * (high - low) / size : 0.) * x.vector};
}

// Returns the reciprocal of the longest step from x, which is inside the cone, that stays in the
// cone; zero if no step in this direction leaves it.
double inverse_max_step(const Cone_vector& x, const Cone_vector& direction)
{
  const double a = determinant(direction), c = determinant(x);
  const double b = x.scalar * direction.scalar - dot(x.vector, direction.vector);
  const double discriminant = b * b - a * c;
  return discriminant >= 0. ? std::max(0., (std::sqrt(discriminant) - b) / c) : 0.;
}

// The Nesterov-Todd scaling W: the symmetric matrix with W z = W^-1 s. It is stored as the
// factor eta and the hyperbolic unit vector w (Vandenberghe 2010).
struct Scaling
{
  Cone_vector w;
  double eta;

  Scaling() = default;
  Scaling(const Cone_vector& s, const Cone_vector& z)
  {
    const double root_s = std::sqrt(std::max(determinant(s), min_determinant));
    const double root_z = std::sqrt(std::max(determinant(z), min_determinant));
    const Cone_vector a = (1. / root_s) * s, b = (1. / root_z) * z;
    const double gamma = std::sqrt(2. * (1. + dot(a, b)));
    w = {(a.scalar + b.scalar) / gamma, (1. / gamma) * (a.vector - b.vector)};
    eta = std::sqrt(root_s / root_z);
  }

  Cone_vector apply(const Cone_vector& x) const // W x
  {
    const double along = internal::dot(w.vector, x.vector);
    const double coefficient = x.scalar + along / (1. + w.scalar);
    return eta * Cone_vector{w.scalar * x.scalar + along, x.vector + coefficient * w.vector};
  }
  Cone_vector apply_inverse(const Cone_vector& x) const // W^-1 x
  {
    const double along = internal::dot(w.vector, x.vector);
    const double coefficient = along / (1. + w.scalar) - x.scalar;
    return (1. / eta) * Cone_vector{w.scalar * x.scalar - along, x.vector + coefficient * w.vector};
  }
  Cone_vector apply_inverse_squared(const Vec2& x) const // W^-2 (0, x)
  {
    const double along = 2. * internal::dot(w.vector, x);
    return (1. / (eta * eta)) * Cone_vector{-along * w.scalar, x + along * w.vector};
  }
  Metric_tensor tensor() const // the block of W^-2 that acts on the vector part
  {
    const double x = w.vector[0], y = w.vector[1], factor = 1. / (eta * eta);
    return {factor * (1. + 2. * x * x), factor * 2. * x * y, factor * (1. + 2. * y * y)};
  }

  static constexpr double min_determinant = std::numeric_limits<double>::min();
};

// The variables of an exit: the outflow x, the remaining capacity y = capacity - x, and the
// multipliers u of x >= 0 and v of y >= 0. At the optimum price x + potential = u - v, and the
// products u x and v y are zero.
struct Exit_slack : Exit
{
  double x, y, u = 0., v = 0.;
  double x_step = 0., u_step = 0., v_step = 0.;
  double u_change = 0., v_change = 0.; // target changes of the products u x and v y

  Exit_slack(const Exit& exit, double x) : Exit(exit), x(x), y(capacity - x) {}

  bool is_limited() const { return y < infinity; }

  // Chooses multipliers such that v y equals the product and price x + potential = u - v.
  void initialize(double potential, double product)
  {
    v = is_limited() ? product / y : 0.;
    u = price * x + potential + v;
  }

  // Returns u x + v y after steps of the given lengths.
  double gap(double primal, double dual) const
  {
    const double gap_of_x = (u + primal * u_step) * (x + dual * x_step);
    return is_limited() ? gap_of_x + (v + primal * v_step) * (y - dual * x_step) : gap_of_x;
  }

  // Returns the change of x if the potential decreases by one, in the linearized system.
  double compliance() const { return 1. / (price + u / x + (is_limited() ? v / y : 0.)); }
  // Returns the change of x that results from the target changes of the products.
  double rhs_contribution() const
  {
    return compliance() * (u_change / x - (is_limited() ? v_change / y : 0.));
  }

  void find_step(double potential_step)
  {
    x_step = rhs_contribution() - compliance() * potential_step;
    u_step = (u_change - u * x_step) / x;
    v_step = is_limited() ? (v_change + v * x_step) / y : 0.;
  }
  double inverse_primal_step() const
  {
    return std::max({0., -u_step / u, is_limited() ? -v_step / v : 0.});
  }
  double inverse_dual_step() const
  {
    return std::max({0., -x_step / x, is_limited() ? x_step / y : 0.});
  }

  void predict()
  {
    u_change = -u * x;
    v_change = is_limited() ? -v * y : 0.;
  }
  template <typename Change>
  void adjust(double primal, double dual, const Change& correction)
  {
    u_change += correction((u + primal * u_step) * (x + dual * x_step));
    if(is_limited())
      v_change += correction((v + primal * v_step) * (y - dual * x_step));
  }
  void move(double primal, double dual)
  {
    x += dual * x_step;
    y -= dual * x_step;
    u += primal * u_step;
    v += primal * v_step;
  }
};

// In each triangle s = (1, gradient phi) and z = (tau, -J) are inside the cone, and at the
// optimum their product is zero. Names as in Vandenberghe 2010 ("The CVXOPT linear and quadratic
// cone program solvers"), which describes the method for general cones.
class Interior_point : public Transport_iteration
{
public:
  explicit Interior_point(const Transport_problem& problem)
      : Transport_iteration(problem), m_operators(problem.operators), m_matrix(problem.matrix),
        m_solver(problem.solver), m_potential(Vector::Zero(problem.masses.size()))
  {
    const std::size_t n = m_operators.number_of_triangles();
    m_gradient.assign(n, Vec2{0., 0.});
    m_gradient_step.resize(n);
    m_dual.resize(n);
    m_dual_step.resize(n);
    m_target.resize(n);
    m_scaling.resize(n);
    m_scaled_dual.resize(n);
    m_tensor.resize(n);
    for(const double area : m_operators.area)
      m_area += area;
    for(const Exit_group& group : problem.exits)
      add_slacks(group);
    start_from_least_squares();
  }

  bool advance() override
  {
    scale();
    if(!factorize())
      return false;
    const double gap = mean_gap({0., 0.});
    const Steps predicted = predict();
    // The flow of a full predictor step moves the masses even if the step leaves the cone, so that
    // it gives an upper bound. This bound often has half the error of the iterate.
    update_upper_bound(flow(1.), outflow(1.));
    const double ratio = mean_gap(predicted) / gap;
    const double next = gap * std::clamp(ratio * ratio * ratio, 1e-6, 1.);
    return move(correct_centrality(next, correct(next)));
  }

private:
  // Initializes the outflows. Each is 0.9 times the outflow that is optimal if moving costs
  // nothing, plus 0.1 times an outflow in proportion to the capacity. Then none is zero or at
  // its capacity.
  void add_slacks(const Exit_group& group)
  {
    m_has_exits.resize(std::max(m_has_exits.size(), std::size_t(group.component) + 1), false);
    m_has_exits[group.component] = true;
    double total_capacity = 0.;
    for(const Exit& exit : group.exits)
      total_capacity += std::min(exit.capacity, 2. * group.mass);
    const double price = dual_exit_cost(group, Vector::Zero(problem().masses.size())).marginal_cost;
    for(const Exit& exit : group.exits)
    {
      const double uniform =
          std::min(exit.capacity, 2. * group.mass) * (group.mass / total_capacity);
      const double unconstrained =
          exit.price > 0. ? std::min(price / exit.price, exit.capacity) : uniform;
      m_slacks.emplace_back(exit, 0.1 * uniform + 0.9 * unconstrained);
    }
  }

  // Starts from the least squares flow to the initial outflows, and from a potential that is zero
  // if there are no exits.
  void start_from_least_squares()
  {
    const std::size_t n = m_dual.size();
    const Field flow = gradient(m_operators, problem().solver.solve(masses()));
    const double mean_square = inner_product(m_operators, flow, flow) / m_area;
    for(std::size_t f = 0; f < n; ++f)
      m_dual[f] = {std::sqrt(dot(flow[f], flow[f]) + mean_square), -1. * flow[f]};
    m_exit_weight = m_area / double(n);
    m_total_weight = m_area;
    const double product = m_exit_weight * std::sqrt(mean_square);
    double max_outflow = 0., min_price = infinity;
    for(const Exit_slack& slack : m_slacks)
    {
      max_outflow = std::max(max_outflow, slack.x);
      min_price = std::min(min_price, slack.price * slack.x);
      m_total_weight += slack.is_limited() ? 2. * m_exit_weight : m_exit_weight;
    }
    if(!m_slacks.empty())
      m_potential.setConstant(product / max_outflow - min_price);
    for(Exit_slack& slack : m_slacks)
      slack.initialize(m_potential[slack.vertex], product);
    update_upper_bound(flow, outflow(0.));
  }

  // Step lengths of s (primal) and z (dual), at most one.
  struct Steps
  {
    double primal, dual;
  };

  Cone_vector primal(std::size_t f) const { return {1., m_gradient[f]}; }

  // Computes the scalings of the current iterate.
  void scale()
  {
    for(std::size_t f = 0; f < m_dual.size(); ++f)
    {
      m_scaling[f] = Scaling(primal(f), m_dual[f]);
      m_scaled_dual[f] = m_scaling[f].apply(m_dual[f]);
      m_tensor[f] = m_scaling[f].tensor();
    }
  }

  // Factorizes the matrix of the current scalings. Returns false if it is not positive definite.
  bool factorize()
  {
    problem().laplacian.assemble(m_operators, m_tensor, m_matrix);
    problem().laplacian.pin(m_matrix, m_has_exits);
    for(const Exit_slack& slack : m_slacks)
      m_matrix.coeffRef(slack.vertex, slack.vertex) += slack.compliance();
    return m_solver.factorize(m_matrix);
  }

  // #vertices: returns the masses of the problem plus the current outflows.
  Vector masses() const
  {
    Vector result = problem().masses;
    for(const Exit_slack& slack : m_slacks)
      result[slack.vertex] += slack.x;
    return result;
  }

  // #exits: returns the outflows after a step.
  Vector outflow(double step) const
  {
    Vector result(Eigen::Index(m_slacks.size()));
    for(std::size_t i = 0; i < m_slacks.size(); ++i)
      result[Eigen::Index(i)] = m_slacks[i].x + step * m_slacks[i].x_step;
    return result;
  }

  // Returns the mean of the products of s and z after steps, weighted by area.
  double mean_gap(const Steps& steps) const
  {
    double sum = 0.;
    for(std::size_t f = 0; f < m_dual.size(); ++f)
      sum += m_operators.area[f] *
             dot(Cone_vector{1., m_gradient[f] + steps.primal * m_gradient_step[f]},
                 m_dual[f] + steps.dual * m_dual_step[f]);
    for(const Exit_slack& slack : m_slacks)
      sum += slack.gap(steps.primal, steps.dual);
    return sum / m_total_weight;
  }

  // Returns the product of the matrix of the current scalings with a potential, and the gradient of
  // the potential. The entries of the assembled matrix have round-off errors that are relative to
  // the largest ones, whereas this product has small errors at each vertex.
  Vector multiply(const Vector& potential, Field& slope) const
  {
    gradient(m_operators, potential, slope);
    Field image(slope.size());
    for(std::size_t f = 0; f < slope.size(); ++f)
      image[f] = m_scaling[f].apply_inverse_squared(slope[f]).vector;
    Vector result = minus_divergence(m_operators, image);
    for(const Exit_slack& slack : m_slacks)
      result[slack.vertex] += slack.compliance() * potential[slack.vertex];
    return result;
  }

  // Computes the potential step and its gradient. If there are needles, the factorization is
  // inaccurate, and conjugate gradients reduce the residual. The factorization is the
  // preconditioner.
  void solve(const Vector& rhs)
  {
    Vector potential = m_solver.solve(rhs), direction = Vector::Zero(rhs.size());
    Field slope;
    double previous_product = infinity, best = infinity, target = infinity;
    unsigned number_of_slow_steps = 0;
    for(;;)
    {
      const Vector residual = rhs - multiply(potential, slope);
      const double size = residual.lpNorm<1>();
      if(!(size >= best))
      {
        best = size;
        m_potential_step = potential;
        m_gradient_step = slope;
      }
      number_of_slow_steps = best <= target ? 0 : number_of_slow_steps + 1;
      if(number_of_slow_steps == 0)
        target = 0.5 * best;
      if(!(best > max_residual) || number_of_slow_steps > max_slow_steps)
        return;
      const Vector step = m_solver.solve(residual);
      const double product = residual.dot(step);
      direction = step + product / previous_product * direction;
      previous_product = product;
      const double curvature = direction.dot(multiply(direction, slope));
      if(!(product > 0. && curvature > 0.))
        return;
      potential += product / curvature * direction;
    }
  }

  // Computes the changes ds and dz with W^-1 ds + W dz = d, where m_target = W^-1 d. Returns the
  // longest steps that stay in the cone.
  Steps find_step()
  {
    Field correction(m_dual.size());
    for(std::size_t f = 0; f < m_dual.size(); ++f)
      correction[f] = m_target[f].vector + m_dual[f].vector;
    Vector rhs = minus_divergence(m_operators, correction) + masses();
    for(const Exit_slack& slack : m_slacks)
      rhs[slack.vertex] += slack.rhs_contribution();
    solve(rhs);
    double primal_inverse = 1., dual_inverse = 1.;
    for(Exit_slack& slack : m_slacks)
    {
      slack.find_step(m_potential_step[slack.vertex]);
      primal_inverse = std::max(primal_inverse, slack.inverse_primal_step());
      dual_inverse = std::max(dual_inverse, slack.inverse_dual_step());
    }
    for(std::size_t f = 0; f < m_dual.size(); ++f)
    {
      m_dual_step[f] = m_target[f] + (-1.) * m_scaling[f].apply_inverse_squared(m_gradient_step[f]);
      primal_inverse =
          std::max(primal_inverse, inverse_max_step(primal(f), {0., m_gradient_step[f]}));
      dual_inverse = std::max(dual_inverse, inverse_max_step(m_dual[f], m_dual_step[f]));
    }
    // A price couples x and the potential in one equation, which needs equal steps to stay
    // satisfied.
    if(std::any_of(m_slacks.begin(), m_slacks.end(),
                   [](const Exit_slack& slack) { return slack.price > 0.; }))
      primal_inverse = dual_inverse = std::max(primal_inverse, dual_inverse);
    return {1. / primal_inverse, 1. / dual_inverse};
  }

  // Computes the predictor, d = -W z, which leads to the optimum if the equations are linear.
  Steps predict()
  {
    for(std::size_t f = 0; f < m_dual.size(); ++f)
      m_target[f] = -1. * m_dual[f];
    for(Exit_slack& slack : m_slacks)
      slack.predict();
    return find_step();
  }

  // Adds a correction to the right-hand side and solves again. If x is the product of W^-1 s and
  // W z that the current change reaches with the given steps, the new one reaches x +
  // correction(x), to first order.
  template <typename Change>
  Steps adjust(const Steps& steps, const Change& correction)
  {
    for(std::size_t f = 0; f < m_dual.size(); ++f)
    {
      const Scaling& scaling = m_scaling[f];
      const Cone_vector s =
          m_scaled_dual[f] + steps.primal * scaling.apply_inverse({0., m_gradient_step[f]});
      const Cone_vector z = m_scaled_dual[f] + steps.dual * scaling.apply(m_dual_step[f]);
      m_target[f] = m_target[f] + scaling.apply_inverse(jordan_quotient(
                                      correction(jordan_product(s, z)), m_scaled_dual[f]));
    }
    const auto correction_of_slack = [&](double product) {
      return m_exit_weight * correction(Cone_vector{product / m_exit_weight, {0., 0.}}).scalar;
    };
    for(Exit_slack& slack : m_slacks)
      slack.adjust(steps.primal, steps.dual, correction_of_slack);
    return find_step();
  }

  // Computes the corrector, whose target is that all products equal `gap`. The products that
  // remain after a full predictor step are the second-order terms.
  Steps correct(double gap)
  {
    return adjust({1., 1.},
                  [&](const Cone_vector& x) {
                    return Cone_vector{gap - x.scalar, -1. * x.vector};
                  });
  }

  // Computes the centrality corrector (Gondzio 1996): products that would be far from `gap` after
  // steps 0.3 longer than feasible are moved toward it. Keeps the old change if the steps do not
  // become longer.
  Steps correct_centrality(double gap, const Steps& steps)
  {
    const std::vector<Cone_vector> target = m_target;
    const std::vector<Exit_slack> slacks = m_slacks;
    const Steps longer_steps = {std::min(1., steps.primal + 0.3), std::min(1., steps.dual + 0.3)};
    const Steps centered =
        adjust(longer_steps, [&](const Cone_vector& x) { return centrality_correction(gap, x); });
    if(centered.primal + centered.dual > steps.primal + steps.dual)
      return centered;
    m_target = target;
    m_slacks = slacks;
    return find_step();
  }

  // Moves the iterate and updates the bounds. Returns false if the steps are too short for
  // progress.
  bool move(const Steps& steps)
  {
    const double primal_step = std::min(1., 0.95 * steps.primal);
    const double dual_step = std::min(1., 0.95 * steps.dual);
    if(!(primal_step > 1e-6 || dual_step > 1e-6) || !m_potential_step.allFinite())
      return false;
    m_potential += primal_step * m_potential_step;
    for(std::size_t f = 0; f < m_dual.size(); ++f)
    {
      m_gradient[f] = m_gradient[f] + primal_step * m_gradient_step[f];
      m_dual[f] = m_dual[f] + dual_step * m_dual_step[f];
    }
    for(Exit_slack& slack : m_slacks)
      slack.move(primal_step, dual_step);
    update_upper_bound(flow(0.), outflow(0.));
    update_lower_bound(m_potential);
    return true;
  }

  // Returns the flow of z after a step.
  Field flow(double step) const
  {
    Field result(m_dual.size());
    for(std::size_t f = 0; f < result.size(); ++f)
      result[f] = -1. * (m_dual[f].vector + step * m_dual_step[f].vector);
    return result;
  }

  const Operators& m_operators;
  Sparse_matrix m_matrix;
  Sparse_solver m_solver;
  double m_area = 0., m_exit_weight = 0., m_total_weight = 0.;
  std::vector<Exit_slack> m_slacks;
  std::vector<bool> m_has_exits;                    // #components
  Vector m_potential, m_potential_step;             // #vertices
  Field m_gradient, m_gradient_step;                // #triangles: gradient of the potential
  std::vector<Cone_vector> m_dual, m_dual_step;     // #triangles: z
  std::vector<Cone_vector> m_target, m_scaled_dual; // #triangles: W^-1 d, and W z
  std::vector<Scaling> m_scaling;                   // #triangles
  std::vector<Metric_tensor> m_tensor;              // #triangles
};

} // namespace

std::unique_ptr<Transport_iteration> interior_point(const Transport_problem& problem)
{
  return std::make_unique<Interior_point>(problem);
}

} // namespace CGAL::Geodesic_processing::internal
