// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_COVERAGE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_COVERAGE_H

#include <CGAL/Geodesic_processing/internal/surfels/Surfel_cloud.h>

#include <atomic>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The region that a cloud covers: all points that are close to the surfels relative to their
// spacing.
//
// A point is covered if its distance to the nearest surfel is at most the 95th percentile of the
// local spacing. The percentile is the third largest spacing of the 60 surfels nearest to the
// point. The spacing of a surfel is the distance to its sixth nearest surfel.
class CGAL_GEODESIC_PROCESSING_EXPORT Surfel_coverage
{
public:
  // Precomputes the radii; O(n). Keeps a reference to the cloud. The graph of the cloud must be
  // of type `extended_spheres`; only the constructor uses it.
  explicit Surfel_coverage(const Surfel_cloud& cloud, unsigned number_of_threads = 1);

  // Returns an estimate of the distance from a vertex up to which points are covered. It is the
  // third largest spacing of the vertex and its graph neighbors. It is an overestimate if the
  // cloud is denser around the point than around the vertex.
  double radius(Index vertex) const { return m_radius[vertex]; }
  // Returns true if a point is covered. `vertex` is a guess of the nearest vertex: it accelerates
  // the query and does not change the result.
  bool is_covered(const Vec3& point, Index vertex) const;
  // Returns the point if it is covered, otherwise a covered point on the segment from the nearest
  // surfel to it. `vertex` is a guess of the nearest vertex.
  Vec3 clamped_to_coverage(const Vec3& point, Index vertex) const;

  const Surfel_cloud& cloud() const { return m_cloud; }

private:
  // The surfel nearest to a point, and the distance to it up to which the point is covered.
  struct Nearest_surfel
  {
    Index vertex;
    double distance, max_distance;
  };
  Nearest_surfel nearest_surfel(const Vec3& point) const;

  const Surfel_cloud& m_cloud;
  double wide_radius(Index vertex) const;

  // #vertices. All points within m_certain_radius of a vertex are covered.
  std::vector<double> m_radius, m_certain_radius;
  // #vertices. A better bound of the same kind, computed at its first use; 0: not yet.
  mutable std::vector<std::atomic<double>> m_wide_radius;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_COVERAGE_H
