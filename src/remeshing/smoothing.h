// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_SMOOTHING_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_SMOOTHING_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include "mesh/flips.h"
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Lloyd relaxation in the triangulation of the samples. Each sample moves to the centroid of its
// Voronoi cell in the incident triangles, and edges are flipped towards a Delaunay triangulation. A
// step takes a third of the time of a step on the surface (`Relaxation`). It also resolves smaller
// displacements, because cells do not consist of vertices, so that angles become larger. Samples in
// regions of high curvature stay: the triangles do not approximate the surface there.
class CGAL_GEODESIC_PROCESSING_EXPORT Smoothing
{
public:
  // slowness: as in Front_limits, or null
  // sample_triangles: samples at the corners, counterclockwise; samples without a closed one-ring
  // of triangles stay fixed
  // is_fixed: #samples
  // is_feature: 3 #triangles, equal for both halfedges of an edge; samples do not cross these edges
  Smoothing(const Surface_arrays& triangles, const std::vector<double>* slowness,
            std::vector<Surface_location> samples,
            const std::vector<std::array<Index, 3>>& sample_triangles, std::vector<bool> is_fixed,
            const std::vector<bool>& is_feature);

  // Moves each sample once, then flips edges. O(#samples), plus the number of triangles crossed.
  void step();

  const std::vector<Surface_location>& samples() const { return m_samples; }

private:
  struct Cell
  {
    double mass = 0.;
    Vec3 moment = {0., 0., 0.}; // mass times centroid
    double area = 0.;           // twice the area of the incident triangles
    Vec3 normal = {0., 0., 0.}; // sum of their normals with twice their areas as lengths
  };

  double density(Index sample) const;
  void compute_cells();
  void distribute(const std::array<Index, 3>& samples, double density);
  void flip();

  const Surface_arrays& m_triangles;
  const std::vector<double>* m_slowness;
  const std::vector<bool>& m_is_feature;
  std::vector<Surface_location> m_samples;
  std::vector<Vec3> m_points; // #samples, in the scale of the triangles
  std::vector<bool> m_is_fixed;
  Flippable_triangles m_sample_triangles;
  std::vector<Cell> m_cells; // #samples, of the current step
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_SMOOTHING_H
