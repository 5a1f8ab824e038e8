// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/karcher_mean.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include <CGAL/Geodesic_processing/internal/distances/Departure_finder.h>
#include <CGAL/Geodesic_processing/internal/log_map/Polar_frame.h>
#include <CGAL/Geodesic_processing/internal/log_map/coarse_mean.h>
#include <CGAL/Geodesic_processing/internal/log_map/cone_descent.h>
#include "core/unfold.h"
#include "log_map/Planar_quasi_newton.h"
#include "log_map/mean_iteration.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The part of the predicted decrease that a step must attain (Armijo).
constexpr double sufficient_decrease = 1e-4;
// Changes of the objective below this fraction are round-off errors. There, a step must decrease
// the gradient.
constexpr double value_round_off = 1e-14;
constexpr int max_halvings = 40;
// If the locations are close to each other, the tolerance does not become smaller than that for
// locations at this fraction of the extent of the mesh.
constexpr double min_spread_ratio = 1e-5;
// A vertex whose angle exceeds a flat one by less than this cannot hold a minimum.
constexpr double kink_tolerance = 1e-8;

double extent(const Surface_arrays& t)
{
  if(t.point.empty())
    return 1.;
  Vec3 lowest = t.point.front(), highest = lowest;
  for(const Vec3& p : t.point)
    for(int k = 0; k < 3; ++k)
    {
      lowest[k] = std::min(lowest[k], p[k]);
      highest[k] = std::max(highest[k], p[k]);
    }
  return norm(highest - lowest);
}

// Returns whether the sum can have a minimum at a vertex. At other vertices, the mean derivative
// over all directions is negative.
bool can_hold_minimum(const std::vector<Direction_fan>& fans)
{
  return fans.size() != 1 || fans[0].angle > (fans[0].is_closed ? 2. : 1.) * pi + kink_tolerance;
}

// The objective is 1/2 sum w_i d_i^2 with weights of sum one.
struct Mean_state
{
  Polar_frame frame;
  double value;
  double farthest; // the maximum distance of the locations
  Cone_descent descent;
  bool is_smooth;
  Vec2 pull; // the negative gradient if the point is smooth

  double gradient_norm() const { return std::max(0., -descent.slope); }
};

class Mean_descent
{
public:
  Mean_descent(Departure_finder& finder, std::vector<double> weights, const Mean_options& options)
      : t(*finder.triangles()), m_finder(finder), m_weights(std::move(weights)), m_options(options),
        m_min_spread(min_spread_ratio * extent(t))
  {}

  Mean_location operator()(const Surface_location& start)
  {
    Mean_state x = evaluate(start);
    if(!(x.value < infinity))
      throw Invalid_argument_error(
          "The locations and the initial location are not in one component of the surface.");
    for(;; ++m_number_of_iterations)
    {
      const bool is_converged =
          x.gradient_norm() <= m_options.tolerance * std::max(x.farthest, m_min_spread);
      if(is_converged || m_number_of_iterations >= m_options.maximum_number_of_iterations ||
         !advance(x))
        return {x.frame.location(), 2. * x.value, x.gradient_norm(), is_converged,
                m_number_of_iterations};
    }
  }

private:
  struct Move
  {
    Mean_state state;
    Straightest_path path;
    double start_angle = 0.;
    bool is_full = false; // whether the first step was sufficient
  };

  Mean_state evaluate(const Surface_location& location)
  {
    const auto callback = [&](double)
    {
      return m_options.callback(
          completed_fraction(m_number_of_iterations, m_options.maximum_number_of_iterations));
    };
    Mean_state result = {Polar_frame(t, location), 0., 0., {}, false, {0., 0.}};
    const auto departures =
        m_finder(result.frame.location(),
                 m_options.callback ? std::function<bool(double)>(callback) : nullptr);
    std::vector<Direction_pull> pulls;
    for(std::size_t i = 0; i < departures.size(); ++i)
    {
      const auto& [length, angle] = departures[i];
      result.value += 0.5 * m_weights[i] * length * length;
      result.farthest = std::max(result.farthest, length);
      pulls.push_back({angle, m_weights[i] * length});
    }
    result.is_smooth = is_smooth(result.frame.fans()) && result.frame.vertex() == none;
    result.descent = steepest_descent(result.frame.fans(), pulls);
    if(result.is_smooth)
      result.pull = sum_of_pulls(pulls);
    return result;
  }

