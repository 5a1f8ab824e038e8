// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SMOOTHING_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SMOOTHING_H

#include <CGAL/Geodesic_processing/internal/core/Glued_triangles.h>
#include "mesh/flips.h"
#include <CGAL/Geodesic_processing/internal/core/spatial.h>

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
  // slowness: as in Front_limits, or null; between_samples: triangles, counterclockwise: samples that they do not
  // surround stay; is_fixed: #samples, others that do; is_curve: #sides, twins alike: no sample crosses them
  Smoothing(const Glued_triangles& triangles, const std::vector<double>* slowness,
            std::vector<Location> samples, const std::vector<std::array<Index, 3>>& between_samples,
            std::vector<bool> is_fixed, const std::vector<bool>& is_curve);

  // O(#samples), and what they move over.
  void step();

  const std::vector<Location>& samples() const { return m_samples; }

private:
  struct Cell
  {
    double mass = 0.;
    Spatial moment = {0., 0., 0.};
    double area = 0.; // of the triangles around the sample
    Spatial normal = {0., 0., 0.};
  };

  double density(Index sample) const;
  void make_cells();
  void divide(const std::array<Index, 3>& samples, double density);
  void flip();

  const Glued_triangles& m_triangles;
  const std::vector<double>* m_slowness;
  const std::vector<bool>& m_is_curve;
  std::vector<Location> m_samples;
  std::vector<Spatial> m_points; // of samples, in the triangles' scale
  std::vector<bool> m_is_fixed;
  Flippable_triangles m_between_samples;
  std::vector<Cell> m_cells; // of samples, while these move
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SMOOTHING_H
