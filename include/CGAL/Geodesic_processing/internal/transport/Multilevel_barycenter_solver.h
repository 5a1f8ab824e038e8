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

// Computes barycenters on a surface that is refined uniformly, optionally with a metric. This
// class refines the masses, calls Barycenter_solver on the finest level, and maps the result back
// to the input.
//
// Const member functions can be called concurrently.
class CGAL_GEODESIC_PROCESSING_EXPORT Multilevel_barycenter_solver
{
public:
  // refinements, metric  as for Multilevel_transport_solver
  // Throws Unsupported_surface_error if no triangle has an area or the refined surface is too
  // large.
  explicit Multilevel_barycenter_solver(std::shared_ptr<const Surface_arrays> triangles,
                                        unsigned refinements = 0,
                                        std::vector<Metric_tensor> metric = {});

  // Computes a barycenter in the unit of the coordinates. Masses and flows of the result are
  // those of the vertices and triangles before refinement; potentials are omitted.
  //
  // do_normalize  scales each mass distribution to a total mass of one
  // Throws Invalid_argument_error as Barycenter_solver, and if a distribution that is to be
  // normalized has no finite positive total mass.
  Barycenter_result solve(const std::vector<Mass_distribution>& masses,
                          const std::vector<double>& weights, bool do_normalize = false,
                          const Barycenter_options& options = {}) const;

  // #vertices: a third of the area of the incident triangles, in the squared unit of the
  // coordinates.
  const Vector& vertex_areas() const { return m_vertex_areas; }

private:
  struct Level
  {
    std::shared_ptr<const Surface_arrays> triangles;
    std::vector<double> area; // #triangles: zero in obstacles; only of the first and last level
  };

  // #vertices of the finest level: the masses of a distribution, scaled to a sum of one on request.
  Vector finest_masses(Mass_distribution distribution, bool do_normalize) const;
  // #triangles of the input: a flow of the finest level in the unit of the coordinates, without
  // metric.
  Field restored(Field flow) const;

  std::vector<Level> m_levels;         // from coarse to fine
  std::vector<Metric_tensor> m_metric; // of the finest triangles, or empty
  Vector m_vertex_areas;
  std::unique_ptr<Barycenter_solver> m_solver;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_MULTILEVEL_BARYCENTER_SOLVER_H
