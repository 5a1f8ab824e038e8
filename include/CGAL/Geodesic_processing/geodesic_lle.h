// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_LLE_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_LLE_H

#include <CGAL/Geodesic_processing/internal/adaptors/flattening.h>
#include <CGAL/Geodesic_processing/internal/parameterization/untangling.h>

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingFlattening
///
/// flattens a patch by geodesic locally linear embedding: as little as can be is done to distances between
/// neighbours, at the price of angles and of areas alike. \cgalCite{cgal:pc-grfgm-05}
///
/// A few <em>base points</em> are spread over the patch.  Each is a mean of its neighbours along the surface, with
/// weights that come from distances alone; the plane is where they have the same weights, and about the same
/// distances.  Every other site goes to the mean of the base points around it, with weights of the same kind,
/// which fade out smoothly towards those that it does not see: the map is continuous, and smooth between few base
/// points.
///
/// Where faces flip, up to a thousand about them are moved such that none does and, but for what is around them,
/// the symmetric Dirichlet energy is least.  Larger groups, as there are on patches that bend much, stay, and so do
/// those beyond three thousand faces: no face is promised not to flip, see `minimize_distortion()`.
///
/// \tparam Method `Euclidean_front` (the default), `Fast_marching` or `Dijkstra`
/// \param surface as for `geodesic_distances()`: one piece, which may have holes
/// \param uv_map receives where vertices or surfels go: values are `Point_2` or arrays of two numbers, which are
///        not numbers for vertices without faces and surfels without neighbors.  Lengths are the surface's; most faces
///        keep their side up.
/// \param np what `make_domain()` takes, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{number_of_base_points}
///     \cgalParamDescription{from 3 to 1,000, as many as there are sites where these are fewer}
///     \cgalParamDefault{200, and up to 1,000 on a mesh so narrow that those would be farther apart than it is wide
///       in the mean, which is twice its area over the length of its border} \cgalParamNEnd
///   \cgalParamNBegin{base_points}
///     \cgalParamDescription{a range of sites, each once: instead of farthest ones; such as those of
///       `farthest_vertex_sampling()` with `curvature_speeds()`, which are denser where the surface bends}
///     \cgalParamNEnd
///   \cgalParamNBegin{number_of_neighbors}
///     \cgalParamDescription{how many base points are around each; 3 or more. It is raised, by a quarter at most, where
///       groups of base points would know only themselves}
///     \cgalParamDefault{10} \cgalParamNEnd
///   \cgalParamNBegin{random_seed}
///     \cgalParamDescription{as for `farthest_vertex_sampling()`} \cgalParamDefault{0} \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a `std::function<bool(double)>` that is told the fraction done and cancels by
///       returning false: then nothing is written} \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the base points, or none when the callback cancelled it
/// \throws Unsupported_surface_error when the surface is not one piece
/// \throws Invalid_argument_error when there are less than three base points, or groups of them have no neighbors
///         in each other, or a number is out of range
///
/// The fronts of base points end where their neighbours' neighbours are: together they visit each site less than
/// twenty times for ten neighbours, whatever the number of base points.
template <typename Method = Euclidean_front, typename Surface, typename UVMap,
          typename NamedParameters = internal::Default_parameters>
auto geodesic_lle(const Surface& surface, UVMap uv_map,
                  const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  const std::size_t neighbors =
      internal::parameter(np, internal_np::number_of_neighbors, std::size_t(10));
  if(neighbors < 3)
    throw Invalid_argument_error("Each base point needs three neighbors or more.");
  return internal::flatten<Method>(
      domain, uv_map, np, internal::suitable_number_of_base_points(*domain.triangles()),
      [&](const auto& triangles, const auto& sampling, const auto& front, const auto& callback)
      {
        const internal::Base_points base = internal::nearest_base_points(
            triangles, sampling, front, internal::number_of_nearest_for(neighbors), callback);
        if(base.size() == 0)
          return std::vector<internal::Vec2>();
        const std::vector<internal::Vec2> positions = embed_base_points(base, neighbors);
        if(positions.empty())
          throw Invalid_argument_error(
              "Base points are in groups apart: give more of their neighbors.");
        std::vector<internal::Vec2> image = extend_embedding(base, positions, neighbors);
        orient_positively(triangles, image);
        untangle(triangles, image);
        return image;
      });
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_LLE_H
