// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_VOLUMETRIC_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_VOLUMETRIC_H

#include <CGAL/Geodesic_processing/internal/transport/Multilevel_transport_solver.h>
#include <CGAL/Geodesic_processing/internal/spatial_search/Triangle_tree.h>
#include <CGAL/Geodesic_processing/internal/transport/mean_value.h>

#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Tolerance, number of threads and callback of Volumetric_distances::one_to_many().
struct Volumetric_options
{
  double tolerance = 0.02; // of the gap between the bounds, relative to the upper bound
  unsigned number_of_threads = 1;
  // Called with the fraction done. If it returns false, the computation is cancelled.
  std::function<bool(double)> callback;
};

// Lower and upper bounds, in the unit of the input coordinates.
struct Volumetric_bounds
{
  double lower = 0., upper = 0.;
  unsigned number_of_iterations = 0;
  bool is_solved = false; // true if solved by the interior point method, not by interpolation
};

// A polyline in space, in the input coordinates. If `has_arrived` is true, it ends at the target.
struct Volumetric_path
{
  std::vector<Vec3> points;
  bool has_arrived = false;
  unsigned number_of_solutions = 0;
};

// Checks barycentric coordinates of a point: #vertices finite weights that sum to 1. The weighted
// sum of the vertices is the point. At a vertex its weight is 1 and all others are 0. Vertices
// without triangles have weight 0. Returns the weights divided by their sum. The tolerance is 1e-6,
// times the extent of the mesh and the sum of the absolute weights. Throws Invalid_argument_error
// if a property does not hold.
CGAL_GEODESIC_PROCESSING_EXPORT
Vector checked_coordinates(const Surface_arrays& triangles, const Vec3& point, Vector weights);

// Computes transport distances between points in space, inside or outside of a closed mesh
// (Solomon, Rustamov, Guibas and Butscher 2014, section 6). The distance is the cost of
// transporting the mean value coordinates of one point, as masses at the vertices, to those of the
// other.
//
// The Euclidean distance is a lower bound: mean value coordinates reproduce linear functions, and
// the linear function along the segment is a feasible potential.
//
// Other barycentric coordinates can replace mean value coordinates. They are checked at each point.
class CGAL_GEODESIC_PROCESSING_EXPORT Volumetric_distances
{
public:
  // Returns a weight for each vertex at a point in the input coordinates. One thread at a time
  // calls it.
  using Coordinate_function = std::function<Vector(const Vec3&)>;

  // refinements  as for Multilevel_transport_solver
  //
  // coordinate_function  empty for mean value coordinates
  //
  // Throws Unsupported_surface_error as Mean_value_coordinates does, or if the mesh has several
  // components. No mass can move between components.
  Volumetric_distances(std::shared_ptr<const Surface_arrays> triangles, unsigned refinements,
                       Coordinate_function coordinate_function = {});

  // Computes the distance of two points, given in the input coordinates. Throws as
  // coordinates().
  Transport_result cost(const Vec3& from, const Vec3& to, const Transport_options& options) const;

  // Computes bounds of the distances from one point to many. For most points, potentials and flows
  // are interpolated from solved points nearby. If the bounds are not within the tolerance, some
  // iterations of the splitting method follow. If these fail, the point is solved. Only a few
  // hundred points are solved, however many there are. The result does not depend on the number of
  // threads. It is empty if the callback cancelled.
  std::vector<Volumetric_bounds> one_to_many(const Vec3& from, const std::vector<Vec3>& to,
                                             const Volumetric_options& options) const;

  // Computes a path by gradient descent of the distance to `to`. A step follows the gradient of the
  // sum over all vertices of potential times mean value coordinate. The potential is the optimal
  // one for the start of the step. A step is shorter than the distance to the surface, so that the
  // path cannot cross it. The path does not arrive if the distance stops decreasing or the maximum
  // number of solutions is reached.
  //
  // Throws Invalid_argument_error if a point is on the surface, or if the surface separates the
  // points.
  Volumetric_path path(const Vec3& from, const Vec3& to,
                       unsigned maximum_number_of_solutions) const;

  // Returns #vertices coordinates of a point. Throws as Mean_value_coordinates' operator(). If
  // there is a coordinate function, throws Invalid_argument_error as checked_coordinates() instead.
  Vector coordinates(const Vec3& point) const;

  // Returns a lower bound of the distance, given the difference of the coordinates. It is the
  // Euclidean distance, of the points that the coordinates reproduce if there is a coordinate
  // function.
  double euclidean_bound(const Vec3& from, const Vec3& to, const Vector& difference) const;

private:
  double distance_to_surface(const Vec3& point) const;
  Vec3 offset_from_surface(const Vec3& point) const;
  bool descend(const Vec3& to, double clearance_target, unsigned maximum_number_of_solutions,
               Volumetric_path& path) const;
  Vec3 potential_gradient(const Vector& potential, const Vec3& point, double step) const;

  std::shared_ptr<const Surface_arrays> m_triangles;
  Mean_value_coordinates m_mean_value_coordinates;
  Coordinate_function m_coordinate_function; // serialized; empty for mean value coordinates
  Multilevel_transport_solver m_transport_solver;
  Triangle_tree m_tree;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_VOLUMETRIC_H
