// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/curvature.h>

#include <CGAL/Geodesic_processing/internal/front.h>
#include <CGAL/Geodesic_processing/internal/planar.h>
#include <CGAL/Geodesic_processing/internal/rows.h>

#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The radius of a ball in mean lengths around its site: the least that evens out the triangulation of
// a scan.
constexpr double mean_lengths = 3.;

// A surface of second order has six coefficients; with twice as many surfels noise averages out.
constexpr std::size_t enough_surfels = 12;

// What each triangle and each side add to the balls that hold them.
struct Parts
{
  std::vector<Spatial> normal; // #triangles: as long as twice the area
  std::vector<double> bend;    // #sides: the angle between the normals, positive at a convex edge
};

Parts parts(const Glued_triangles& t)
{
  Parts result;
  result.normal.resize(t.number_of_triangles());
  for(Index f = 0; f < result.normal.size(); ++f)
  {
    const Spatial& p = t.point[t.corner[3 * f]];
    result.normal[f] = cross(t.point[t.corner[3 * f + 1]] - p, t.point[t.corner[3 * f + 2]] - p);
  }
  result.bend.resize(t.corner.size(), 0.);
  for(Index side = 0; side < t.corner.size(); ++side)
    if(const Index twin = t.twin[side]; twin != none)
    {
      const Spatial along = unit(t.point[t.corner[next_side(side)]] - t.point[t.corner[side]]);
      const Spatial &n = result.normal[side / 3], &other = result.normal[twin / 3];
      result.bend[side] = std::atan2(dot(cross(n, other), along), dot(n, other));
    }
  return result;
}

double mean_length(const Glued_triangles& t, Index site)
{
  double sum = 0.;
  for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
    sum += t.length[t.star[i]] + t.length[previous_side(t.star[i])];
  return sum / (2. * (t.first[site + 1] - t.first[site]));
}

// The sum over a ball of  angle  length  e e^T  of its edges, of which one direction lies in two
// dimensions.
struct Tensor
{
  std::array<std::array<double, 3>, 3> sum = {};

  void add(double weight, const Spatial& e)
  {
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        sum[i][j] += weight * e[i] * e[j];
  }
  double in(const Spatial& p, const Spatial& q) const
  {
    double result = 0.;
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        result += p[i] * sum[i][j] * q[j];
    return result;
  }
};

// Edges and triangles count as far as the front comes into them.
Curvature normal_cycle(const Glued_triangles& t, const Parts& parts, const Front& front,
                       double radius)
{
  Tensor tensor;
  Spatial normal = {0., 0., 0.};
  double twice_area = 0.;
  // The part of a side, from one end, that the front covers when it is reached there.
  const auto part = [&](Index side, Index from)
  { return std::min(1., (radius - front.distance(from)) / t.length[side]); };
  for(const Index site : front.reached())
    for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
    {
      const Index f = t.star[i] / 3;
      std::array<bool, 3> is_inside;
      Index inside = 0, first = none;
      for(Index k = 0; k < 3; ++k)
      {
        const Index corner = t.corner[3 * f + k];
        is_inside[k] = front.distance(corner) <= radius;
        inside += is_inside[k];
        if(is_inside[k])
          first = std::min(first, corner);
      }
      if(first != site)
        continue; // once for each triangle
      std::array<double, 3> covered;
      for(Index k = 0; k < 3; ++k)
      {
        const Index side = 3 * f + k, end = (k + 1) % 3;
        covered[k] = is_inside[k] && is_inside[end] ? 1.
                     : is_inside[k]                 ? part(side, t.corner[side])
                     : is_inside[end]               ? part(side, t.corner[3 * f + end])
                                                    : 0.;
        // Each of an edge's two sides has a half of it.
        tensor.add(0.5 * parts.bend[side] * covered[k] * t.length[side],
                   unit(t.point[t.corner[3 * f + end]] - t.point[t.corner[side]]));
      }
      double share = 1.;
      for(Index k = 0; k < 3; ++k)
      {
        if(inside == 1 && is_inside[k])
          share = covered[k] * covered[(k + 2) % 3];
        if(inside == 2 && !is_inside[k])
          share = 1. - (1. - covered[k]) * (1. - covered[(k + 2) % 3]);
      }
      normal = normal + share * parts.normal[f];
      twice_area += share * norm(parts.normal[f]);
    }
  if(!(twice_area > 0.) || !(norm(normal) > 0.))
    return {};

  const auto [x, y] = tangent_frame(unit(normal));
  const double scale = 2. / twice_area;
  const double a = scale * tensor.in(x, x), b = scale * tensor.in(x, y),
               c = scale * tensor.in(y, y);
  const double half = std::hypot(0.5 * (a - c), b), angle = 0.5 * std::atan2(b, 0.5 * (a - c));
  // Edges lie across the direction in which they bend the surface.
  const Spatial along = std::cos(angle) * x + std::sin(angle) * y,
                across = std::cos(angle) * y - std::sin(angle) * x;
  return {0.5 * (a + c) - half, 0.5 * (a + c) + half, along, across};
}

// The surface of second order through a ball of surfels, the site's first.
Curvature fitted(const Glued_triangles& t, const std::vector<Index>& ball)
{
  using Kernel = Simple_cartesian<double>;
  using Fitting = Monge_via_jet_fitting<Kernel>;
  std::vector<Kernel::Point_3> points;
  for(const Index site : ball)
    points.emplace_back(t.point[site][0], t.point[site][1], t.point[site][2]);
  auto form = Fitting()(points.begin(), points.end(), 2, 2);
  const Spatial& n = t.normal[ball.front()];
  form.comply_wrt_given_normal(Kernel::Vector_3(n[0], n[1], n[2]));
  const auto spatial = [](const Kernel::Vector_3& v) -> Spatial { return {v.x(), v.y(), v.z()}; };
  // A Monge form is positive where the surface bends towards its normal.
  Curvature result = {-form.principal_curvatures(0), -form.principal_curvatures(1),
                      spatial(form.maximal_principal_direction()),
                      spatial(form.minimal_principal_direction())};
  return std::isfinite(result.least) && std::isfinite(result.most) ? result : Curvature();
}

} // namespace

std::vector<Curvature> curvatures(const std::shared_ptr<const Glued_triangles>& triangles,
                                  double radius, unsigned threads)
{
  const Glued_triangles& t = *triangles;
  std::vector<Curvature> result(t.number_of_sites());
  const Parts all = t.is_cloud() ? Parts() : parts(t);
  // Straight fronts are near enough for a ball, and never take back what they know: a Euclidean one does,
  // for milliseconds at each site of a lantern of Schwarz.
  for_each_row(Front(triangles, Front_kind::planar), result.size(), {}, threads,
               [&](std::size_t i, Front& front, Front_limits limits)
               {
                 const Index site = Index(i);
                 if(t.first[site] == t.first[site + 1])
                   return;
                 limits.maximum_distance =
                     radius > 0. ? radius : mean_lengths * mean_length(t, site);
                 front.run({{{{none, site, {}}}, 0., 0}}, limits);
                 if(!t.is_cloud())
                 {
                   result[site] = normal_cycle(t, all, front, limits.maximum_distance);
                   return;
                 }
                 for(int grown = 0; grown < 4 && front.reached().size() < enough_surfels; ++grown)
                 {
                   limits.maximum_distance *= 1.5;
                   front.run({{{{none, site, {}}}, 0., 0}}, limits);
                 }
                 if(front.reached().size() >= enough_surfels)
                   result[site] = fitted(t, front.reached());
               });
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
