// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/drawings.h"

#include <cmath>
#include <optional>

namespace program {

namespace {

constexpr Colour paper = {0.98, 0.96, 0.88}, ink = {0.10, 0.18, 0.36}, red = {0.86, 0.11, 0.12},
                 sea = {0.30, 0.50, 0.72};

// Of a place from (-1, -1) to (1, 1); nothing outside of the ring.
std::optional<Colour> of_rose(double x, double y)
{
  const double radius = std::hypot(x, y);
  if(radius > 1.)
    return std::nullopt;
  if(radius > 0.94 || (radius > 0.86 && radius < 0.88))
    return ink;
  // Rays a quarter of a turn apart, and shorter ones between them.  A ray is a kite: on either side of
  // its axis a line from its tip to where it leaves the middle.
  const double quarter = std::acos(0.), turn = std::atan2(y, x) / quarter;
  for(const double between : {0., 0.5})
  {
    const double ray = std::round(turn - between) + between, angle = (turn - ray) * quarter;
    const double along = radius * std::cos(angle), across = radius * std::sin(angle);
    const double length = between > 0. ? 0.55 : 0.84;
    if(std::abs(across) / 0.11 + std::abs(along - 0.11) / (length - 0.11) > 1. ||
       (along < 0.11 && std::abs(across) > along))
      continue;
    if(across > 0.)
      return paper;
    return between == 0. && ray == 1. ? red : ink;
  }
  return paper;
}

std::optional<Colour> of_grid(double x, double y)
{
  const int cell = polar_cell(x, y, 20);
  return cell < 0 ? std::nullopt : std::optional<Colour>(cell > 0 ? sea : paper);
}

// A square image; a pixel is the mean of what a function has in it.
template <typename Function>
Image drawn(std::size_t size, Function colour_at)
{
  constexpr std::size_t samples = 4; // along the sides of a pixel
  Image image;
  image.width = image.height = size;
  for(std::size_t row = 0; row < size; ++row)
    for(std::size_t column = 0; column < size; ++column)
    {
      Colour sum = {0., 0., 0.};
      double number = 0.;
      for(std::size_t j = 0; j < samples; ++j)
        for(std::size_t i = 0; i < samples; ++i)
        {
          const auto place = [size](std::size_t pixel, std::size_t sample)
          { return 2. * (double(pixel * samples + sample) + 0.5) / double(size * samples) - 1.; };
          if(const auto colour = colour_at(place(column, i), place(row, j)))
          {
            for(std::size_t c = 0; c < 3; ++c)
              sum[c] += (*colour)[c];
            number += 1.;
          }
        }
      for(double& part : sum)
        part = number > 0. ? part / number : 0.;
      image.pixels.push_back(sum);
      image.opacity.push_back(number / (samples * samples));
    }
  return image;
}

} // namespace

Image compass_rose() { return drawn(256, of_rose); }

Image polar_grid() { return drawn(1024, of_grid); }

int polar_cell(double x, double y, int rings)
{
  const double radius = std::hypot(x, y);
  if(!(radius <= 1.))
    return -1;
  const double turn = std::atan2(y, x) / (2. * std::acos(-1.));
  return (static_cast<int>(radius * rings) + static_cast<int>(std::floor(24. * turn))) & 1;
}

int square_of(const std::array<double, 2>& place)
{
  return (int(std::floor(20. * place[0])) + int(std::floor(20. * place[1]))) & 1;
}

Image checkers()
{
  constexpr std::size_t size = 1000;
  Image result{size, size, {}};
  for(std::size_t i = 0; i < size * size; ++i)
    result.pixels.push_back(
        square_of({(double(i % size) + 0.5) / size, (double(i / size) + 0.5) / size}) != 0
            ? Colour{0.13, 0.33, 0.55}
            : Colour{0.95, 0.94, 0.9});
  return result;
}

} // namespace program
