// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_CONE_DESCENT_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_CONE_DESCENT_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The directions at a point of a mesh, as an interval of polar angles. It is closed (periodic)
// except at the boundary. A non-manifold vertex has several fans.
struct Direction_fan
{
  double begin = 0.;
  double angle = 2. * pi;
  bool is_closed = true;
};

// The direction of the shortest path to a point, and the weight times the length of the path.
struct Direction_pull
{
  double angle = 0.;
  double moment = 0.; // not negative
};

// The direction of the smallest directional derivative, and this derivative (`slope`). The slope is
// negative if and only if there is a descent direction. If there are no directions, it is zero.
struct Cone_descent
{
  double slope = 0.;
  double angle = 0.;
};

// Minimizes the directional derivative of 1/2 sum w_i d(x, p_i)^2 over all directions at x.
//
// The surface at x is a cone. Let v_i be the direction of the shortest path to p_i, and d_i the
// length of this path. By the first variation of arc length, the derivative in direction u is
//
//   - sum w_i d_i cos(min(angle(u, v_i), pi)).
//
// In a closed fan, angle(u, v_i) is the smaller one of the clockwise and the counterclockwise
// angle. In the fan of a boundary vertex, only one of them exists. If u and v_i are in different
// fans, the angle is infinite.
//
// As a function of the polar angle of u, the derivative is a sinusoid between critical directions.
// A direction is critical if its angle to some v_i is pi, or if the clockwise and the
// counterclockwise angle are equal. Each interval is minimized in closed form. O(k log k) time for
// k paths.
//
// fans   disjoint intervals of polar angles
// pulls  if a fan is closed, angles can differ by multiples of its angle. Otherwise, each angle is
//        in a fan, up to round-off errors
CGAL_GEODESIC_PROCESSING_EXPORT
Cone_descent steepest_descent(const std::vector<Direction_fan>& fans,
                              const std::vector<Direction_pull>& pulls);

// Returns whether the point has a single closed fan of angle 2 pi: an interior point, or a vertex
// without curvature.
CGAL_GEODESIC_PROCESSING_EXPORT
bool is_smooth(const std::vector<Direction_fan>& fans);

// Returns the vector sum of the pulls. At a smooth point, this is the negative gradient.
CGAL_GEODESIC_PROCESSING_EXPORT
Vec2 sum_of_pulls(const std::vector<Direction_pull>& pulls);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_CONE_DESCENT_H
