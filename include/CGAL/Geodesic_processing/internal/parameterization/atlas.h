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
  Tessellation_options tessellation; // its seed, number of threads and callback apply to all stages
  Chart_options charts;
  std::size_t texels = 1024; // texels along each edge of the texture
  std::size_t gutter = 4;    // minimum number of texels between two charts
};

// Charts in the unit square.
struct Atlas
{
  std::size_t number_of_charts = 0;
  std::vector<Index> chart;           // #triangles: the chart of each triangle
  std::vector<Vec2> coordinates;      // 3 #triangles: UV coordinates of each corner
  std::size_t number_of_flips = 0;    // triangles whose image is not counterclockwise
  std::size_t number_of_overlaps = 0; // charts whose boundary intersects itself
  double coverage = 0.;               // the sum of the areas of the charts
  double texels_per_length = 0.;      // per scaled length
  bool is_complete = true;            // false if the callback cancelled; nothing else is set then
};

// Divides a mesh into disks, flattens each of them injectively and packs them into a texture.
//
// front, slowness: as for tessellate()
// Throws Invalid_argument_error if the texture is too small for the charts.
CGAL_GEODESIC_PROCESSING_EXPORT
Atlas make_atlas(std::shared_ptr<const Surface_arrays> triangles, const Front& front,
                 std::shared_ptr<const std::vector<double>> slowness, const Atlas_options& options);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_ATLAS_H
