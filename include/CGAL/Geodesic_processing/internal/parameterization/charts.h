// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_CHARTS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_CHARTS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/parameterization/outline.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A disk cut out of a mesh, and its image in the plane.
struct Chart
{
  std::vector<Index> triangles; // #triangles of `surface`: their indices in the mesh
  Surface_arrays surface;       // the disk; lengths in the scaled unit of the mesh
  std::vector<Vec2> image;      // #vertices of `surface`; empty if not computed yet
};

// Cuts out the nonempty patches. O(n log n).
// \pre Each patch is a disk.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Chart> extract_charts(const Surface_arrays& triangles, const std::vector<Index>& patch,
                                  Index number_of_patches);

// Returns the image of the boundary of a disk and, if requested, its halfedges in the same order.
CGAL_GEODESIC_PROCESSING_EXPORT
Outline outline(const Chart& chart, std::vector<Index>* halfedges = nullptr);

// Returns the number of triangles whose image is not counterclockwise. Exact.
CGAL_GEODESIC_PROCESSING_EXPORT
std::size_t number_of_flips(const Chart& chart);

// Returns whether the map is injective. Exact: if all images are counterclockwise and the boundary
// is mapped to a simple polygon, each point inside is covered as often as the boundary winds around
// it, which is once.
CGAL_GEODESIC_PROCESSING_EXPORT
bool is_injective(const Chart& chart);

// Returns the two triangles between which a chart that is not injective is split: those whose
// boundary edges intersect. If triangles are inverted, or if the edges belong to one triangle, they
// are those at the ends of the longest extent, because charts that are too distorted are long.
// \pre The chart has at least two triangles.
CGAL_GEODESIC_PROCESSING_EXPORT
std::array<Index, 2> triangles_to_separate(const Chart& chart);

// Splits a chart between two triangles into disks, which keep their part of its map.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Chart> split_chart(const Chart& chart, Index first, Index second);

struct Chart_options
{
  std::size_t max_steps = 20; // maximum number of Newton steps
  // the iteration ends if a step decreases the energy by less than this fraction
  double energy_tolerance = 1e-3;
  unsigned number_of_threads = 1;
  std::function<bool(double)> callback; // gets the fraction done; cancels by returning false
};

// Flattens patches, which must be disks. Each gets an initial map by geodesic locally linear
// embedding or Tutte's method; then the symmetric Dirichlet energy is minimized. If the result is
// not injective, the patch is split in two, if possible between two triangles whose boundary edges
// intersect, and both are flattened in turn. So each chart is injective, and there can be more
// charts than patches.
//
// Returns no charts if the callback cancelled. The result does not depend on the number of
// threads.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Chart> injective_charts(const Surface_arrays& triangles,
                                    const std::vector<Index>& patch, Index number_of_patches,
                                    const Chart_options& options = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_CHARTS_H
