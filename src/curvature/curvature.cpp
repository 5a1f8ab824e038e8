// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/curvature/curvature.h>

#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include "numerics/fit_quadric.h"
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include "distances/for_each_row.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The default radius of a ball in mean edge lengths of its center: the smallest one that averages
// out the irregular triangulation of a scan.
constexpr double radius_in_edge_lengths = 3.;

// A quadric has six coefficients. Twice as many surfels average out noise.
constexpr std::size_t min_number_of_surfels = 12;

// A symmetric 3 x 3 matrix: the sum over edges of angle * length * e e^T, e the unit direction.
struct Curvature_tensor
{
  std::array<double, 6> sum = {}; // xx, yy, zz, yz, zx, xy

  void add(double weight, const Vec3& e)
  {
    for(int i = 0; i < 3; ++i)
    {
      sum[i] += weight * e[i] * e[i];
      sum[3 + i] += weight * e[(i + 1) % 3] * e[(i + 2) % 3];
    }
  }
  void add(const Curvature_tensor& other)
  {
    for(int i = 0; i < 6; ++i)
      sum[i] += other.sum[i];
  }
  // Returns p^T M q.
  double evaluate(const Vec3& p, const Vec3& q) const
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

// The contributions of triangles and halfedges to the balls that contain them.
struct Curvature_terms
{
  std::vector<Vec3> normal; // #triangles: of length 2 area
  // #halfedges: the dihedral angle between the normals, positive at a convex edge, times half of
  // the length; the twin has the other half. 0 at the boundary.
  std::vector<double> weighted_angle;
  std::vector<Curvature_tensor> tensor; // #triangles: sum over its halfedges
};

// Returns the unit direction of a halfedge.
Vec3 edge_direction(const Surface_arrays& t, Index h)
{
  return unit(t.point[t.corner[next_halfedge(h)]] - t.point[t.corner[h]]);
}

// Computes the contributions of all triangles and halfedges of a mesh.
Curvature_terms curvature_terms(const Surface_arrays& t)
{
  Curvature_terms result;
  result.normal.resize(t.number_of_triangles());
  for(Index f = 0; f < result.normal.size(); ++f)
  {
    const Vec3& p = t.point[t.corner[3 * f]];
    result.normal[f] = cross(t.point[t.corner[3 * f + 1]] - p, t.point[t.corner[3 * f + 2]] - p);
  }
  result.weighted_angle.resize(t.corner.size(), 0.);
  result.tensor.resize(t.number_of_triangles());
  for(Index h = 0; h < t.corner.size(); ++h)
    if(const Index twin = t.twin[h]; twin != none)
    {
      const Vec3 &n = result.normal[h / 3], &other = result.normal[twin / 3];
      const Vec3 e = edge_direction(t, h);
      result.weighted_angle[h] =
          0.5 * t.length[h] * std::atan2(dot(cross(n, other), e), dot(n, other));
      result.tensor[h / 3].add(result.weighted_angle[h], e);
    }
  return result;
}

// Returns the mean length of the edges of a vertex, over its triangles.
double mean_length(const Surface_arrays& t, Index v)
{
  double sum = 0.;
  for(Index i = t.ring_begin[v]; i < t.ring_begin[v + 1]; ++i)
    sum += t.length[t.ring[i]] + t.length[previous_halfedge(t.ring[i])];
  return sum / (2. * (t.ring_begin[v + 1] - t.ring_begin[v]));
}

// Returns the eigenvalues and eigenvectors of the symmetric form (a, b; b, c) in the orthonormal
// basis (x, y).
Curvature principal_curvature(double a, double b, double c, const Vec3& x, const Vec3& y)
{
  const double half_difference = std::hypot(0.5 * (a - c), b),
               angle = 0.5 * std::atan2(b, 0.5 * (a - c));
  return {0.5 * (a + c) - half_difference, 0.5 * (a + c) + half_difference,
          std::cos(angle) * y - std::sin(angle) * x, std::cos(angle) * x + std::sin(angle) * y};
}

// Returns the curvature from the normal cycle of a ball. Edges and triangles at its boundary are
// weighted by the fraction that the front covers.
Curvature normal_cycle(const Surface_arrays& t, const Curvature_terms& terms, const Front& front,
                       double radius)
{
  Curvature_tensor tensor;
  Vec3 normal = {0., 0., 0.};
  double twice_area = 0.;
  const auto is_inside = [&](Index v) { return front.distance(v) <= radius; };
  const auto add_halfedge = [&](Index h, double fraction)
  {
    if(terms.weighted_angle[h] != 0.)
      tensor.add(fraction * terms.weighted_angle[h], edge_direction(t, h));
    return fraction;
  };
  // Adds the part of a halfedge that the front covers from its end `from`, and returns its
  // fraction.
  const auto add_covered = [&](Index h, Index from)
  { return add_halfedge(h, std::min(1., (radius - front.distance(from)) / t.length[h])); };
  for(const Index v : front.reached())
    for(Index i = t.ring_begin[v]; i < t.ring_begin[v + 1]; ++i)
    {
      const Index corner = t.ring[i], f = corner / 3;
      // Each triangle is counted once: at its corner with the smallest index in the ball.
      const Index next = t.corner[next_halfedge(corner)],
                  previous = t.corner[previous_halfedge(corner)];
      const bool has_next = is_inside(next);
      if(has_next && next < v)
        continue;
      const bool has_previous = is_inside(previous);
      if(has_previous && previous < v)
        continue;
      double covered_fraction = 1.;
      if(has_next && has_previous)
        tensor.add(terms.tensor[f]);
      else if(has_next || has_previous)
      {
        const Index outside = has_next ? previous_halfedge(corner) : next_halfedge(corner);
        const Index before = previous_halfedge(outside), after = next_halfedge(outside);
        add_halfedge(after, 1.);
        covered_fraction = 1. - (1. - add_covered(before, t.corner[before])) *
                                    (1. - add_covered(outside, t.corner[after]));
      }
      else
        covered_fraction = add_covered(corner, v) * add_covered(previous_halfedge(corner), v);
      normal = normal + covered_fraction * terms.normal[f];
      twice_area += covered_fraction * norm(terms.normal[f]);
    }
  if(!(twice_area > 0.) || !(norm(normal) > 0.))
    return {};

  const auto [x, y] = tangent_frame(unit(normal));
  const double scale = 2. / twice_area;
  const double a = scale * tensor.evaluate(x, x), b = scale * tensor.evaluate(x, y),
               c = scale * tensor.evaluate(y, y);
  // The directions are exchanged, because an edge bends the surface perpendicularly to itself.
  const Curvature result = principal_curvature(a, b, c, x, y);
  return {result.min_curvature, result.max_curvature, result.max_direction, result.min_direction};
}

// Returns the curvature of the quadric fitted to a ball of surfels. The first one is the center.
Curvature fit_curvature(const Surface_arrays& t, const std::vector<Index>& ball)
{
  const Index origin = ball.front();
  std::vector<Vec3> points;
  for(const Index v : ball)
    points.push_back(t.point[v]);
  const Quadric quadric = fit_quadric(t.point[origin], points);
  if(!(quadric.length_unit > 0.))
    return {};
  const std::array<double, 6>& surface = quadric.coefficients;

  // The negative second fundamental form at the center, in the orthonormal basis (e, f) of the
  // tangent plane.
  const Vec3 along_u = quadric.x + surface[1] * quadric.plane_normal,
             along_v = quadric.y + surface[2] * quadric.plane_normal;
  const Vec3 e = unit(along_u), f = unit(along_v - dot(along_v, e) * e);
  const double length = norm(along_u), c_0 = dot(along_v, e), c_1 = dot(along_v, f);
  const double slope =
      quadric.length_unit * std::sqrt(1. + surface[1] * surface[1] + surface[2] * surface[2]);
  const double a = -surface[3] / (slope * length * length);
  const double b = (-surface[4] / (slope * length) - c_0 * a) / c_1;
  const double c = (-surface[5] / slope - 2. * c_0 * c_1 * b - c_0 * c_0 * a) / (c_1 * c_1);
  const double sign = dot(cross(e, f), t.normal[origin]) < 0. ? -1. : 1.;
  const Curvature result = principal_curvature(sign * a, sign * b, sign * c, e, f);
  return std::isfinite(result.min_curvature) && std::isfinite(result.max_curvature) ? result
                                                                                    : Curvature();
}

} // namespace

