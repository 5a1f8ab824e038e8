// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_ATLAS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_ATLAS_H

#include <CGAL/Geodesic_processing/internal/parameterization/charts.h>
#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include <CGAL/Geodesic_processing/internal/sampling/tessellation.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

struct Atlas_options
{
  Tessellation_options
      tessellation; // its number of cells, its seed, its threads and its callback count for all
  Chart_options charts;
  std::size_t texels = 1024; // along a side of the texture
  std::size_t gutter = 4;    // texels between two charts
};

// Charts in the unit square.
struct Atlas
{
  std::size_t number_of_charts = 0;
  std::vector<Index> chart;           // #triangles
  std::vector<Vec2> coordinates;      // 3 #triangles: of corners
  std::size_t number_of_flips = 0;    // triangles that do not turn left there
  std::size_t number_of_overlaps = 0; // charts whose border meets itself there
  double coverage = 0.;               // the area of all charts
  double texels_per_length = 0.;      // in the scale of the triangles
  bool is_complete = true;            // false: the callback cancelled it, and there is nothing else
};

// Divides a mesh into discs, flattens each without flips or overlaps, and packs them.
//
// front, slowness: as for tessellate()
// Throws Invalid_argument_error where the texture has no room for the charts.
CGAL_GEODESIC_PROCESSING_EXPORT
Atlas make_atlas(std::shared_ptr<const Surface_arrays> triangles, const Front& front,
                 std::shared_ptr<const std::vector<double>> slowness, const Atlas_options& options);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_ATLAS_H
