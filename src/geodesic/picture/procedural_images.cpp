// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/procedural_images.h"

#include <cmath>
#include <optional>

namespace program {

namespace {

constexpr Color paper = {0.98, 0.96, 0.88}, ink = {0.10, 0.18, 0.36}, red = {0.86, 0.11, 0.12},
                sea = {0.30, 0.50, 0.72};

// Returns the color at (x, y) in [-1, 1]^2, or std::nullopt outside of the outer circle.
std::optional<Color> compass_rose_color(double x, double y)
{
  const double radius = std::hypot(x, y);
  if(radius > 1.)
    return std::nullopt;
  if(radius > 0.94 || (radius > 0.86 && radius < 0.88))
    return ink;
  // Long rays at multiples of 90 degrees, and shorter ones between them. Each ray is a kite. On
  // each side of its axis, one edge runs from the tip to the point where the ray leaves the center.
  const double quarter_turn = std::acos(0.), quarter_turns = std::atan2(y, x) / quarter_turn;
  for(const double offset : {0., 0.5})
  {
    const double ray = std::round(quarter_turns - offset) + offset,
                 angle = (quarter_turns - ray) * quarter_turn;
    const double along = radius * std::cos(angle), across = radius * std::sin(angle);
    const double length = offset > 0. ? 0.55 : 0.84;
    if(std::abs(across) / 0.11 + std::abs(along - 0.11) / (length - 0.11) > 1. ||
       (along < 0.11 && std::abs(across) > along))
      continue;
    if(across > 0.)
      return paper;
    return offset == 0. && ray == 1. ? red : ink;
  }
  return paper;
}

std::optional<Color> polar_grid_color(double x, double y)
{
  const int cell = polar_grid_cell(x, y, 20);
  return cell < 0 ? std::nullopt : std::optional<Color>(cell > 0 ? sea : paper);
}

// Returns a square image. Each pixel is the average of 16 samples of color_at; its opacity is the
// fraction of samples with a color.
template <typename Function>
Image rasterize(std::size_t size, Function color_at)
{
  constexpr std::size_t samples_per_side = 4; // along each side of a pixel
  Image image;
  image.width = image.height = size;
  for(std::size_t row = 0; row < size; ++row)
    for(std::size_t column = 0; column < size; ++column)
    {
      Color sum = {0., 0., 0.};
      double count = 0.;
      for(std::size_t j = 0; j < samples_per_side; ++j)
        for(std::size_t i = 0; i < samples_per_side; ++i)
        {
          const auto coordinate = [size](std::size_t pixel, std::size_t sample)
          {
            return 2. * (double(pixel * samples_per_side + sample) + 0.5) /
                       double(size * samples_per_side) -
                   1.;
          };
          if(const auto color = color_at(coordinate(column, i), coordinate(row, j)))
          {
            for(std::size_t c = 0; c < 3; ++c)
              sum[c] += (*color)[c];
            count += 1.;
          }
        }
      for(double& channel : sum)
        channel = count > 0. ? channel / count : 0.;
      image.pixels.push_back(sum);
      image.opacity.push_back(count / (samples_per_side * samples_per_side));
    }
  return image;
}

} // namespace

Image compass_rose() { return rasterize(256, compass_rose_color); }

Image polar_grid() { return rasterize(1024, polar_grid_color); }

int polar_grid_cell(double x, double y, int number_of_rings)
{
  const double radius = std::hypot(x, y);
  if(!(radius <= 1.))
    return -1;
  const double turns = std::atan2(y, x) / (2. * std::acos(-1.));
  return (static_cast<int>(radius * number_of_rings) + static_cast<int>(std::floor(24. * turns))) &
         1;
}

int checkerboard_cell(const std::array<double, 2>& place)
{
  return (int(std::floor(20. * place[0])) + int(std::floor(20. * place[1]))) & 1;
}

Image checkerboard()
{
  constexpr std::size_t size = 1000;
  Image result{size, size, {}};
  for(std::size_t i = 0; i < size * size; ++i)
    result.pixels.push_back(
        checkerboard_cell({(double(i % size) + 0.5) / size, (double(i / size) + 0.5) / size}) != 0
            ? Color{0.13, 0.33, 0.55}
            : Color{0.95, 0.94, 0.9});
  return result;
}

} // namespace program
