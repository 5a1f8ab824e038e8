// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/path_energy.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/paths/path_curve.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Removes the component of a vector along a direction.
Vec3 project_out(const Vec3& unit_direction, const Vec3& p)
{
  return p - dot(p, unit_direction) * unit_direction;
}

double inner_product(const std::vector<Vec3>& p, const std::vector<Vec3>& q)
{
  double sum = 0.;
  for(std::size_t i = 0; i < p.size(); ++i)
    sum += dot(p[i], q[i]);
  return sum;
}

// The LDL^T factorization of the Hessian of the energy's first sum with respect to the inner nodes,
// with `shift` added to its diagonal.
class Tridiagonal_factorization
{
public:
  Tridiagonal_factorization(const std::vector<double>& relative_length, double shift)
      : m_off_diagonal(relative_length.size() + 1, 0.),
        m_inverse_pivot(relative_length.size() + 1, 0.)
  {
    for(std::size_t i = 1; i < relative_length.size(); ++i)
    {
      m_off_diagonal[i] = 2. / relative_length[i];
      m_inverse_pivot[i] =
          1. /
          (2. / relative_length[i - 1] + 2. / relative_length[i] + shift -
           (i > 1 ? m_off_diagonal[i - 1] * m_off_diagonal[i - 1] * m_inverse_pivot[i - 1] : 0.));
    }
  }
  void solve(std::vector<Vec3>& x) const
  {
    const std::size_t n = x.size();
    for(std::size_t i = 2; i + 1 < n; ++i)
      x[i] = x[i] + m_off_diagonal[i - 1] * m_inverse_pivot[i - 1] * x[i - 1];
    for(std::size_t i = n - 2; i > 0; --i)
      x[i] = m_inverse_pivot[i] * (i + 2 < n ? x[i] + m_off_diagonal[i] * x[i + 1] : x[i]);
  }

private:
  std::vector<double> m_off_diagonal,
      m_inverse_pivot; // #nodes: the negated off-diagonal entries; the reciprocals of the pivots
};

class Energy_minimizer
{
public:
  Energy_minimizer(const Path_surface& surface, const Path_options& options,
                   const std::vector<double>& relative_length, std::vector<Projection>& path)
      : m_surface(surface), m_options(options), m_relative_length(relative_length), m_path(path),
        m_mean_length(polyline_length(path) / double(path.size() - 1)),
        m_tangential_preconditioner(relative_length, 0.),
        m_normal_preconditioner(relative_length, 2. * (options.alpha + options.beta))
  {
    for(const Projection& projection : path)
      m_current.points.push_back(projection.point);
    m_current.projections = path;
    if(m_options.constraint == Path_constraint::energy)
      m_current.midpoint_projections.assign(path.begin(), path.end() - 1);
    evaluate_energy(m_current);
  }

  Path_energy_level operator()()
  {
    Path_energy_level level = {m_path.size() - 2, 0, m_current.energy.value, 0.};
    std::vector<Vec3> gradient = m_current.energy.gradient, step = preconditioned(gradient),
                      direction;
    double previous_product = inner_product(gradient, step), last_decrease = infinity;
    for(const Vec3& s : step)
      direction.push_back(-1. * s);
    while(level.number_of_iterations < m_options.max_iterations)
    {
      const double slope = inner_product(m_current.energy.gradient, direction);
      if(!(-slope > 0.1 * m_options.tolerance * m_current.energy.value))
        break;
      const double previous_energy = m_current.energy.value;
      const bool is_line_search_successful = line_search(direction, slope);
      if(!is_line_search_successful && !gauss_seidel_sweep())
        break;
      ++level.number_of_iterations;
      const double decrease = previous_energy - m_current.energy.value;
      if(std::max(decrease, last_decrease) < m_options.tolerance * previous_energy)
        break;
      last_decrease = decrease;
      // Polak-Ribiere, restarted if the factor is negative.
      const std::vector<Vec3> preconditioned_gradient = preconditioned(m_current.energy.gradient);
      const double current_product =
          inner_product(m_current.energy.gradient, preconditioned_gradient);
      const double beta =
          is_line_search_successful
              ? std::max(0., (current_product - inner_product(gradient, preconditioned_gradient)) /
                                 previous_product)
              : 0.;
      for(std::size_t i = 0; i < direction.size(); ++i)
        direction[i] = tangential(i, beta * direction[i]) - preconditioned_gradient[i];
      if(!(inner_product(m_current.energy.gradient, direction) < -0.01 * current_product))
        for(std::size_t i = 0; i < direction.size(); ++i)
          direction[i] = -1. * preconditioned_gradient[i];
      gradient = m_current.energy.gradient;
      previous_product = current_product;
    }
    level.last_energy = m_current.energy.value;
    for(std::size_t i = 0; i < m_path.size(); ++i)
    {
      m_path[i] = m_current.projections[i];
      m_path[i].point = m_current.points[i];
    }
    return level;
  }

private:
  void evaluate_energy(Path_state& state) const
  {
    internal::evaluate_energy(m_surface, m_options, m_relative_length, m_mean_length, state);
  }

