// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_ARRAYS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_ARRAYS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/spatial_search/Kd_tree.h>
#include <CGAL/Geodesic_processing/internal/mesh/morton_order.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Maximum circumradius of a triangle divided by the smallest radius of its corners. In random
// samples of a plane, 1.5 loses 1 % of the triangles, 2 loses a few, and 2.5 loses triangles along
// the boundary only. Larger values close gaps.
constexpr double max_circumradius_ratio = 2.5;

struct Surfel_options
{
  // The normals of two neighbors differ by less than this angle, in radians; at most pi.
  double maximum_angle = 1.3089969389957472; // 75 degrees
  // If no radii are given, the radius of a surfel is the distance to its neighbor of this rank,
  // divided by sqrt(2).
  unsigned rank = 8;
  // If it is set, normals are unit vectors, points are relative to the origin of this frame, and
  // its scale is used. So arrays are built again from their own points without round-off errors.
  std::optional<Frame> frame;
  unsigned number_of_threads = 1; // does not change the result
  // Called with 0 between the steps of the construction. An exception that it throws cancels it.
  std::function<bool(double)> callback;
};

// The arrays of a cloud, and the maps between the caller's surfels and the vertices of the arrays.
struct Surfel_arrays
{
  Surface_arrays arrays;
  double frame_scale = 1.;            // that of the frame, before lengths are scaled
  std::vector<double> radius;         // #vertices: scaled
  std::vector<Index> internal_vertex; // #surfels: the vertex of each surfel
  std::vector<Index> caller_vertex;   // #vertices: the surfel of each vertex
  // The tree of the first tree.size() vertices. The other vertices are copies of one of these.
  Kd_tree tree;
};

// Computes a proximity graph and local triangles of a cloud of surfels.
//
// points   #surfels: finite coordinates
// normals  #surfels: vectors of any positive length
// radii    #surfels: nonnegative, in the caller's unit; or empty
//
// Two surfels are neighbors if their normals are compatible and the chord between them is nearly
// tangential, see Compatibility_test. So parallel sheets remain separate. If a sharp edge leaves
// a gap in the ring of a surfel, neighbors with steeper chords are used as well.
//
// The graph has two kinds of edges. One is the extended sphere-of-influence graph (Ruggeri, Darom,
// Saupe and Kiryati 2006). It connects two neighbors if their spheres intersect, and if one is
// among the 24 nearest surfels of the other. The other kind is the edges of all triangles. The
// graph is symmetric, and the edges of a vertex are sorted by their targets.
//
// The triangles at a surfel are those of the Delaunay triangulation of the projections of its
// neighbors to its tangent plane. A triangle has weight 1 if all three corners find it, otherwise
// 1/3 for each corner that finds it (Sharp and Crane 2020). Triangles whose circumradius exceeds
// `max_circumradius_ratio` times the smallest radius of their corners are omitted, so that gaps and
// boundaries remain open.
//
// Coincident surfels with compatible normals are represented by one vertex, and its copies are
// connected to it by edges of length zero. Copies have no triangles. Coordinates and lengths are
// scaled by a power of two, such that the longest edge lies in [1, 2).
//
// Throws Invalid_argument_error if the sizes differ, or an option is out of range. It is also
// thrown if a number is not finite, a radius is negative, a normal is zero, or distances overflow.
// Throws Unsupported_surface_error if there are more than 2^25 surfels. O(n log n); the result has
// about 250 bytes per surfel, and the computation needs at most 380.
CGAL_GEODESIC_PROCESSING_EXPORT
Surfel_arrays build_surfel_arrays(std::vector<std::array<double, 3>> points,
                                  std::vector<std::array<double, 3>> normals,
                                  const std::vector<double>& radii = {},
                                  const Surfel_options& options = {});

// A location on a cloud: an offset in the tangent plane of a vertex. Its two components refer to
// the basis of tangent_frame() and are scaled.
struct Tangent_location
{
  Index vertex = none;
  std::array<double, 2> offset = {0., 0.};
};

// Returns the vertex of the tree that is nearest to a point, and the projection of the point to its
// tangent plane. The point is given in the caller's coordinates. The length of the offset is
// clamped to `max_circumradius_ratio` radii, the maximum distance of the circumcenters of its
// triangles. Throws Invalid_argument_error if a coordinate is not finite or the tree is empty.
CGAL_GEODESIC_PROCESSING_EXPORT
Tangent_location locate(const Kd_tree& tree, const std::vector<Vec3>& points,
                        const std::vector<Vec3>& normals, const std::vector<double>& radii,
                        const Frame& frame, const std::array<double, 3>& point);
inline Tangent_location locate(const Surfel_arrays& surfels, const std::array<double, 3>& point)
{
  const Surface_arrays& t = surfels.arrays;
  return locate(surfels.tree, t.point, t.normal, surfels.radius, {t.origin, t.scale}, point);
}

// Converts a location in a tangent plane to a location in a triangle. The triangle is incident to
// the vertex of the location or to one of its neighbors in the graph. All triangles are projected
// to the tangent plane. If none contains the location, returns the closest location on their
// edges. If there are no triangles, or the offset is zero, returns the vertex.
CGAL_GEODESIC_PROCESSING_EXPORT
Surface_location to_surface_location(const Surface_arrays& arrays,
                                     const Tangent_location& location);

// Converts a location in a triangle to the tangent plane of the corner with the largest barycentric
// coordinate.
CGAL_GEODESIC_PROCESSING_EXPORT
Tangent_location to_tangent_location(const Surface_arrays& arrays,
                                     const Surface_location& location);

// Returns the scaled coordinates of a location.
CGAL_GEODESIC_PROCESSING_EXPORT
std::array<double, 3> position(const Surface_arrays& arrays, const Tangent_location& location);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_ARRAYS_H
