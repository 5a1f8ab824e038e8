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

// The direction in which a function increases least, and its derivative there. The slope is
// negative if and only if there is a descent direction. If there are no directions, it is zero.
struct Cone_descent
{
  double slope = 0.;
  double angle = 0.;
};

// Minimizes the directional derivative of 1/2 sum w_i d(x, p_i)^2 over all directions at x.
//
// The surface is a cone at x. By the first variation of arc length, the derivative in direction u
// is
//
//   - sum w_i d_i cos(min(angle(u, v_i), pi)),
//
// where v_i is the direction of the path to p_i. The angle is the smaller one of both sides of u;
// at the boundary, and between different fans, there is one side or none. Between critical
// directions this is a sinusoid. The critical directions are those at the angle pi from a v_i, and
// those at equal angles on both sides of it. All intervals between them are minimized in closed
// form. O(k log k) for k paths.
//
// fans   disjoint intervals of polar angles
// pulls  each direction is in a fan, up to round-off errors and multiples of the angle of a closed
//        fan
CGAL_GEODESIC_PROCESSING_EXPORT
Cone_descent steepest_descent(const std::vector<Direction_fan>& fans,
                              const std::vector<Direction_pull>& pulls);

// Returns whether the only fan is that of a point without curvature, inside the surface.
CGAL_GEODESIC_PROCESSING_EXPORT
bool is_smooth(const std::vector<Direction_fan>& fans);

// Returns the sum of moments as a vector: at a smooth point, the negative gradient.
CGAL_GEODESIC_PROCESSING_EXPORT
Vec2 sum_of_pulls(const std::vector<Direction_pull>& pulls);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_CONE_DESCENT_H
