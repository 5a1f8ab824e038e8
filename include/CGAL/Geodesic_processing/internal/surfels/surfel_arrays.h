// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_ARRAYS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_ARRAYS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/spatial_search/Kd_tree.h>
#include <CGAL/Geodesic_processing/internal/mesh/morton_order.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Largest circumradius of a triangle, in the smallest radius of its corners.  With 1.5 one triangle
// in a hundred is missing from random samples of a plane, with 2 some are, with 2.5 none but along
// the border; larger ones bridge gaps.
constexpr double max_circumradius_ratio = 2.5;

struct Surfel_options
{
  // Surfels are neighbours only where their normals differ by less than this, radians below pi.
  double maximum_angle = 1.3089969389957472; // 75 degrees
  // The radius of a surfel, where none is given, is the distance to its neighbour of this rank
  // divided by sqrt(2).
  unsigned rank = 8;
  unsigned threads = 1; // changes nothing but the time
};

// A cloud as a domain, and the way back to the caller's numbers.
struct Surfel_arrays
{
  Surface_arrays arrays;
  std::vector<double> radius;         // #sites, scaled
  std::vector<Index> internal_vertex; // #surfels
  std::vector<Index> caller_vertex;   // #sites
  // Over the first tree.size() sites; those behind are copies of one of them.
  Kd_tree tree;
};

// Arcs and local triangles of a cloud of surfels.
//
// points   #surfels, finite; normals  #surfels, of any positive length;
// radii    #surfels, not negative, in the caller's unit; or empty.
//
// Neighbours: surfels whose normals agree, and whose chord hardly leaves their tangent planes: so
// that parallel sheets stay apart although their normals agree.  Where a sharp edge leaves a gap in
// the star of a surfel, steeper chords are taken as well.
//
// Arcs: the extended sphere-of-influence graph of Ruggeri, Darom, Saupe and Kiryati 2006 (two
// neighbours whose spheres meet), of which each surfel looks at its 24 nearest surfels only, and
// the sides of all triangles.  Symmetric; the arcs of a site in the order of their ends.
//
// Triangles: those that the Delaunay triangulation of its neighbours' projections to its tangent
// plane has at a surfel.  One found from its three corners weighs 1, else 1/3 for each that found
// it (Sharp and Crane 2020).  Triangles whose circumradius exceeds 2.5 times the smallest radius of
// their corners are left out: gaps and borders stay open.
//
// Surfels at one point with agreeing normals are one site with arcs of length zero to its copies,
// which have no triangles.  Sides and arcs are scaled by a power of two such that the longest of
// them all lies in [1, 2).
//
// Throws Invalid_argument_error when sizes differ, a coordinate or a radius is not finite, a radius
// is negative, a normal has no direction, or distances overflow; Unsupported_surface_error above
// 2^25 surfels.
// O(n log n); keeps about 400 bytes per surfel and needs as many more while it runs.
CGAL_GEODESIC_PROCESSING_EXPORT
Surfel_arrays build_surfel_arrays(std::vector<std::array<double, 3>> points,
                                  std::vector<std::array<double, 3>> normals,
                                  const std::vector<double>& radii = {},
                                  const Surfel_options& options = {});

// A location on a cloud: a place in the tangent plane of a site, in the frame of tangent_frame()
// and the domain's scale.
struct Tangent_location
{
  Index vertex = none;
  std::array<double, 2> offset = {0., 0.};
};

// The site nearest to a point in the caller's coordinates, and the point's projection to its
// tangent plane, at most 2.5 radii from the site: as far as its triangles' circumcentres may be.
// Sites behind those of the tree are not looked at.
// Throws Invalid_argument_error when a coordinate is not finite or there is no site.
CGAL_GEODESIC_PROCESSING_EXPORT
Tangent_location locate(const Kd_tree& tree, const std::vector<Vec3>& points,
                        const std::vector<Vec3>& normals, const std::vector<double>& radii,
                        const Frame& frame, const std::array<double, 3>& point);
inline Tangent_location locate(const Surfel_arrays& surfels, const std::array<double, 3>& point)
{
  const Surface_arrays& t = surfels.arrays;
  return locate(surfels.tree, t.point, t.normal, surfels.radius, {t.origin, t.scale}, point);
}

// The same place in a triangle at the site or at a neighbour of it, or the site itself where there
// are none.  Outside of these triangles: the nearest place on one of them, measured in the tangent
// plane.
CGAL_GEODESIC_PROCESSING_EXPORT
Surface_location to_surface_location(const Surface_arrays& arrays,
                                     const Tangent_location& location);

// The same place in the tangent plane of the corner with the largest barycentric coordinate.
CGAL_GEODESIC_PROCESSING_EXPORT
Tangent_location to_tangent_location(const Surface_arrays& arrays,
                                     const Surface_location& location);

// Scaled coordinates of a location.
CGAL_GEODESIC_PROCESSING_EXPORT
std::array<double, 3> position(const Surface_arrays& arrays, const Tangent_location& location);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_ARRAYS_H
