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
    throw Invalid_argument_error("There are " + std::to_string(points) + " points, " +
                                 std::to_string(normals) + " normals and " + std::to_string(radii) +
                                 " radii.");
  if(points > none / 128)
    throw Unsupported_surface_error("A cloud of more than 2^25 surfels is too large.");
}

void normalize(std::vector<Spatial>& normals)
{
  for(std::size_t i = 0; i < normals.size(); ++i)
  {
    Spatial& n = normals[i];
    const double largest = std::max({std::abs(n[0]), std::abs(n[1]), std::abs(n[2])});
    if(!(largest > 0.) || !std::isfinite(n[0]) || !std::isfinite(n[1]) || !std::isfinite(n[2]))
      throw Invalid_argument_error("The normal of surfel " + std::to_string(i) +
                                   " has no direction.");
    const int exponent = std::ilogb(largest);
    for(double& x : n)
      x = std::ldexp(x, -exponent);
    const double length = std::sqrt(dot(n, n));
    for(double& x : n)
      x /= length;
  }
}

namespace {

// For each surfel the first one at the same point with an agreeing normal: itself for most.  Surfels are
// dealt out by their points, so that each part's table stays in the cache, and parts are treated side by
// side.
std::vector<Index> originals(const std::vector<Spatial>& points,
                             const std::vector<Spatial>& normals, double cosine, unsigned threads)
{
  constexpr std::size_t parts = 256;
  // Points closer than 2^-51 of the extent are rounded together by this sum, so that no squared
  // distance between originals underflows.
  const auto key = [&](Index i) -> Spatial {
    return {points[i][0] + 4., points[i][1] + 4., points[i][2] + 4.};
  };
  const std::size_t n = points.size();
  std::vector<std::uint64_t> hash(n);
  for_each_block(n, surfel_block, threads,
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
  std::vector<std::size_t> first(parts + 1, 0);
  for(const std::uint64_t h : hash)
    ++first[h % parts + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Index> dealt(n), original(n);
  std::vector<std::size_t> end_of_part = first;
  for(Index i = 0; i < n; ++i)
    dealt[end_of_part[hash[i] % parts]++] = i;

  for_each_block(parts, 1, threads,
                 [&](std::size_t part, std::size_t, std::size_t)
                 {
                   std::size_t slots = 16;
                   while(slots < 2 * (first[part + 1] - first[part]))
                     slots *= 2;
                   std::vector<Index> table(slots, none);
                   for(std::size_t k = first[part]; k < first[part + 1]; ++k)
                   {
                     const Index i = dealt[k];
                     const auto is_same = [&](Index j) {
                       return hash[j] == hash[i] && key(j) == key(i) &&
                              dot(normals[j], normals[i]) > cosine;
                     };
                     std::size_t slot = hash[i] / parts & (slots - 1);
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

Sorted_surfels sort_surfels(std::vector<Spatial> points, const std::vector<Spatial>& normals,
                            double cosine, unsigned threads, const Frame* frame)
{
  Sorted_surfels result;
  const Frame own = unit_frame(points);
  result.frame = frame == nullptr ? own : *frame;
  to_frame(points, result.frame);
  const std::size_t n = points.size();
  const std::vector<Index> original = originals(points, normals, cosine, threads);
  std::vector<Index> place, order;
  place.reserve(n);
  for(Index i = 0; i < n; ++i)
    if(original[i] == i)
      place.push_back(i);
  if(place.size() < n)
    for(Index i = 0; i < place.size(); ++i)
      points[i] = points[place[i]];
  points.resize(place.size());
  result.point = std::move(points);
  result.tree = Kd_tree(result.point, order, threads);
  result.site_of_surfel.resize(n);
  result.surfel_of_site.resize(place.size());
  result.normal.resize(place.size());
  for_each_block(place.size(), surfel_block, threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   for(Index s = static_cast<Index>(begin); s < end; ++s)
                   {
                     const Index surfel = place[order[s]];
                     result.surfel_of_site[s] = surfel;
                     result.site_of_surfel[surfel] = s;
                     result.normal[s] = normals[surfel];
                   }
                 });
  for(Index i = 0; place.size() < n && i < n; ++i)
    result.site_of_surfel[i] = result.site_of_surfel[original[i]];
  return result;
}

std::vector<double> site_radii(const Sorted_surfels& surfels, const std::vector<double>& radii,
                               const Rows& near, std::size_t rank, unsigned threads)
{
  for(std::size_t i = 0; i < radii.size(); ++i)
    if(!std::isfinite(radii[i]) || radii[i] < 0.)
      throw Invalid_argument_error("The radius of surfel " + std::to_string(i) +
                                   " is negative or not finite.");
  std::vector<double> result(surfels.point.size(), 0.);
  const int exponent = std::ilogb(surfels.frame.scale);
  for_each_block(result.size(), surfel_block, threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   for(Index s = static_cast<Index>(begin); s < end; ++s)
                     if(!radii.empty())
                       result[s] =
                           std::min(std::ldexp(radii[surfels.surfel_of_site[s]], -exponent), 8.);
                     else if(near.begin(s) != near.end(s))
                     {
                       const std::size_t count = near.end(s) - near.begin(s);
                       const Index last = near.begin(s)[std::min(rank, count) - 1];
                       result[s] = norm(surfels.point[last] - surfels.point[s]) / std::sqrt(2.);
                     }
                 });
  return result;
}

Rows find_neighbors(const std::vector<Spatial>& point, const std::vector<Spatial>& normal,
                    const Kd_tree& tree, const Agree* agree, std::size_t count, unsigned threads,
                    Surroundings& around)
{
  constexpr std::size_t rank = 6; // as many as a surfel of an even cloud has around it
  Rows rows(tree.size());
  around.seen.assign(tree.size(), infinity);
  around.spacing.resize(tree.size());
  visit_nearest(point, tree, count, threads,
                [&](std::size_t block, Index i, const std::vector<Kd_tree::Neighbor>& found)
                {
                  if(i % surfel_block == 0)
                    rows.part(block).reserve(count * std::min(surfel_block, point.size() - i));
                  if(found.size() > count)
                    around.seen[i] = std::sqrt(found.back().squared_distance);
                  around.spacing[i] =
                      std::sqrt(found[std::min(rank, found.size() - 1)].squared_distance);
                  for(const Kd_tree::Neighbor& neighbor : found)
                  {
                    const Index j = neighbor.point;
                    if(j != i && (agree == nullptr || (*agree)(point[i], normal[i], point[j],
                                                               normal[j]) != Agreement::no))
                      rows.part(block).push_back(j);
                  }
                  rows.end_row(block, i);
                });
  return rows;
}

} // namespace CGAL::Geodesic_processing::internal
