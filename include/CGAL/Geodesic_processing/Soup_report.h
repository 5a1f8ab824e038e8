// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_SOUP_REPORT_H
#define CGAL_GEODESIC_PROCESSING_SOUP_REPORT_H

#include <cstddef>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingDomain
///
/// Contains what `make_domain()` changed in a polygon soup, and the topology of the surface that
/// resulted. All members are numbers.
struct Soup_report
{
  /// Points that were replaced by an earlier point within `merge_tolerance`
  std::size_t number_of_merged_points = 0;
  /// Polygons with more than three corners, which were divided into triangles
  std::size_t number_of_triangulated_polygons = 0;
  /// Polygons that were removed because they have fewer than three distinct corners, and triangles
  /// without area if `do_remove_degenerate_faces` is true
  std::size_t number_of_degenerate_faces = 0;
  /// Triangles that were removed because an earlier one has the same corners in the same cyclic
  /// order. Polygons with more corners were divided before; their duplicates are found if they are
  /// divided by the same diagonals, which is certain if they begin with the same corner
  std::size_t number_of_duplicate_triangles = 0;
  /// Triangles without area in double precision that remain
  std::size_t number_of_triangles_without_area = 0;
  /// Triangles whose orientation was reversed
  std::size_t number_of_reversed_triangles = 0;
  /// Edges at which the surface was split: those of three or more triangles, and those in which a
  /// nonorientable surface meets itself
  std::size_t number_of_split_edges = 0;
  /// Points at which several fans of triangles meet
  std::size_t number_of_nonmanifold_points = 0;
  /// Components of triangles that are connected by edges, after the surface was split at edges
  std::size_t number_of_components = 0;
  /// Cycles of boundary edges, after the surface was split at edges and points
  std::size_t number_of_boundary_cycles = 0;
  /// The sum of the genera of all components, after the surface was split
  std::size_t genus = 0;

  /// Returns whether the triangles differ from the polygons of the soup. O(1).
  bool is_changed() const
  {
    return number_of_merged_points > 0 || number_of_triangulated_polygons > 0 ||
           number_of_degenerate_faces > 0 || number_of_duplicate_triangles > 0 ||
           number_of_reversed_triangles > 0 || number_of_split_edges > 0;
  }
  /// Returns whether the surface is a manifold without a split. O(1).
  bool is_manifold() const
  {
    return number_of_split_edges == 0 && number_of_nonmanifold_points == 0;
  }
};

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_SOUP_REPORT_H
