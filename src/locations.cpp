// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/locations.h>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The side whose interior holds a location in a triangle, or none.
Index side_at(const Location& location)
{
  for(Index k = 0; k < 3; ++k)
    if(location.barycentric[k] == 0. && location.barycentric[(k + 1) % 3] != 0. &&
       location.barycentric[(k + 2) % 3] != 0.)
      return 3 * location.triangle + (k + 1) % 3;
  return none;
}

} // namespace

Index site_at(const Glued_triangles& triangles, const Location& location)
{
  if(location.triangle == none)
    return location.site;
  for(Index k = 0; k < 3; ++k)
    if(location.barycentric[(k + 1) % 3] == 0. && location.barycentric[(k + 2) % 3] == 0.)
      return triangles.corner[3 * location.triangle + k];
  return none;
}

std::vector<Index> triangles_at(const Glued_triangles& triangles, const Location& location)
{
  std::vector<Index> result;
  if(const Index site = site_at(triangles, location); site != none)
  {
    for(Index i = triangles.first[site]; i < triangles.first[site + 1]; ++i)
      result.push_back(triangles.star[i] / 3);
    return result;
  }
  result.push_back(location.triangle);
  if(const Index side = side_at(location);
     side != none && !triangles.twin.empty() && triangles.twin[side] != none)
    result.push_back(triangles.twin[side] / 3);
  return result;
}

bool express(const Glued_triangles& triangles, const Location& location, Index triangle,
             Location& result)
{
  if(location.triangle == triangle)
  {
    result = location;
    return true;
  }
  if(const Index site = site_at(triangles, location); site != none)
  {
    for(Index k = 0; k < 3; ++k)
      if(triangles.corner[3 * triangle + k] == site)
      {
        result.triangle = triangle;
        result.barycentric = {0., 0., 0.};
        result.barycentric[k] = 1.;
        return true;
      }
    return false;
  }
  const Index side = side_at(location);
  if(side == none || triangles.twin.empty() || triangles.twin[side] == none ||
     triangles.twin[side] / 3 != triangle)
    return false;
  const Index twin = triangles.twin[side];
  result.triangle = triangle;
  result.barycentric = {0., 0., 0.};
  result.barycentric[twin % 3] = location.barycentric[next_side(side) % 3];
  result.barycentric[next_side(twin) % 3] = location.barycentric[side % 3];
  return true;
}

} // namespace CGAL::Geodesic_processing::internal
