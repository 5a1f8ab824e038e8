// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/colors.h"

#include <algorithm>
#include <cmath>

namespace program {

Color viridis(double t)
{
  static constexpr Color map[] = {{0.267, 0.005, 0.329},
                                  {0.230, 0.322, 0.546},
                                  {0.128, 0.567, 0.551},
                                  {0.369, 0.789, 0.383},
                                  {0.993, 0.906, 0.144}};
  const double position = 4. * std::clamp(t, 0., 1.);
  const auto k = static_cast<std::size_t>(std::min(position, 3.));
  Color color;
  for(std::size_t c = 0; c < 3; ++c)
    color[c] = map[k][c] + (position - static_cast<double>(k)) * (map[k + 1][c] - map[k][c]);
  return color;
}

Color color_of_label(long long label)
{
  if(label < 0)
    return gray;
  // Hues at multiples of the golden ratio stay well separated for any number of labels. Saturation
  // and value alternate, so that similar hues still differ in color.
  const double hue = 6. * std::fmod(0.08 + 0.6180339887498949 * static_cast<double>(label), 1.);
  const double value = label % 3 == 2 ? 0.72 : 0.93, saturation = label % 2 == 1 ? 0.45 : 0.65;
  Color color;
  static constexpr double shift[] = {5., 3., 1.};
  for(std::size_t c = 0; c < 3; ++c)
  {
    const double k = std::fmod(shift[c] + hue, 6.);
    color[c] = value * (1. - saturation * std::clamp(std::min(k, 4. - k), 0., 1.));
  }
  return color;
}

std::vector<Color> colors_of(const std::vector<double>& values, double low, double high)
{
  std::vector<Color> colors(values.size(), gray);
  for(std::size_t i = 0; i < values.size(); ++i)
    if(std::isfinite(values[i]))
      colors[i] = viridis(high > low ? (values[i] - low) / (high - low) : 0.);
  return colors;
}

std::vector<Color> colors_of(const std::vector<double>& values)
{
  double low = INFINITY, high = -INFINITY;
  for(const double x : values)
    if(std::isfinite(x))
    {
      low = std::min(low, x);
      high = std::max(high, x);
    }
  return colors_of(values, low, high);
}

} // namespace program