  // Returns the component of a step along which a node can move: for projected nodes, the
  // tangential component.
  Vec3 tangential(std::size_t i, Vec3 step) const
  {
    if(m_options.constraint == Path_constraint::energy)
      return step;
    const Projection& projection = m_current.projections[i];
    step = project_out(projection.normal, step);
    // If descent leads beyond the surface's boundary, the node can only slide along it.
    if(dot(m_current.energy.gradient[i], projection.conormal) < 0.)
      step = project_out(projection.conormal, step);
    return step;
  }

  // Applies the preconditioner to a gradient.
  std::vector<Vec3> preconditioned(const std::vector<Vec3>& gradient) const
  {
    std::vector<Vec3> step = gradient;
    if(m_options.constraint == Path_constraint::projected)
    {
      for(std::size_t i = 0; i < step.size(); ++i)
        step[i] = tangential(i, step[i]);
      m_tangential_preconditioner.solve(step);
      for(std::size_t i = 0; i < step.size(); ++i)
        step[i] = tangential(i, step[i]);
      return step;
    }
    // The squared distances contribute to the Hessian in the normal direction only.
    std::vector<Vec3> normal_components(step.size());
    for(std::size_t i = 0; i < step.size(); ++i)
    {
      const Vec3& normal = m_current.projections[i].normal;
      normal_components[i] = dot(step[i], normal) * normal;
      step[i] = step[i] - normal_components[i];
    }
    m_tangential_preconditioner.solve(step);
    m_normal_preconditioner.solve(normal_components);
    for(std::size_t i = 0; i < step.size(); ++i)
    {
      const Vec3& normal = m_current.projections[i].normal;
      step[i] = project_out(normal, step[i]) + dot(normal_components[i], normal) * normal;
    }
    return step;
  }

  // Sets a state to the current path plus a step.
  void take_step(const std::vector<Vec3>& direction, double step_length, Path_state& state) const
  {
    state.points = m_current.points;
    state.projections = m_current.projections;
    state.midpoint_projections = m_current.midpoint_projections;
    for(std::size_t i = 1; i + 1 < direction.size(); ++i)
      state.points[i] = state.points[i] + step_length * direction[i];
    evaluate_energy(state);
  }

  // Decreases the energy along a direction. Returns false if no trial step does. The first trial
  // is the full step: on a plane, the preconditioner is the exact Hessian.
  bool line_search(const std::vector<Vec3>& direction, double slope)
  {
    constexpr double sufficient_decrease = 1e-4; // fraction of the linear prediction (Armijo)
    double step_length = 1.;
    const double initial_energy = m_current.energy.value;
    for(int i = 0; i < 12; ++i)
    {
      take_step(direction, step_length, m_trial);
      const double increase = m_trial.energy.value - initial_energy;
      // The minimum of the parabola through both energies with the initial slope.
      const double parabola_minimum =
          -0.5 * slope * step_length * step_length / (increase - slope * step_length);
      if(increase <= sufficient_decrease * step_length * slope)
      {
        if(parabola_minimum > 0. && parabola_minimum < 4. * step_length &&
           std::abs(parabola_minimum - step_length) > 0.2 * step_length)
        {
          take_step(direction, parabola_minimum, m_second_trial);
          if(m_second_trial.energy.value < m_trial.energy.value)
            std::swap(m_second_trial, m_trial);
        }
        std::swap(m_current, m_trial);
        return true;
      }
      step_length = std::clamp(parabola_minimum, 0.1 * step_length, 0.5 * step_length);
    }
    return false;
  }

