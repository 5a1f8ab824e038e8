// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/spatial_search/Leaf_neighbors.h>

#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include "numerics/simd.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL::Geodesic_processing::internal {

namespace {

// If more points are gathered, or remain within the bound of a point, a query of the tree is
// faster.
constexpr std::size_t max_gathered = 768, max_candidates = 160;

constexpr std::size_t max_leaf_size = 64;

constexpr std::size_t batch_size = 4;

struct Coordinates
{
  const double *x, *y, *z;
  std::size_t size;
};

// Writes the indices and squared distances of all points within the squared distance `bound`, and
// returns their number.
template <typename Pack>
GEODESIC_PROCESSING_INLINE std::size_t filter_near(const Coordinates& coordinate_arrays,
                                                   const Kd_tree::Point& from, double bound,
                                                   double* distance, Index* kept_index)
{
  constexpr std::size_t lanes = sizeof(Pack) / sizeof(double);
  std::size_t number = 0;
  for(std::size_t i = 0; i < coordinate_arrays.size; i += lanes)
  {
    Pack u, v, w;
    load(coordinate_arrays.x + i, u);
    load(coordinate_arrays.y + i, v);
    load(coordinate_arrays.z + i, w);
    u -= from[0];
    v -= from[1];
    w -= from[2];
    double squared_distance[lanes];
    store(u * u + v * v + w * w, squared_distance);
    for(std::size_t j = 0; j < lanes; ++j)
    {
      distance[number] = squared_distance[j];
      kept_index[number] = Index(i + j);
      number += squared_distance[j] <= bound ? 1 : 0;
    }
  }
  return number;
}

// Computes for each value the number of smaller values.
template <typename Pack>
GEODESIC_PROCESSING_INLINE void rank(const double* value, std::size_t size, std::int64_t* result)
{
  constexpr std::size_t lanes = sizeof(Pack) / sizeof(double);
  for(std::size_t i = 0; i < size; i += batch_size)
  {
    decltype(Pack() < Pack()) smaller[batch_size] = {};
    for(std::size_t j = 0; j < size; j += lanes)
    {
      Pack other;
      load(value + j, other);
      for(std::size_t k = 0; k < batch_size; ++k)
        smaller[k] += other < value[i + k];
    }
    for(std::size_t k = 0; k < batch_size; ++k)
    {
      std::int64_t counts[lanes];
      store(smaller[k], counts);
      result[i + k] = 0;
      for(std::size_t j = 0; j < lanes; ++j)
        result[i + k] -= counts[j]; // a comparison that is true yields -1
    }
  }
}

std::size_t filter_near_baseline(const Coordinates& coordinate_arrays, const Kd_tree::Point& from,
                                 double bound, double* distance, Index* kept_index)
{
  return filter_near<Baseline_pack<double>>(coordinate_arrays, from, bound, distance, kept_index);
}
GEODESIC_PROCESSING_TARGET_AVX2
std::size_t filter_near_avx2(const Coordinates& coordinate_arrays, const Kd_tree::Point& from,
                             double bound, double* distance, Index* kept_index)
{
  return filter_near<Avx2_pack<double>>(coordinate_arrays, from, bound, distance, kept_index);
}
void rank_baseline(const double* value, std::size_t size, std::int64_t* result)
{
  rank<Baseline_pack<double>>(value, size, result);
}
GEODESIC_PROCESSING_TARGET_AVX2
void rank_avx2(const double* value, std::size_t size, std::int64_t* result)
{
  rank<Avx2_pack<double>>(value, size, result);
}

const auto dispatched_filter_near = has_avx2() ? filter_near_avx2 : filter_near_baseline;
const auto dispatched_rank = has_avx2() ? rank_avx2 : rank_baseline;

} // namespace

void Leaf_neighbors::Gathered_points::clear()
{
  x.clear();
  y.clear();
  z.clear();
  index.clear();
}

void Leaf_neighbors::Gathered_points::append(const std::vector<Kd_tree::Point>& points,
                                             std::pair<Index, Index> range)
{
  for(Index i = range.first; i < range.second; ++i)
  {
    x.push_back(points[i][0]);
    y.push_back(points[i][1]);
    z.push_back(points[i][2]);
    index.push_back(i);
  }
}

// Pads the coordinates with infinite points to a multiple of the batch size.
void Leaf_neighbors::Gathered_points::pad()
{
  while(x.size() % batch_size != 0)
    for(std::vector<double>* coordinates : {&x, &y, &z})
      coordinates->push_back(infinity);
}

