// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/Cloud_departure_finder.h>

#include <CGAL/Geodesic_processing/internal/core/parallel.h>
#include <CGAL/Geodesic_processing/internal/paths/trace_on_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The steps of traced geodesics are those of Cloud_tracer.
constexpr double departure_step_ratio = 0.5;
constexpr double min_departure_step = 1e-6;

constexpr int max_shots = 8;
// A miss below this fraction of the length is accepted. If the fit is not smooth, misses of 1e-6
// remain.
constexpr double shot_tolerance = 1e-11;
// A geodesic whose miss is larger does not reach its location.
constexpr double max_miss_ratio = 1e-3;
// Geodesics are shot in blocks of this number.
constexpr std::size_t shots_per_block = 8;

// The normal at the end of a curve with the orientation of that at its beginning.
Vec3 oriented_end_normal(const std::vector<Projection>& points)
{
  double sign = 1.;
  for(std::size_t i = 1; i < points.size(); ++i)
    if(dot(points[i - 1].normal, points[i].normal) < 0.)
      sign = -sign;
  return sign * points.back().normal;
}

Cloud_motion motion_along(const Vec3& step, const Traced_curve& curve)
{
  const Vec3 normal = curve.points.front().normal;
  Cloud_motion result;
  result.step = step;
  const Vec3 tangent = step - dot(step, normal) * normal;
  result.from_x = unit(tangent);
  result.from_y = cross(normal, result.from_x);
  result.to_x = curve.end_direction;
  result.to_y = cross(oriented_end_normal(curve.points), result.to_x);
  return result;
}

} // namespace

Cloud_departure_finder::Cloud_departure_finder(const Cloud_path_finder& finder,
                                               std::vector<Tangent_location> to,
                                               unsigned number_of_threads)
    : m_finder(finder), m_to(std::move(to)), m_number_of_threads(number_of_threads)
{
  for(const Tangent_location& location : m_to)
    m_ends.push_back(fitted_cloud().project(location));
}

double Cloud_departure_finder::max_step(Index vertex) const
{
  return std::max(min_departure_step,
                  departure_step_ratio * fitted_cloud().cloud().spacing[vertex]);
}

Projection Cloud_departure_finder::move(const Projection& from, const Vec3& step,
                                        Cloud_motion& motion) const
{
  const Traced_curve curve = trace_on_surface(
      fitted_cloud().surface(), [&](Index v) { return max_step(v); }, from, step, norm(step));
  motion = motion_along(curve.length / norm(step) * step, curve);
  return curve.points.back();
}

// Corrects the vector of a departure until its geodesic ends at a point. Returns false if the miss
// remains too large.
bool Cloud_departure_finder::shoot(const Projection& from, const Projection& to,
                                   Cloud_departure& departure) const
{
  Cloud_departure best = departure;
  double smallest_miss = infinity, previous_offset = 0., previous_turn = 0.;
  for(int i = 0; i < max_shots; ++i)
  {
    const double length = norm(departure.vector);
    const Vec3 miss_of_start = to.point - from.point;
    if(!(length > 0.) || norm(miss_of_start) < shot_tolerance)
    {
      best.vector = miss_of_start - dot(miss_of_start, from.normal) * from.normal;
      smallest_miss = 0.;
      break;
    }
    Cloud_motion motion;
    const Traced_curve curve = trace_on_surface(
        fitted_cloud().surface(), [&](Index v) { return max_step(v); }, from, departure.vector,
        length);
    motion = motion_along(departure.vector, curve);
    const Vec3 miss = to.point - curve.points.back().point;
    const double along = dot(miss, motion.to_x), across = dot(miss, motion.to_y);
    // The change of the direction that the last correction made, and of the offset.
    if(i > 0 && std::abs(previous_turn) > 1e-3 * std::abs(previous_offset))
      if(const double ratio = (previous_offset - across) / previous_turn;
         ratio > 0.2 * departure.spreading && ratio < 5. * departure.spreading)
        departure.spreading = ratio;
    if(norm(miss) < smallest_miss)
    {
      const bool is_last = norm(miss) > 0.5 * smallest_miss || curve.is_cut_by_boundary;
      smallest_miss = norm(miss);
      best = departure;
      best.vector =
          (1. + along / length) * departure.vector + across / departure.spreading * motion.from_y;
      if(is_last || smallest_miss < shot_tolerance * length)
        break;
    }
    else
      break;
    previous_offset = across;
    previous_turn = across / departure.spreading;
    departure.vector = best.vector;
  }
  departure = best;
  departure.is_connected = true;
  return smallest_miss <= max_miss_ratio * norm(best.vector);
}

// Returns departures by the paths of the finder, for some of the locations.
std::vector<Cloud_departure>
Cloud_departure_finder::by_paths(const Projection& from,
                                 const std::vector<std::size_t>& targets) const
{
  const Tangent_location start = fitted_cloud().location(from);
  std::vector<std::pair<Tangent_location, Tangent_location>> pairs;
  for(const std::size_t i : targets)
    pairs.emplace_back(start, m_to[i]);
  const std::vector<Cloud_path> paths = find_paths(m_finder, pairs, m_number_of_threads);
  std::vector<Cloud_departure> result(targets.size());
  for(std::size_t k = 0; k < targets.size(); ++k)
  {
    const std::vector<Projection>& points = paths[k].path.points;
    if(points.empty())
      continue;
    result[k].is_connected = true;
    if(points.size() < 2)
      continue;
    Vec3 chord = points[1].point - points[0].point;
    chord = chord - dot(chord, from.normal) * from.normal;
    if(const double size = norm(chord); size > 0.)
      result[k].vector = paths[k].path.length / size * chord;
  }
  return result;
}

std::vector<Cloud_departure> Cloud_departure_finder::operator()(const Projection& from) const
{
  std::vector<std::size_t> all(m_to.size());
  for(std::size_t i = 0; i < all.size(); ++i)
    all[i] = i;
  std::vector<Cloud_departure> result = by_paths(from, all);
  for_each_block(result.size(), shots_per_block, m_number_of_threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   for(std::size_t i = begin; i < end; ++i)
                     if(result[i].is_connected)
                       if(Cloud_departure shot = result[i]; shoot(from, m_ends[i], shot))
                         result[i] = shot;
                 });
  return result;
}

std::vector<Cloud_departure>
Cloud_departure_finder::operator()(const Projection& from,
                                   const std::vector<Cloud_departure>& before,
                                   const Cloud_motion& motion) const
{
  std::vector<Cloud_departure> result(m_to.size());
  std::vector<char> is_reached(m_to.size(), 0);
  for_each_block(result.size(), shots_per_block, m_number_of_threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   for(std::size_t i = begin; i < end; ++i)
                   {
                     result[i] = before[i];
                     result[i].vector = motion.transported(before[i].vector - motion.step);
                     is_reached[i] = shoot(from, m_ends[i], result[i]);
                   }
                 });
  std::vector<std::size_t> missed;
  for(std::size_t i = 0; i < result.size(); ++i)
    if(!is_reached[i])
      missed.push_back(i);
  const std::vector<Cloud_departure> paths = by_paths(from, missed);
  for(std::size_t k = 0; k < missed.size(); ++k)
    result[missed[k]] = paths[k];
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
