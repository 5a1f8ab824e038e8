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
  std::size_t neighbors = 20; // how many of its nearest surfels each looks at, or is joined to
  // Neighbours have normals that differ by less: across the edges of a cube, not through a sheet.
  double maximum_angle = 1.7453292519943295; // 100 degrees
  // The radius of a surfel, where none is given, is the distance to its neighbour of this rank
  // divided by sqrt(2).
  std::size_t rank = 8;
  // Of the spheres of influence, in radii: those of a lattice then meet in sixteen directions, in which
  // chains are 2.7 % too long at most; with 1 in eight, 8 %.
  double influence_ratio = 1.4142135623730951;
  unsigned threads = 1; // changes nothing but the time
};

// Surfels in the order of their kd-tree, and a proximity graph: what paths on a cloud need.
struct Surfel_cloud : Sorted_surfels
{
  std::vector<double> radius;        // #sites
  std::vector<double> spacing;       // #sites: the distance to the sixth nearest site
  std::vector<double> search_radius; // #sites: that up to which all sites have been looked at
  Proximity_graph graph;             // symmetric; without lengths
  std::vector<Index> component;      // #sites: 0 .. number_of_components - 1
  Index number_of_components = 0;

  std::size_t number_of_vertices() const { return point.size(); }
};

// Reads a cloud.
//
// points   #surfels, finite; normals  #surfels, of any positive length;
// radii    #surfels, not negative, in the caller's unit; or empty.
//
// Surfels at one point with agreeing normals are one site.  The graph is one of
//   extended_spheres  two surfels whose spheres of influence, of their radii, meet, and which are
//                     neighbours by their normals (Ruggeri, Darom, Saupe and Kiryati 2006)
//   spheres           the radius is the distance to the nearest surfel; normals do not count
//   nearest           each surfel and its nearest ones; normals do not count
// (Klein and Zachmann 2004 for the last two), where each surfel looks at its nearest ones only.
//
// A frame may be given, of a cloud that is hardly another one, to have both in one.
//
// Throws as build_surfel_arrays().  O(n log n).
CGAL_GEODESIC_PROCESSING_EXPORT
Surfel_cloud make_cloud(std::vector<Vec3> points, std::vector<Vec3> normals,
                        const std::vector<double>& radii = {},
                        const Surfel_cloud_options& options = {}, const Frame* frame = nullptr);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_CLOUD_H
