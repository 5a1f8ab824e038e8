// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/View.h"

#include <algorithm>
#include <cmath>

namespace program {

namespace {

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point cross(const Point& a, const Point& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

constexpr double radians = 0.017453292519943295;

// The camera turns by `azimuth` about the up axis from the front and rises by `elevation`.
View view_from(std::size_t up_axis, double azimuth, double elevation)
{
  // With y up the front is +z, with z up it is -y.
  Point up = {0., 0., 0.}, front = {0., 0., 0.};
  up[up_axis] = 1.;
  if(up_axis == 1)
    front[2] = 1.;
  else
    front[1] = -1.;
  const Point side = cross(up, front);
  View view;
  for(std::size_t c = 0; c < 3; ++c)
  {
    const double level =
        std::cos(azimuth * radians) * front[c] + std::sin(azimuth * radians) * side[c];
    view.right[c] = std::cos(azimuth * radians) * side[c] - std::sin(azimuth * radians) * front[c];
    view.back[c] = std::cos(elevation * radians) * level + std::sin(elevation * radians) * up[c];
  }
  view.up = cross(view.back, view.right);
  view.center = {0., 0., 0.};
  return view;
}

// What is seen from a view: a coarse picture of depths.
struct Seen
{
  double area;  // of the outline
  double share; // of the places that nothing hides
};

Seen look(const View& view, const std::vector<Point>& samples, const std::vector<Point>& places)
{
  constexpr int size = 80;
  std::vector<double> depth(size * size, -INFINITY);
  const auto pixel = [&](const Point& p)
  {
    const auto place = [](double x)
    { return std::clamp(static_cast<int>((x + 1.8) / 3.6 * size), 0, size - 1); };
    return static_cast<std::size_t>(place(dot(p, view.up)) * size + place(dot(p, view.right)));
  };
  for(const Point& p : samples)
    depth[pixel(p)] = std::max(depth[pixel(p)], dot(p, view.back));
  const auto filled =
      std::count_if(depth.begin(), depth.end(), [](double d) { return std::isfinite(d); });
  // A pixel is as deep as wide, and a surface seen obliquely is deeper.
  constexpr double tolerance = 3. * 3.6 / size;
  const auto seen = std::count_if(places.begin(), places.end(),
                                  [&](const Point& p)
                                  { return dot(p, view.back) > depth[pixel(p)] - tolerance; });
  return {static_cast<double>(filled) * 3.6 * 3.6 / (size * size),
          places.empty() ? 0. : static_cast<double>(seen) / static_cast<double>(places.size())};
}

void fit(View& view, const std::vector<Point>& samples, double aspect)
{
  const double slope_up = std::tan(view_angle / 2. * radians), slope_right = slope_up * aspect;
  // The middle of what is seen depends on the distance, and that on the middle: after a few rounds
  // both stand still.
  view.distance = 1.;
  for(int round = 0; round < 8; ++round)
  {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY}, needed = 1e-3;
    for(const Point& sample : samples)
    {
      const Point p = {sample[0] - view.center[0], sample[1] - view.center[1],
                       sample[2] - view.center[2]};
      const double x = dot(p, view.right), y = dot(p, view.up), z = dot(p, view.back);
      needed = std::max({needed, std::abs(x) / slope_right + z, std::abs(y) / slope_up + z});
      const double depth = std::max(view.distance - z, 1e-3);
      low[0] = std::min(low[0], x / depth);
      high[0] = std::max(high[0], x / depth);
      low[1] = std::min(low[1], y / depth);
      high[1] = std::max(high[1], y / depth);
    }
    if(round > 0)
      for(std::size_t c = 0; c < 3; ++c)
        view.center[c] += 0.5 * view.distance *
                          ((low[0] + high[0]) * view.right[c] + (low[1] + high[1]) * view.up[c]);
    view.distance = needed;
  }
}

} // namespace

View choose_view(const std::vector<Point>& samples, const std::vector<Point>& places, double aspect,
                 const std::vector<Point>& normals)
{
  Point low = samples[0], high = samples[0];
  for(const Point& p : samples)
    for(std::size_t c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], p[c]);
      high[c] = std::max(high[c], p[c]);
    }
  const double wide = std::max(high[0] - low[0], high[1] - low[1]), thick = high[2] - low[2];
  // What lies flat in x and y is a landscape or a plane figure; most other models have y up.
  const bool flat = thick < 0.35 * wide;
  const bool plane = thick < 0.02 * wide;

  View best;
  double best_score = -INFINITY;
  for(int step = -6; step < 6; ++step)
  {
    // Not straight from the front: two sides show more of a shape than one.
    const double azimuth = plane ? 0. : 15. + 30. * step, elevation = plane  ? 89.9
                                                                      : flat ? 40.
                                                                             : 20.;
    const View view = view_from(flat ? 2 : 1, azimuth, elevation);
    const Seen seen = look(view, samples, places);
    double towards = 0.;
    for(const Point& normal : normals)
      towards += dot(view.back, normal) / static_cast<double>(normals.size());
    const double score = 2. * towards + seen.area + 2. * seen.share +
                         0.25 * std::cos(azimuth * radians) + 0.05 * std::sin(azimuth * radians);
    if(score > best_score)
    {
      best_score = score;
      best = view;
    }
  }
  fit(best, samples, aspect);
  best.distance *= 1.06; // a margin
  return best;
}

} // namespace program
