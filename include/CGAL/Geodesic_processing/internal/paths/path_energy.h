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

// What holds the nodes of a path on a surface.
enum class Path_constraint
{
  projected, // each node is a foot
  energy     // squared distances are part of the energy
};

struct Path_options
{
  Path_constraint constraint = Path_constraint::projected;
  double alpha = 0.7, beta = 0.7; // weights of the distances of nodes and of middles of segments
  std::size_t number_of_control_points = 75; // at most
  double tolerance = 1e-11; // relative decrease of the energy at which a level ends
  // At each level at most: the kitten's paths, which need a hundred, get shorter by 1e-6 after these.
  std::size_t max_iterations = 40;
  double min_spacing = 0.; // control points need not be nearer to each other
};

// The energy of a path v_0 .. v_(n+1) (Ruggeri, Darom, Saupe and Kiryati 2006, Eq. 1-4)
//
//   sum |s_i|^2  +  alpha sum d^2(v_i)  +  beta l^2 sum d^2(m_i) / |s_i|^2,    s_i = v_(i+1) - v_i
//
// where d is the distance from the surface, m_i the middle of a segment, and l the mean length of
// the segments when a level began: so the energy grows as the square of the unit of length.  Where
// nodes are projected the second sum is zero, and the third is left out.
//
// A segment that is meant to be shorter than others has a smaller share: |s_i|^2 / share_i takes the
// place of |s_i|^2 in the first sum, which is least when lengths are in the ratio of the shares.
struct Path_energy
{
  double value = 0.;
  std::vector<Vec3> gradient; // #nodes; zero at the ends
};

// A path with its energy.
struct Path_state
{
  std::vector<Vec3> points;              // #nodes
  std::vector<Projection> feet;          // #nodes: the closest surface points of the nodes
  std::vector<Projection> midpoint_feet; // #segments: those of the midpoints of segments
  Path_energy energy;
};

// At points, which move to their feet where nodes are projected.
//
// share  #segments; feet, middles  of the nodes and of the middles of segments; those given tell
// where to look.
CGAL_GEODESIC_PROCESSING_EXPORT
void evaluate_energy(const Path_surface& surface, const Path_options& options,
                     const std::vector<double>& relative_length, double mean_length,
                     Path_state& state);

// A minimum of the energy near to a path, whose ends stay: Polak-Ribiere conjugate gradients,
// preconditioned by the first sum's own matrix, which is tridiagonal, with a line search that
// interpolates and never goes up.
CGAL_GEODESIC_PROCESSING_EXPORT
Path_energy_level minimize_energy(const Path_surface& surface, const Path_options& options,
                                  const std::vector<double>& relative_length,
                                  std::vector<Projection>& path);

struct Shortened_path
{
  std::vector<Projection> points; // the curve, finer than its control points; both ends
  std::size_t number_of_control_points = 0;
  double length = 0.; // along arcs through the points
  double polyline_length = 0.;
  std::vector<Path_energy_level> levels;
};

// Straightens a chain of feet, from few control points to many, by twice as many at each level; then
// more where a segment leaves the surface, as at a sharp edge or a border.
CGAL_GEODESIC_PROCESSING_EXPORT
Shortened_path shorten_path(const Path_surface& surface, const Path_options& options,
                            const std::vector<Projection>& chain);

// The same of a chain of points near a surface that is known by squared distances alone: nodes are
// held by the energy.
// Throws Invalid_argument_error when there are fewer than two points, or one of them or a squared
// distance is not finite.
CGAL_GEODESIC_PROCESSING_EXPORT
Shortened_path shorten_path(const std::function<double(const Vec3&)>& squared_distance,
                            Path_options options, const std::vector<Vec3>& chain);

// Sets the points and the lengths of a path to those of a smooth curve through nodes on a surface,
// with three more points on each segment.
CGAL_GEODESIC_PROCESSING_EXPORT
void fit_curve(const Path_surface& surface, const std::vector<Projection>& nodes,
               Shortened_path& path);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_PATH_ENERGY_H
