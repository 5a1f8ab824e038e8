// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATH_ENERGY_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATH_ENERGY_H

#include <CGAL/Geodesic_processing/internal/Path_surface.h>
#include <CGAL/Geodesic_processing/internal/export.h>

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// What holds the nodes of a path on a surface.
enum class Path_hold
{
  projected, // each node is a foot
  energy     // squared distances are part of the energy
};

struct Path_options
{
  Path_hold hold = Path_hold::projected;
  double alpha = 0.7, beta = 0.7;   // weights of the distances of nodes and of middles of segments
  std::size_t control_points = 75;  // at most
  double tolerance = 1e-12;         // relative decrease of the energy at which a level ends
  std::size_t iterations = 200;     // at most, at each level
  double spacing = 0.;              // control points need not be nearer to each other
};

// How the energy went down at one level, of equally many control points.
struct Path_level
{
  std::size_t control_points = 0, iterations = 0;
  double first_energy = 0., last_energy = 0.;
};

// The energy of a path v_0 .. v_(n+1) (Ruggeri, Darom, Saupe and Kiryati 2006, Eq. 1-4)
//
//   sum |v_(i+1) - v_i|^2  +  alpha sum d^2(v_i)  +  beta l^2 sum d^2(m_i) / |v_(i+1) - v_i|^2
//
// where d is the distance from the surface, m_i the middle of a segment, and l the mean length of
// the segments when a level began: so the energy grows as the square of the unit of length.  Where
// nodes are projected the second sum is zero, and the third, which guards sharp edges, is left out.
struct Path_energy
{
  double value = 0.;
  std::vector<Spatial> gradient; // #nodes; zero at the ends
};

// At points, which move to their feet where nodes are projected.  `feet` and `middles`: the feet of
// nodes and of middles of segments; those given tell where to look.
CGAL_GEODESIC_PROCESSING_EXPORT
void evaluate(const Path_surface& surface, const Path_options& options, double mean_length,
              std::vector<Spatial>& points, std::vector<Foot>& feet, std::vector<Foot>& middles,
              Path_energy& energy);

// A minimum of the energy near to a path, whose ends stay: Polak-Ribiere conjugate gradients,
// preconditioned by the first sum's own matrix, which is tridiagonal, with a line search that
// interpolates and never goes up.
CGAL_GEODESIC_PROCESSING_EXPORT
Path_level minimize(const Path_surface& surface, const Path_options& options,
                    std::vector<Foot>& path);

struct Shortened_path
{
  std::vector<Foot> points;         // the curve, finer than its control points; both ends
  std::size_t control_points = 0;
  double length = 0.;               // along arcs through the points
  double polyline_length = 0.;
  std::vector<Path_level> levels;
};

// Straightens a chain of feet, from few control points to many, by twice as many at each level.
CGAL_GEODESIC_PROCESSING_EXPORT
Shortened_path shortened(const Path_surface& surface, const Path_options& options,
                         const std::vector<Foot>& chain);

// Of a smooth curve through points: the circle through three consecutive ones says by how much an
// arc is longer than its chord.  Where they turn by more than 30 degrees there is a corner.
CGAL_GEODESIC_PROCESSING_EXPORT
double length_along_arcs(const std::vector<Foot>& points);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATH_ENERGY_H
