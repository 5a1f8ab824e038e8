// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/surfel_neighbors.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include <cstdint>
#include <numeric>
#include <string>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

void check_sizes(std::size_t points, std::size_t normals, std::size_t radii)
{
  if(normals != points || (radii != 0 && radii != points))
    throw Invalid_argument_error("The numbers of points, normals and radii (0 if none are given) "
                                 "must be equal, but are " +
                                 std::to_string(points) + ", " + std::to_string(normals) + " and " +
                                 std::to_string(radii) + ".");
  if(points > none / 128)
    throw Unsupported_surface_error("A cloud can have at most 2^25 surfels.");
}

void normalize(std::vector<Vec3>& normals)
{
  for(std::size_t i = 0; i < normals.size(); ++i)
  {
    Vec3& n = normals[i];
    const double largest = std::max({std::abs(n[0]), std::abs(n[1]), std::abs(n[2])});
    if(!(largest > 0.) || !std::isfinite(n[0]) || !std::isfinite(n[1]) || !std::isfinite(n[2]))
      throw Invalid_argument_error("The normal of surfel " + std::to_string(i) +
                                   " is zero or not finite.");
    const int exponent = std::ilogb(largest);
    for(double& x : n)
      x = std::ldexp(x, -exponent);
    const double length = std::sqrt(dot(n, n));
    for(double& x : n)
      x /= length;
  }
}

namespace {

// Returns for each surfel the first surfel at the same point with a compatible normal, which can be
// itself. Surfels are distributed to buckets by a hash of their points. So the hash table of a
// bucket stays in the cache, and threads process buckets in parallel. O(n) expected.
std::vector<Index> find_originals(const std::vector<Vec3>& points, const std::vector<Vec3>& normals,
                                  double cosine, unsigned number_of_threads)
{
  constexpr std::size_t number_of_buckets = 256;
  // The sum rounds points closer than 2^-51 of the extent to the same key. So squared distances
  // between different originals cannot underflow.
  const auto key = [&](Index i) -> Vec3 {
    return {points[i][0] + 4., points[i][1] + 4., points[i][2] + 4.};
  };
  const std::size_t n = points.size();
  std::vector<std::uint64_t> hash(n);
  for_each_block(n, surfel_block_size, number_of_threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   for(Index i = Index(begin); i < end; ++i)
                     for(const double x : key(i))
                     {
                       hash[i] = (hash[i] ^ static_cast<std::uint64_t>(x * 0x1p50)) *
                                 0x9e3779b97f4a7c15ull;
                       hash[i] ^= hash[i] >> 29;
                     }
                 });
  std::vector<std::size_t> bucket_begin(number_of_buckets + 1, 0);
  for(const std::uint64_t value : hash)
    ++bucket_begin[value % number_of_buckets + 1];
  std::partial_sum(bucket_begin.begin(), bucket_begin.end(), bucket_begin.begin());
  std::vector<Index> bucketed(n), original(n);
  std::vector<std::size_t> bucket_end = bucket_begin;
  for(Index i = 0; i < n; ++i)
    bucketed[bucket_end[hash[i] % number_of_buckets]++] = i;

  for_each_block(number_of_buckets, 1, number_of_threads,
                 [&](std::size_t bucket, std::size_t, std::size_t)
                 {
                   std::size_t slots = 16;
                   while(slots < 2 * (bucket_begin[bucket + 1] - bucket_begin[bucket]))
                     slots *= 2;
                   std::vector<Index> table(slots, none);
                   for(std::size_t k = bucket_begin[bucket]; k < bucket_begin[bucket + 1]; ++k)
                   {
                     const Index i = bucketed[k];
                     const auto is_same = [&](Index j) {
                       return hash[j] == hash[i] && key(j) == key(i) &&
                              dot(normals[j], normals[i]) > cosine;
                     };
                     std::size_t slot = hash[i] / number_of_buckets & (slots - 1);
                     while(table[slot] != none && !is_same(table[slot]))
                       slot = (slot + 1) & (slots - 1);
                     if(table[slot] == none)
                       table[slot] = i;
                     original[i] = table[slot];
                   }
                 });
  return original;
}

} // namespace

