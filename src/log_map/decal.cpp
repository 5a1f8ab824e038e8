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

double longest_side_of(const Glued_triangles& t, Index triangle)
{
  return *std::max_element(&t.length[3 * triangle], &t.length[3 * triangle] + 3);
}

// Whether a line across an axis parts a polygon from the rectangle; `reach` is that of the rectangle.
template <std::size_t N>
bool is_apart(const std::array<Planar, N>& polygon, const Planar& axis, double reach)
{
  double low = infinity, high = -infinity;
  for(const Planar& p : polygon)
  {
    low = std::min(low, dot(axis, p));
    high = std::max(high, dot(axis, p));
  }
  return low >= reach || high <= -reach;
}

// Whether a point, a segment or a triangle meets the inside of the rectangle: no line along a side of
// either parts them.
template <std::size_t N>
bool meets(const std::array<Planar, N>& polygon, const Planar& half)
{
  if(is_apart(polygon, {1., 0.}, half[0]) || is_apart(polygon, {0., 1.}, half[1]))
    return false;
  constexpr std::size_t sides = N == 3 ? 3 : N - 1;
  for(std::size_t k = 0; k < sides; ++k)
  {
    const Planar side = polygon[(k + 1) % N] - polygon[k], axis = {-side[1], side[0]};
    if(norm(side) > 0. &&
       is_apart(polygon, axis, std::abs(axis[0]) * half[0] + std::abs(axis[1]) * half[1]))
      return false;
  }
  return true;
}

bool has_image(const Triangle_image& image, Index k) { return std::isfinite(image.corners[k][0]); }

bool is_side_cut(const Glued_triangles& t, const Triangle_image& image, Index k)
{
  return is_cut(t, 3 * image.triangle + k, image.corners[k], image.corners[(k + 1) % 3]);
}

// Makes a triangle that is cut whole: similar to itself, on its longest side that is not cut.  False where it
// has none.
bool make_whole(const Glued_triangles& t, Triangle_image& image)
{
  Index longest = none;
  int cuts = 0;
  for(Index k = 0; k < 3; ++k)
    if(is_side_cut(t, image, k))
      ++cuts;
    else if(longest == none ||
            t.length[3 * image.triangle + k] > t.length[3 * image.triangle + longest])
      longest = k;
  if(cuts == 0)
    return true;
  const double length = longest == none ? 0. : t.length[3 * image.triangle + longest];
  if(!(length > 0.))
    return false;
  const Planar &p = image.corners[longest], &q = image.corners[(longest + 1) % 3];
  image.corners[(longest + 2) % 3] =
      p + turned(apex(t, 3 * image.triangle + longest), (1. / length) * (q - p));
  return true;
}

// Of a triangle without all of its images.
bool may_belong(const Glued_triangles& t, const Triangle_image& image, const Planar& half)
{
  for(Index k = 0; k < 3; ++k)
  {
    const Planar &p = image.corners[k], &q = image.corners[(k + 1) % 3];
    if(has_image(image, k) && meets(std::array<Planar, 1>{p}, half))
      return true;
    if(has_image(image, k) && has_image(image, (k + 1) % 3) && !is_side_cut(t, image, k) &&
       meets(std::array<Planar, 2>{p, q}, half))
      return true;
  }
  return false;
}

} // namespace

double longest_side_around(const Glued_triangles& t, const Location& at)
{
  double result = 0.;
  for(const Index triangle : triangles_at(t, cleaned(t, at)))
    result = std::max(result, longest_side_of(t, triangle));
  return result;
}

Decal_triangles triangles_of_decal(const Glued_triangles& t, const std::vector<Index>& reached,
                                   const std::vector<Planar>& coordinates, const Planar& half)
{
  Decal_triangles result;
  for(const Index site : reached)
    for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
    {
      Triangle_image image = {t.star[i] / 3, {}};
      bool is_first = true /* of its reached corners */, is_reached = true;
      for(Index k = 0; k < 3; ++k)
      {
        const Index corner = t.corner[3 * image.triangle + k];
        image.corners[k] = coordinates[corner];
        is_reached = is_reached && has_image(image, k);
        is_first = is_first && (site <= corner || !has_image(image, k));
      }
      if(!is_first)
        continue;
      if(!is_reached)
      {
        if(may_belong(t, image, half))
          result.longest_side = std::max(result.longest_side, longest_side_of(t, image.triangle));
      }
      else if(make_whole(t, image) && meets(image.corners, half))
        result.inside.push_back(image);
    }
  return result;
}

Rgba over(const Rgba& front, const Rgba& back)
{
  const double behind = back[3] * (1. - front[3]), opacity = front[3] + behind;
  Rgba result = {0., 0., 0., opacity};
  if(opacity > 0.)
    for(std::size_t c = 0; c < 3; ++c)
      result[c] = (front[3] * front[c] + behind * back[c]) / opacity;
  return result;
}

Texture_cells::Texture_cells(std::size_t number_of_triangles, std::size_t segments)
    : m_segments(segments)
{
  constexpr double most_texels = 268435456.;
  if(segments == 0)
    throw Invalid_argument_error("A face of a texture has one texel or more along its sides.");
  const std::size_t cells = std::max<std::size_t>(1, (number_of_triangles + 1) / 2);
  const double size = double(segments) + 5.;
  if(double(cells) * size * size > most_texels)
    throw Invalid_argument_error(
        "The texture has more than 2^28 texels; take fewer for each face.");
  m_columns = std::size_t(std::ceil(std::sqrt(double(cells))));
  m_rows = (cells + m_columns - 1) / m_columns;
}

std::array<Planar, 3> Texture_cells::corners(std::size_t triangle) const
{
  const std::size_t first = first_texel(triangle);
  const Planar texel = {1. / double(width()), 1. / double(height())};
  // Of the middle of a texel of the cell.
  const auto place = [&](std::size_t i, std::size_t j) -> Planar
  {
    return {(double(first % width() + i) + 0.5) * texel[0],
            (double(first / width() + j) + 0.5) * texel[1]};
  };
  const std::size_t n = m_segments;
  if(triangle % 2 == 0)
    return {place(1, 1), place(n + 1, 1), place(1, n + 1)};
  return {place(n + 3, n + 3), place(3, n + 3), place(n + 3, 3)};
}

} // namespace CGAL::Geodesic_processing::internal
