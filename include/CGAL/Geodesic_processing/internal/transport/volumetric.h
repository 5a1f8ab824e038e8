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

struct Volumetric_options
{
  double tolerance = 0.02; // of the gap between the bounds, relative to the upper one
  unsigned threads = 1;
  std::function<bool(double)> callback; // gets the part that is done, and cancels by false
};

// In the caller's unit.
struct Volumetric_bounds
{
  double lower = 0., upper = 0.;
  unsigned iterations = 0;
  bool is_solved = false; // on its own, by the interior point method
};

struct Volumetric_path
{
  std::vector<Vec3> points;
  bool has_arrived = false;
  unsigned number_of_solutions = 0;
};

// Distances between points in space, inside and outside of a closed mesh (Solomon, Rustamov, Guibas and
// Butscher 2014, section 6): what it costs to move the mean value coordinates of one point, as masses
// at the sites, to those of the other.
//
// The straight distance is a lower bound: as the coordinates are precise for linear functions, the
// function along the straight line is a potential that proves it.
class CGAL_GEODESIC_PROCESSING_EXPORT Volumetric_distances
{
public:
  // refinements  as for Multilevel_transport_solver
  // Throws Unsupported_surface_error as Mean_value_coordinates, and when the mesh has several pieces,
  // between which no mass can move.
  Volumetric_distances(std::shared_ptr<const Surface_arrays> triangles, unsigned refinements);

  // points  in the caller's coordinates
  // Throws as Mean_value_coordinates' operator().
  Transport_result cost(const Vec3& from, const Vec3& to, const Transport_options& options) const;

  // From one point to many, which help each other: potentials and flows that were found for points nearby
  // are nearly those of a point.  Those that are still too far apart become so by some steps of the
  // splitting, and a few hundred points, whatever their number, are solved.  The result does not depend
  // on the number of threads; it is empty when the callback cancelled it.
  std::vector<Volumetric_bounds> one_to_many(const Vec3& from, const std::vector<Vec3>& to,
                                             const Volumetric_options& options) const;

  // Down the distance to a point, by its gradient: where potential is the one that proves the distance
  // from x, that of the sum of potentials times coordinates of x.  No step is as long as the way to the
  // surface, so that none crosses it.  Does not arrive when the distance falls no more or after so many
  // solutions.
  // Throws Invalid_argument_error when a point is on the surface, or they are on different sides of it.
  Volumetric_path path(const Vec3& from, const Vec3& to,
                       unsigned maximum_number_of_solutions) const;

  const Mean_value_coordinates& coordinates() const { return m_coordinates; }

private:
  double distance_to_surface(const Vec3& point) const;
  Vec3 offset_from_surface(const Vec3& point) const;
  bool descend(const Vec3& to, double clearance_target, unsigned maximum_number_of_solutions,
               Volumetric_path& path) const;
  Vec3 potential_gradient(const Vector& potential, const Vec3& point, double step) const;

  std::shared_ptr<const Surface_arrays> m_triangles;
  Mean_value_coordinates m_coordinates;
  Multilevel_transport_solver m_transport_solver;
  Triangle_tree m_tree;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_VOLUMETRIC_H
