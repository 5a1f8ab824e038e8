// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DIVIDED_MESH_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DIVIDED_MESH_H

#include <CGAL/Geodesic_processing/internal/core/Glued_triangles.h>
#include <CGAL/Geodesic_processing/internal/core/spatial.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The coordinates of p in a part of a triangle that has these corners, all in the triangle's own; minus
// infinity in one without area.
CGAL_GEODESIC_PROCESSING_EXPORT
std::array<double, 3> coordinates_in_part(const std::array<std::array<double, 3>, 3>& corner,
                                          const std::array<double, 3>& p);

// A mesh while lines are drawn on it, each of which divides the triangles that it crosses.  Sides have
// labels: that of the line that they are a part of.
class CGAL_GEODESIC_PROCESSING_EXPORT Divided_mesh
{
public:
  // Of a side: how far new sites keep off its ends.  A tenth of it makes needles of a hundred to one
  // where paths pass a site, and a tenfold of it kinks that can be seen.
  static constexpr double margin = 0.005;
  // The label of sides on curves, until they get another one.
  static constexpr Index curve = none - 1;

  // coarse    with points; must live as long as this
  // is_curve  #sides, twins alike
  // Where fans of triangles meet in a site only, each but the first gets a new one.
  Divided_mesh(const Glued_triangles& coarse, const std::vector<bool>& is_curve);

  // Without lengths and stars.
  const Glued_triangles& triangles() const { return m_t; }
  // #sides
  const std::vector<Index>& labels() const { return m_label; }
  // #triangles: the triangle of the mesh that each is a part of
  const std::vector<Index>& wholes() const { return m_whole; }
  // #sites: where they are in the mesh, clean
  const std::vector<Location>& locations() const { return m_location; }

  Index source(Index side) const { return m_t.corner[side]; }
  Index target(Index side) const { return m_t.corner[next_side(side)]; }
  Index apex(Index side) const { return m_t.corner[previous_side(side)]; }
  // The smaller one of it and its twin.
  Index first(Index side) const { return std::min(side, m_t.twin[side]); }
  double length(Index side) const { return between(source(side), target(side)); }
  double between(Index p, Index q) const { return norm(m_t.point[p] - m_t.point[q]); }
  double angle_at(Index corner) const;
  // Of a site in the triangle of the mesh that a triangle is a part of.
  std::array<double, 3> barycentric(Index triangle, Index site) const;

  // The corners around a site, counterclockwise, from the border on where there is one.
  std::vector<Index> corners_around(Index site) const;
  // Sides that end or begin at a site, one of each pair of twins.
  std::vector<Index> sides_around(Index site) const;

  // Of a side and its twin.
  void set_label(Index side, Index label);

  // A new site on a side u v of triangles u v w and v u x, which become u p w and v p x, and, with the
  // next two numbers, p v w and p u x.
  Index split_side(Index side, double share);

  // The site of a sample: a new one, or that which is near, unless the sample would change sides of a
  // curve.  No two samples get the same.
  Index insert(const Location& sample);

private:
  using Barycentric = std::array<double, 3>;

  void take_apart_pinched_sites();
  bool touches_curve(Index site) const;
  bool is_taken(Index site) const { return site < m_is_taken.size() && m_is_taken[site]; }
  Index take(Index site);
  void glue(Index side, Index twin);
  Index add_site(const Spatial& point, const Location& location);
  Index add_triangle(Index whole);
  void move(Index from, Index to);
  Index halve(Index side, Index p);
  Index split_triangle(Index f, const Barycentric& b);
  Barycentric coordinates_in(Index f, const Barycentric& b) const;

  const Glued_triangles& m_coarse;
  Glued_triangles m_t;
  std::vector<Index> m_label; // #sides: the line that it is a part of, or none
  std::vector<Index> m_whole;
  std::vector<Location> m_location;
  std::vector<Index> m_corner_of; // #sites: one of its corners, or none
  std::vector<bool> m_is_taken;
  std::map<Index, std::vector<Index>> m_parts; // of a triangle of the mesh, without itself
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DIVIDED_MESH_H
