// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/View.h"

#include "readers/vectors.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace program {

namespace {

constexpr double radians_per_degree = 0.017453292519943295;

// Returns the view from a direction: `azimuth` about the up axis from the front, and `elevation`
// above it.
View view_from(std::size_t up_axis, double azimuth, double elevation)
{
  // The front is +z if y is up, and -y if z is up.
  Point up = {0., 0., 0.}, front = {0., 0., 0.};
  up[up_axis] = 1.;
  if(up_axis == 1)
    front[2] = 1.;
  else
    front[1] = -1.;
  const Point right = cross(up, front);
  View view;
  for(std::size_t c = 0; c < 3; ++c)
  {
    const double horizontal = std::cos(azimuth * radians_per_degree) * front[c] +
                              std::sin(azimuth * radians_per_degree) * right[c];
    view.right[c] = std::cos(azimuth * radians_per_degree) * right[c] -
                    std::sin(azimuth * radians_per_degree) * front[c];
    view.back[c] = std::cos(elevation * radians_per_degree) * horizontal +
                   std::sin(elevation * radians_per_degree) * up[c];
  }
  view.up = cross(view.back, view.right);
  view.center = {0., 0., 0.};
  return view;
}

// Visibility from a view, estimated by a coarse depth buffer.
struct Visibility
{
  double area;             // of the silhouette
  double visible_fraction; // of `visible_points` that are not hidden
};

Visibility evaluate_view(const View& view, const std::vector<Point>& samples,
                         const std::vector<Point>& visible_points)
{
  constexpr int size = 80;
  std::vector<double> depth(size * size, -INFINITY);
  const auto pixel = [&](const Point& p)
  {
    const auto to_cell = [](double x)
    { return std::clamp(static_cast<int>((x + 1.8) / 3.6 * size), 0, size - 1); };
    return static_cast<std::size_t>(to_cell(dot(p, view.up)) * size + to_cell(dot(p, view.right)));
  };
  for(const Point& p : samples)
    depth[pixel(p)] = std::max(depth[pixel(p)], dot(p, view.back));
  const auto number_of_covered_pixels =
      std::count_if(depth.begin(), depth.end(), [](double d) { return std::isfinite(d); });
  // Depth tolerance: a pixel's width, larger because the depth varies within a pixel on oblique
  // surfaces.
  constexpr double tolerance = 3. * 3.6 / size;
  const auto number_of_visible = std::count_if(
      visible_points.begin(), visible_points.end(),
      [&](const Point& p) { return dot(p, view.back) > depth[pixel(p)] - tolerance; });
  return {static_cast<double>(number_of_covered_pixels) * 3.6 * 3.6 / (size * size),
          visible_points.empty() ? 0.
                                 : static_cast<double>(number_of_visible) /
                                       static_cast<double>(visible_points.size())};
}

void fit_distance(View& view, const std::vector<Point>& samples, double aspect)
{
  const double slope_up = std::tan(view_angle / 2. * radians_per_degree),
               slope_right = slope_up * aspect;
  // The center of the projection and the distance depend on each other. Both converge in a few
  // iterations.
  view.distance = 1.;
  for(int iteration = 0; iteration < 8; ++iteration)
  {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY},
           required_distance = 1e-3;
    for(const Point& sample : samples)
    {
      const Point p = {sample[0] - view.center[0], sample[1] - view.center[1],
                       sample[2] - view.center[2]};
      const double x = dot(p, view.right), y = dot(p, view.up), z = dot(p, view.back);
      required_distance =
          std::max({required_distance, std::abs(x) / slope_right + z, std::abs(y) / slope_up + z});
      const double depth = std::max(view.distance - z, 1e-3);
      low[0] = std::min(low[0], x / depth);
      high[0] = std::max(high[0], x / depth);
      low[1] = std::min(low[1], y / depth);
      high[1] = std::max(high[1], y / depth);
    }
    if(iteration > 0)
      for(std::size_t c = 0; c < 3; ++c)
        view.center[c] += 0.5 * view.distance *
                          ((low[0] + high[0]) * view.right[c] + (low[1] + high[1]) * view.up[c]);
    view.distance = required_distance;
  }
}

} // namespace

std::vector<Point> sample_points(const std::vector<Point>& points,
                                 const std::vector<std::uint32_t>& corners)
{
  constexpr std::size_t number_of_samples = 60000;
  if(corners.empty())
    return points;
  std::vector<double> cumulative_area(corners.size() / 3);
  double sum = 0.;
  for(std::size_t f = 0; f < cumulative_area.size(); ++f)
  {
    const Point& a = points[corners[3 * f]];
    sum += norm(cross(points[corners[3 * f + 1]] - a, points[corners[3 * f + 2]] - a));
    cumulative_area[f] = sum;
  }
  std::vector<Point> samples;
  std::mt19937 generator(1);
  const auto random = [&generator] { return static_cast<double>(generator()) / 4294967296.; };
  for(std::size_t i = 0; i < number_of_samples && sum > 0.; ++i)
  {
    const auto entry =
        std::upper_bound(cumulative_area.begin(), cumulative_area.end(), random() * sum);
    const std::size_t f = std::min<std::size_t>(
        static_cast<std::size_t>(entry - cumulative_area.begin()), cumulative_area.size() - 1);
    double s = random(), t = random();
    if(s + t > 1.)
    {
      s = 1. - s;
      t = 1. - t;
    }
    const Point& a = points[corners[3 * f]];
    samples.push_back(a + s * (points[corners[3 * f + 1]] - a) +
                      t * (points[corners[3 * f + 2]] - a));
  }
  // Corners are included, because the outermost ones limit the distance of the camera.
  const std::size_t stride = corners.size() / 100000 + 1;
  for(std::size_t i = 0; i < corners.size(); i += stride)
    samples.push_back(points[corners[i]]);
  return samples;
}

View choose_view(const std::vector<Point>& samples, const std::vector<Point>& visible_points,
                 double aspect, const std::vector<Point>& normals)
{
  Point low = samples[0], high = samples[0];
  for(const Point& p : samples)
    for(std::size_t c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], p[c]);
      high[c] = std::max(high[c], p[c]);
    }
  const double extent = std::max(high[0] - low[0], high[1] - low[1]), thickness = high[2] - low[2];
  // A surface that is thin in z is a terrain or a planar figure with z up. Most other models have
  // y up.
  const bool is_flat = thickness < 0.35 * extent;
  const bool is_planar = thickness < 0.02 * extent;

  View best;
  double best_score = -INFINITY;
  for(int step = -6; step < 6; ++step)
  {
    // The view is not exactly from the front: two visible sides show more of the shape than one.
    const double azimuth = is_planar ? 0. : 15. + 30. * step, elevation = is_planar ? 89.9
                                                                          : is_flat ? 40.
                                                                                    : 20.;
    const View view = view_from(is_flat ? 2 : 1, azimuth, elevation);
    const Visibility visibility = evaluate_view(view, samples, visible_points);
    double facing = 0.;
    for(const Point& normal : normals)
      facing += dot(view.back, normal) / static_cast<double>(normals.size());
    const double score = 2. * facing + visibility.area + 2. * visibility.visible_fraction +
                         0.25 * std::cos(azimuth * radians_per_degree) +
                         0.05 * std::sin(azimuth * radians_per_degree);
    if(score > best_score)
    {
      best_score = score;
      best = view;
    }
  }
  fit_distance(best, samples, aspect);
  best.distance *= 1.06; // a margin
  return best;
}

} // namespace program