  // Moves one projected node after another to the minimum between its neighbors. Returns false if
  // the energy does not decrease. Projections are discontinuous at sharp edges and at inconsistent
  // surfels. There, one node can make every common step fail, although most nodes could move.
  bool gauss_seidel_sweep()
  {
    if(m_options.constraint == Path_constraint::energy)
      return false;
    m_trial = m_current;
    std::vector<Vec3>& points = m_trial.points;
    for(int k = 0; k < number_of_sweeps; ++k)
      for(std::size_t i = 1; i + 1 < points.size(); ++i)
      {
        const double weight_before = 1. / m_relative_length[i - 1],
                     weight_after = 1. / m_relative_length[i];
        const auto energy = [&](const Vec3& p)
        {
          const Vec3 to_point = p - points[i - 1], from_point = points[i + 1] - p;
          return weight_before * dot(to_point, to_point) +
                 weight_after * dot(from_point, from_point);
        };
        const Projection projection =
            m_surface.project(1. / (weight_before + weight_after) *
                                  (weight_before * points[i - 1] + weight_after * points[i + 1]),
                              m_trial.projections[i].vertex);
        if(energy(projection.point) < energy(points[i]))
        {
          points[i] = projection.point;
          m_trial.projections[i] = projection;
        }
      }
    evaluate_energy(m_trial);
    if(!(m_trial.energy.value < m_current.energy.value))
      return false;
    std::swap(m_current, m_trial);
    return true;
  }

  static constexpr int number_of_sweeps = 4;

  const Path_surface& m_surface;
  const Path_options& m_options;
  const std::vector<double>& m_relative_length;
  std::vector<Projection>& m_path;
  double m_mean_length;
  Tridiagonal_factorization m_tangential_preconditioner, m_normal_preconditioner;
  Path_state m_current, m_trial, m_second_trial;
};

// Returns the point of a polyline at a given length along it.
Projection point_at_length(const std::vector<Projection>& chain,
                           const std::vector<double>& cumulative_length, double length)
{
  const std::size_t i = std::clamp<std::size_t>(
      std::lower_bound(cumulative_length.begin(), cumulative_length.end(), length) -
          cumulative_length.begin(),
      1, cumulative_length.size() - 1);
  const double segment_length = cumulative_length[i] - cumulative_length[i - 1];
  const double fraction =
      segment_length > 0. ? (length - cumulative_length[i - 1]) / segment_length : 0.;
  Projection projection = chain[fraction < 0.5 ? i - 1 : i];
  projection.point = chain[i - 1].point + fraction * (chain[i].point - chain[i - 1].point);
  return projection;
}

// Returns the length of a polyline up to each of its points.
std::vector<double> cumulative_lengths(const std::vector<Projection>& chain)
{
  std::vector<double> cumulative_length = {0.};
  for(std::size_t i = 0; i + 1 < chain.size(); ++i)
    cumulative_length.push_back(cumulative_length.back() +
                                norm(chain[i + 1].point - chain[i].point));
  return cumulative_length;
}

// Returns evenly spaced points of a polyline, projected to the surface. The endpoints are kept.
std::vector<Projection> resample(const Path_surface& surface, const std::vector<Projection>& chain,
                                 std::size_t number_of_nodes)
{
  const std::vector<double> cumulative_length = cumulative_lengths(chain);
  std::vector<Projection> result = {chain.front()};
  for(std::size_t i = 1; i + 1 < number_of_nodes; ++i)
  {
    const Projection sample =
        point_at_length(chain, cumulative_length,
                        cumulative_length.back() * double(i) / double(number_of_nodes - 1));
    result.push_back(surface.project(sample.point, sample.vertex));
  }
  result.push_back(chain.back());
  return result;
}

// Returns the maximum distance between a polyline and its resampling with fewer nodes, divided by
// the spacing of these nodes.
double relative_deviation(const std::vector<Projection>& chain, std::size_t number_of_nodes)
{
  const std::vector<double> cumulative_length = cumulative_lengths(chain);
  const double spacing = cumulative_length.back() / double(number_of_nodes - 1);
  double max_deviation = 0.;
  Vec3 from = chain.front().point, to = from;
  std::size_t next = 0;
  for(std::size_t i = 0; i < chain.size(); ++i)
  {
    while(next + 1 < number_of_nodes && cumulative_length[i] >= spacing * double(next))
    {
      ++next;
      from = to;
      to = point_at_length(chain, cumulative_length, spacing * double(next)).point;
    }
    const Vec3 offset = chain[i].point - from, segment = to - from;
    const double square = dot(segment, segment);
    const double fraction = square > 0. ? std::clamp(dot(offset, segment) / square, 0., 1.) : 0.;
    max_deviation = std::max(max_deviation, norm(offset - fraction * segment));
  }
  return spacing > 0. ? max_deviation / spacing : 0.;
}