  // Moves to a point with a smaller sum. Returns false if none is found.
  bool advance(Mean_state& x)
  {
    std::optional<Move> move = search(x);
    const double unit_step = x.gradient_norm();
    if(!move || !move->is_full || move->state.gradient_norm() > 0.5 * unit_step)
    {
      std::optional<Mean_state> kink = best_kink(x, unit_step);
      if(move && move->state.frame.vertex() == none)
        if(std::optional<Mean_state> other = best_kink(move->state, unit_step);
           other && (!kink || other->value < kink->value))
          kink = std::move(other);
      if(kink && kink->value < (move ? move->state.value : x.value))
      {
        m_model.reset();
        x = std::move(*kink);
        return true;
      }
    }
    if(!move)
      return false;
    update_model(x, *move);
    x = std::move(move->state);
    return true;
  }

  std::optional<Move> search(const Mean_state& x)
  {
    if(x.is_smooth && !m_model.is_identity())
    {
      const Vec2 step = m_model.step(x.pull);
      const double length = norm(step);
      if(std::optional<Move> move =
             try_step(x, std::atan2(step[1], step[0]), std::min(length, x.farthest),
                      -dot(step, x.pull) / length))
        return move;
      m_model.reset();
    }
    double length = x.gradient_norm();
    for(int i = 0; i < max_halvings; ++i, length /= 2.)
      if(std::optional<Move> move = try_step(x, x.descent.angle, length, x.descent.slope))
      {
        move->is_full = i == 0;
        return move;
      }
    return std::nullopt;
  }

  // Returns a step if it decreases the sum sufficiently, or the gradient if the decrease is below
  // round-off errors.
  std::optional<Move> try_step(const Mean_state& x, double angle, double length, double slope)
  {
    Straightest_path path = x.frame.path(angle, length);
    if(!(path.length > 0.))
      return std::nullopt;
    Mean_state y = evaluate(path.locations.back());
    const bool is_lower = y.value <= x.value + sufficient_decrease * slope * path.length;
    const bool is_flatter =
        y.value <= x.value * (1. + value_round_off) && y.gradient_norm() < 0.9 * x.gradient_norm();
    if(!is_lower && !is_flatter)
      return std::nullopt;
    return Move{std::move(y), std::move(path), angle, true};
  }

  // Returns the best of the vertices that may hold a minimum, among those of the location's
  // triangle that are closer than a distance and were not tried before.
  std::optional<Mean_state> best_kink(const Mean_state& x, double max_distance)
  {
    std::optional<Mean_state> result;
    const Surface_location& at = x.frame.location();
    if(at.triangle == none)
      return result;
    for(Index corner = 3 * at.triangle; corner < 3 * at.triangle + 3; ++corner)
    {
      const Index vertex = t.corner[corner];
      if(vertex == x.frame.vertex() ||
         distance_in_triangle(t, at.triangle, barycentric_at_corner(corner), at.barycentric) >
             max_distance ||
         !can_hold_minimum(Polar_frame(t, vertex_location(t, vertex)).fans()) ||
         !m_tried_vertices.insert(vertex).second)
        continue;
      Mean_state state = evaluate(vertex_location(t, vertex));
      if(!result || state.value < result->value)
        result = std::move(state);
    }
    return result;
  }

  void update_model(const Mean_state& x, const Move& move)
  {
    const Mean_state& y = move.state;
    if(!x.is_smooth || !y.is_smooth)
      return m_model.reset();
    const double end_angle = y.frame.polar_angle(move.path.angle),
                 turn = end_angle - move.start_angle;
    const Vec2 rotation = {std::cos(turn), std::sin(turn)};
    m_model.rotate(rotation);
    m_model.update(move.path.length * Vec2{std::cos(end_angle), std::sin(end_angle)},
                   rotated(x.pull, rotation) - y.pull);
  }

  const Surface_arrays& t;
  Departure_finder& m_finder;
  const std::vector<double> m_weights; // #locations, with sum one
  const Mean_options& m_options;
  const double m_min_spread;
  Planar_quasi_newton m_model; // in the polar frame of the present location
  std::set<Index> m_tried_vertices;
  std::size_t m_number_of_iterations = 0;
};

} // namespace

Mean_location karcher_mean(const std::shared_ptr<const Surface_arrays>& triangles,
                           const std::vector<Surface_location>& locations,
                           const std::vector<double>& weights, const Mean_options& options)
{
  std::vector<Surface_location> canonical_locations;
  for(const Surface_location& location : locations)
    canonical_locations.push_back(canonical(*triangles, location));
  Unit_weights unit = unit_weights(weights);
  const Surface_location start =
      options.initial_location
          ? *options.initial_location
          : coarse_mean(triangles, canonical_locations, unit.values, options.callback);
  Departure_finder finder(triangles, std::move(canonical_locations));
  Mean_location result = Mean_descent(finder, std::move(unit.values), options)(start);
  result.value *= unit.sum;
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