Leaf_neighbors::Leaf_neighbors(const std::vector<Kd_tree::Point>& points, const Kd_tree& tree,
                               std::size_t k)
    : m_points(points), m_tree(tree), m_size(std::min(k, tree.size()))
{}

// Keeps the gathered points within a squared distance of a point. Ranks them by distance, unless
// there are more than `max_candidates`.
std::size_t Leaf_neighbors::filter_and_rank(Index point, double bound, std::int64_t* rank)
{
  const Coordinates coordinate_arrays = {m_gathered.x.data(), m_gathered.y.data(),
                                         m_gathered.z.data(), m_gathered.x.size()};
  const std::size_t number_kept =
      dispatched_filter_near(coordinate_arrays, m_points[point], bound,
                             m_candidate_distances.data(), m_candidate_indices.data());
  std::fill_n(m_candidate_distances.begin() + number_kept, batch_size, infinity);
  if(number_kept <= max_candidates)
    dispatched_rank(m_candidate_distances.data(), number_kept, rank);
  return number_kept;
}

// Gathers all points that can be neighbors of points first .. last - 1, and sets `bound` to an
// upper bound of the squared distance of the last neighbor of each. Returns false if the points
// are too many.
bool Leaf_neighbors::gather(Index first, Index last, double* bound, std::int64_t* rank)
{
  // An ancestor with slightly more than size() points gives the bounds.
  const auto ancestor = m_tree.ancestor(first, m_size + m_size / 4);
  m_gathered.clear();
  if(ancestor.second - ancestor.first > max_candidates || last - first > max_leaf_size)
    return false;
  m_gathered.append(m_points, ancestor);
  m_gathered.pad();
  double farthest = 0.;
  for(Index i = 0; i < last - first; ++i)
  {
    const std::size_t number_kept =
        filter_and_rank(first + i, std::numeric_limits<double>::max(), rank);
    // The largest distance with a rank below size(): at least size() points are not farther.
    bound[i] = 0.;
    for(std::size_t j = 0; j < number_kept; ++j)
      bound[i] = std::max(bound[i], rank[j] < std::int64_t(m_size) ? m_candidate_distances[j] : 0.);
    farthest = std::max(farthest, bound[i]);
  }
  const bool is_complete =
      m_tree.leaves_near(m_points, first, last, farthest, max_gathered, m_leaves);
  m_gathered.clear();
  for(const auto& leaf : m_leaves)
    m_gathered.append(m_points, leaf);
  m_gathered.pad();
  return is_complete;
}

// Writes the neighbors of a point by a query of the tree. `previous`, if not null, is the row of
// another point: the same size() points bound the distance of the last neighbor.
void Leaf_neighbors::find_in_tree(Index point, const Neighbor* previous, Neighbor* row)
{
  double max_squared_distance = previous == nullptr ? infinity : 0.;
  for(std::size_t j = 0; previous != nullptr && j < m_size; ++j)
  {
    const Vec3 offset = m_points[previous[j].point] - m_points[point];
    max_squared_distance = std::max(max_squared_distance, dot(offset, offset));
  }
  m_tree.nearest(m_points, m_points[point], m_size, m_row, max_squared_distance);
  std::copy(m_row.begin(), m_row.end(), row);
}

const std::vector<Kd_tree::Neighbor>& Leaf_neighbors::find(Index first, Index last)
{
  std::int64_t rank[max_candidates + batch_size];
  double bound[max_leaf_size];
  const std::size_t n = last - first;
  m_candidate_distances.resize(max_gathered + 2 * batch_size);
  m_candidate_indices.resize(max_gathered + 2 * batch_size);
  const bool is_gathered = gather(first, last, bound, rank);
  m_rows.resize(n * m_size);
  Neighbor* row = m_rows.data();
  for(std::size_t i = 0; i < n; ++i, row += m_size)
  {
    const std::size_t number_kept =
        is_gathered ? filter_and_rank(first + Index(i), bound[i], rank) : max_candidates + 1;
    if(number_kept > max_candidates)
    {
      find_in_tree(first + Index(i), i == 0 ? nullptr : row - m_size, row);
      continue;
    }
    // Points at equal distances have equal ranks and are sorted by index: the first one takes the
    // first free position.
    m_is_taken.assign(m_size, 0);
    for(std::size_t j = 0; j < number_kept; ++j)
    {
      std::size_t k = std::size_t(rank[j]);
      while(k < m_size && m_is_taken[k])
        ++k;
      if(k >= m_size)
        continue;
      m_is_taken[k] = 1;
      row[k] = {m_candidate_distances[j], m_gathered.index[m_candidate_indices[j]]};
    }
  }
  return m_rows;
}

} // namespace CGAL::Geodesic_processing::internal
