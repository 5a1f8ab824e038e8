// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_BENCHMARK_CGAL_HEAT_SOLVER_H
#define CGAL_GEODESIC_PROCESSING_BENCHMARK_CGAL_HEAT_SOLVER_H

#include "models.h"

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>

#include <limits>

namespace benchmarks {

// Computes distances by CGAL's heat method on the intrinsic Delaunay triangulation. The
// factorization is computed once in the constructor.
class Cgal_heat_solver
{
public:
  explicit Cgal_heat_solver(Mesh& mesh)
      : m_solver(mesh), m_distance(mesh.add_property_map<Vertex, double>("v:heat", 0.).first)
  {}

  void compute(Vertex source)
  {
    m_solver.clear_sources();
    m_solver.add_source(source);
    m_solver.estimate_geodesic_distances(m_distance);
  }
  // Returns the distance of `vertex`, or infinity if CGAL's solve left its initial value (the
  // largest double) unchanged.
  double distance(Vertex vertex) const
  {
    const double value = m_distance[vertex];
    return value < (std::numeric_limits<double>::max)() / 2.
               ? value
               : std::numeric_limits<double>::infinity();
  }

private:
  using Mode = CGAL::Heat_method_3::Intrinsic_Delaunay;
  CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh, Mode> m_solver;
  Mesh::Property_map<Vertex, double> m_distance;
};

} // namespace benchmarks

#endif // CGAL_GEODESIC_PROCESSING_BENCHMARK_CGAL_HEAT_SOLVER_H
