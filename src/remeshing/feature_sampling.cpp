// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/feature_sampling.h"

#include <CGAL/Geodesic_processing/exceptions.h>

#include <algorithm>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Longer than any feature polyline: edges are shorter than two in the scale of the arrays, and a
// polyline has fewer than 2^31 edges. It replaces larger spacings, which may be infinite.
constexpr double max_feature_length = 0x1p32;

} // namespace

std::size_t number_requested_on_features(const Refined_surface& surface,
                                         const std::vector<double>& requested_spacing)
{
  double result = 0.;
  for(Index h = 0; h < requested_spacing.size(); ++h)
    if(surface.is_coarse_feature()[h] && requested_spacing[h] > 0.)
      result += surface.coarse().length[h] / requested_spacing[h];
  if(!(result <= double(max_number_of_vertices)))
    throw Invalid_argument_error("The spacing along features is too small: the result would have "
                                 "more than 2^31 halfedges.");
  return std::size_t(result);
}

std::vector<double> feature_spacing(const Refined_surface& surface, double default_spacing,
                                    const std::vector<double>& requested_spacing)
{
  const Surface_arrays& t = surface.triangles();
  std::vector<double> result(t.corner.size(), 0.);
  if(!surface.has_features())
    return result;
  const std::vector<Index> coarse = coarse_halfedges(surface.refinement());
  for(Index h = 0; h < result.size(); ++h)
  {
    if(!surface.is_feature()[h])
      continue;
    const double requested = requested_spacing.empty() ? 0. : requested_spacing[coarse[h]];
    const Index twin = t.twin[h];
    const double min_slowness = twin == none
                                    ? surface.slowness(h / 3)
                                    : std::min(surface.slowness(h / 3), surface.slowness(twin / 3));
    const double spacing =
        (requested > 0. ? requested : default_spacing / min_slowness) / surface.unit_size();
    result[h] = std::min(spacing, max_feature_length);
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
