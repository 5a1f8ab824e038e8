// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FRONT_UPDATES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FRONT_UPDATES_H

#include <CGAL/Geodesic_processing/internal/distances/Front_state.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The update rules of a front. Each propagate_*() relaxes the vertices around a vertex that has
// just become final.

// Relaxes along the edges of the mesh or cloud (Dijkstra's algorithm), in propagate_edges.cpp. A
// planar front on a cloud uses the edges of the proximity graph only.
void propagate_along_edges(Front_state& front, Index vertex);

// Relaxes by straight fronts through triangles with two final corners and through split obtuse
// corners (Kimmel and Sethian 1998), in propagate_planar.cpp.
void propagate_planar(Front_state& front, Index vertex);

// Relaxes by circular fronts on a mesh, in propagate_circular.cpp.
void propagate_circular(Front_state& front, Index vertex);

// Relaxes by circular fronts on a cloud, in propagate_on_cloud.cpp.
void propagate_on_cloud(Front_state& front, Index vertex);

// Computes the direction to the source of a vertex in the triangle of one of its corners. The
// direction is rotated around the vertex from the triangle in which it is stored. The first axis
// of `source` is the halfedge that leaves the corner or, if mirrored, the other edge of the
// triangle at the vertex; its second coordinate is <= 0. Returns false if there is no direction,
// or if the triangle is the one in which it is stored. Also returns false if the triangle is in
// the shadow of the vertex: more than pi from the source.
bool source_direction(const Front_state& front, Index corner, bool is_mirrored, Vec2& source);

// Projects a direction in space onto the tangent plane of a surfel and normalizes it.
Vec2 tangent_coordinates(const Front_state& front, Index vertex, const Vec3& direction);

// Relaxes the vertices on the sources, and the corners of the triangles that contain a piece of a
// source, in front_sources.cpp.
void initialize(Front_state& front, const std::vector<Front_source>& sources);

// Returns the distance at a point of a triangle, in front_distance.cpp: the minimum over the source
// pieces in the triangle, its corners, and the fronts that enter through its edges. Infinity if
// none reaches the point.
double distance_in_front(const Front_state& front, Index triangle,
                         const std::array<double, 3>& barycentric);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FRONT_UPDATES_H
