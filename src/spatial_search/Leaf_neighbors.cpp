// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/spatial_search/Leaf_neighbors.h>

#include <CGAL/Geodesic_processing/internal/core/spatial.h>
#include "numerics/wide.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL::Geodesic_processing::internal {

namespace {

// More would take longer to go through than the tree does.
constexpr std::size_t most_around = 768, most_kept = 160;

constexpr std::size_t at_once = 4;

struct Places
{
  const double *x, *y, *z;
  std::size_t size;
};

// Appends the places and squared distances of those within a bound.
template <typename Pack>
GEODESIC_PROCESSING_INLINE std::size_t keep_near(const Places& places, const Kd_tree::Point& from,
                                                 double bound, double* distance, Index* kept)
{
  constexpr std::size_t lanes = sizeof(Pack) / sizeof(double);
  std::size_t number = 0;
  for(std::size_t i = 0; i < places.size; i += lanes)
  {
    Pack u, v, w;
    load(places.x + i, u);
    load(places.y + i, v);
    load(places.z + i, w);
    u -= from[0];
    v -= from[1];
    w -= from[2];
    double square[lanes];
    store(u * u + v * v + w * w, square);
    for(std::size_t j = 0; j < lanes; ++j)
    {
      distance[number] = square[j];
      kept[number] = Index(i + j);
      number += square[j] <= bound ? 1 : 0;
    }
  }
  return number;
}

// How many are smaller than each.
template <typename Pack>
GEODESIC_PROCESSING_INLINE void rank(const double* value, std::size_t size, std::int64_t* result)
{
  constexpr std::size_t lanes = sizeof(Pack) / sizeof(double);
  for(std::size_t i = 0; i < size; i += at_once)
  {
    decltype(Pack() < Pack()) smaller[at_once] = {};
    for(std::size_t j = 0; j < size; j += lanes)
    {
      Pack other;
      load(value + j, other);
      for(std::size_t k = 0; k < at_once; ++k)
        smaller[k] += other < value[i + k];
    }
    for(std::size_t k = 0; k < at_once; ++k)
    {
      std::int64_t part[lanes];
      store(smaller[k], part);
      result[i + k] = 0;
      for(std::size_t j = 0; j < lanes; ++j)
        result[i + k] -= part[j]; // what is true is -1
    }
  }
}

std::size_t keep_near_narrow(const Places& places, const Kd_tree::Point& from, double bound,
                             double* distance, Index* kept)
{
  return keep_near<Narrow<double>>(places, from, bound, distance, kept);
}
GEODESIC_PROCESSING_FOR_WIDE_UNFUSED
std::size_t keep_near_wide(const Places& places, const Kd_tree::Point& from, double bound,
                           double* distance, Index* kept)
{
  return keep_near<Wide<double>>(places, from, bound, distance, kept);
}
void rank_narrow(const double* value, std::size_t size, std::int64_t* result)
{
  rank<Narrow<double>>(value, size, result);
}
GEODESIC_PROCESSING_FOR_WIDE_UNFUSED
void rank_wide(const double* value, std::size_t size, std::int64_t* result)
{
  rank<Wide<double>>(value, size, result);
}

const auto quickest_keep_near = has_wide_instructions() ? keep_near_wide : keep_near_narrow;
const auto quickest_rank = has_wide_instructions() ? rank_wide : rank_narrow;

} // namespace

void Leaf_neighbors::Gathered::clear()
{
  x.clear();
  y.clear();
  z.clear();
  place.clear();
}

void Leaf_neighbors::Gathered::append(const std::vector<Kd_tree::Point>& points,
                                      std::pair<Index, Index> range)
{
  for(Index i = range.first; i < range.second; ++i)
  {
    x.push_back(points[i][0]);
    y.push_back(points[i][1]);
    z.push_back(points[i][2]);
    place.push_back(i);
  }
}

// To a multiple of what is treated at once, by points that are near to none.
void Leaf_neighbors::Gathered::fill_up()
{
  while(x.size() % at_once != 0)
    for(std::vector<double>* coordinates : {&x, &y, &z})
      coordinates->push_back(infinity);
}

Leaf_neighbors::Leaf_neighbors(const std::vector<Kd_tree::Point>& points, const Kd_tree& tree,
                               std::size_t k)
    : m_points(points), m_tree(tree), m_size(std::min(k, tree.size()))
{}

const std::vector<Kd_tree::Neighbor>& Leaf_neighbors::find(Index first, Index last)
{
  std::int64_t rank[most_kept + at_once];
  double bound[64];
  const std::size_t n = last - first;
  m_kept.resize(most_around + 2 * at_once);
  m_kept_place.resize(most_around + 2 * at_once);
  const auto keep = [&](Index i, double bound)
  {
    const Places places = {m_around.x.data(), m_around.y.data(), m_around.z.data(),
                           m_around.x.size()};
    const std::size_t kept =
        quickest_keep_near(places, m_points[i], bound, m_kept.data(), m_kept_place.data());
    std::fill_n(m_kept.begin() + kept, at_once, infinity);
    if(kept <= most_kept)
      quickest_rank(m_kept.data(), kept, rank);
    return kept;
  };

  // Among enough points there are as many as that within this distance of each.
  m_around.clear();
  const auto family = m_tree.ancestor(first, m_size + m_size / 4);
  bool is_even = family.second - family.first <= most_kept && n <= 64;
  if(is_even)
  {
    m_around.append(m_points, family);
    m_around.fill_up();
  }
  double farthest = 0.;
  for(std::size_t i = 0; is_even && i < n; ++i)
  {
    const std::size_t kept = keep(first + Index(i), std::numeric_limits<double>::max());
    // The largest one with a rank below the number: as many are not larger.
    bound[i] = 0.;
    for(std::size_t j = 0; j < kept; ++j)
      bound[i] = std::max(bound[i], rank[j] < std::int64_t(m_size) ? m_kept[j] : 0.);
    farthest = std::max(farthest, bound[i]);
  }
  if(is_even)
  {
    is_even = m_tree.leaves_near(m_points, first, last, farthest, most_around, m_leaves);
    m_around.clear();
    for(const auto& leaf : m_leaves)
      m_around.append(m_points, leaf);
    m_around.fill_up();
  }
  m_rows.resize(n * m_size);
  Neighbor* row = m_rows.data();
  for(std::size_t i = 0; i < n; ++i, row += m_size)
  {
    const std::size_t kept = is_even ? keep(first + Index(i), bound[i]) : most_kept + 1;
    if(kept > most_kept)
    {
      // As many were found around the point before: none of ours is farther than they.
      double limit = i == 0 ? infinity : 0.;
      for(std::size_t j = 0; i > 0 && j < m_size; ++j)
      {
        const Spatial way = m_points[(row - m_size)[j].point] - m_points[first + i];
        limit = std::max(limit, dot(way, way));
      }
      m_tree.nearest(m_points, m_points[first + i], m_size, m_row, limit);
      std::copy(m_row.begin(), m_row.end(), row);
      continue;
    }
    // Of equal ones the first gets the first place.
    m_is_taken.assign(m_size, 0);
    for(std::size_t j = 0; j < kept; ++j)
    {
      std::size_t k = std::size_t(rank[j]);
      while(k < m_size && m_is_taken[k])
        ++k;
      if(k >= m_size)
        continue;
      m_is_taken[k] = 1;
      row[k] = {m_kept[j], m_around.place[m_kept_place[j]]};
    }
  }
  return m_rows;
}

} // namespace CGAL::Geodesic_processing::internal
