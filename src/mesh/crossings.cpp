// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/crossings.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Kernel = Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Box =
    Box_intersection_d::Box_with_info_d<double, 3, Index, Box_intersection_d::ID_FROM_BOX_ADDRESS>;

// Below so many boxes all pairs of them are looked at.
constexpr std::ptrdiff_t few_boxes = 500;

// Below it products have lost digits.
constexpr double least_product = 1e-290;

// The only way out of CGAL's search.
struct Enough
{};

class Crossings
{
public:
  Crossings(const std::vector<Spatial>& points, const std::vector<std::array<Index, 3>>& corners)
      : m_points(points), m_corners(corners)
  {}

  std::vector<std::array<Index, 2>> find(std::size_t most) const
  {
    std::vector<std::array<Index, 2>> result;
    std::vector<Box> boxes;
    for(Index f = 0; f < m_corners.size(); ++f)
      if(const auto [p, q, r] = points_of(f); collinear(p, q, r))
        result.push_back({f, f});
      else
        boxes.emplace_back(p.bbox() + q.bbox() + r.bbox(), f);
    std::vector<const Box*> addresses;
    for(const Box& box : boxes)
      addresses.push_back(&box);
    try
    {
      box_self_intersection_d(
          addresses.begin(), addresses.end(),
          [&](const Box* box, const Box* other)
          {
            if(result.size() >= most)
              throw Enough();
            const auto [f, g] = std::minmax({box->info(), other->info()});
            if(do_cross(f, g))
              result.push_back({f, g});
          },
          few_boxes);
    }
    catch(const Enough&)
    {}
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  std::array<Point, 3> points_of(Index f) const
  {
    const auto point = [&](int k)
    {
      const Spatial& p = m_points[m_corners[f][k]];
      return Point(p[0], p[1], p[2]);
    };
    return {point(0), point(1), point(2)};
  }

  bool do_cross(Index f, Index g) const
  {
    // Where the corners that they share are in each.
    std::array<int, 3> in_f{}, in_g{};
    int shared = 0;
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        if(shared < 3 && m_corners[f][i] == m_corners[g][j])
        {
          in_f[shared] = i;
          in_g[shared++] = j;
        }
    if(shared == 1 && are_parted(f, in_f[0], g, in_g[0]))
      return false;
    const auto p = points_of(f), q = points_of(g);
    const Kernel::Triangle_3 a(p[0], p[1], p[2]), b(q[0], q[1], q[2]);
    if(shared == 0)
      return do_intersect(a, b);
    if(shared == 1)
    {
      const auto opposite = [](const std::array<Point, 3>& corners, int i)
      { return Kernel::Segment_3(corners[(i + 1) % 3], corners[(i + 2) % 3]); };
      return do_intersect(a, opposite(q, in_g[0])) || do_intersect(b, opposite(p, in_f[0]));
    }
    if(shared == 3)
      return true;
    // Folded onto each other: both lie on one side of what they share.
    const Point &x = p[in_f[0]], &y = p[in_f[1]], &z = p[3 - in_f[0] - in_f[1]],
                &w = q[3 - in_g[0] - in_g[1]];
    return coplanar(x, y, z, w) && coplanar_orientation(x, y, z, w) == POSITIVE;
  }

  // Whether a plane through the corner that two triangles share, square to the way from one to the other, has
  // them on two sides for certain.
  bool are_parted(Index f, int in_f, Index g, int in_g) const
  {
    const Spatial& tip = m_points[m_corners[f][in_f]];
    const auto side = [&](Index triangle, int k)
    { return m_points[m_corners[triangle][k % 3]] - tip; };
    const std::array<Spatial, 2> of_f = {side(f, in_f + 1), side(f, in_f + 2)},
                                 of_g = {side(g, in_g + 1), side(g, in_g + 2)};
    const Spatial way = (of_g[0] + of_g[1]) - (of_f[0] + of_f[1]);
    // The differences, products and sums are right to five roundings of 2^-53 of the sizes of the products.
    const auto is_before = [&](const Spatial& p, double sign)
    {
      const std::array<double, 3> product = {p[0] * way[0], p[1] * way[1], p[2] * way[2]};
      const double size = std::abs(product[0]) + std::abs(product[1]) + std::abs(product[2]);
      return sign * (product[0] + product[1] + product[2]) > 1e-15 * size + least_product;
    };
    return is_before(of_f[0], -1.) && is_before(of_f[1], -1.) && is_before(of_g[0], 1.) &&
           is_before(of_g[1], 1.);
  }

  const std::vector<Spatial>& m_points;
  const std::vector<std::array<Index, 3>>& m_corners;
};

} // namespace

std::vector<std::array<Index, 2>>
crossing_triangles(const std::vector<Spatial>& points,
                   const std::vector<std::array<Index, 3>>& corners, std::size_t most)
{
  return Crossings(points, corners).find(most);
}

} // namespace CGAL::Geodesic_processing::internal
