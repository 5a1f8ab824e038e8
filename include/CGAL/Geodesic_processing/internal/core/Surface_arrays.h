// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_SURFACE_ARRAYS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_SURFACE_ARRAYS_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Sites 0..n-1 and the arcs that leave each; those of v are first[v] .. first[v+1]-1.
struct Proximity_graph
{
  std::vector<Index> begin;   // #sites + 1
  std::vector<Index> target;  // #arcs
  std::vector<double> length; // #arcs, finite, not negative; or empty: that between the sites
};

// Minimum length of an edge, for surfaces whose extent is about one.  Shorter edges are set to it:
// across an edge of length zero no direction is defined.  Far below every tolerance of distances,
// far above the round-off errors of coordinates.
inline constexpr double min_edge_length = 0x1p-36;

struct Vertex_fans;

// What fronts over the same triangles share as long as one of them lives: see spokes.h.  Copies of
// triangles, whose lengths may be changed, share nothing.
struct Shared_vertex_fans
{
  Shared_vertex_fans() = default;
  Shared_vertex_fans(const Shared_vertex_fans&) {}
  Shared_vertex_fans& operator=(const Shared_vertex_fans&)
  {
    cached = {};
    return *this;
  }

  std::mutex mutex;
  std::array<std::weak_ptr<const Vertex_fans>, 2> cached; // without splits, and with them
};

// Triangles, how they are glued, and how long their sides are: all that intrinsic algorithms need.
//
// On a mesh every side has at most one twin, corners turn counterclockwise around each site, and
// the site graph is left empty because the sides are its arcs.  On a surfel cloud the triangles
// overlap: each has a weight, an edge may carry more than two of them, and nothing is glued.
struct Surface_arrays
{
  std::vector<Index> corner;     // 3 #triangles: the site at each corner
  std::vector<Index> twin;       // 3 #triangles: the opposite side or none; empty on a cloud
  std::vector<double> length;    // 3 #triangles: of each side, the longest one of all in [1, 2)
  std::vector<Index> ring_begin; // #sites + 1: where the star of each site begins in `star`
  std::vector<Index> ring;       // 3 #triangles: corners around each site; on a mesh each fan in
      //   counterclockwise order, fans of pinched sites one after another
  std::vector<float> weight; // #triangles in (0, 1]; empty on a mesh, where all weigh 1
  Proximity_graph graph;     // arcs between surfels; empty on a mesh
  std::vector<std::array<double, 3>> point;  // #sites: scaled coordinates; may be empty
  std::vector<std::array<double, 3>> normal; // #sites: unit normals; empty on a mesh

  // What a caller's length is divided by to become one of ours: a power of two.
  double scale = 1.;
  std::array<double, 3> origin = {0., 0., 0.}; // caller's coordinates = origin + scale * point

  mutable Shared_vertex_fans vertex_fans;

  std::size_t number_of_vertices() const { return ring_begin.empty() ? 0 : ring_begin.size() - 1; }
  std::size_t number_of_triangles() const { return corner.size() / 3; }
  bool is_cloud() const { return !graph.begin.empty(); }
};

// A location on the domain: in a triangle, or at a site (triangle == none; sites without triangles
// can only be given so).  Barycentric coordinates follow the corners and sum to one.
struct Surface_location
{
  Index triangle = none;
  Index vertex = none;
  std::array<double, 3> barycentric = {1., 0., 0.};
};

// Where a front starts: a polyline of one or more locations, consecutive ones in a common triangle.
struct Front_source
{
  std::vector<Surface_location> polyline; // one location: a point source
  double offset = 0.;                     // distance at the source, in the domain's scale
  Index label = 0;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_SURFACE_ARRAYS_H
