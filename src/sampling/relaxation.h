// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SAMPLING_RELAXATION_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SAMPLING_RELAXATION_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <array>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Samples on the way to the centroids of their cells (Lloyd 1982).  A step goes beyond the centroid,
// and on in the direction of the step before it (Polyak 1964): ten steps are as good as twenty that
// end at centroids, or better.  O(n) each.
//
// Cells follow their samples at their rims: a site goes over to the cell next to it whose sample is
// nearer in space, if that lies on the same side of the surface.  That takes a sixth of the time of fronts, and
// what fronts of the samples find in the end differs as little as chords of cells from ways.
class CGAL_GEODESIC_PROCESSING_EXPORT Relaxation
{
public:
  // slowness: as in Front_limits; labels: #sites, the nearest sample of each or none;
  // is_fixed: #samples, those that stay
  Relaxation(std::shared_ptr<const Surface_arrays> triangles,
             std::shared_ptr<const std::vector<double>> slowness,
             std::vector<Surface_location> samples, std::vector<Index> labels,
             std::vector<bool> is_fixed);

  // The last step ends at the centroids.
  void step(bool is_last);

  const std::vector<Surface_location>& samples() const { return m_samples; }
  // #sites: the sample of each before the last step
  const std::vector<Index>& labels() const { return m_labels; }

private:
  void update_cells();

  std::shared_ptr<const Surface_arrays> m_triangles;
  std::shared_ptr<const std::vector<double>> m_slowness;
  std::vector<Surface_location> m_samples;
  std::vector<Index> m_labels; // #sites
  std::vector<bool> m_is_fixed;
  std::vector<Vec3> m_displacements; // #samples: the last ones
  std::vector<double> m_masses;      // #triangles
  std::vector<Vec3> m_normals;       // #sites
  std::vector<std::array<Index, 2>>
      m_growth_edges; // sites that a side joins which a cell may grow along
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SAMPLING_RELAXATION_H
