// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/Cover.h"

#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

Cover::Cover(const Surface_arrays& triangles, const Homotopy& homotopy, Index triangle)
    : m_triangles(triangles), m_homotopy(homotopy)
{
  add(triangle, {});
}

const std::vector<Index>& Cover::copies(Index triangle) const
{
  static const std::vector<Index> no_copies;
  const auto found = m_copies.find(triangle);
  return found == m_copies.end() ? no_copies : found->second;
}

Cover::Word Cover::word_across(Index h) const
{
  Word result = m_word[h / 3];
  const Word crossing = m_homotopy.word({base(h)});
  if(crossing.empty())
    return result;
  result.insert(result.end(), crossing.begin(), crossing.end());
  return m_homotopy.reduced(result);
}

Index Cover::find(Index triangle, const Word& word) const
{
  for(const Index i : copies(triangle))
    if(m_homotopy.is_equal(m_word[i], word))
      return i;
  return none;
}

Index Cover::copy(Index triangle, const Word& word)
{
  const Index found = find(triangle, word);
  return found == none ? add(triangle, word) : found;
}

Index Cover::add(Index triangle, Word word)
{
  const Index result = size();
  m_triangle.push_back(triangle);
  m_word.push_back(std::move(word));
  m_twin.resize(m_twin.size() + 3, none);
  for(Index h = 3 * result; h < 3 * result + 3; ++h)
  {
    const Index twin = m_triangles.twin[base(h)];
    if(twin == none || copies(twin / 3).empty())
      continue;
    const Index neighbor = find(twin / 3, word_across(h));
    if(neighbor == none)
      continue;
    m_twin[h] = 3 * neighbor + twin % 3;
    m_twin[m_twin[h]] = h;
  }
  m_copies[triangle].push_back(result);
  return result;
}

std::shared_ptr<const Surface_arrays> Cover::arrays(double& factor) const
{
  auto result = std::make_shared<Surface_arrays>();
  result->twin = m_twin;
  for(Index h = 0; h < m_twin.size(); ++h)
    result->length.push_back(m_triangles.length[base(h)]);
  // The longest edge of surface arrays is in [1, 2).
  factor =
      std::ldexp(1., std::ilogb(*std::max_element(result->length.begin(), result->length.end())));
  for(double& length : result->length)
    length /= factor;
  result->scale = m_triangles.scale * factor;
  Index number_of_vertices = 0;
  result->corner.assign(m_twin.size(), none);
  for(Index first = 0; first < m_twin.size(); ++first)
  {
    if(result->corner[first] != none)
      continue;
    Index corner = first;
    for(; corner != none && result->corner[corner] == none;
        corner = next_corner_ccw(*result, corner))
      result->corner[corner] = number_of_vertices;
    if(corner == none)
      for(corner = next_corner_cw(*result, first); corner != none;
          corner = next_corner_cw(*result, corner))
        result->corner[corner] = number_of_vertices;
    ++number_of_vertices;
  }
  // The distance of two points is not longer than a path between any of their copies.
  result->origin = m_triangles.origin;
  result->point.resize(number_of_vertices);
  for(Index corner = 0; corner < m_twin.size(); ++corner)
    result->point[result->corner[corner]] =
        (1. / factor) * m_triangles.point[m_triangles.corner[base(corner)]];
  build_rings(*result, number_of_vertices);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
