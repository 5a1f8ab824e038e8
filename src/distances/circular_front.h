// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_CIRCULAR_FRONT_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_CIRCULAR_FRONT_H

#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <cmath>

namespace CGAL::Geodesic_processing::internal {

// The geometry of a circular front in the plane (Reimers 2004).
//
// The front passes a vertex x at the origin. An edge of a given length runs from x along the first
// axis to a vertex z. The front arrives from below this edge and is evaluated at a point y above
// it. `difference` is the distance of z minus the distance of x.

struct Circular_front
{
  Vec2 source;      // unit vector from x to the source; second coordinate <= 0
  double curvature; // 1 / distance from x to the source; 0 for a straight front
};

// Computes `gain`, the distance at y minus the distance at x, and `back`, the unit vector from y to
// the source. Returns false if the straight line from y to the source misses the edge.
inline bool cross_edge(const Circular_front& circle, double length, const Vec2& y, double& gain,
                       Vec2& back)
{
  const Vec2 backward = circle.source - circle.curvature * y;
  if(backward[1] >= 0.)
    return false;
  const double scaled_crossing =
      y[0] * backward[1] - y[1] * backward[0]; // position on the edge times backward[1] < 0
  if(scaled_crossing > 0. || scaled_crossing < length * backward[1])
    return false;
  const double length_of_backward = norm(backward);
  // |y - r u| - r with r = 1 / curvature and u = source, in a form that holds for curvature 0.
  gain = (dot(y, y) * circle.curvature - 2. * dot(y, circle.source)) / (length_of_backward + 1.);
  back = (1. / length_of_backward) * backward;
  return true;
}

// Computes the direction to the source of a circle of known curvature from the difference of the
// distances at the ends of an edge. Returns false if no direction yields that difference.
inline bool fit_source_direction(double length, double difference, Circular_front& circle)
{
  const double cosine = -difference / length + 0.5 * circle.curvature * (length - difference) *
                                                   (length + difference) / length;
  if(!(std::abs(cosine) <= 1.))
    return false;
  circle.source = {cosine, -std::sqrt((1. - cosine) * (1. + cosine))};
  return true;
}

// Returns the residual d + l c - (l^2 - d^2) / (2 r) of a circle of this curvature (see below). It
// is positive if `difference` is larger than that of the circle, and negative if it is smaller.
// For a straight front it is the difference of both. `cosine` is that of the angle at x between
// the edge and the source.
inline double circle_residual(double curvature, double length, double difference, double cosine)
{
  return difference + length * cosine -
         0.5 * curvature * (length - difference) * (length + difference);
}

// Returns the curvature of the circle that has the source's direction at x and the given difference
// along the edge, but at least `min_curvature`.
//
// With d = difference, l = length, c = cosine, u = source, e = the edge's direction: |l e - r u| =
// r + d yields 1 / r = 2 (d + l c) / (l^2 - d^2). Only a residual beyond 1e-11 of the distance is
// used. Otherwise round-off errors always increase the curvature and accumulate. On a flat
// square, the relative error after 300 edges was 1e-10 instead of 1e-15.
inline double fitted_curvature(double min_curvature, double length, double difference,
                               double cosine, double distance)
{
  const double denominator = (length - difference) * (length + difference);
  const double residual_of_straight_front = difference + length * cosine;
  const bool is_larger = denominator > 0. && circle_residual(min_curvature, length, difference,
                                                             cosine) > 1e-11 * distance;
  return is_larger ? 2. * residual_of_straight_front / denominator : min_curvature;
}
} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_CIRCULAR_FRONT_H
