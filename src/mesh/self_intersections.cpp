// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/self_intersections.h"

#include "core/exact_predicates.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Triangle = std::array<Vec3, 3>;
using Box =
    Box_intersection_d::Box_with_info_d<double, 3, Index, Box_intersection_d::ID_FROM_BOX_ADDRESS>;

// For at most this number of boxes, all pairs are tested.
constexpr std::ptrdiff_t cutoff = 500;

// Products below this bound can have lost digits by underflow.
constexpr double min_product = 1e-290;

// Leaves CGAL's box intersection early, which offers no other possibility.
struct Limit_reached
{};

Bbox_3 bounding_box(const Triangle& triangle)
{
  Bbox_3 result;
  for(const Vec3& p : triangle)
    result += Bbox_3(p[0], p[1], p[2], p[0], p[1], p[2]);
  return result;
}

class Self_intersection_finder
{
public:
  Self_intersection_finder(const std::vector<Vec3>& points,
                           const std::vector<std::array<Index, 3>>& corners)
      : m_points(points), m_corners(corners)
  {}

  std::vector<std::array<Index, 2>> find_pairs(std::size_t max_pairs) const
  {
    std::vector<std::array<Index, 2>> result;
    std::vector<Box> boxes;
    for(Index f = 0; f < m_corners.size(); ++f)
      if(const Triangle triangle = triangle_at(f); is_degenerate(triangle))
        result.push_back({f, f});
      else
        boxes.emplace_back(bounding_box(triangle), f);
    std::vector<const Box*> addresses;
    for(const Box& box : boxes)
      addresses.push_back(&box);
    try
    {
      box_self_intersection_d(
          addresses.begin(), addresses.end(),
          [&](const Box* box, const Box* other)
          {
            if(result.size() >= max_pairs)
              throw Limit_reached();
            const auto [f, g] = std::minmax({box->info(), other->info()});
            if(intersect_properly(f, g))
              result.push_back({f, g});
          },
          cutoff);
    }
    catch(const Limit_reached&)
    {}
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  Triangle triangle_at(Index f) const
  {
    return {m_points[m_corners[f][0]], m_points[m_corners[f][1]], m_points[m_corners[f][2]]};
  }

  bool intersect_properly(Index f, Index g) const
  {
    // The positions of the shared corners in each triangle.
    std::array<int, 3> in_f{}, in_g{};
    int number_shared = 0;
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        if(number_shared < 3 && m_corners[f][i] == m_corners[g][j])
        {
          in_f[number_shared] = i;
          in_g[number_shared++] = j;
        }
    if(number_shared == 1 && are_separated(f, in_f[0], g, in_g[0]))
      return false;
    const Triangle p = triangle_at(f), q = triangle_at(g);
    if(number_shared == 0)
      return triangles_intersect(p, q);
    if(number_shared == 1)
    {
      const auto opposite_edge = [](const Triangle& triangle, int i) {
        return std::array<Vec3, 2>{triangle[(i + 1) % 3], triangle[(i + 2) % 3]};
      };
      return triangle_intersects_segment(p, opposite_edge(q, in_g[0])) ||
             triangle_intersects_segment(q, opposite_edge(p, in_f[0]));
    }
    return number_shared == 3 || is_folded_flat(p[in_f[0]], p[in_f[1]], p[3 - in_f[0] - in_f[1]],
                                                q[3 - in_g[0] - in_g[1]]);
  }

  // Tests in floating-point arithmetic whether a plane through the shared corner separates two
  // triangles for certain. Its normal is the difference of the centers of the opposite edges.
  // False means that the exact test must decide.
  bool are_separated(Index f, int in_f, Index g, int in_g) const
  {
    const Vec3& shared_corner = m_points[m_corners[f][in_f]];
    const auto to_corner = [&](Index triangle, int k)
    { return m_points[m_corners[triangle][k % 3]] - shared_corner; };
    const std::array<Vec3, 2> edges_of_f = {to_corner(f, in_f + 1), to_corner(f, in_f + 2)},
                              edges_of_g = {to_corner(g, in_g + 1), to_corner(g, in_g + 2)};
    const Vec3 direction = (edges_of_g[0] + edges_of_g[1]) - (edges_of_f[0] + edges_of_f[1]);
    // The sign is certain if the sum exceeds the error of five round-off errors of 2^-53 relative
    // to the sum of the absolute products.
    const auto is_separated = [&](const Vec3& p, double sign)
    {
      const std::array<double, 3> product = {p[0] * direction[0], p[1] * direction[1],
                                             p[2] * direction[2]};
      const double size = std::abs(product[0]) + std::abs(product[1]) + std::abs(product[2]);
      return sign * (product[0] + product[1] + product[2]) > 1e-15 * size + min_product;
    };
    return is_separated(edges_of_f[0], -1.) && is_separated(edges_of_f[1], -1.) &&
           is_separated(edges_of_g[0], 1.) && is_separated(edges_of_g[1], 1.);
  }

  const std::vector<Vec3>& m_points;
  const std::vector<std::array<Index, 3>>& m_corners;
};

} // namespace

std::vector<std::array<Index, 2>>
self_intersections(const std::vector<Vec3>& points,
                   const std::vector<std::array<Index, 3>>& corners, std::size_t max_pairs)
{
  return Self_intersection_finder(points, corners).find_pairs(max_pairs);
}

} // namespace CGAL::Geodesic_processing::internal
