// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_CHARTS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_CHARTS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/parameterization/outline.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A disc cut out of a mesh, and where its sites go in the plane.
struct Chart
{
  std::vector<Index> triangles; // of the mesh, those of the shape in their order
  Surface_arrays surface;       // lengths in the scale of the mesh
  std::vector<Vec2> image;      // #sites of the shape; empty until it is known
};

// Cuts out patches, which must be discs, and keeps those that are not empty.  O(n log n).
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Chart> extract_charts(const Surface_arrays& triangles, const std::vector<Index>& patch,
                                  Index number_of_patches);

// The image of the border of a disc, and on request its sides.
CGAL_GEODESIC_PROCESSING_EXPORT
Outline outline(const Chart& chart, std::vector<Index>* halfedges = nullptr);

// How many triangles of an image do not turn left.  Exact.
CGAL_GEODESIC_PROCESSING_EXPORT
std::size_t number_of_flips(const Chart& chart);

// Whether no two places have the same image.  Exact: triangles of a disc that all turn left, and whose border
// becomes a simple polygon, cover each place inside as often as the border winds around it, which is once.
CGAL_GEODESIC_PROCESSING_EXPORT
bool is_injective(const Chart& chart);

struct Chart_options
{
  std::size_t max_steps = 20;     // of Newton's method
  double energy_tolerance = 1e-3; // of a step, of the energy
  unsigned threads = 1;
  std::function<bool(double)> callback; // told the fraction done; false cancels
};

// Flattens patches, which must be discs: by geodesic locally linear embedding, then to less symmetric Dirichlet
// energy.  One whose border then meets itself is cut in two between the places that do, and so on: each chart
// is injective, and there may be more charts than patches.
//
// Nothing when the callback cancelled it.  Each chart on its own: threads change nothing.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Chart> injective_charts(const Surface_arrays& triangles,
                                    const std::vector<Index>& patch, Index number_of_patches,
                                    const Chart_options& options = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_CHARTS_H
