// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_LOG_MAP_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_LOG_MAP_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/log_map/tangent_plane.h>

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Locations around a base point with their tangent vectors at the base point.
struct Stencil
{
  std::vector<Surface_location> locations;
  std::vector<Vec2> vectors;
};

// Returns the endpoints of straightest paths of equal length in evenly spaced directions, on a
// mesh. Their tangent vectors are exact up to round-off errors. A path that reaches the boundary
// after less than 30 % of the length is omitted. If the remaining vectors are almost parallel, the
// length is halved.
CGAL_GEODESIC_PROCESSING_EXPORT
Stencil straightest_stencil(const Tangent_plane& plane, double length, std::size_t count);

// Returns a stencil of vertices. In each of `count` sectors of the tangent plane, it contains the
// farthest vertex within a distance. The tangent vector has the direction of the projected offset
// and the length of the distance. If the vectors are almost parallel, the length is doubled.
//
// vertices   the candidates
// distances  #vertices: distances of the candidates from the base point
// length     the maximum distance
CGAL_GEODESIC_PROCESSING_EXPORT
Stencil vertex_stencil(const Surface_arrays& triangles, const Tangent_plane& plane,
                       const std::vector<Index>& vertices, const std::vector<double>& distances,
                       double length, std::size_t count);

// Returns the mean length of the edges of the triangles that contain a location.
CGAL_GEODESIC_PROCESSING_EXPORT
double mean_edge_length(const Surface_arrays& triangles, const Surface_location& location);

// Returns the mean angle, in radians, between the vertex normals at the endpoints of these edges.
// It measures curvature relative to the edge lengths, or roughness.
CGAL_GEODESIC_PROCESSING_EXPORT
double mean_normal_angle(const Surface_arrays& triangles, const Surface_location& location);

// Fits tangent vectors to distances (Brun, Westin, Herberthson and Knutsson 2005).
//
// For a base point p and stencil locations with tangent vectors q_j,
//   d^2(q_j, x) - d^2(p, x) - |q_j|^2 = -2 <log x, q_j>
// up to terms of higher order in q_j. In a symmetric stencil, the terms of odd order cancel. The
// direction of log x is the least-squares solution.
class CGAL_GEODESIC_PROCESSING_EXPORT Log_map_fit
{
public:
  explicit Log_map_fit(std::vector<Vec2> stencil);

  // Returns the tangent vector of a point x. Its length is the distance.
  //
  // distance           d(p, x)
  // stencil_distances  #stencil: d(q_j, x); infinite ones are ignored
  //
  // Returns zero if the remaining stencil vectors are almost parallel.
  Vec2 operator()(double distance, const double* stencil_distances) const
  {
    return with_length(gradient(distance, stencil_distances), distance);
  }

  // Returns -1/2 times the fitted gradient of d^2(., x) at the base point. Its length differs from
  // the distance by the error of the fit.
  Vec2 gradient(double distance, const double* stencil_distances) const;

  // Returns the vector of a length in the direction of another one; zero if that is zero.
  static Vec2 with_length(const Vec2& direction, double length);

private:
  std::vector<Vec2> m_stencil;
};

// Returns the tangent vector that the discrete exponential map (Schmidt, Grimm and Wyvill 2006)
// adds for a step from a vertex.
//
// The step is projected to the tangent plane of the vertex and rotated to the plane of the base
// point by the smallest rotation between both normals. The result has the length of the step.
//
// normal  unit normal of the vertex
// step    in space, in the scale of the surface arrays
CGAL_GEODESIC_PROCESSING_EXPORT
Vec2 transported_step(const Tangent_plane& plane, const Vec3& normal, const Vec3& step);

// The defects of a piecewise linear map to the plane.
struct Log_map_defects
{
  std::vector<Index> cut_triangles; // triangles with an edge that is cut, see is_cut()
  std::size_t number_of_flips = 0;  // number of all other triangles with negative orientation
};

// Returns whether a map is discontinuous along an edge: the images of its endpoints are farther
// apart than four times its length. On a sphere, the logarithmic map stretches by this factor at a
// distance of 2.47 radii. At a cut locus, discontinuities are as large as the distance from the
// base point.
inline bool is_cut(const Surface_arrays& triangles, Index h, const Vec2& p, const Vec2& q)
{
  return norm(q - p) > 4. * triangles.length[h];
}

// Finds the defects of a map in the triangles whose corners are all reached.
//
// reached      the vertices that have an image
// coordinates  #vertices: the images; NaN for vertices that are not reached
CGAL_GEODESIC_PROCESSING_EXPORT
Log_map_defects find_map_defects(const Surface_arrays& triangles, const std::vector<Index>& reached,
                                 const std::vector<Vec2>& coordinates);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_LOG_MAP_H
