// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/cone_descent.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Angle sums of flat vertices have round-off errors of this order.
constexpr double flat_angle_tolerance = 1e-12;

// A x cosine + B x sine + constant, as a function of an angle.
struct Sinusoid
{
  double cosine = 0., sine = 0., constant = 0.;

  double operator()(double angle) const
  {
    return cosine * std::cos(angle) + sine * std::sin(angle) + constant;
  }
  void add(const Sinusoid& other, double factor)
  {
    cosine += factor * other.cosine;
    sine += factor * other.sine;
    constant += factor * other.constant;
  }
};

// A change of the sinusoid at an angle.
struct Change
{
  double angle;
  Sinusoid change;
};

// Returns the fan that contains a direction or, because of round-off errors, is closest to it.
std::size_t fan_of(const std::vector<Direction_fan>& fans, double angle)
{
  std::size_t result = 0;
  double smallest_distance = infinity;
  for(std::size_t i = 0; i < fans.size(); ++i)
  {
    const double offset = angle - fans[i].begin;
    const double distance = std::max({0., -offset, offset - fans[i].angle});
    if(distance < smallest_distance)
    {
      smallest_distance = distance;
      result = i;
    }
  }
  return result;
}

// Appends the changes in [0, angle of the fan] by one pull. Elsewhere it contributes its moment.
void append_changes(const Direction_fan& fan, const Direction_pull& pull,
                    std::vector<Change>& changes)
{
  const double offset = pull.angle - fan.begin;
  const double center = fan.is_closed ? offset - fan.angle * std::floor(offset / fan.angle)
                                      : std::clamp(offset, 0., fan.angle);
  const auto add = [&](double image, double begin, double end)
  {
    if(!(begin < end))
      return;
    const Sinusoid change = {-pull.moment * std::cos(image), -pull.moment * std::sin(image),
                             -pull.moment};
    changes.push_back({begin, change});
    changes.push_back({end, {-change.cosine, -change.sine, -change.constant}});
  };
  if(fan.is_closed && fan.angle <= 2. * pi)
  {
    // Both sides meet at the opposite direction, without a gap or an overlap by round-off errors.
    const bool is_first_half = center < 0.5 * fan.angle;
    const double opposite = center + (is_first_half ? 0.5 : -0.5) * fan.angle;
    add(is_first_half ? center : center - fan.angle, 0., opposite);
    add(is_first_half ? center + fan.angle : center, opposite, fan.angle);
    return;
  }
  for(const int turn : {-1, 0, 1})
  {
    if(!fan.is_closed && turn != 0)
      continue;
    const double image = center + turn * fan.angle;
    add(image, std::max(0., image - pi), std::min(fan.angle, image + pi));
  }
}

// Minimizes a sinusoid in an interval.
Cone_descent minimum_in(const Sinusoid& f, double begin, double end)
{
  Cone_descent result = {f(begin), begin};
  if(const double value = f(end); value < result.slope)
    result = {value, end};
  const double lowest = std::atan2(-f.sine, -f.cosine);
  const double angle = lowest + 2. * pi * std::ceil((begin - lowest) / (2. * pi));
  if(angle < end)
    if(const double value = f.constant - std::hypot(f.cosine, f.sine); value < result.slope)
      result = {value, angle};
  return result;
}

} // namespace

bool is_smooth(const std::vector<Direction_fan>& fans)
{
  return fans.size() == 1 && fans[0].is_closed &&
         std::abs(fans[0].angle - 2. * pi) < flat_angle_tolerance;
}

Vec2 sum_of_pulls(const std::vector<Direction_pull>& pulls)
{
  Vec2 result = {0., 0.};
  for(const Direction_pull& pull : pulls)
    result = result + pull.moment * Vec2{std::cos(pull.angle), std::sin(pull.angle)};
  return result;
}

Cone_descent steepest_descent(const std::vector<Direction_fan>& fans,
                              const std::vector<Direction_pull>& pulls)
{
  if(fans.empty())
    return {};
  if(is_smooth(fans))
  {
    const Vec2 sum = sum_of_pulls(pulls);
    return {-norm(sum), std::atan2(sum[1], sum[0])};
  }
  double sum_of_moments = 0.;
  std::vector<std::vector<Change>> changes(fans.size());
  for(const Direction_pull& pull : pulls)
  {
    sum_of_moments += pull.moment;
    const std::size_t i = fan_of(fans, pull.angle);
    append_changes(fans[i], pull, changes[i]);
  }
  Cone_descent result = {infinity, 0.};
  for(std::size_t i = 0; i < fans.size(); ++i)
  {
    std::stable_sort(changes[i].begin(), changes[i].end(),
                     [](const Change& a, const Change& b) { return a.angle < b.angle; });
    changes[i].push_back({fans[i].angle, {}});
    Sinusoid derivative = {0., 0., sum_of_moments};
    double begin = 0.;
    for(const Change& change : changes[i])
    {
      if(begin <= change.angle)
        if(const Cone_descent found = minimum_in(derivative, begin, change.angle);
           found.slope < result.slope)
          result = {found.slope, fans[i].begin + found.angle};
      derivative.add(change.change, 1.);
      begin = change.angle;
    }
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
