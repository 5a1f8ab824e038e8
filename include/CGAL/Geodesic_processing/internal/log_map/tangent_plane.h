// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_TANGENT_PLANE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_TANGENT_PLANE_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include <CGAL/Geodesic_processing/internal/paths/trace_straightest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The unit normal of a site: the surfel's own, or on a mesh that of the triangles around, weighted by their
// areas; zero where these have none.
CGAL_GEODESIC_PROCESSING_EXPORT
Vec3 vertex_normal(const Surface_arrays& triangles, Index vertex);

// The directions in which a surface leaves a place.
//
// A polar angle is the angle on the surface, as of a Departure: counterclockwise, around a site from the
// side that leaves the first corner of its star, on a side from the one of its two that comes first,
// and inside of a triangle from its side 0.  Around a site inside of the surface all of them need
// not be 2 pi; stretched to 2 pi they are the angles of tangent vectors.  At a border they are not
// stretched, but pressed where they are more than 2 pi.
//
// On a cloud, angles are those in the plane of the nearest surfel, from the first axis of its frame.
class CGAL_GEODESIC_PROCESSING_EXPORT Tangent_plane
{
public:
  // The triangles stay with the caller.
  // Throws Invalid_argument_error at a site without triangles.
  Tangent_plane(const Surface_arrays& triangles, const Surface_location& location);

  // The place, in a triangle, and where it is, scaled.
  const Surface_location& location() const { return m_location; }
  const Vec3& point() const { return m_point; }

  // The unit vectors in space at the tangent angles 0 and pi / 2; around a site that is no plane, such
  // that its sides are at their own angles in the mean.
  const Vec3& x() const { return m_x; }
  const Vec3& y() const { return m_y; }
  Vec3 normal() const { return cross(m_x, m_y); }
  Vec3 direction(double tangent_angle) const
  {
    return std::cos(tangent_angle) * m_x + std::sin(tangent_angle) * m_y;
  }

  // Up to which tangent angle there is a surface: 2 pi but at a border.
  double total_angle() const { return m_angle_scale * m_total_polar_angle; }

  // Of a polar angle, and of the part of a direction in space that lies in the plane.
  // The second throws Invalid_argument_error when there is none.
  double tangent_angle(double polar_angle) const { return m_angle_scale * polar_angle; }
  double tangent_angle(const Vec3& direction) const;

  // The straightest path in a direction; on a mesh.
  Straightest_path straightest_path(double tangent_angle, double length) const;

private:
  void set_axes(const std::vector<std::pair<double, Vec3>>& directions, const Vec3& normal);

  const Surface_arrays& m_triangles;
  Surface_location m_location;
  Vec3 m_point, m_x, m_y;
  double m_total_polar_angle = 2. * pi, m_angle_scale = 1.;
  // Where each triangle around begins: a side that leaves the place, or has it inside, and its polar
  // angle; empty inside of a triangle.
  std::vector<std::pair<Index, double>> m_sectors;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_TANGENT_PLANE_H
