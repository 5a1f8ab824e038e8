// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_VARIANTS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_VARIANTS_H

#include <cstddef>

// The choices of paths on surfel clouds. The public header of the same name documents them.

namespace CGAL::Geodesic_processing::internal {

enum class Surfel_graph
{
  extended_spheres,
  spheres,
  nearest
};

enum class Surfel_search
{
  coarse_to_fine,
  a_star,
  bidirectional,
  dijkstra
};

enum class Surfel_path_method
{
  projected_quadrics,
  projected_spheres,
  projected_planes,
  spheres,
  robust_spheres,
  planes,
  disks
};

enum class Surfel_noise
{
  removed_when_found,
  removed,
  kept
};

struct Path_energy_level
{
  std::size_t number_of_control_points = 0;
  std::size_t number_of_iterations = 0;
  double first_energy = 0.;
  double last_energy = 0.;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_VARIANTS_H
