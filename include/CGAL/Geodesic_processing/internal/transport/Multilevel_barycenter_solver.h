// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_MULTILEVEL_BARYCENTER_SOLVER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_MULTILEVEL_BARYCENTER_SOLVER_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/transport/Mass_distribution.h>
#include <CGAL/Geodesic_processing/internal/transport/Barycenter_solver.h>

#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Barycenter_solver on a surface, on request refined, and with another measure of lengths.
class CGAL_GEODESIC_PROCESSING_EXPORT Multilevel_barycenter_solver
{
public:
  // As those of Multilevel_transport_solver.  Throws Unsupported_surface_error when there is no triangle with an area,
  // or too many.
  explicit Multilevel_barycenter_solver(std::shared_ptr<const Surface_arrays> triangles,
                                        unsigned refinements = 0,
                                        std::vector<Metric_tensor> metric = {});

  // In the caller's units, with masses at sites and flows of the triangles as they were; potentials are left
  // out.
  // do_normalize: whether the masses are scaled so that each sums to one.  Throws Invalid_argument_error
  // as Barycenter_solver does, and when nothing can be scaled.
  Barycenter_result solve(const std::vector<Mass_distribution>& masses,
                          const std::vector<double>& weights, bool do_normalize = false,
                          const Barycenter_options& options = {}) const;

  // #sites: the area whose masses are theirs, in the square of the caller's unit.
  const Vector& vertex_areas() const { return m_vertex_areas; }

private:
  struct Level
  {
    std::shared_ptr<const Surface_arrays> triangles;
    std::vector<double> area; // #triangles: zero where nothing may pass
  };

  std::vector<Level> m_levels;         // the finest last
  std::vector<Metric_tensor> m_metric; // of the finest triangles
  Vector m_vertex_areas;
  std::unique_ptr<Barycenter_solver> m_solver;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_MULTILEVEL_BARYCENTER_SOLVER_H
