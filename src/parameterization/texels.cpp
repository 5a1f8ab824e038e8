// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/texels.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

std::array<double, 3> nearest_barycentric(const std::array<Vec2, 3>& image, const Vec2& point)
{
  const double area = cross(image[1] - image[0], image[2] - image[0]);
  std::array<double, 3> barycentric;
  bool is_inside = area > 0.;
  for(std::size_t k = 0; k < 3; ++k)
  {
    barycentric[k] = cross(image[(k + 1) % 3] - point, image[(k + 2) % 3] - point) / area;
    is_inside = is_inside && barycentric[k] >= 0.;
  }
  if(is_inside)
    return barycentric;
  std::array<double, 3> result = {1., 0., 0.};
  double min_distance = infinity;
  for(std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t next = (k + 1) % 3;
    const Vec2 edge = image[next] - image[k];
    const double squared_length = dot(edge, edge),
                 fraction = squared_length > 0.
                                ? std::clamp(dot(point - image[k], edge) / squared_length, 0., 1.)
                                : 0.;
    const Vec2 offset = image[k] + fraction * edge - point;
    if(const double distance = dot(offset, offset); distance < min_distance)
    {
      min_distance = distance;
      result = {0., 0., 0.};
      result[k] = 1. - fraction;
      result[next] = fraction;
    }
  }
  return result;
}

Texel_map rasterize_texels(const std::vector<Vec2>& coordinates, std::size_t size, double margin)
{
  if(size == 0 || size > 16384)
    throw Invalid_argument_error("The size of a texture must be between 1 and 16384 texels.");
  Texel_map result;
  result.size = size;
  result.triangle.assign(size * size, none);
  result.squared_distance.assign(size * size, margin * margin);
  const auto to_texel = [&](double x) { return std::size_t(std::clamp(x, 0., double(size - 1))); };
  for(Index f = 0; f < coordinates.size() / 3; ++f)
  {
    std::array<Vec2, 3> image;
    Vec2 low = {infinity, infinity}, high = {-infinity, -infinity};
    for(Index k = 0; k < 3; ++k)
    {
      // Centers of texels have integer coordinates.
      image[k] = double(size) * coordinates[3 * f + k] - Vec2{0.5, 0.5};
      for(std::size_t axis = 0; axis < 2; ++axis)
      {
        low[axis] = std::min(low[axis], image[k][axis] - margin);
        high[axis] = std::max(high[axis], image[k][axis] + margin);
      }
    }
    for(std::size_t j = to_texel(std::ceil(low[1])); j <= to_texel(high[1]); ++j)
      for(std::size_t i = to_texel(std::ceil(low[0])); i <= to_texel(high[0]); ++i)
      {
        double& best = result.squared_distance[j * size + i];
        if(best == 0. && result.triangle[j * size + i] != none)
          continue;
        const Vec2 point = {double(i), double(j)};
        const auto b = nearest_barycentric(image, point);
        double squared_distance = 0.;
        if(!(b[0] > 0. && b[1] > 0. && b[2] > 0.))
        {
          const Vec2 offset = b[0] * image[0] + b[1] * image[1] + b[2] * image[2] - point;
          squared_distance = dot(offset, offset);
        }
        if(squared_distance < best ||
           (squared_distance == best && result.triangle[j * size + i] == none))
        {
          best = squared_distance;
          result.triangle[j * size + i] = f;
        }
      }
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
