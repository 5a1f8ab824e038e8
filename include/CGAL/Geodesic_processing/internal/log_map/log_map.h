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

// Places around a place, and the tangent vectors that lead to them.
struct Stencil
{
  std::vector<Surface_location> locations;
  std::vector<Vec2> vectors;
};

// The ends of straightest paths of one length in evenly spread directions: on a mesh the tangent
// vectors are known to rounding.  Those that meet a border soon are left out; where less than two
// directions are left, the length is halved.
CGAL_GEODESIC_PROCESSING_EXPORT
Stencil straightest_stencil(const Tangent_plane& plane, double length, std::size_t count);

// Of surfels, or of other sites whose distances are known: in each of evenly spread directions the
// farthest one up to a length, at its distance.  The length is doubled where less than two directions
// have one.
//
// distances  #sites, from the place; sites  those to choose among
CGAL_GEODESIC_PROCESSING_EXPORT
Stencil vertex_stencil(const Surface_arrays& triangles, const Tangent_plane& plane,
                       const std::vector<Index>& vertices, const std::vector<double>& distances,
                       double length, std::size_t count);

// The mean length of the sides around a place.
CGAL_GEODESIC_PROCESSING_EXPORT
double mean_edge_length(const Surface_arrays& triangles, const Surface_location& location);

// The mean angle between the normals at the ends of these sides: how far they are from flat, or how rough.
CGAL_GEODESIC_PROCESSING_EXPORT
double mean_normal_angle(const Surface_arrays& triangles, const Surface_location& location);

// Tangent vectors from distances (Brun, Westin, Herberthson and Knutsson 2005): of the place p and
// of the stencil q_j, the squares d^2(q_j, x) - d^2(p, x) - |q_j|^2 are -2 <log x, q_j> but for terms
// of higher order in q_j, the odd ones of which a stencil that is symmetric does not see.
class CGAL_GEODESIC_PROCESSING_EXPORT Log_map_fit
{
public:
  explicit Log_map_fit(std::vector<Vec2> stencil);

  // As long as `distance` says.  Of the distances from the stencil those that are infinite do not count;
  // zero where they leave no direction.
  Vec2 operator()(double distance, const double* stencil_distances) const;

private:
  std::vector<Vec2> m_stencil;
};

// What the discrete exponential map (Schmidt, Grimm and Wyvill 2006) adds for a step from a site with
// a normal: the step, laid into the site's own plane at its full length, which the least rotation between
// the normals takes to the plane of the base.
CGAL_GEODESIC_PROCESSING_EXPORT
Vec2 transported_step(const Tangent_plane& plane, const Vec3& normal, const Vec3& step);

// What a map of sites to the plane does to triangles.
struct Log_map_defects
{
  std::vector<Index> cut_triangles; // across which the map jumps
  std::size_t number_of_folded = 0; // of the others, those turned round
};

// Whether a map jumps along a side: the images of its ends are four times as far apart as it is long.  On a
// sphere the map stretches as much 2.47 radii away from its base, and jumps behind a cut locus are as
// large as the distance.
inline bool is_cut(const Surface_arrays& triangles, Index h, const Vec2& p, const Vec2& q)
{
  return norm(q - p) > 4. * triangles.length[h];
}

// Looks at the triangles all of whose corners have been reached.
//
// reached  sites; coordinates  #sites, those of the others are not a number
CGAL_GEODESIC_PROCESSING_EXPORT
Log_map_defects find_map_defects(const Surface_arrays& triangles, const std::vector<Index>& reached,
                                 const std::vector<Vec2>& coordinates);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_LOG_MAP_H