std::vector<Curvature> curvatures(const std::shared_ptr<const Surface_arrays>& triangles,
                                  double radius, unsigned number_of_threads)
{
  const Surface_arrays& t = *triangles;
  std::vector<Curvature> result(t.number_of_vertices());
  const Curvature_terms terms = t.is_cloud() ? Curvature_terms() : curvature_terms(t);
  // Planar fronts are accurate enough for a ball, and never correct final vertices. Euclidean
  // fronts do, which takes milliseconds for each vertex of a Schwarz lantern. On clouds, edges in
  // many directions make Dijkstra's algorithm accurate enough.
  const Front_kind kind = t.is_cloud() ? Front_kind::dijkstra : Front_kind::planar;
  for_each_row(Front(triangles, kind), result.size(), {}, number_of_threads,
               [&](std::size_t i, Front& front, Front_limits limits)
               {
                 const Index v = Index(i);
                 if(t.ring_begin[v] == t.ring_begin[v + 1])
                   return;
                 limits.maximum_distance =
                     radius > 0. ? radius : radius_in_edge_lengths * mean_length(t, v);
                 front.run({{{{none, v, {}}}, 0., 0}}, limits);
                 if(!t.is_cloud())
                 {
                   result[v] = normal_cycle(t, terms, front, limits.maximum_distance);
                   return;
                 }
                 for(int attempt = 0; attempt < 4 && front.reached().size() < min_number_of_surfels;
                     ++attempt)
                 {
                   limits.maximum_distance *= 1.5;
                   front.run({{{{none, v, {}}}, 0., 0}}, limits);
                 }
                 if(front.reached().size() >= min_number_of_surfels)
                   result[v] = fit_curvature(t, front.reached());
               });
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
