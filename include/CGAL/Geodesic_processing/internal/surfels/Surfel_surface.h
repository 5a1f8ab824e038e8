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
  disks, // the nearest point of the surfels' disks, of no more than the mean of their neighbours' radii
  planes,  // the plane of the weighted mean point and normal (Alexa and others 2003)
  spheres, // the algebraic sphere through points and normals (Guennebaud, Germann and Gross 2008)
  robust_spheres, // the same where outliers do not count
  quadrics        // that sphere, and the surface of second order over it through what it leaves
};

// The surface that a cloud suggests.
//
// Around the surfel nearest to a place, found by a walk over the graph such that it stays on one
// sheet, it is fitted to that surfel and its graph neighbours, with weights (1 - (d / h)^2)^4 of their
// distances d, where h is 2.3 radii, in the mean of the neighbours.  Surfels beyond a sharp edge
// do not count: the weight falls to zero between 40 and 60 degrees of difference from the normal of
// the nearest one, and the edge lies where the fits of both sides are equally far.
//
// Robust weights have a factor (1 - (h / (2.5 s))^2)^2 for a surfel of a height h over the 24 nearest with
// agreeing normals, where s is the standard deviation of such heights around, both by medians: noise
// counts, outliers do not.  No foot is sought on those, and the 24 nearest with agreeing normals take part
// instead of those joined by arcs, which noise cuts.
//
// It ends 1.5 radii from the nearest surfel, along its tangent plane: of its own, or the mean of its
// neighbours' where that is less, because next to a gap a surfel's neighbours are farther away.  One
// radius would leave holes of 2 % of the area in random samples, 1.5 of 0.01 %.  Nor is it farther than
// 1.1 times the radius that one in ten of the neighbours exceeds: a surfel beside denser ones, alone in
// a hole of a scan, does not close that.  And all feet are as near to surfels as Surfel_coverage wants,
// as the site and its neighbours know it: a foot farther away is drawn to the ball that it misses least.
class CGAL_GEODESIC_PROCESSING_EXPORT Surfel_surface : public Path_surface
{
public:
  // The cloud and the vicinity stay with the caller.
  //
  // home  #sites, or empty where both have the same: the site of the vicinity's cloud, in the same
  //       frame, that each comes from
  Surfel_surface(const Surfel_cloud& cloud, Surfel_fit fit, const Surfel_coverage& coverage,
                 const std::vector<Index>& original_vertex);

  // `near` is a site.
  Projection project(const Vec3& point, Index near_vertex) const override;
  Vec3 clamped_to_coverage(const Vec3& point, Index near_vertex) const override;

  // The length of a walk over arcs from one site to another, nearer to it with each; infinite where it
  // does not arrive.
  double walk_length(Index from, Index to) const;

  const Surfel_cloud& cloud() const { return m_cloud; }

private:
  Index nearest(const Vec3& point, Index near_vertex) const;
  Index original_vertex(Index vertex) const
  {
    return m_original_vertex.empty() ? vertex : m_original_vertex[vertex];
  }
  Projection project_unclamped(const Vec3& point, Index near_vertex) const;
  bool is_covered(const Vec3& point, Index vertex) const;
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
  std::vector<double> m_squared_support, m_disk_radius, m_extent; // #sites
  std::vector<double> m_robust_weight; // #sites: of robust weights, else none
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_SURFACE_H
