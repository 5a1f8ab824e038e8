// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TANGENT_PLANE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TANGENT_PLANE_H

#include <CGAL/Geodesic_processing/internal/core/Glued_triangles.h>
#include <CGAL/Geodesic_processing/internal/core/planar.h>
#include <CGAL/Geodesic_processing/internal/core/spatial.h>
#include <CGAL/Geodesic_processing/internal/paths/straightest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The unit normal of a site: the surfel's own, or on a mesh that of the triangles around, weighted by their
// areas; zero where these have none.
CGAL_GEODESIC_PROCESSING_EXPORT
Spatial site_normal(const Glued_triangles& triangles, Index site);

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
  Tangent_plane(const Glued_triangles& triangles, const Location& at);

  // The place, in a triangle, and where it is, scaled.
  const Location& location() const { return m_at; }
  const Spatial& point() const { return m_point; }

  // The unit vectors in space at the tangent angles 0 and pi / 2; around a site that is no plane, such
  // that its sides are at their own angles in the mean.
  const Spatial& x() const { return m_x; }
  const Spatial& y() const { return m_y; }
  Spatial normal() const { return cross(m_x, m_y); }
  Spatial direction(double tangent_angle) const
  {
    return std::cos(tangent_angle) * m_x + std::sin(tangent_angle) * m_y;
  }

  // Up to which tangent angle there is a surface: 2 pi but at a border.
  double opening() const { return m_stretch * m_whole; }

  // Of a polar angle, and of the part of a direction in space that lies in the plane.
  // The second throws Invalid_argument_error when there is none.
  double tangent_angle(double polar_angle) const { return m_stretch * polar_angle; }
  double tangent_angle(const Spatial& direction) const;

  // The straightest path in a direction; on a mesh.
  Straightest_path straight(double tangent_angle, double length) const;

private:
  void set_axes(const std::vector<std::pair<double, Spatial>>& sides, const Spatial& normal);

  const Glued_triangles& m_triangles;
  Location m_at;
  Spatial m_point, m_x, m_y;
  double m_whole = 2. * pi, m_stretch = 1.;
  // Where each triangle around begins: a side that leaves the place, or has it inside, and its polar
  // angle; empty inside of a triangle.
  std::vector<std::pair<Index, double>> m_sides;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TANGENT_PLANE_H
