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

// Samples of a mesh on the way to the centroids of what is nearest to them of the triangles between them, whose
// edges are flipped meanwhile such that these are Delaunay triangles.  It takes a third of the time of steps on
// the surface itself, and moves samples by less than its triangles tell, so that angles become larger.  But
// triangles in space cut off what bends more than they can follow: there samples stay.
class CGAL_GEODESIC_PROCESSING_EXPORT Smoothing
{
public:
  // slowness: as in Front_limits, or null; sample_triangles: triangles, counterclockwise: samples that they do not
  // surround stay; is_fixed: #samples, others that do; is_feature: #sides, twins alike: no sample crosses them
  Smoothing(const Surface_arrays& triangles, const std::vector<double>* slowness,
            std::vector<Surface_location> samples,
            const std::vector<std::array<Index, 3>>& sample_triangles, std::vector<bool> is_fixed,
            const std::vector<bool>& is_feature);

  // O(#samples), and what they move over.
  void step();

  const std::vector<Surface_location>& samples() const { return m_samples; }

private:
  struct Cell
  {
    double mass = 0.;
    Vec3 moment = {0., 0., 0.};
    double area = 0.; // of the triangles around the sample
    Vec3 normal = {0., 0., 0.};
  };

  double density(Index sample) const;
  void compute_cells();
  void distribute(const std::array<Index, 3>& samples, double density);
  void flip();

  const Surface_arrays& m_triangles;
  const std::vector<double>* m_slowness;
  const std::vector<bool>& m_is_feature;
  std::vector<Surface_location> m_samples;
  std::vector<Vec3> m_points; // of samples, in the triangles' scale
  std::vector<bool> m_is_fixed;
  Flippable_triangles m_sample_triangles;
  std::vector<Cell> m_cells; // of samples, while these move
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_SMOOTHING_H
