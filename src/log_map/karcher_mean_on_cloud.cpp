// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/karcher_mean_on_cloud.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/log_map/Cloud_departure_finder.h>
#include "log_map/Planar_quasi_newton.h"
#include "log_map/mean_iteration.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

constexpr double sufficient_cloud_decrease = 1e-4;
// The fit is not smooth. On a torus, sums of squared lengths change by a fraction of 6e-8 if shots
// start with other directions. Below this fraction, a step must decrease the gradient.
constexpr double cloud_value_noise = 1e-6;
constexpr int max_cloud_halvings = 20;
// The extent of a cloud in its frame is about one.
constexpr double min_cloud_spread = 1e-5;
// The mean of a shortest path is better only if it decreases the objective by this fraction.
constexpr double shortcut_ratio = 1e-6;

// The objective is 1/2 sum w_i d_i^2 with weights of sum one, in the frame of the cloud.
struct Cloud_mean_state
{
  Projection at;
  Vec3 x, y; // the axes
  std::vector<Cloud_departure> departures;
  double value = 0., farthest = 0.;
  Vec2 pull = {0., 0.}; // the negative gradient in the axes
  bool is_shortest = false;
};

class Cloud_mean_descent
{
public:
  Cloud_mean_descent(const Cloud_departure_finder& finder, std::vector<double> weights,
                     const Cloud_mean_options& options)
      : m_finder(finder), m_weights(std::move(weights)), m_options(options)
  {}

  // Returns the mean in the frame of the cloud; its location is not set.
  Cloud_mean operator()(const Projection& start, Projection& end)
  {
    Cloud_mean_state x = start_state(start);
    if(!(x.value < infinity))
      throw Invalid_argument_error(
          "The locations and the initial location are not in one component of the surface.");
    for(;;)
    {
      const bool is_converged =
          norm(x.pull) <= m_options.tolerance * std::max(x.farthest, min_cloud_spread);
      const bool is_last = m_number_of_iterations >= m_options.maximum_number_of_iterations;
      if(is_converged || is_last || !advance(x))
      {
        if(!x.is_shortest && !is_last && take_shortcuts(x))
          continue;
        end = x.at;
        return {{}, x.at.point, 2. * x.value, norm(x.pull), is_converged, m_number_of_iterations};
      }
      ++m_number_of_iterations;
    }
  }

private:
  void check_callback() const
  {
    if(m_options.callback && !m_options.callback(completed_fraction(
                                 m_number_of_iterations, m_options.maximum_number_of_iterations)))
      throw Cancelled();
  }

  Cloud_mean_state start_state(const Projection& at)
  {
    check_callback();
    Cloud_mean_state result;
    result.at = at;
    std::tie(result.x, result.y) = tangent_frame(at.normal);
    result.departures = m_finder(at);
    result.is_shortest = true;
    sum_up(result);
    return result;
  }

  void sum_up(Cloud_mean_state& state) const
  {
    state.value = state.farthest = 0.;
    Vec3 pull = {0., 0., 0.};
    for(std::size_t i = 0; i < m_weights.size(); ++i)
    {
      const Cloud_departure& departure = state.departures[i];
      const double length = departure.is_connected ? norm(departure.vector) : infinity;
      state.value += 0.5 * m_weights[i] * length * length;
      state.farthest = std::max(state.farthest, length);
      pull = pull + m_weights[i] * departure.vector;
    }
    if(const double outward = dot(pull, state.at.conormal); outward > 0.)
      pull = pull - outward * state.at.conormal;
    state.pull = {dot(pull, state.x), dot(pull, state.y)};
  }

  // Replaces the geodesics by shortest paths. Returns true if this decreases the objective.
  bool take_shortcuts(Cloud_mean_state& x)
  {
    check_callback();
    Cloud_mean_state other = x;
    other.departures = m_finder(x.at);
    other.is_shortest = true;
    sum_up(other);
    x.is_shortest = true;
    if(!(other.value < x.value * (1. - shortcut_ratio)))
      return false;
    m_model.reset();
    x = std::move(other);
    return true;
  }

  bool advance(Cloud_mean_state& x)
  {
    if(!m_model.is_identity())
    {
      if(try_step(x, m_model.step(x.pull)))
        return true;
      m_model.reset();
    }
    Vec2 step = x.pull;
    for(int i = 0; i < max_cloud_halvings; ++i, step = 0.5 * step)
      if(try_step(x, step))
        return true;
    return false;
  }

  // Moves if this decreases the objective sufficiently, or the gradient if the decrease is below
  // the errors of the fit.
  bool try_step(Cloud_mean_state& x, Vec2 step)
  {
    check_callback();
    if(const double length = norm(step); length > x.farthest)
      step = (x.farthest / length) * step;
    if(!(norm(step) > 0.))
      return false;
    Cloud_mean_state y;
    Cloud_motion motion;
    y.at = m_finder.move(x.at, step[0] * x.x + step[1] * x.y, motion);
    step = {dot(motion.step, x.x), dot(motion.step, x.y)};
    if(!(norm(step) > 0.))
      return false;
    y.x = motion.transported(x.x);
    y.y = motion.transported(x.y);
    y.departures = m_finder(y.at, x.departures, motion);
    sum_up(y);
    const bool is_lower = y.value <= x.value - sufficient_cloud_decrease * dot(step, x.pull) &&
                          y.value < x.value * (1. - cloud_value_noise);
    const bool is_flatter =
        y.value <= x.value * (1. + cloud_value_noise) && norm(y.pull) < 0.9 * norm(x.pull);
    if(!is_lower && !is_flatter)
      return false;
    m_model.update(step, x.pull - y.pull);
    x = std::move(y);
    return true;
  }

  const Cloud_departure_finder& m_finder;
  const std::vector<double> m_weights; // #locations, with sum one
  const Cloud_mean_options& m_options;
  Planar_quasi_newton m_model; // in the axes of the state
  std::size_t m_number_of_iterations = 0;
};

} // namespace

Cloud_mean karcher_mean_on_cloud(const Cloud_path_finder& finder,
                                 const std::vector<Tangent_location>& locations,
                                 const std::vector<double>& weights, const Tangent_location& start,
                                 const Cloud_mean_options& options)
{
  const Fitted_cloud& fitted = *finder.fitted_cloud();
  const auto& cloud = fitted.cloud();
  const auto& [origin, scale] = cloud.frame;
  const auto inner = [&, scale = scale](const Tangent_location& location) -> Tangent_location
  {
    return {cloud.internal_vertex[location.vertex],
            {location.offset[0] / scale, location.offset[1] / scale}};
  };
  std::vector<Tangent_location> inner_locations;
  for(const Tangent_location& location : locations)
    inner_locations.push_back(inner(location));
  Unit_weights unit = unit_weights(weights);

  const Cloud_departure_finder departures(finder, std::move(inner_locations),
                                          options.number_of_threads);
  Projection end;
  Cloud_mean result = Cloud_mean_descent(departures, std::move(unit.values),
                                         options)(fitted.project(inner(start)), end);
  const Tangent_location location = fitted.location(end);
  result.location = {cloud.caller_vertex[location.vertex],
                     {scale * location.offset[0], scale * location.offset[1]}};
  result.point = origin + scale * result.point;
  result.value *= unit.sum * scale * scale;
  result.gradient_norm *= scale;
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
