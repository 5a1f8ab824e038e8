// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/spatial.h>
#include "core/unfold.h"

#include <cmath>

namespace CGAL::Geodesic_processing::internal {

Location at_site(const Glued_triangles& t, Index site)
{
  Location result;
  if(t.first[site] == t.first[site + 1])
    result.site = site;
  else
  {
    const Index corner = t.star[t.first[site]];
    result.triangle = corner / 3;
    result.barycentric = at_corner(corner);
  }
  return result;
}

Location cleaned(const Glued_triangles& t, const Location& location)
{
  if(location.triangle == none)
    return at_site(t, location.site);
  Location result = location;
  result.site = none;
  double sum = 0.;
  for(double& b : result.barycentric)
  {
    if(!(b > 1e-14))
      b = 0.;
    sum += b;
  }
  // Not for the sake of a rounding: what is clean stays as it is.
  if(const Index corner = corner_of(result); corner != none)
    result.barycentric[corner % 3] = 1.;
  else if(std::abs(sum - 1.) > 4e-16)
    for(double& b : result.barycentric)
      b /= sum;
  return result;
}

Location checked(const Glued_triangles& t, const Location& location)
{
  double sum = 0.;
  for(const double b : location.barycentric)
  {
    if(!(b >= -1e-6))
      throw Invalid_argument_error("A location lies outside of its face.");
    sum += b;
  }
  if(!(std::abs(sum - 1.) <= 1e-6))
    throw Invalid_argument_error("The barycentric coordinates of a location do not sum to one.");
  return cleaned(t, location);
}

Spatial scaled_coordinates(const Glued_triangles& t, const Location& location)
{
  if(location.triangle == none)
    return t.point[location.site];
  const Index* corner = &t.corner[3 * std::size_t(location.triangle)];
  return location.barycentric[0] * t.point[corner[0]] +
         location.barycentric[1] * t.point[corner[1]] +
         location.barycentric[2] * t.point[corner[2]];
}

std::array<double, 3> coordinates(const Glued_triangles& t, const Location& location)
{
  return t.origin + t.scale * scaled_coordinates(t, location);
}

double polyline_length(const Glued_triangles& t, const std::vector<Location>& path)
{
  double length = 0.;
  for(std::size_t i = 1; i < path.size(); ++i)
    length += norm(scaled_coordinates(t, path[i]) - scaled_coordinates(t, path[i - 1]));
  return length;
}

Index corner_of(const Location& location)
{
  if(location.triangle != none)
    for(Index k = 0; k < 3; ++k)
      if(location.barycentric[(k + 1) % 3] == 0. && location.barycentric[(k + 2) % 3] == 0.)
        return 3 * location.triangle + k;
  return none;
}

Index site_of(const Glued_triangles& t, const Location& location)
{
  const Index corner = corner_of(location);
  return corner == none ? location.site : t.corner[corner];
}

Index side_of(const Location& location)
{
  if(location.triangle != none && corner_of(location) == none)
    for(Index k = 0; k < 3; ++k)
      if(location.barycentric[(k + 2) % 3] == 0.)
        return 3 * location.triangle + k;
  return none;
}

std::optional<std::array<double, 3>> seen_from(const Glued_triangles& t, Index triangle,
                                               const Location& location)
{
  if(location.triangle == triangle)
    return location.barycentric;
  const Index site = site_of(t, location);
  if(site != none)
  {
    for(Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
      if(t.corner[corner] == site)
        return at_corner(corner);
    return std::nullopt;
  }
  const Index side = side_of(location);
  if(side != none && !t.twin.empty() && t.twin[side] != none && t.twin[side] / 3 == triangle)
    return on_side(t.twin[side], location.barycentric[side % 3]);
  return std::nullopt;
}

namespace {

std::size_t number_of_holders(const Glued_triangles& t, const Location& location)
{
  const Index site = site_of(t, location);
  if(site != none)
    return t.first[site + 1] - t.first[site];
  return side_of(location) == none ? 1 : 2;
}

} // namespace

std::vector<Index> triangles_at(const Glued_triangles& t, const Location& location)
{
  std::vector<Index> result;
  result.reserve(number_of_holders(t, location));
  if(const Index site = site_of(t, location); site != none)
  {
    for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
      result.push_back(t.star[i] / 3);
    return result;
  }
  result.push_back(location.triangle);
  if(const Index side = side_of(location); side != none && !t.twin.empty() && t.twin[side] != none)
    result.push_back(t.twin[side] / 3);
  return result;
}

Index triangle_at(const Glued_triangles& t, const Location& location)
{
  if(location.triangle != none)
    return location.triangle;
  const Index first = t.first[location.site];
  return first < t.first[location.site + 1] ? t.star[first] / 3 : none;
}

Index common_triangle(const Glued_triangles& t, const Location& p, const Location& q)
{
  if(number_of_holders(t, p) > number_of_holders(t, q))
    return common_triangle(t, q, p);
  const Index site = site_of(t, p);
  if(site != none)
  {
    for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
      if(seen_from(t, t.star[i] / 3, q))
        return t.star[i] / 3;
    return none;
  }
  if(seen_from(t, p.triangle, q))
    return p.triangle;
  const Index side = side_of(p), twin = side == none || t.twin.empty() ? none : t.twin[side];
  return twin != none && seen_from(t, twin / 3, q) ? twin / 3 : none;
}

bool is_same_point(const Glued_triangles& t, const Location& p, const Location& q)
{
  const Index site = site_of(t, p);
  if(site != none || site_of(t, q) != none)
    return site == site_of(t, q);
  const auto seen = seen_from(t, q.triangle, p);
  return seen && *seen == q.barycentric;
}

double path_length(const Glued_triangles& t, const std::vector<Location>& path)
{
  double length = 0.;
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    const Location p = cleaned(t, path[i]), q = cleaned(t, path[i + 1]);
    if(is_same_point(t, p, q))
      continue;
    const Index triangle = common_triangle(t, p, q);
    if(triangle == none)
      throw Invalid_argument_error(
          "Two consecutive locations of a path lie in no common triangle.");
    length +=
        distance_in_triangle(t, triangle, *seen_from(t, triangle, p), *seen_from(t, triangle, q));
  }
  return length;
}

} // namespace CGAL::Geodesic_processing::internal
