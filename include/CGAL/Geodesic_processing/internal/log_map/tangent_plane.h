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

// Returns the unit normal of a vertex. On a cloud, it is the surfel's normal. On a mesh, it is
// the area-weighted average of the incident triangles' normals, or zero if these have no area.
CGAL_GEODESIC_PROCESSING_EXPORT
Vec3 vertex_normal(const Surface_arrays& triangles, Index vertex);

// The tangent plane at a location: converts between angles on the surface, angles in the plane, and
// directions in space.
//
// Polar angles are angles on the surface, as in Departure. They are counterclockwise:
// - at a vertex, from the halfedge of the first corner of its one-ring;
// - on an edge, from its halfedge with the smaller index;
// - inside a triangle, from its halfedge 0.
//
// The total polar angle at an interior vertex can differ from 2 pi. Polar angles are scaled such
// that it becomes 2 pi; the results are the angles of tangent vectors. At a boundary vertex, they
// are scaled only if the total exceeds 2 pi.
//
// On a cloud, angles are measured in the plane of the closest surfel, from the first axis of its
// frame.
class CGAL_GEODESIC_PROCESSING_EXPORT Tangent_plane
{
public:
  // Keeps a reference to the triangles.
  // Throws Invalid_argument_error at an isolated vertex of a mesh.
  Tangent_plane(const Surface_arrays& triangles, const Surface_location& location);

  // Return the canonical location, and its position in the scale of the surface arrays.
  const Surface_location& location() const { return m_location; }
  const Vec3& point() const { return m_point; }

  // Return the unit vectors in space at the tangent angles 0 and pi / 2. At a vertex, the frame is
  // rotated such that the projected edges have their tangent angles on average.
  const Vec3& x() const { return m_x; }
  const Vec3& y() const { return m_y; }
  Vec3 normal() const { return cross(m_x, m_y); }
  Vec3 direction(double tangent_angle) const
  {
    return std::cos(tangent_angle) * m_x + std::sin(tangent_angle) * m_y;
  }

  // Returns the maximum tangent angle: 2 pi, or less on the boundary.
  double total_angle() const { return m_angle_scale * m_total_polar_angle; }

  // Return the tangent angle of a polar angle, and that of a direction in space, which is projected
  // to the plane. The second throws Invalid_argument_error if the direction is zero, not finite or
  // normal to the plane.
  double tangent_angle(double polar_angle) const { return m_angle_scale * polar_angle; }
  double tangent_angle(const Vec3& direction) const;

  // Traces the straightest path in a direction, on a mesh. If the angle exceeds the total angle,
  // the path has length zero and ends at the boundary.
  Straightest_path straightest_path(double tangent_angle, double length) const;

private:
  void initialize_on_cloud(Index vertex);
  void initialize_at_vertex(Index vertex);
  void initialize_on_edge(Index h);
  void set_axes(const std::vector<std::pair<double, Vec3>>& directions, const Vec3& normal);

  const Surface_arrays& m_triangles;
  Surface_location m_location;
  Vec3 m_point, m_x, m_y;
  double m_total_polar_angle = 2. * pi, m_angle_scale = 1.;
  // The incident triangles of a vertex or an edge, counterclockwise: the first halfedge of each and
  // its polar angle. Empty inside a triangle.
  std::vector<std::pair<Index, double>> m_sectors;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_TANGENT_PLANE_H
