// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_RELAXATION_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_RELAXATION_H

#include <CGAL/Geodesic_processing/internal/front.h>
#include <CGAL/Geodesic_processing/internal/spatial.h>

#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Samples on the way to the centroids of their cells (Lloyd 1982).  A step goes beyond the centroid,
// and on in the direction of the step before it (Polyak 1964): ten steps are as good as twenty that
// end at centroids, or better.  O(n) each.
class CGAL_GEODESIC_PROCESSING_EXPORT Relaxation
{
public:
  // front: any over the triangles; slowness: as in Front_limits; is_fixed: #samples, those that stay
  Relaxation(std::shared_ptr<const Glued_triangles> triangles, Front& front,
             std::shared_ptr<const std::vector<double>> slowness, std::vector<Location> samples,
             std::vector<bool> is_fixed);

  // The last step ends at the centroids.
  void step(bool is_last);

  const std::vector<Location>& samples() const { return m_samples; }

private:
  void update_cells();

  std::shared_ptr<const Glued_triangles> m_triangles;
  Front& m_front;
  Front_limits m_limits;
  std::vector<Location> m_samples;
  std::vector<bool> m_is_fixed;
  std::vector<Spatial> m_moves;    // #samples: the last ones
  std::vector<double> m_distances; // #sites: of the nearest sample, or more since it has moved
  std::vector<Index> m_labels;     // #sites: the nearest sample, or one that was
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_RELAXATION_H
