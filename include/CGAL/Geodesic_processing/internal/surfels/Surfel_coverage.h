// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_COVERAGE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_COVERAGE_H

#include <CGAL/Geodesic_processing/internal/surfels/Surfel_cloud.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// What is near to the surfels of a cloud, measured by how far they are from each other.
//
// A point is near when its distance from the nearest surfel is at most the 95th percentile of the
// spacing there: of the 60 surfels nearest to the point, the third largest distance to a sixth
// neighbour.
class CGAL_GEODESIC_PROCESSING_EXPORT Surfel_coverage
{
public:
  // The cloud stays with the caller; its graph, of extended spheres, is needed here only.
  explicit Surfel_coverage(const Surfel_cloud& cloud, unsigned threads = 1);

  // A point no farther than this from a site is near, but for clouds that are denser beside it: what
  // the site and its neighbours say of the percentile.
  double radius(Index vertex) const { return m_radius[vertex]; }
  // `site`: one that may be the nearest.
  bool is_covered(const Vec3& point, Index vertex) const;
  // The point, or where it is not near one that is, on the way to the nearest surfel.
  Vec3 clamped_to_coverage(const Vec3& point, Index vertex) const;

  const Surfel_cloud& cloud() const { return m_cloud; }

private:
  const Surfel_cloud& m_cloud;
  // #sites; what is within `sure` is near whatever the cloud is like elsewhere.
  std::vector<double> m_radius, m_certain_radius;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_COVERAGE_H
