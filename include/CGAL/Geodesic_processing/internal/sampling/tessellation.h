// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SAMPLING_TESSELLATION_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SAMPLING_TESSELLATION_H

#include <CGAL/Geodesic_processing/internal/distances/front.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

struct Tessellation_options
{
  std::size_t number_of_cells = 1;
  unsigned max_steps = 20;
  double energy_tolerance = 1e-3; // stops if a step decreases the energy by a smaller fraction
  bool does_make_disks = false;   // adds cells until each patch of a mesh is a disk
  unsigned seed = 0;              // as in Sampling_options
  unsigned number_of_threads = 1;
  // Receives the fraction that is completed. If it returns false, the computation is cancelled.
  std::function<bool(double)> callback;
};

struct Tessellation
{
  std::vector<Surface_location> centers; // #cells
  // #triangles of a mesh or #surfels of a cloud: the cell, or none if no center reaches it.
  std::vector<Index> labels;
  // The energy of the initial centers, after each step and after each insertion of cells, in the
  // scale of the triangles.
  std::vector<double> energies;
  bool is_finished = true; // false if the callback cancelled
};

// Computes a centroidal Voronoi tessellation. Centers start at farthest points and move to the
// intrinsic centroids of their cells (Peyré and Cohen 2005, section 3) by gradient descent. The
// energy is the integral of squared distances to the closest center. No step increases it. A step
// takes about the time of five fronts over the surface. Fragments that are disconnected from their
// cell are merged with an adjacent cell if there is one.
//
// front: Euclidean on a cloud
// slowness: as in Front_limits, or null; distances are then travel times, and areas are those of
// the metric that measures travel times
CGAL_GEODESIC_PROCESSING_EXPORT
Tessellation tessellate(std::shared_ptr<const Surface_arrays> triangles, const Front& front,
                        std::shared_ptr<const std::vector<double>> slowness,
                        const Tessellation_options& options);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SAMPLING_TESSELLATION_H
