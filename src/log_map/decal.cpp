// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/decal.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/log_map/log_map.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns the length of the longest edge of a triangle.
double longest_edge_of(const Surface_arrays& t, Index triangle)
{
  return *std::max_element(&t.length[3 * triangle], &t.length[3 * triangle] + 3);
}

// Returns whether the projections of a polygon and of the rectangle to an axis are disjoint.
//
// extent  the rectangle projects to [-extent, extent]
template <std::size_t N>
bool is_separated(const std::array<Vec2, N>& polygon, const Vec2& axis, double extent)
{
  double low = infinity, high = -infinity;
  for(const Vec2& p : polygon)
  {
    low = std::min(low, dot(axis, p));
    high = std::max(high, dot(axis, p));
  }
  return low >= extent || high <= -extent;
}

// Returns whether a point, a segment or a triangle intersects the interior of the rectangle
// (separating axis theorem).
template <std::size_t N>
bool intersects(const std::array<Vec2, N>& polygon, const Vec2& half_size)
{
  if(is_separated(polygon, {1., 0.}, half_size[0]) || is_separated(polygon, {0., 1.}, half_size[1]))
    return false;
  constexpr std::size_t number_of_edges = N == 3 ? 3 : N - 1;
  for(std::size_t k = 0; k < number_of_edges; ++k)
  {
    const Vec2 edge = polygon[(k + 1) % N] - polygon[k], axis = {-edge[1], edge[0]};
    if(norm(edge) > 0. &&
       is_separated(polygon, axis,
                    std::abs(axis[0]) * half_size[0] + std::abs(axis[1]) * half_size[1]))
      return false;
  }
  return true;
}

bool has_image(const Triangle_image& image, Index k) { return std::isfinite(image.corners[k][0]); }

bool is_edge_cut(const Surface_arrays& t, const Triangle_image& image, Index k)
{
  return is_cut(t, 3 * image.triangle + k, image.corners[k], image.corners[(k + 1) % 3]);
}

// Replaces the image of a cut triangle. The new one is similar to the triangle and attached to its
// longest edge that is not cut. Returns false if all edges are cut.
bool complete_image(const Surface_arrays& t, Triangle_image& image)
{
  Index longest = none;
  int number_of_cuts = 0;
  for(Index k = 0; k < 3; ++k)
    if(is_edge_cut(t, image, k))
      ++number_of_cuts;
    else if(longest == none ||
            t.length[3 * image.triangle + k] > t.length[3 * image.triangle + longest])
      longest = k;
  if(number_of_cuts == 0)
    return true;
  const double length = longest == none ? 0. : t.length[3 * image.triangle + longest];
  if(!(length > 0.))
    return false;
  const Vec2 &p = image.corners[longest], &q = image.corners[(longest + 1) % 3];
  image.corners[(longest + 2) % 3] =
      p + rotated(apex(t, 3 * image.triangle + longest), (1. / length) * (q - p));
  return true;
}

// Returns whether a known corner or edge of an incomplete image intersects the rectangle.
bool may_intersect(const Surface_arrays& t, const Triangle_image& image, const Vec2& half_size)
{
  for(Index k = 0; k < 3; ++k)
  {
    const Vec2 &p = image.corners[k], &q = image.corners[(k + 1) % 3];
    if(has_image(image, k) && intersects(std::array<Vec2, 1>{p}, half_size))
      return true;
    if(has_image(image, k) && has_image(image, (k + 1) % 3) && !is_edge_cut(t, image, k) &&
       intersects(std::array<Vec2, 2>{p, q}, half_size))
      return true;
  }
  return false;
}

} // namespace

double longest_edge_at(const Surface_arrays& t, const Surface_location& location)
{
  double result = 0.;
  for(const Index triangle : triangles_at(t, canonical(t, location)))
    result = std::max(result, longest_edge_of(t, triangle));
  return result;
}

Decal_triangles find_decal_triangles(const Surface_arrays& t, const std::vector<Index>& reached,
                                     const std::vector<Vec2>& coordinates, const Vec2& half_size)
{
  Decal_triangles result;
  for(const Index v : reached)
    for(Index i = t.ring_begin[v]; i < t.ring_begin[v + 1]; ++i)
    {
      Triangle_image image = {t.ring[i] / 3, {}};
      // Each triangle is processed at the first of its reached corners only.
      bool is_first = true, is_reached = true;
      for(Index k = 0; k < 3; ++k)
      {
        const Index corner = t.corner[3 * image.triangle + k];
        image.corners[k] = coordinates[corner];
        is_reached = is_reached && has_image(image, k);
        is_first = is_first && (v <= corner || !has_image(image, k));
      }
      if(!is_first)
        continue;
      if(!is_reached)
      {
        if(may_intersect(t, image, half_size))
          result.longest_edge = std::max(result.longest_edge, longest_edge_of(t, image.triangle));
      }
      else if(complete_image(t, image) && intersects(image.corners, half_size))
        result.covered.push_back(image);
    }
  return result;
}

Rgba blend_over(const Rgba& front, const Rgba& back)
{
  const double back_weight = back[3] * (1. - front[3]), opacity = front[3] + back_weight;
  Rgba result = {0., 0., 0., opacity};
  if(opacity > 0.)
    for(std::size_t c = 0; c < 3; ++c)
      result[c] = (front[3] * front[c] + back_weight * back[c]) / opacity;
  return result;
}

Texture_cells::Texture_cells(std::size_t number_of_triangles, std::size_t segments)
    : m_segments(segments)
{
  constexpr double max_number_of_texels = 268435456.;
  if(segments == 0)
    throw Invalid_argument_error("The number of texels per edge must be positive.");
  const std::size_t cells = std::max<std::size_t>(1, (number_of_triangles + 1) / 2);
  const double size = double(segments) + 5.;
  if(double(cells) * size * size > max_number_of_texels)
    throw Invalid_argument_error(
        "The texture would have more than 2^28 texels: use fewer texels per edge.");
  m_columns = std::size_t(std::ceil(std::sqrt(double(cells))));
  m_rows = (cells + m_columns - 1) / m_columns;
}

std::array<Vec2, 3> Texture_cells::corners(std::size_t triangle) const
{
  const std::size_t origin = first_texel(triangle);
  const Vec2 texel = {1. / double(width()), 1. / double(height())};
  // Returns the texture coordinates of the center of texel (i, j) of the cell.
  const auto texel_center = [&](std::size_t i, std::size_t j) -> Vec2
  {
    return {(double(origin % width() + i) + 0.5) * texel[0],
            (double(origin / width() + j) + 0.5) * texel[1]};
  };
  const std::size_t n = m_segments;
  if(triangle % 2 == 0)
    return {texel_center(1, 1), texel_center(n + 1, 1), texel_center(1, n + 1)};
  return {texel_center(n + 3, n + 3), texel_center(3, n + 3), texel_center(n + 3, 3)};
}

} // namespace CGAL::Geodesic_processing::internal
