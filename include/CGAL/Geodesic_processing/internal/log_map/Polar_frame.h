// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_POLAR_FRAME_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_POLAR_FRAME_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/log_map/cone_descent.h>
#include <CGAL/Geodesic_processing/internal/paths/trace_straightest.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The directions at a location of a mesh, by polar angles as those of Departure::polar_angle. They
// are not scaled: at a vertex their range is the sum of the angles of its triangles.
class CGAL_GEODESIC_PROCESSING_EXPORT Polar_frame
{
public:
  Polar_frame(const Surface_arrays& triangles, const Surface_location& location);

  const Surface_location& location() const { return m_location; } // canonical
  Index vertex() const { return m_vertex; }                       // none if not at a vertex
  // Returns the intervals of directions; none at a vertex without triangles.
  const std::vector<Direction_fan>& fans() const { return m_fans; }

  // Returns the straightest geodesic in a direction.
  Straightest_path path(double polar_angle, double length) const;
  // Returns the polar angle of a direction in the layout of the location's triangle; not at a
  // vertex.
  double polar_angle(double angle_in_triangle) const;

private:
  double angle_of_halfedge(Index h) const;

  const Surface_arrays* m_triangles;
  Surface_location m_location;
  Index m_vertex;
  // On an edge, the polar angle of the first axis of the triangle's layout; otherwise 0.
  double m_axis = 0.;
  std::vector<Direction_fan> m_fans;
  std::vector<Index> m_first_corners; // #fans, at a vertex
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_POLAR_FRAME_H
