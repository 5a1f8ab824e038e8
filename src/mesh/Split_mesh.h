// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_SPLIT_MESH_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_SPLIT_MESH_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The coordinates of p in a part of a triangle that has these corners, all in the triangle's own; minus
// infinity in one without area.
CGAL_GEODESIC_PROCESSING_EXPORT
std::array<double, 3> subtriangle_coordinates(const std::array<std::array<double, 3>, 3>& corner,
                                              const std::array<double, 3>& p);

// A mesh while lines are drawn on it, each of which divides the triangles that it crosses.  Sides have
// labels: that of the line that they are a part of.
class CGAL_GEODESIC_PROCESSING_EXPORT Split_mesh
{
public:
  // Of a side: how far new sites keep off its ends.  A tenth of it makes needles of a hundred to one
  // where paths pass a site, and a tenfold of it kinks that can be seen.
  static constexpr double min_split_fraction = 0.005;
  // The label of sides on curves, until they get another one.
  static constexpr Index curve_label = none - 1;

  // coarse    with points; must live as long as this
  // is_curve  #sides, twins alike
  // Where fans of triangles meet in a site only, each but the first gets a new one.
  Split_mesh(const Surface_arrays& coarse, const std::vector<bool>& is_curve);

  // Without lengths and stars.
  const Surface_arrays& triangles() const { return m_arrays; }
  // #sides
  const std::vector<Index>& labels() const { return m_label; }
  // #triangles: the triangle of the mesh that each is a part of
  const std::vector<Index>& coarse_triangles() const { return m_coarse_triangle; }
  // #sites: where they are in the mesh, clean
  const std::vector<Surface_location>& locations() const { return m_location; }

  Index source(Index h) const { return m_arrays.corner[h]; }
  Index target(Index h) const { return m_arrays.corner[next_halfedge(h)]; }
  Index apex(Index h) const { return m_arrays.corner[previous_halfedge(h)]; }
  // The smaller one of it and its twin.
  Index smaller_twin(Index h) const { return std::min(h, m_arrays.twin[h]); }
  double length(Index h) const { return distance_between(source(h), target(h)); }
  double distance_between(Index p, Index q) const
  {
    return norm(m_arrays.point[p] - m_arrays.point[q]);
  }
  double angle_at(Index corner) const;
  // Of a site in the triangle of the mesh that a triangle is a part of.
  std::array<double, 3> barycentric(Index triangle, Index vertex) const;

  // The corners around a site, counterclockwise, from the border on where there is one.
  std::vector<Index> corners_around(Index vertex) const;
  // Sides that end or begin at a site, one of each pair of twins.
  std::vector<Index> halfedges_around(Index vertex) const;

  // Of a side and its twin.
  void set_label(Index h, Index label);

  // A new site on a side u v of triangles u v w and v u x, which become u p w and v p x, and, with the
  // next two numbers, p v w and p u x.
  Index split_edge(Index h, double fraction);

  // The site of a sample: a new one, or that which is near, unless the sample would change sides of a
  // curve.  No two samples get the same.
  Index insert(const Surface_location& sample);

private:
  using Barycentric = std::array<double, 3>;

  void split_nonmanifold_vertices();
  bool is_on_curve(Index vertex) const;
  bool is_sample(Index vertex) const { return vertex < m_is_sample.size() && m_is_sample[vertex]; }
  Index mark_sample(Index vertex);
  void set_twins(Index h, Index twin);
  Index add_vertex(const Vec3& point, const Surface_location& location);
  Index add_triangle(Index coarse_triangle);
  void move_halfedge(Index from, Index to);
  Index split_halfedge(Index h, Index p);
  Index split_triangle(Index f, const Barycentric& b);
  Barycentric coordinates_in_subtriangle(Index f, const Barycentric& b) const;

  const Surface_arrays& m_coarse;
  Surface_arrays m_arrays;
  std::vector<Index> m_label; // #sides: the line that it is a part of, or none
  std::vector<Index> m_coarse_triangle;
  std::vector<Surface_location> m_location;
  std::vector<Index> m_corner_of; // #sites: one of its corners, or none
  std::vector<bool> m_is_sample;
  std::map<Index, std::vector<Index>> m_subtriangles; // of a triangle of the mesh, without itself
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_SPLIT_MESH_H
