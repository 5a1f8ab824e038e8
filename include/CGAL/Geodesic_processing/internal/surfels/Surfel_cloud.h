// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_CLOUD_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_CLOUD_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/spatial_search/Kd_tree.h>
#include <CGAL/Geodesic_processing/internal/mesh/morton_order.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_neighbors.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_variants.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

struct Surfel_cloud_options
{
  Surfel_graph graph = Surfel_graph::extended_spheres;
  std::size_t neighbors =
      20; // number of nearest surfels that are candidates for the edges of a surfel
  // The normals of two neighbors differ by less than this angle. It admits edges across the
  // creases of a cube, and excludes edges through a thin sheet.
  double maximum_angle = 1.7453292519943295; // 100 degrees
  // If no radii are given, the radius of a surfel is the distance to its neighbor of this rank,
  // divided by sqrt(2).
  std::size_t rank = 8;
  // The radius of the spheres of influence divided by the radius of the surfel. On a square
  // lattice, sqrt(2) yields edges in 16 directions, whose shortest paths are at most 2.7 % too
  // long. A ratio of 1 yields 8 directions and 8 %.
  double influence_ratio = 1.4142135623730951;
  unsigned number_of_threads = 1; // does not change the result
};

// A cloud of surfels in the order of its kd-tree, with a proximity graph. Paths on clouds use it.
struct Surfel_cloud : Sorted_surfels
{
  std::vector<double> radius;        // #vertices: scaled
  std::vector<double> spacing;       // #vertices: distance to the sixth nearest vertex
  std::vector<double> search_radius; // #vertices: all vertices within this distance were candidates
  Proximity_graph graph;             // symmetric; without lengths
  std::vector<Index> component;      // #vertices: 0 .. number_of_components - 1
  Index number_of_components = 0;

  std::size_t number_of_vertices() const { return point.size(); }
};

// Builds a cloud and its proximity graph.
//
// points   #surfels: finite coordinates
// normals  #surfels: vectors of any positive length
// radii    #surfels: nonnegative, in the caller's unit; or empty
// frame    if not null, the coordinates are scaled by this frame instead of the frame of the
//          points; so two similar clouds can have the same coordinates
//
// Coincident surfels with compatible normals become one vertex. Edges connect a surfel only to its
// `options.neighbors` nearest surfels. The types of graphs are:
//   extended_spheres  edges between compatible surfels whose spheres of influence intersect; the
//                     radius of a sphere is `influence_ratio` times the radius of the surfel
//                     (Ruggeri, Darom, Saupe and Kiryati 2006)
//   spheres           edges between surfels whose spheres intersect; the radius of a sphere is the
//                     distance to the nearest surfel; normals are ignored (Klein and Zachmann 2004)
//   nearest           edges to all `neighbors` nearest surfels; normals are ignored (ditto)
//
// Throws the exceptions of build_surfel_arrays(). O(n log n).
CGAL_GEODESIC_PROCESSING_EXPORT
Surfel_cloud make_cloud(std::vector<Vec3> points, std::vector<Vec3> normals,
                        const std::vector<double>& radii = {},
                        const Surfel_cloud_options& options = {}, const Frame* frame = nullptr);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_CLOUD_H
