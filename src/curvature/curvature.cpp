// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/curvature/curvature.h>

#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include "numerics/nearest_quadric.h"
#include <CGAL/Geodesic_processing/internal/core/planar.h>
#include "distances/rows.h"

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

// The sum over edges of  angle  length  e e^T, of which one direction lies in two dimensions.
struct Tensor
{
  std::array<double, 6> sum = {}; // xx, yy, zz, yz, zx, xy

  void add(double weight, const Spatial& e)
  {
    for(int i = 0; i < 3; ++i)
    {
      sum[i] += weight * e[i] * e[i];
      sum[3 + i] += weight * e[(i + 1) % 3] * e[(i + 2) % 3];
    }
  }
  void add(const Tensor& other)
  {
    for(int i = 0; i < 6; ++i)
      sum[i] += other.sum[i];
  }
  double in(const Spatial& p, const Spatial& q) const
  {
    double result = 0.;
    for(int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      result += sum[i] * p[i] * q[i] + sum[3 + i] * (p[j] * q[k] + p[k] * q[j]);
    }
    return result;
  }
};

// What each triangle and each side add to the balls that hold them.
struct Parts
{
  std::vector<Spatial> normal; // #triangles: as long as twice the area
  std::vector<double> bend;    // #sides: the angle between the normals, positive at a convex edge,
                               //   times half of the length: the twin has the other half
  std::vector<Tensor> tensor;  // #triangles: of its sides
};

Spatial along(const Glued_triangles& t, Index side)
{
  return unit(t.point[t.corner[next_side(side)]] - t.point[t.corner[side]]);
}

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
  result.tensor.resize(t.number_of_triangles());
  for(Index side = 0; side < t.corner.size(); ++side)
    if(const Index twin = t.twin[side]; twin != none)
    {
      const Spatial &n = result.normal[side / 3], &other = result.normal[twin / 3];
      const Spatial e = along(t, side);
      result.bend[side] = 0.5 * t.length[side] * std::atan2(dot(cross(n, other), e), dot(n, other));
      result.tensor[side / 3].add(result.bend[side], e);
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

// Of the symmetric form  a, b; b, c  in two directions.
Curvature principal(double a, double b, double c, const Spatial& x, const Spatial& y)
{
  const double half = std::hypot(0.5 * (a - c), b), angle = 0.5 * std::atan2(b, 0.5 * (a - c));
  return {0.5 * (a + c) - half, 0.5 * (a + c) + half, std::cos(angle) * y - std::sin(angle) * x,
          std::cos(angle) * x + std::sin(angle) * y};
}

// Edges and triangles count as far as the front comes into them.
Curvature normal_cycle(const Glued_triangles& t, const Parts& parts, const Front& front,
                       double radius)
{
  Tensor tensor;
  Spatial normal = {0., 0., 0.};
  double twice_area = 0.;
  const auto is_inside = [&](Index site) { return front.distance(site) <= radius; };
  const auto add_side = [&](Index side, double part)
  {
    if(parts.bend[side] != 0.)
      tensor.add(part * parts.bend[side], along(t, side));
    return part;
  };
  // The part of a side, from one end, that the front covers when it is reached there.
  const auto add_part = [&](Index side, Index from)
  { return add_side(side, std::min(1., (radius - front.distance(from)) / t.length[side])); };
  for(const Index site : front.reached())
    for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
    {
      const Index corner = t.star[i], f = corner / 3;
      // Once for each triangle, at the first corner that is inside.
      const Index next = t.corner[next_side(corner)], previous = t.corner[previous_side(corner)];
      const bool has_next = is_inside(next);
      if(has_next && next < site)
        continue;
      const bool has_previous = is_inside(previous);
      if(has_previous && previous < site)
        continue;
      double share = 1.;
      if(has_next && has_previous)
        tensor.add(parts.tensor[f]);
      else if(has_next || has_previous)
      {
        const Index outside = has_next ? previous_side(corner) : next_side(corner);
        const Index before = previous_side(outside), after = next_side(outside);
        add_side(after, 1.);
        share = 1. - (1. - add_part(before, t.corner[before])) *
                         (1. - add_part(outside, t.corner[after]));
      }
      else
        share = add_part(corner, site) * add_part(previous_side(corner), site);
      normal = normal + share * parts.normal[f];
      twice_area += share * norm(parts.normal[f]);
    }
  if(!(twice_area > 0.) || !(norm(normal) > 0.))
    return {};

  const auto [x, y] = tangent_frame(unit(normal));
  const double scale = 2. / twice_area;
  const double a = scale * tensor.in(x, x), b = scale * tensor.in(x, y),
               c = scale * tensor.in(y, y);
  // Edges lie across the direction in which they bend the surface.
  const Curvature result = principal(a, b, c, x, y);
  return {result.least, result.most, result.most_direction, result.least_direction};
}

// Of the quadric that is nearest to a ball of surfels, the site's first.
Curvature fitted(const Glued_triangles& t, const std::vector<Index>& ball)
{
  const Index origin = ball.front();
  std::vector<Spatial> points;
  for(const Index site : ball)
    points.push_back(t.point[site]);
  const Quadric quadric = nearest_quadric(t.point[origin], points);
  if(!(quadric.unit > 0.))
    return {};
  const std::array<double, 6>& surface = quadric.coefficients;

  // Its second fundamental form above the site, in orthonormal directions; positive where it bends away
  // from the surfel's normal.
  const Spatial along_u = quadric.x + surface[1] * quadric.up,
                along_v = quadric.y + surface[2] * quadric.up;
  const Spatial e = unit(along_u), f = unit(along_v - dot(along_v, e) * e);
  const double length = norm(along_u), c_0 = dot(along_v, e), c_1 = dot(along_v, f);
  const double slope =
      quadric.unit * std::sqrt(1. + surface[1] * surface[1] + surface[2] * surface[2]);
  const double a = -surface[3] / (slope * length * length);
  const double b = (-surface[4] / (slope * length) - c_0 * a) / c_1;
  const double c = (-surface[5] / slope - 2. * c_0 * c_1 * b - c_0 * c_0 * a) / (c_1 * c_1);
  const double sign = dot(cross(e, f), t.normal[origin]) < 0. ? -1. : 1.;
  const Curvature result = principal(sign * a, sign * b, sign * c, e, f);
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
  // for milliseconds at each site of a lantern of Schwarz.  Surfels have arcs in many directions.
  const Front_kind kind = t.is_cloud() ? Front_kind::arcs : Front_kind::planar;
  for_each_row(Front(triangles, kind), result.size(), {}, threads,
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
