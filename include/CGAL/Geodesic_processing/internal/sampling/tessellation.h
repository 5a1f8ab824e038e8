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
  std::size_t number_of_cells = 1; // of cells
  unsigned max_steps = 20;
  double energy_tolerance = 1e-3; // of a step, relative: with less the energy stalls
  bool does_make_disks = false;   // of the patches of a mesh, by more cells than asked for
  unsigned seed = 0;
  unsigned threads = 1;
  std::function<bool(double)> callback; // told the fraction done; false cancels
};

struct Tessellation
{
  std::vector<Surface_location> centers; // one for each cell
  std::vector<Index>
      labels; // of each triangle, on a cloud of each site; none where no centre reaches
  std::vector<double>
      energies; // at the start, after each step and after cells were added, in the domain's scale
  bool is_finished = true; // false when the callback cancelled it
};

// The cells of farthest points, whose centres go to their intrinsic centres of mass (Peyré and Cohen 2005,
// section 3): down the gradient of the energy, the integral of squared distances, which no step raises.  Each
// costs about five fronts over the surface.  Cells of a mesh are in one piece, as far as one of their neighbours
// can take what is not.
//
// front: Euclidean on a cloud; slowness: as in Front_limits: distances are times then, and areas those of the
// metric that measures them
CGAL_GEODESIC_PROCESSING_EXPORT
Tessellation tessellate(std::shared_ptr<const Surface_arrays> triangles, const Front& front,
                        std::shared_ptr<const std::vector<double>> slowness,
                        const Tessellation_options& options);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SAMPLING_TESSELLATION_H
