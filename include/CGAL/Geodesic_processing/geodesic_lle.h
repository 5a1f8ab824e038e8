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
/// The initial embedding of base points for `geodesic_lle()`, before it is made as rigid as
/// possible.
enum class Flattening_start
{
  best, ///< both are tried, and the result that is closest to rigid is used
  /// locally linear embedding, after the linear map that fits the distances of neighbors
  lle,
  /// classical scaling of the distances along chains of base points
  mds
};

/// \ingroup PkgGeodesicProcessingFlattening
///
/// Flattens a patch by geodesic locally linear embedding. \cgalCite{cgal:pc-grfgm-05} It changes
/// distances between neighbors as little as possible; angles and areas are both distorted in
/// return.
///
/// A few <em>base points</em> are distributed over the patch. Each is a weighted mean of its
/// neighbors on the surface; the weights are computed from distances only. In the plane, base
/// points have the same weights and about the same distances.
///
/// Every other vertex or surfel is mapped to a weighted mean of the base points around it. These
/// weights are of the same kind and decrease smoothly to zero toward base points that are not used.
/// The map is therefore continuous, and varies smoothly between sparse base points.
///
/// If faces are inverted, up to 1,000 faces around them are moved until all are oriented correctly.
/// The rest of the map is fixed, and the symmetric Dirichlet energy of the moved faces is
/// minimized. Larger groups, which occur on patches of high curvature, are not changed, nor are
/// groups beyond a total of 3,000 faces. It is therefore not guaranteed that no face is inverted;
/// see `minimize_distortion()`.
///
/// \tparam Method `Euclidean_front` (the default), `Fast_marching` or `Dijkstra`
/// \tparam Surface as for `geodesic_distances()`
/// \tparam UVMap a model of `WritablePropertyMap` with vertices or surfels as keys and `Point_2` or
///         arrays of two numbers as values
/// \param surface as for `geodesic_distances()`: connected, possibly with holes. A
///        closed surface is accepted, but most of its faces overlap: cut it first, or use
///        `texture_atlas()`
/// \param uv_map receives the image of each vertex or surfel: a `Point_2` or an array of two
///        numbers, in the unit of the surface. Vertices without faces and surfels without neighbors
///        get NaN. Most faces are mapped counterclockwise.
/// \param np parameters of `make_domain()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{number_of_base_points}
///     \cgalParamDescription{from 3 to 1,000; if there are fewer vertices or surfels, all of them
///       are base points}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{200. On a narrow mesh up to 1,000, if the spacing of 200 base points would
///       exceed its mean width. The mean width is twice the area divided by the length of the
///       boundary}
///   \cgalParamNEnd
///   \cgalParamNBegin{base_points}
///     \cgalParamDescription{a range of different vertices or surfels that replace the farthest
///       point samples. An example is the output of `farthest_vertex_sampling()` with
///       `curvature_speeds()`, which is denser in regions of high curvature}
///     \cgalParamType{a range of vertices or surfels}
///     \cgalParamDefault{farthest point samples}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_neighbors}
///     \cgalParamDescription{the number of neighbors of each base point, at least 3. If base points
///       would form disconnected groups, it is increased by at most a quarter}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{10. If base points would form disconnected groups, it is increased until
///       they are connected}
///   \cgalParamNEnd
///   \cgalParamNBegin{flattening_start}
///     \cgalParamDescription{the initial embedding of the base points}
///     \cgalParamType{`Flattening_start`}
///     \cgalParamDefault{`Flattening_start::best`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_rigid_steps}
///     \cgalParamDescription{the number of steps that make the neighborhoods of the base points as
///       rigid as possible. If it is 0, the initial embedding is used, with `Flattening_start::lle`
///       that of \cgalCite{cgal:pc-grfgm-05}}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{30}
///   \cgalParamNEnd
///   \cgalParamNBegin{random_seed}
///     \cgalParamDescription{as for `farthest_vertex_sampling()`}
///     \cgalParamType{`unsigned`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a function that is called with the fraction done. If it returns false,
///       the function throws `Cancelled`}
///     \cgalParamType{`std::function<bool(double)>`}
///     \cgalParamDefault{no callback}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the base points
/// \throws Unsupported_surface_error if the surface is not connected
/// \throws Invalid_argument_error if there are fewer than three base points or a number is out of
///         range, or if `number_of_neighbors` is given and groups of base points have no neighbors
///         in each other
/// \throws Cancelled if the callback returns false
///
/// The front of each base point ends at the neighbors of its neighbors. With ten neighbors, all
/// fronts together visit each vertex fewer than twenty times. They take O(n log n) time,
/// independently of the number of base points. If the default number of neighbors is increased,
/// time and memory are proportional to it.
template <typename Method = Euclidean_front, typename Surface, typename UVMap,
          typename NamedParameters = internal::Default_parameters>
std::vector<typename internal::Surface_traits<Surface_of<Surface>>::Vertex>
geodesic_lle(const Surface& surface, UVMap uv_map, const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  const std::size_t neighbors =
      internal::parameter(np, internal_np::number_of_neighbors, std::size_t(10));
  if(neighbors < 3)
    throw Invalid_argument_error("The number of neighbors must be at least 3.");
  const Flattening_start start =
      internal::parameter(np, internal_np::flattening_start, Flattening_start::best);
  internal::Embedding_options options;
  options.use_lle = start != Flattening_start::mds;
  options.use_isomap = start != Flattening_start::lle;
  options.number_of_rigid_steps =
      internal::parameter(np, internal_np::number_of_rigid_steps, options.number_of_rigid_steps);
  return internal::flatten<Method>(
      domain, uv_map, np, internal::suitable_number_of_base_points(*domain.triangles()),
      [&](const auto& triangles, const auto& sampling, const auto& front, const auto& callback)
      {
        constexpr bool can_grow =
            !internal::has_parameter<NamedParameters, internal_np::number_of_neighbors_t>;
        const internal::Embedded_base_points found =
            embed_samples(triangles, sampling, front, neighbors, can_grow, callback, options);
        if(found.base.size() == 0)
          return std::vector<internal::Vec2>();
        if(found.positions.empty())
          throw Invalid_argument_error(
              "The neighbor graph of the base points is not connected: use more neighbors.");
        std::vector<internal::Vec2> image =
            extend_embedding(found.base, found.positions, found.neighbors);
        orient_positively(triangles, image);
        untangle(triangles, image);
        return image;
      });
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_LLE_H