Sorted_surfels sort_surfels(std::vector<Vec3> points, const std::vector<Vec3>& normals,
                            double cosine, unsigned number_of_threads, const Frame* frame)
{
  Sorted_surfels result;
  const Frame cloud_frame = unit_frame(points);
  result.frame = frame == nullptr ? cloud_frame : *frame;
  to_frame(points, result.frame);
  const std::size_t n = points.size();
  const std::vector<Index> original = find_originals(points, normals, cosine, number_of_threads);
  std::vector<Index> distinct, order;
  distinct.reserve(n);
  for(Index i = 0; i < n; ++i)
    if(original[i] == i)
      distinct.push_back(i);
  if(distinct.size() < n)
    for(Index i = 0; i < distinct.size(); ++i)
      points[i] = points[distinct[i]];
  points.resize(distinct.size());
  result.point = std::move(points);
  result.tree = Kd_tree(result.point, order, number_of_threads);
  result.internal_vertex.resize(n);
  result.caller_vertex.resize(distinct.size());
  result.normal.resize(distinct.size());
  for_each_block(distinct.size(), surfel_block_size, number_of_threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   for(Index v = static_cast<Index>(begin); v < end; ++v)
                   {
                     const Index surfel = distinct[order[v]];
                     result.caller_vertex[v] = surfel;
                     result.internal_vertex[surfel] = v;
                     result.normal[v] = normals[surfel];
                   }
                 });
  for(Index i = 0; distinct.size() < n && i < n; ++i)
    result.internal_vertex[i] = result.internal_vertex[original[i]];
  return result;
}

std::vector<double> surfel_radii(const Sorted_surfels& surfels, const std::vector<double>& radii,
                                 const Ragged_rows& neighbors, std::size_t rank,
                                 unsigned number_of_threads)
{
  for(std::size_t i = 0; i < radii.size(); ++i)
    if(!std::isfinite(radii[i]) || radii[i] < 0.)
      throw Invalid_argument_error("The radius of surfel " + std::to_string(i) +
                                   " is negative or not finite.");
  std::vector<double> result(surfels.point.size(), 0.);
  const int exponent = std::ilogb(surfels.frame.scale);
  for_each_block(result.size(), surfel_block_size, number_of_threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   for(Index v = static_cast<Index>(begin); v < end; ++v)
                     if(!radii.empty())
                       result[v] =
                           std::min(std::ldexp(radii[surfels.caller_vertex[v]], -exponent), 8.);
                     else if(neighbors.begin(v) != neighbors.end(v))
                     {
                       const std::size_t count = neighbors.end(v) - neighbors.begin(v);
                       const Index last = neighbors.begin(v)[std::min(rank, count) - 1];
                       result[v] = norm(surfels.point[last] - surfels.point[v]) / std::sqrt(2.);
                     }
                 });
  return result;
}

Ragged_rows find_neighbors(const Sorted_surfels& surfels,
                           const Compatibility_test* compatibility_test, std::size_t count,
                           unsigned number_of_threads, Neighbor_distances& distances)
{
  const std::vector<Vec3>&point = surfels.point, &normal = surfels.normal;
  const Kd_tree& tree = surfels.tree;
  constexpr std::size_t rank = 6; // the number of adjacent surfels in a regular triangulation
  Ragged_rows rows(tree.size());
  distances.search_radius.assign(tree.size(), infinity);
  distances.spacing.resize(tree.size());
  visit_nearest(
      point, tree, count, number_of_threads,
      [&](std::size_t block, Index i, const std::vector<Kd_tree::Neighbor>& found)
      {
        if(i % surfel_block_size == 0)
          rows.buffer(block).reserve(count * std::min(surfel_block_size, point.size() - i));
        if(found.size() > count)
          distances.search_radius[i] = std::sqrt(found.back().squared_distance);
        distances.spacing[i] = std::sqrt(found[std::min(rank, found.size() - 1)].squared_distance);
        for(const Kd_tree::Neighbor& neighbor : found)
        {
          const Index j = neighbor.point;
          if(j != i && (compatibility_test == nullptr ||
                        (*compatibility_test)(point[i], normal[i], point[j], normal[j]) !=
                            Compatibility::incompatible))
            rows.buffer(block).push_back(j);
        }
        rows.end_row(block, i);
      });
  return rows;
}

} // namespace CGAL::Geodesic_processing::internal
