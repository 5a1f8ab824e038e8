// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_TOPOLOGY_REPAIR_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_TOPOLOGY_REPAIR_H

#include <CGAL/Geodesic_processing/internal/sampling/sampling.h>
#include "remeshing/Refined_surface.h"
#include "remeshing/dual.h"

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The Voronoi cells of the samples that own at least one vertex, numbered in the order of samples.
struct Cells
{
  std::vector<Index> labels;  // #vertices: the cell of each, none for vertices without triangles
  std::vector<Index> samples; // #cells: the sample of each
};

// Returns the cells of a sampling, each made connected. The vertices of a cell that are not
// connected by edges to the vertex closest to its sample join an adjacent cell. Such vertices occur
// if round-off errors changed a label, or if a front passed around another one. O(n) for few of
// them.
CGAL_GEODESIC_PROCESSING_EXPORT
Cells connected_cells(const Surface_arrays& triangles, const Sampling& sampling);

// Returns the vertex of each cell that is farthest from the sample (#cells), or none if all
// distances in the cell are zero. O(n).
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Index> farthest_vertices(const Cells& cells, const Sampling& sampling);

// The dual triangulation of cells, and the violations of two conditions: the closed ball property,
// and that samples cover the features. If there are none, the dual has the topology of the surface.
struct Topology_check
{
  Dual dual;
  // Cells that contain a feature vertex although their sample lies on no feature.
  std::vector<Index> off_feature_cells;
  // Cells whose sample lies on a feature edge or vertex, but which own none of its end vertices,
  // followed by the cells of these vertices.
  std::vector<Index> cells_without_own_sample;

  bool is_valid() const
  {
    return dual.is_closed_ball() && off_feature_cells.empty() && cells_without_own_sample.empty();
  }
};

// Computes the dual triangulation and its violations. O(n log n).
CGAL_GEODESIC_PROCESSING_EXPORT
Topology_check check_topology(const Refined_surface& surface, const Sampling& sampling,
                              const Cells& cells);

struct Topology_repair
{
  // New samples: for each violation the vertex farthest from its sample. A cell takes part in one
  // repair only. Followed by the additional samples of these cells.
  std::vector<Surface_location> samples;
  // Cells with a violation all of whose vertices are samples already.
  std::vector<Index> unresolved;
};

// Selects new samples that reduce the violations of a topology check. Adds up to
// `number_of_additional` vertices of each repaired cell, at equal steps in the order of vertices.
// O(n log n).
CGAL_GEODESIC_PROCESSING_EXPORT
Topology_repair repair_topology(const Refined_surface& surface, const Sampling& sampling,
                                const Cells& cells, const Topology_check& check,
                                std::size_t number_of_additional = 0);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_TOPOLOGY_REPAIR_H
