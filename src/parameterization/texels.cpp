// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/texels.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

std::array<double, 3> nearest_barycentric(const std::array<Planar, 3>& image, const Planar& place)
{
  const double area = cross(image[1] - image[0], image[2] - image[0]);
  std::array<double, 3> inside;
  bool is_inside = area > 0.;
  for(std::size_t k = 0; k < 3; ++k)
  {
    inside[k] = cross(image[(k + 1) % 3] - place, image[(k + 2) % 3] - place) / area;
    is_inside = is_inside && inside[k] >= 0.;
  }
  if(is_inside)
    return inside;
  std::array<double, 3> result = {1., 0., 0.};
  double least = infinity;
  for(std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t next = (k + 1) % 3;
    const Planar side = image[next] - image[k];
    const double square = dot(side, side),
                 share =
                     square > 0. ? std::clamp(dot(place - image[k], side) / square, 0., 1.) : 0.;
    const Planar way = image[k] + share * side - place;
    if(const double distance = dot(way, way); distance < least)
    {
      least = distance;
      result = {0., 0., 0.};
      result[k] = 1. - share;
      result[next] = share;
    }
  }
  return result;
}

Texels find_texels(const std::vector<Planar>& coordinates, std::size_t size, double margin)
{
  if(size == 0 || size > 16384)
    throw Invalid_argument_error("A texture has between 1 and 16384 texels along a side.");
  Texels result;
  result.size = size;
  result.triangle.assign(size * size, none);
  result.square.assign(size * size, margin * margin);
  const auto texel = [&](double x) { return std::size_t(std::clamp(x, 0., double(size - 1))); };
  for(Index f = 0; f < coordinates.size() / 3; ++f)
  {
    std::array<Planar, 3> image;
    Planar low = {infinity, infinity}, high = {-infinity, -infinity};
    for(Index k = 0; k < 3; ++k)
    {
      // Middles of texels are where both are integers.
      image[k] = double(size) * coordinates[3 * f + k] - Planar{0.5, 0.5};
      for(std::size_t axis = 0; axis < 2; ++axis)
      {
        low[axis] = std::min(low[axis], image[k][axis] - margin);
        high[axis] = std::max(high[axis], image[k][axis] + margin);
      }
    }
    for(std::size_t j = texel(std::ceil(low[1])); j <= texel(high[1]); ++j)
      for(std::size_t i = texel(std::ceil(low[0])); i <= texel(high[0]); ++i)
      {
        double& best = result.square[j * size + i];
        if(best == 0. && result.triangle[j * size + i] != none)
          continue;
        const Planar place = {double(i), double(j)};
        const auto b = nearest_barycentric(image, place);
        double square = 0.;
        if(!(b[0] > 0. && b[1] > 0. && b[2] > 0.))
        {
          const Planar way = b[0] * image[0] + b[1] * image[1] + b[2] * image[2] - place;
          square = dot(way, way);
        }
        if(square < best || (square == best && result.triangle[j * size + i] == none))
        {
          best = square;
          result.triangle[j * size + i] = f;
        }
      }
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