// The minimum tolerance of all levels but the finest: a level ends if the energy decreases by less
// than this fraction.
constexpr double coarse_level_tolerance = 1e-6;

// The maximum number of times that segments off the surface are halved.
constexpr int max_segment_refinements = 4;

// Halves the segments whose midpoint is farther from the surface, or from its boundary, than a
// twentieth of the segment's length. Returns false if there are no such segments.
bool refine_segments(const Path_surface& surface, std::vector<double>& relative_length,
                     std::vector<Projection>& path)
{
  std::vector<Projection> result = {path.front()};
  std::vector<double> new_relative_length;
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    const Vec3 midpoint = 0.5 * (path[i].point + path[i + 1].point);
    const Projection projection = surface.project(midpoint, path[i].vertex);
    const double length = norm(path[i + 1].point - path[i].point);
    if(norm(projection.point - midpoint) > 0.05 * length)
    {
      result.push_back(projection);
      new_relative_length.insert(new_relative_length.end(), 2, 0.5 * relative_length[i]);
    }
    else
      new_relative_length.push_back(relative_length[i]);
    result.push_back(path[i + 1]);
  }
  const bool is_changed = result.size() > path.size();
  path = std::move(result);
  relative_length = std::move(new_relative_length);
  return is_changed;
}

} // namespace

void evaluate_energy(const Path_surface& surface, const Path_options& options,
                     const std::vector<double>& relative_length, double mean_length,
                     Path_state& state)
{
  auto& [points, projections, midpoint_projections, energy] = state;
  const std::size_t n = points.size();
  const bool is_energy_constrained = options.constraint == Path_constraint::energy;
  energy.value = 0.;
  energy.gradient.assign(n, {0., 0., 0.});
  for(std::size_t i = 1; i + 1 < n; ++i)
  {
    projections[i] = surface.project(points[i], projections[i].vertex);
    if(!is_energy_constrained)
    {
      points[i] = projections[i].point;
      continue;
    }
    const Vec3 offset = points[i] - projections[i].point;
    energy.value += options.alpha * dot(offset, offset);
    energy.gradient[i] = 2. * options.alpha * offset;
  }
  const double beta = options.beta * mean_length * mean_length;
  for(std::size_t i = 0; i + 1 < n; ++i)
  {
    const Vec3 segment = points[i + 1] - points[i];
    const double square = dot(segment, segment);
    energy.value += square / relative_length[i];
    Vec3 segment_gradient = 2. / relative_length[i] * segment; // derivative with respect to s_i
    if(is_energy_constrained && beta > 0. && square > 0.)
    {
      const Vec3 midpoint = 0.5 * (points[i] + points[i + 1]);
      midpoint_projections[i] = surface.project(midpoint, midpoint_projections[i].vertex);
      const Vec3 offset = midpoint - midpoint_projections[i].point;
      const double term = beta * dot(offset, offset) / square;
      energy.value += term;
      segment_gradient = segment_gradient - 2. * term / square * segment;
      // Half of the derivative with respect to the midpoint: each endpoint moves it by half.
      const Vec3 midpoint_gradient = beta / square * offset;
      energy.gradient[i] = energy.gradient[i] + midpoint_gradient;
      energy.gradient[i + 1] = energy.gradient[i + 1] + midpoint_gradient;
    }
    energy.gradient[i] = energy.gradient[i] - segment_gradient;
    energy.gradient[i + 1] = energy.gradient[i + 1] + segment_gradient;
  }
  energy.gradient.front() = energy.gradient.back() = {0., 0., 0.};
}

Path_energy_level minimize_energy(const Path_surface& surface, const Path_options& options,
                                  const std::vector<double>& relative_length,
                                  std::vector<Projection>& path)
{
  if(path.size() < 3)
    return {};
  return Energy_minimizer(surface, options, relative_length, path)();
}

void fit_curve(const Path_surface& surface, const std::vector<Projection>& nodes,
               Shortened_path& path)
{
  path.points = subdivide_curve(surface, subdivide_curve(surface, insert_sharp_edges(nodes)));
  for(std::size_t i = 1; i + 1 < path.points.size(); ++i)
    path.points[i].point = surface.clamped_to_coverage(path.points[i].point, path.points[i].vertex);
  path.length = curve_length(path.points);
  path.polyline_length = polyline_length(path.points);
}

