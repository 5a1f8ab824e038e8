// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_MESH_OPTIMIZATION_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_MESH_OPTIMIZATION_H

#include <CGAL/Geodesic_processing/internal/sampling/sampling.h>
#include <CGAL/Geodesic_processing/internal/spatial_search/Triangle_tree.h>
#include "remeshing/Refined_surface.h"
#include "remeshing/fitting.h"
#include "remeshing/topology_repair.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// With at least this number of relaxation steps, quality is preferred to speed: edges are split
// more finely, and the fit takes further steps that preserve angles.
inline constexpr std::size_t many_relaxation_steps = 30;

// Improves the dual triangulation of cells in space. Also returns the vertices of the refined
// surface that must become samples to meet the geometric goals of `Remeshing_options`: the maximum
// deviation and no self-intersections.
class CGAL_GEODESIC_PROCESSING_EXPORT Mesh_optimization
{
public:
  Mesh_optimization(const Refined_surface& surface, const Remeshing_options& options)
      : m_surface(surface), m_options(options)
  {}

  // Returns the mesh of the samples after edge flips for larger angles and, if
  // `does_fit_to_input`, the fit of its points to the vertices of the surface. Points are in the
  // scale of the refined surface. Samples on features stay fixed. So do samples whose cell has no
  // other vertex if there is a maximum deviation: their surroundings cannot be sampled more
  // densely.
  Coarse_mesh build_mesh(const Cells& cells, const Sampling& sampling,
                         std::vector<std::array<Index, 3>> triangles) const;

  // Returns vertices at which the mesh exceeds the maximum deviation: from each cell, the vertex
  // farthest from the mesh. If all vertices are close enough, triangles that are too far from the
  // surface are considered. Of the cells of such a triangle, the vertex farthest from its sample is
  // returned. Samples are never returned, because the fit moves a point by at most the maximum
  // deviation. O(n), and O(log n) for each triangle of the mesh.
  std::vector<Surface_location> far_locations(const Cells& cells, const Sampling& sampling,
                                              const Coarse_mesh& mesh);

  // Returns the farthest vertices of the cells of intersecting triangles. Intersections between
  // triangles over self-intersecting parts of the input are ignored. If there are as many
  // intersecting pairs as triangles, the search stops, and no vertex is returned: more samples
  // would not help. Sets `candidate.number_of_self_intersections`.
  std::vector<Surface_location>
  locations_at_intersections(const Cells& cells, const Sampling& sampling, Remeshing& candidate);

private:
  std::vector<std::array<Index, 2>>
  kept_edges(const Cells& cells, const std::vector<Index>& farthest,
             const std::vector<std::array<Index, 3>>& triangles) const;
  bool is_far(const Coarse_mesh& mesh, const std::array<Index, 3>& triangle);
  std::vector<bool> self_intersecting_cells(const Cells& cells);

  const Refined_surface& m_surface;
  const Remeshing_options& m_options;
  // Computed on demand.
  std::optional<std::vector<bool>> m_is_self_intersecting; // #triangles of the coarse mesh
  std::optional<Triangle_tree> m_tree;                     // of the coarse mesh
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_MESH_OPTIMIZATION_H
