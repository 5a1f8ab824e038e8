// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_POLYGON_SOUP_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_POLYGON_SOUP_H

#include <CGAL/Geodesic_processing/Soup_report.h>
#include <CGAL/Geodesic_processing/internal/core/Index.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Polygons that refer to points by their indices.
struct Polygon_soup
{
  std::vector<std::array<double, 3>> points;
  std::vector<Index> corners;                   // of all polygons, concatenated
  std::vector<std::size_t> polygon_begin = {0}; // #polygons + 1
};

struct Soup_options
{
  // Points within this distance, which is at least zero, are merged. If empty, none is.
  std::optional<double> merge_tolerance;
  bool do_remove_degenerate_faces = false;
  unsigned number_of_threads = 1; // the result does not depend on it
  // Called with 0 between the steps of the construction. An exception that it throws cancels it.
  std::function<bool(double)> callback;
};

// A soup after repair: oriented triangles whose halfedges are paired.
struct Repaired_soup
{
  std::vector<Index> corners; // 3 #triangles, indices of points
  std::vector<Index> twins;   // 3 #triangles, the opposite halfedge or none
  std::vector<Index> polygon; // #triangles, the polygon that contains the triangle, increasing
  // #points: the point that replaces each one, which replaces itself; empty if none was replaced
  std::vector<Index> replacement;
  Soup_report report;
};

// Repairs a soup in this order: merges points, triangulates polygons, removes faces that are
// degenerate or duplicates, flips as few triangles as possible for a consistent orientation, and
// splits the surface at edges that have three or more triangles or no consistent orientation.
//
// Throws Invalid_argument_error if a corner is not the index of a point, if a coordinate is not
// finite or if the tolerance is negative. Throws Unsupported_surface_error if a polygon has more
// than 10,000 corners, or if there are more than 2^31 halfedges.
// O(n) for n triangles; O(k^2) for a polygon of k corners.
CGAL_GEODESIC_PROCESSING_EXPORT
Repaired_soup repair_soup(Polygon_soup soup, const Soup_options& options);

// The arrays of the surface of a soup.
struct Soup_arrays
{
  // Vertices are the points that have not been replaced, faces are the triangles. The indices of the
  // caller count only these points.
  Mesh_arrays mesh;
  // #triangles: see Repaired_soup; empty if all polygons are triangles and none was removed
  std::vector<Index> polygon;
  std::vector<Index> replacement; // see Repaired_soup
  Soup_report report;
};

// Returns build_mesh_arrays() of repair_soup(). If the triangles need no repair, the twins are found
// in the sorted triangles, which takes half of the time. Throws the exceptions of both. O(n).
CGAL_GEODESIC_PROCESSING_EXPORT
Soup_arrays build_soup_arrays(Polygon_soup soup, const Soup_options& options);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_POLYGON_SOUP_H
