// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_BARYCENTERS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_BARYCENTERS_H

#include <CGAL/Geodesic_processing/internal/core/Glued_triangles.h>
#include <CGAL/Geodesic_processing/internal/transport/Mass_distribution.h>
#include <CGAL/Geodesic_processing/internal/transport/barycenter.h>

#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Barycenter_solver on a surface, on request refined, and with another measure of lengths.
class CGAL_GEODESIC_PROCESSING_EXPORT Barycenters
{
public:
  // As those of Earth_movers.  Throws Unsupported_surface_error when there is no triangle with an area,
  // or too many.
  explicit Barycenters(std::shared_ptr<const Glued_triangles> triangles, unsigned refinements = 0,
                       std::vector<Tensor> measure = {});

  // In the caller's units, with masses at sites and flows of the triangles as they were; potentials are left
  // out.
  // do_normalize: whether the masses are scaled so that each sums to one.  Throws Invalid_argument_error
  // as Barycenter_solver does, and when nothing can be scaled.
  Barycenter solve(const std::vector<Mass_distribution>& masses, const std::vector<double>& weights,
                   bool do_normalize = false, const Barycenter_options& options = {}) const;

  // #sites: the area whose masses are theirs, in the square of the caller's unit.
  const Vector& site_areas() const { return m_site_areas; }

private:
  struct Level
  {
    std::shared_ptr<const Glued_triangles> triangles;
    std::vector<double> area; // #triangles: zero where nothing may pass
  };

  std::vector<Level> m_levels;   // the finest last
  std::vector<Tensor> m_measure; // of the finest triangles
  Vector m_site_areas;
  std::unique_ptr<Barycenter_solver> m_solver;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_BARYCENTERS_H
