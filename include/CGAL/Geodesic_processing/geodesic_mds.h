// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_MDS_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_MDS_H

#include <CGAL/Geodesic_processing/internal/adaptors/flattening.h>
#include <CGAL/Geodesic_processing/internal/parameterization/untangling.h>

#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingFlattening
///
/// flattens a patch by multidimensional scaling: the distances of all pairs of base points are kept as well as they
/// can be, far ones most of all. \cgalCite{cgal:zkk-tmmds-02}
///
/// Every other site goes where its squared distances to all base points ask for \cgalCite{cgal:st-smsulp-04}; with
/// all sites as base points this is classical scaling.  Where paths go around holes or
/// notches, distances are not those of a plane, and the map bends; `geodesic_lle()` sees neighbours alone, and
/// bends less.
///
/// Parameters, result and errors are those of `geodesic_lle()`, without neighbours, and with 200 base points by default.
///
/// Twice as many fronts over the whole surface as there are base points.
template <typename Method = Euclidean_front, typename Surface, typename UVMap,
          typename NamedParameters = internal::Default_parameters>
auto geodesic_mds(const Surface& surface, UVMap uv_map,
                  const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  return internal::flatten<Method>(
      domain, uv_map, np, internal::default_number_of_base_points,
      [](const auto& triangles, const auto& sampling, const auto& front, const auto& callback)
      {
        std::vector<internal::Index> base_points;
        for(const internal::Surface_location& sample : sampling.samples())
          base_points.push_back(sample.vertex);
        std::vector<internal::Vec2> image = landmark_mds(triangles, front, base_points, callback);
        if(!image.empty())
          orient_positively(triangles, image);
        return image;
      });
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_MDS_H
