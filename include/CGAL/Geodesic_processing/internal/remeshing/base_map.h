// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_BASE_MAP_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_BASE_MAP_H

#include <CGAL/Geodesic_processing/internal/remeshing/base_mesh.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Barycentric coordinates of vertices inside a base triangle. Vertices on its edges are
// parameterized by arc length.
enum class Base_coordinates
{
  heron,      // areas of planar triangles whose edge lengths are geodesic distances to the corners
  mean_value, // mean value coordinates (Floater 2003)
  uniform     // the mean of the neighbors (Tutte 1963)
};

// A location on the base mesh.
struct Base_location
{
  Index triangle = none;
  std::array<double, 3> barycentric = {1., 0., 0.};
};

// The parameterization of a mesh over its base mesh. The map is continuous and linear in each
// triangle of the fine mesh. It is bijective if number_of_flips() is zero.
class CGAL_GEODESIC_PROCESSING_EXPORT Base_map
{
public:
  // If a region has inverted triangles and `does_repair` is true, all its coordinates are replaced
  // by mean value coordinates. If round-off errors invert triangles of these, uniform coordinates
  // are used. Both are convex combinations with a convex boundary, which are injective (Floater
  // 1997).
  //
  // Heron coordinates use exact geodesic distances in the triangles around each base vertex (Peyré
  // and Cohen 2003, section 4.2). On curved surfaces they do not parameterize edges by arc length.
  // The deviation on each edge is subtracted at all vertices of the region, with a weight that
  // decreases linearly to zero at the opposite corner.
  Base_map(std::shared_ptr<const Base_mesh> base, Base_coordinates kind, bool does_repair = true);

  const Base_mesh& base() const { return *m_base; }
  // 3 #triangles of the fine mesh: the barycentric coordinates of each corner in its base triangle.
  // On a base edge the third coordinate is zero, and the other two are equal in both base
  // triangles.
  const std::vector<std::array<double, 3>>& coordinates() const { return m_coordinates; }

  // Number of inverted triangles, and number of regions whose coordinates were replaced.
  std::size_t number_of_flips() const { return m_number_of_flips; }
  std::size_t number_of_repaired_regions() const { return m_number_of_repaired_regions; }
  // One location in each region with inverted triangles, which need not be canonical: the vertex of
  // the fine mesh that is farthest from the base edges, in number of edges.
  const std::vector<Surface_location>& centers_of_inverted_regions() const
  {
    return m_centers_of_inverted_regions;
  }

  // Maps a canonical location of the mesh to the base mesh. Linear in the number of fine triangles
  // in the triangle of the mesh.
  Base_location operator()(const Surface_location& location) const;
  // Maps a location of the base mesh to the mesh. Linear in the number of triangles of the region.
  Surface_location inverse(const Base_location& location) const;

private:
  class Builder;

  std::shared_ptr<const Base_mesh> m_base;
  std::vector<std::array<double, 3>> m_coordinates;
  std::size_t m_number_of_flips = 0, m_number_of_repaired_regions = 0;
  std::vector<Surface_location> m_centers_of_inverted_regions;
  // Triangles of the fine mesh, grouped by triangle of the mesh and by base triangle.
  std::vector<Index> m_parent_begin, m_triangles_by_parent, m_region_begin, m_triangles_by_region;
};

// Computes a base mesh and its map. If a large part of a region has a short boundary, as a closed
// tube with one base triangle has, the image of this part can be smaller than round-off errors.
// While triangles are inverted, a sample is added inside their region, and the base mesh is
// computed again, at most 10 times. The result is the map with the fewest inverted triangles.
//
// Returns null if the callback cancelled. Throws the exceptions of build_base_mesh().
CGAL_GEODESIC_PROCESSING_EXPORT
std::shared_ptr<const Base_map>
build_base_map(const std::shared_ptr<const Surface_arrays>& triangles, Remeshing_options options,
               Base_coordinates kind);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_BASE_MAP_H
