// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_PATH_ENERGY_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_PATH_ENERGY_H

#include <CGAL/Geodesic_processing/internal/core/Path_surface.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_variants.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// How the nodes of a path are kept on a surface.
enum class Path_constraint
{
  projected, // each node is projected to the surface
  energy     // squared distances to the surface are part of the energy
};

struct Path_options
{
  Path_constraint constraint = Path_constraint::projected;
  double alpha = 0.7, beta = 0.7; // weights of the squared distances of nodes and of midpoints
  std::size_t number_of_control_points = 75; // maximum before segments are refined
  double tolerance = 1e-11; // a level ends if the energy decreases by less than this fraction
  // Maximum per level. On the kitten, paths need a hundred iterations to converge, but after 40
  // they become shorter by only 1e-6.
  std::size_t max_iterations = 40;
  double min_spacing = 0.; // fewer control points are used if they would be closer than this
  // If false, the result is the polyline of the control points. Segments are not halved, and no
  // smooth curve on the surface is fitted to the control points.
  bool do_fit_curve = true;
};

// The energy of a path v_0, ..., v_(n+1) (Ruggeri, Darom, Saupe and Kiryati 2006, Eq. 1-4):
//
//   sum |s_i|^2 / r_i  +  alpha sum d^2(v_i)  +  beta l^2 sum d^2(m_i) / |s_i|^2,
//   s_i = v_(i+1) - v_i
//
// Here, d is the distance to the surface and m_i is the midpoint of segment i. The factor l is the
// mean length of the segments at the beginning of a level. It makes the energy scale with the
// square of the unit of length. If nodes are projected, the second and the third sum are omitted.
//
// The relative lengths r_i are an extension of the paper. The first sum is minimal if the lengths
// of the segments are proportional to r_i.
struct Path_energy
{
  double value = 0.;
  std::vector<Vec3> gradient; // #nodes; zero at the ends
};

// The nodes of a path with their projections to the surface and the energy.
struct Path_state
{
  std::vector<Vec3> points;            // #nodes
  std::vector<Projection> projections; // #nodes: the projections of the nodes
  std::vector<Projection>
      midpoint_projections; // #segments: the projections of the segments' midpoints
  Path_energy energy;
};

// Computes the energy of a path and its gradient.
//
// relative_length  #segments: r_i
// mean_length      l
// state            in: points, and projections whose vertices are hints for the search;
//                  out: projections and energy; if nodes are projected, the points as well
//
// Linear in the number of nodes, with one projection per node and, for Path_constraint::energy, per
// segment. The endpoints are not projected.
CGAL_GEODESIC_PROCESSING_EXPORT
void evaluate_energy(const Path_surface& surface, const Path_options& options,
                     const std::vector<double>& relative_length, double mean_length,
                     Path_state& state);

// Minimizes the energy of a path locally; the endpoints are fixed.
//
// The method is Polak-Ribiere conjugate gradients with the tridiagonal matrix of the first sum as
// preconditioner and an interpolating line search. The energy never increases.
//
// path  in: at least the endpoints; out: the nodes. Paths of fewer than three nodes are unchanged.
CGAL_GEODESIC_PROCESSING_EXPORT
Path_energy_level minimize_energy(const Path_surface& surface, const Path_options& options,
                                  const std::vector<double>& relative_length,
                                  std::vector<Projection>& path);

struct Shortened_path
{
  // the smooth curve with four segments per control segment, or the control points, see
  // Path_options::do_fit_curve; including both endpoints
  std::vector<Projection> points;
  std::size_t number_of_control_points = 0;
  double length = 0.; // of the smooth curve, see curve_length(); or of the polyline
  double polyline_length = 0.;
  std::vector<Path_energy_level> levels;
};

// Shortens a path on a surface by a multilevel minimization of its energy.
//
// The number of segments doubles from level to level. Finally, segments whose midpoints are not on
// the surface are halved, for example at sharp edges or at the boundary.
//
// chain  points on the surface; at least one
CGAL_GEODESIC_PROCESSING_EXPORT
Shortened_path shorten_path(const Path_surface& surface, const Path_options& options,
                            const std::vector<Projection>& chain);

// Shortens a path near a surface that is given by its squared distance function. The method is
// that of the other overload with Path_constraint::energy.
//
// Throws Invalid_argument_error if there are fewer than two points, or if a point or a squared
// distance is not finite.
CGAL_GEODESIC_PROCESSING_EXPORT
Shortened_path shorten_path(const std::function<double(const Vec3&)>& squared_distance,
                            Path_options options, const std::vector<Vec3>& chain);

// Computes a smooth curve through nodes on a surface, by inserting sharp edges and subdividing each
// segment twice. Sets the points and the lengths of a path.
CGAL_GEODESIC_PROCESSING_EXPORT
void fit_curve(const Path_surface& surface, const std::vector<Projection>& nodes,
               Shortened_path& path);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_PATH_ENERGY_H