namespace {

// A surface given by its squared distance function, whose gradient at p is 2 (p - q) for the
// closest point q. The gradient is computed by central differences.
class Squared_distance_surface : public Path_surface
{
public:
  Squared_distance_surface(const std::function<double(const Vec3&)>& squared_distance, double step)
      : m_squared_distance(squared_distance), m_step(step)
  {}

  Projection project(const Vec3& point, Index near) const override
  {
    Projection projection;
    projection.vertex = near;
    Vec3 half_gradient;
    for(int k = 0; k < 3; ++k)
    {
      Vec3 point_ahead = point, point_behind = point;
      point_ahead[k] += m_step;
      point_behind[k] -= m_step;
      half_gradient[k] = (m_squared_distance(point_ahead) - m_squared_distance(point_behind)) /
                         (2. * (point_ahead[k] - point_behind[k]));
      if(!std::isfinite(half_gradient[k]))
        throw Invalid_argument_error("A squared distance is not finite.");
    }
    projection.point = point - half_gradient;
    projection.normal = unit(half_gradient);
    return projection;
  }

private:
  const std::function<double(const Vec3&)>& m_squared_distance;
  double m_step;
};

} // namespace

Shortened_path shorten_path(const std::function<double(const Vec3&)>& squared_distance,
                            Path_options options, const std::vector<Vec3>& chain)
{
  if(chain.size() < 2)
    throw Invalid_argument_error("The polyline has fewer than two points.");
  std::vector<Projection> projections(chain.size());
  double length = 0.;
  for(std::size_t i = 0; i < chain.size(); ++i)
  {
    projections[i].point = chain[i];
    if(i > 0)
      length += norm(chain[i] - chain[i - 1]);
    if(!std::isfinite(length) || !std::isfinite(norm(chain[i])))
      throw Invalid_argument_error("A point of the polyline is not finite.");
  }
  options.constraint = Path_constraint::energy;
  // The step of the differences is a hundredth of a segment. On a plane, only round-off errors
  // remain; on a curved surface, the error is below a hundredth of the sagitta.
  const Squared_distance_surface surface(
      squared_distance, 0.01 * length / double(options.number_of_control_points + 1));
  return shorten_path(surface, options, projections);
}

Shortened_path shorten_path(const Path_surface& surface, const Path_options& options,
                            const std::vector<Projection>& chain)
{
  Shortened_path result;
  const double length = polyline_length(chain);
  if(!(length > 0.))
  {
    result.points = {chain.front()};
    return result;
  }
  std::size_t max_nodes = options.number_of_control_points + 2;
  if(options.min_spacing > 0.)
    max_nodes = std::min<std::size_t>(max_nodes,
                                      std::size_t(std::min(length / options.min_spacing, 1e9)) + 9);
  // Each level has half of the segments of the next. The coarsest level must still approximate
  // the chain to a tenth of its spacing.
  std::size_t number_of_nodes = max_nodes;
  while(number_of_nodes > 16 && relative_deviation(chain, (number_of_nodes + 1) / 2) < 0.1)
    number_of_nodes = (number_of_nodes + 1) / 2;
  std::vector<Projection> path = resample(surface, chain, number_of_nodes);
  std::vector<double> relative_length(number_of_nodes - 1, 1.);
  while(true)
  {
    Path_options level_options = options;
    if(number_of_nodes < max_nodes)
      level_options.tolerance = std::max(options.tolerance, coarse_level_tolerance);
    result.levels.push_back(minimize_energy(surface, level_options, relative_length, path));
    if(number_of_nodes >= max_nodes)
      break;
    path = subdivide_curve(surface, path);
    number_of_nodes = std::min(2 * number_of_nodes - 1, max_nodes);
    path = resample(surface, path, number_of_nodes);
    relative_length.assign(number_of_nodes - 1, 1.);
  }
  if(!options.do_fit_curve)
  {
    result.number_of_control_points = path.size() - 2;
    result.length = result.polyline_length = polyline_length(path);
    result.points = std::move(path);
    return result;
  }
  for(int i = 0; i < max_segment_refinements && refine_segments(surface, relative_length, path);
      ++i)
    result.levels.push_back(minimize_energy(surface, options, relative_length, path));
  result.number_of_control_points = path.size() - 2;
  if(options.constraint == Path_constraint::energy)
    for(std::size_t i = 1; i + 1 < path.size(); ++i)
      path[i] = surface.project(path[i].point, path[i].vertex);
  fit_curve(surface, path, result);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
