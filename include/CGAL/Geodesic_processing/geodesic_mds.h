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
/// Flattens a patch by multidimensional scaling of the distances between all pairs of base points.
/// \cgalCite{cgal:zkk-tmmds-02}
///
/// Distances are approximated as well as possible; long distances have the largest influence. Every
/// other vertex or surfel is embedded by its squared distances to all base points.
/// \cgalCite{cgal:st-smsulp-04} If all vertices are base points, this is classical scaling.
///
/// If shortest paths pass around holes or notches, distances differ from distances in the plane,
/// and the map is bent. `geodesic_lle()` uses distances between neighbors only and bends less.
///
/// Parameters, result and exceptions are the same as for `geodesic_lle()`, but
/// `number_of_neighbors` is not used. The default number of base points is 200.
///
/// Propagates two fronts over the whole surface for each base point.
///
/// \tparam Method as for `geodesic_lle()`
/// \tparam Surface as for `geodesic_distances()`
/// \tparam UVMap a model of `WritablePropertyMap` with vertices or surfels as keys and `Point_2` or
///         arrays of two numbers as values
/// \param surface as for `geodesic_lle()`
/// \param uv_map as for `geodesic_lle()`
/// \param np as for `geodesic_lle()`
/// \returns the base points
/// \throws as `geodesic_lle()`
template <typename Method = Euclidean_front, typename Surface, typename UVMap,
          typename NamedParameters = internal::Default_parameters>
std::vector<typename internal::Surface_traits<Surface_of<Surface>>::Vertex>
geodesic_mds(const Surface& surface, UVMap uv_map, const NamedParameters& np = NamedParameters())
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
