// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_SURFACE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_SURFACE_H

#include <CGAL/Geodesic_processing/internal/core/Path_surface.h>
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_cloud.h>
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_coverage.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

enum class Surfel_fit
{
  disks,   // the closest point of the surfels' disks; their radii are at most the local mean radius
  planes,  // the plane of the weighted mean point and normal (Alexa and others 2003)
  spheres, // the algebraic sphere fitted to points and normals (Guennebaud, Germann and Gross 2008)
  robust_spheres, // the algebraic sphere with robust weights, which reject outliers
  quadrics        // the algebraic sphere, corrected by a quadric that is fitted to its residuals
};

// A surface that is fitted to a cloud of surfels by moving least squares.
//
// The nearest surfel of a point is found by walking in the graph, so that the projection stays on
// one sheet. The surface is fitted to this surfel and its graph neighbors. A surfel at the
// distance d has the weight (1 - (d / h)^2)^4, with h = 2.3 times the mean radius of the nearest
// surfel and its neighbors. To preserve sharp edges, the weight decreases to zero if the normal
// differs from the normal of the nearest surfel by 40 to 60 degrees. The surface has an edge at
// equal distances from the fits of both faces.
//
// With robust weights, the 24 nearest surfels with compatible normals are used instead of the graph
// neighbors, because noise removes edges of the graph. Each has an additional factor
// (1 - (h / (2.5 s))^2)^2. Here, h is its median height over its own 24 nearest surfels, and s is
// the local standard deviation of these heights, estimated by the median. So the weight of
// outliers is zero, and noise keeps its weight. The walk skips outliers.
//
// If the nearest surfel of a point is farther away than its neighbors, the support is enlarged such
// that more than one surfel has a positive weight: h is at least 1.53 times the distance.
//
// The surface has a boundary. A query point is not beyond it in two cases:
// - It is within an extent of its nearest surfel, measured along the tangent plane, or within the
//   extent of a graph neighbor of this surfel.
// - The 24 nearest surfels lie on all sides of it, at most 90 degrees apart. In random samples,
//   this closes sparse spots.
// The extent is the minimum of two bounds:
// - 1.5 times the radius of the surfel. In a random sample of a sphere, this leaves holes of 0.03 %
//   of the area if only the nearest surfel counts, and of 0.003 % with its graph neighbors.
// - 1.3 times the maximum radius of its neighbors. So an isolated surfel in a hole of a scan does
//   not close the hole.
// All projections are also covered, see Surfel_coverage. Otherwise the projection is moved towards
// the closest surfel.
class CGAL_GEODESIC_PROCESSING_EXPORT Surfel_surface : public Path_surface
{
public:
  // Precomputes the support and the extent of each vertex; O(n), with robust weights O(n log n).
  // Keeps references to the cloud, the coverage and `original_vertex`.
  //
  // original_vertex  #vertices: the vertex of the coverage's cloud from which each vertex
  //                  originates; empty if both clouds are the same. Both clouds must have the same
  //                  frame.
  Surfel_surface(const Surfel_cloud& cloud, Surfel_fit fit, const Surfel_coverage& coverage,
                 const std::vector<Index>& original_vertex);

  // Returns the projection of a point to the surface. `near_vertex` is the vertex at which the
  // walk to the nearest surfel begins.
  Projection project(const Vec3& point, Index near_vertex) const override;
  // Returns the point if it is covered, otherwise a covered point near it.
  Vec3 clamped_to_coverage(const Vec3& point, Index near_vertex) const override;

  // Returns the length of a greedy walk in the graph from one vertex to another: each step goes to
  // the neighbor closest to the target. Returns infinity if no neighbor is closer than the current
  // vertex.
  double walk_length(Index from, Index to) const;

  const Surfel_cloud& cloud() const { return m_cloud; }

private:
  Index nearest(const Vec3& point, Index near_vertex) const;
  Index original_vertex(Index vertex) const
  {
    return m_original_vertex.empty() ? vertex : m_original_vertex[vertex];
  }
  bool is_surrounded(const Vec3& point, Index vertex) const;
  void clamp_to_boundary(Projection& query) const;
  Projection project_unclamped(const Vec3& point, Index near_vertex) const;
  Projection project_to_disk(const Vec3& point, Index vertex) const;
  bool project_step(Projection& projection) const;
  template <typename Visit>
  void visit_neighbors(const Vec3& point, Index vertex, Visit v) const;
  void add_quadric_correction(const Projection& from, double curvature,
                              Projection& projection) const;

  const Surfel_cloud& m_cloud;
  Surfel_fit m_fit;
  const Surfel_coverage& m_coverage;
  const std::vector<Index>& m_original_vertex;
  std::vector<double> m_squared_support, m_disk_radius, m_extent; // #vertices
  std::vector<double> m_robust_weight; // #vertices; empty without robust weights
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_SURFACE_H
