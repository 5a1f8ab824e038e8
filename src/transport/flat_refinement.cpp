// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/flat_refinement.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// #sides: the site in the middle of each, from number_of_sites() on; one for all sides that join two
// surfels.
std::vector<Index> middles(const Glued_triangles& t)
{
  std::vector<Index> result(t.corner.size());
  Index next = Index(t.number_of_sites());
  if(!t.is_cloud())
  {
    for(Index side = 0; side < result.size(); ++side)
      result[side] = t.twin[side] < side ? result[t.twin[side]] : next++;
    return result;
  }
  const auto ends = [&](Index side) -> std::pair<Index, Index>
  { return std::minmax(t.corner[side], t.corner[next_side(side)]); };
  std::vector<Index> order(result.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return std::tuple(ends(a), a) < std::tuple(ends(b), b); });
  for(std::size_t i = 0; i < order.size(); ++i)
    result[order[i]] = i > 0 && ends(order[i]) == ends(order[i - 1]) ? next - 1 : next++;
  return result;
}

// The corners around each site, by the order in which they come.
void set_star(Glued_triangles& t, std::size_t number_of_sites, const std::vector<Index>& corners)
{
  t.first.assign(number_of_sites + 1, 0);
  for(const Index site : t.corner)
    ++t.first[site + 1];
  std::partial_sum(t.first.begin(), t.first.end(), t.first.begin());
  t.star.resize(t.corner.size());
  std::vector<Index> next(t.first.begin(), t.first.end() - 1);
  for(const Index corner : corners)
    t.star[next[t.corner[corner]]++] = corner;
}

// Corner j of the triangle in the place of `part`, 0 to 3, of the triangle of a corner or side.
constexpr Index corner_in(Index side, Index part, Index j)
{
  return 3 * (4 * (side / 3) + part % 3) + j % 3;
}
constexpr Index corner_in_middle(Index side, Index j) { return 3 * (4 * (side / 3) + 3) + j % 3; }

} // namespace

Glued_triangles refined(const Glued_triangles& t)
{
  Glued_triangles result;
  const std::vector<Index> middle = middles(t);
  Index number_of_sites = Index(t.number_of_sites());
  for(const Index site : middle)
    number_of_sites = std::max(number_of_sites, site + 1);

  result.corner.resize(4 * t.corner.size());
  result.length.resize(result.corner.size());
  for(Index side = 0; side < t.corner.size(); ++side)
  {
    const Index k = side % 3;
    result.corner[corner_in(side, k, k)] = t.corner[side];
    result.corner[corner_in(side, k, k + 1)] = middle[side];
    result.corner[corner_in(side, k, k + 2)] = middle[previous_side(side)];
    result.corner[corner_in_middle(side, k)] = middle[next_side(side)];
    // Twice as long, beside a scale of half.
    for(Index part = 0; part < 3; ++part)
      result.length[corner_in(side, part, k)] = t.length[side];
    result.length[corner_in_middle(side, k)] = t.length[side];
  }
  for(const float weight : t.weight)
    result.weight.insert(result.weight.end(), 4, weight);
  result.scale = 0.5 * t.scale;
  result.origin = t.origin;
  if(t.is_cloud())
    result.graph.first.assign(number_of_sites + 1, 0);
  else
  {
    result.twin.resize(result.corner.size());
    for(Index side = 0; side < t.corner.size(); ++side)
    {
      const Index k = side % 3, twin = t.twin[side], l = twin % 3;
      const bool is_border = twin == none;
      result.twin[corner_in(side, k, k)] = is_border ? none : corner_in(twin, l + 1, l);
      result.twin[corner_in(side, k + 1, k)] = is_border ? none : corner_in(twin, l, l);
      result.twin[corner_in(side, k + 2, k)] = corner_in_middle(side, k);
      result.twin[corner_in_middle(side, k)] = corner_in(side, k + 2, k);
    }
  }

  // Counterclockwise around each site: of a middle those in the one triangle, then those in the other.
  std::vector<Index> corners;
  corners.reserve(result.corner.size());
  for(const Index corner : t.star)
    corners.push_back(corner_in(corner, corner % 3, corner % 3));
  for(Index side = 0; side < t.corner.size(); ++side)
  {
    const Index k = side % 3;
    corners.insert(corners.end(), {corner_in(side, k + 1, k), corner_in_middle(side, k + 2),
                                   corner_in(side, k, k + 1)});
  }
  set_star(result, number_of_sites, corners);
  return result;
}

Location refined(const Location& location)
{
  if(location.triangle == none)
    return location;
  const auto& b = location.barycentric;
  const Index k = Index(std::max_element(b.begin(), b.end()) - b.begin());
  Location result;
  const bool is_at_corner = b[k] >= 0.5;
  result.triangle = 4 * location.triangle + (is_at_corner ? k : 3);
  for(Index j = 0; j < 3; ++j)
    result.barycentric[j] = is_at_corner ? 2. * b[j] - (j == k ? 1. : 0.) : 1. - 2. * b[j];
  return result;
}

Vector refined(const Glued_triangles& coarse, const Glued_triangles& fine, const Vector& function)
{
  Vector result = Vector::Zero(Eigen::Index(fine.number_of_sites()));
  result.head(function.size()) = function;
  for(Index side = 0; side < coarse.corner.size(); ++side)
    result[fine.corner[corner_in(side, side % 3, side % 3 + 1)]] =
        0.5 * (function[coarse.corner[side]] + function[coarse.corner[next_side(side)]]);
  return result;
}

// The triangle in the middle is turned by half.
Field coarsened(const Field& fine)
{
  Field result(fine.size() / 4);
  for(std::size_t f = 0; f < result.size(); ++f)
    result[f] = 0.25 * (fine[4 * f] + fine[4 * f + 1] + fine[4 * f + 2] - fine[4 * f + 3]);
  return result;
}

Vector coarsened(const Glued_triangles& coarse, const Glued_triangles& fine, const Vector& masses)
{
  Vector result = masses.head(Eigen::Index(coarse.number_of_sites()));
  Vector rest = masses;
  for(Index side = 0; side < coarse.corner.size(); ++side)
  {
    double& mass = rest[fine.corner[corner_in(side, side % 3, side % 3 + 1)]];
    for(const Index end : {side, next_side(side)})
      result[coarse.corner[end]] += 0.5 * mass;
    mass = 0.; // other sides with this middle have the same ends
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
