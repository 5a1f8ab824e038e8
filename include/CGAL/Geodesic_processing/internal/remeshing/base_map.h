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

// How sites inside of a base triangle get their coordinates; those on its edges divide these by length.
enum class Base_coordinates
{
  heron,      // areas of the triangles that geodesic distances to the corners span in the plane
  mean_value, // Floater's convex combinations (2003)
  uniform     // the mean of the neighbours (Tutte 1963)
};

// A place on the base.
struct Base_location
{
  Index triangle = none;
  std::array<double, 3> barycentric = {1., 0., 0.};
};

// A mesh and its base, mapped onto each other: linear in each triangle of the fine mesh, continuous, and
// one to one where no triangle is folded.
class CGAL_GEODESIC_PROCESSING_EXPORT Base_map
{
public:
  // Where triangles of a region fold in the coordinates asked for, these are replaced in the whole
  // region by mean value coordinates, and where rounding folds these, by uniform ones: both are convex
  // combinations with a triangle around them, which do not fold (Floater 1997).  Unless `repairs` is
  // false.
  //
  // Geodesic distances are exact, in the triangles around each base vertex (Peyré and Cohen 2003,
  // section 4.2).  Off flat places they do not divide edges by length: what they are wrong by there is
  // taken off at all sites, in proportion to their distance from the opposite corner.
  Base_map(std::shared_ptr<const Base_mesh> base, Base_coordinates kind, bool does_repair = true);

  const Base_mesh& base() const { return *m_base; }
  // 3 #triangles of the fine mesh: of each corner, in the base triangle of the region.  On edges the
  // third one is zero, and both sides have the same two.
  const std::vector<std::array<double, 3>>& coordinates() const { return m_coordinates; }

  // How many triangles are folded, and how many regions have been repaired.
  std::size_t folds() const { return m_number_of_folds; }
  std::size_t number_of_repaired_regions() const { return m_number_of_repaired_regions; }

  // Where a place of the mesh, clean, is on the base.
  Base_location operator()(const Surface_location& location) const;
  // The other way; proportional to the triangles of the region.
  Surface_location inverse(const Base_location& location) const;

private:
  class Builder;

  std::shared_ptr<const Base_mesh> m_base;
  std::vector<std::array<double, 3>> m_coordinates;
  std::size_t m_number_of_folds = 0, m_number_of_repaired_regions = 0;
  // Triangles of the fine mesh by the one of the mesh, and of the base, that they are a part of.
  std::vector<Index> m_parent_begin, m_triangles_by_parent, m_region_begin, m_triangles_by_region;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_BASE_MAP_H
