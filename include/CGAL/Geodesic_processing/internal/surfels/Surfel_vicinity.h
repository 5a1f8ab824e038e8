// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFEL_VICINITY_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFEL_VICINITY_H

#include <CGAL/Geodesic_processing/internal/surfels/Surfel_cloud.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// What is near to the surfels of a cloud, measured by how far they are from each other.
//
// A point is near when its distance from the nearest surfel is at most the 95th percentile of the
// spacing there: of the 60 surfels nearest to the point, the third largest distance to a sixth
// neighbour.
class CGAL_GEODESIC_PROCESSING_EXPORT Surfel_vicinity
{
public:
  // The cloud stays with the caller; its graph, of extended spheres, is needed here only.
  explicit Surfel_vicinity(const Surfel_cloud& cloud, unsigned threads = 1);

  // A point no farther than this from a site is near, but for clouds that are denser beside it: what
  // the site and its neighbours say of the percentile.
  double reach(Index site) const { return m_reach[site]; }
  // `site`: one that may be the nearest.
  bool is_near(const Spatial& point, Index site) const;
  // The point, or where it is not near one that is, on the way to the nearest surfel.
  Spatial drawn_near(const Spatial& point, Index site) const;

  const Surfel_cloud& cloud() const { return m_cloud; }

private:
  const Surfel_cloud& m_cloud;
  // #sites; what is within `sure` is near whatever the cloud is like elsewhere.
  std::vector<double> m_reach, m_sure;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFEL_VICINITY_H
