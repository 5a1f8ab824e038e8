// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEXTURE_ATLAS_H
#define CGAL_GEODESIC_PROCESSING_TEXTURE_ATLAS_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>
#include <CGAL/Geodesic_processing/internal/parameterization/atlas.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/internal/adaptors/planar_value.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/tags.h>

#include <cstddef>
#include <type_traits>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingAtlas
/// what `texture_atlas()` has made.
struct Texture_atlas
{
  std::size_t number_of_charts = 0;
  std::size_t number_of_flips = 0;    ///< faces whose image does not turn counterclockwise
  std::size_t number_of_overlaps = 0; ///< charts whose border meets itself
  double coverage = 0.;               ///< the part of the unit square that charts cover
  double texels_per_length = 0.;      ///< about, anywhere on the mesh
  bool is_complete = true;            ///< false: the callback cancelled it, and nothing is written

  /// whether no two places inside of charts have the same texture coordinates. This is a certificate, as what
  /// it is made of is computed exactly from the coordinates that are written: of a disc whose faces all turn
  /// counterclockwise and whose border becomes a simple polygon, each place has an image of its own.
  bool is_injective() const { return number_of_flips == 0 && number_of_overlaps == 0; }
};

/// \ingroup PkgGeodesicProcessingAtlas
///
/// lays a mesh into the unit square, cut into charts of about equal size, for a texture. \cgalCite{cgal:pc-grfgm-05}
///
/// Charts are the discs of `geodesic_centroidal_tessellation()`. Each is flattened like by `geodesic_lle()` and
/// `minimize_distortion()`, so that no face is turned round. One whose border then meets itself is cut in two
/// between the places that do. All have the same scale, and are packed as large as room is found.
///
/// Corners of faces have coordinates each, as those of a vertex differ where charts meet in it.
///
/// \tparam Method `Euclidean_front` (the default), `Fast_marching` or `Dijkstra`: of the tessellation
/// \tparam Concurrency_tag `CGAL::Sequential_tag` (the default) or `CGAL::Parallel_tag`: several charts at a
///         time, with the same result
/// \param mesh a triangle mesh of any topology, with any number of components and borders
/// \param number of charts to begin with; there are more where cells are no discs, where charts would overlap
///        themselves or stretch lengths by two in the mean, and of components that no chart is left for
/// \param corner_uv_map receives for each halfedge of a face the texture coordinates of the corner that it points
///        to, `Point_2` or arrays of two numbers in the unit square
/// \param np what `make_domain()` takes, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{texture_size} \cgalParamDescription{texels along a side of the texture, 16 or more: what the
///     gutter is measured in} \cgalParamDefault{1024} \cgalParamNEnd
///   \cgalParamNBegin{gutter_width} \cgalParamDescription{texels between two charts along one of the axes, at
///     least, and half as many at the border; bilinear lookup needs three}
///     \cgalParamDefault{4} \cgalParamNEnd
///   \cgalParamNBegin{chart_map} \cgalParamDescription{a property map that receives the chart of each face, from 0
///     on} \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_iterations} \cgalParamDescription{steps of the tessellation at most}
///     \cgalParamDefault{5} \cgalParamNEnd
///   \cgalParamNBegin{speed_map} \cgalParamDescription{as for `geodesic_distances()`: charts are smaller where the
///     speed is lower} \cgalParamDefault{1 everywhere} \cgalParamNEnd
///   \cgalParamNBegin{random_seed} \cgalParamDescription{as for `farthest_point_sampling()`}
///     \cgalParamDefault{0} \cgalParamNEnd
///   \cgalParamNBegin{threads} \cgalParamDescription{with `CGAL::Parallel_tag`}
///     \cgalParamDefault{as many as the machine has} \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a `std::function<bool(double)>` that is told the fraction done and cancels by
///       returning false} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws Invalid_argument_error when a number is zero or out of range, a speed is not usable, or there is no
///         room for so many charts in so few texels
///
/// The tessellation and Newton's method take about half of the time each. The latter factorizes a sparse matrix of
/// two unknowns for each vertex of a chart, 20 times at most.
template <typename Method = Euclidean_front, typename Concurrency_tag = Sequential_tag,
          typename TriangleMesh, typename UVMap,
          typename NamedParameters = internal::Default_parameters>
Texture_atlas texture_atlas(const TriangleMesh& mesh, std::size_t number, UVMap corner_uv_map,
                            const NamedParameters& np = NamedParameters())
{
  static_assert(internal::is_front<Method>,
                "Charts are found by fronts: Euclidean_front, Fast_marching or Dijkstra.");
  using Value = typename boost::property_traits<UVMap>::value_type;
  static_assert(!internal::Is_cloud<TriangleMesh>::value,
                "Texture coordinates are of corners of faces; a surfel cloud has none.");
  if(number == 0)
    throw Invalid_argument_error("An atlas has one chart at least.");
  const auto domain = make_domain(mesh, np);
  const internal::Front_limits front_limits = internal::limits(domain, np);
  internal::Atlas_options options;
  options.tessellation.number_of_cells = number;
  options.tessellation.max_steps =
      internal::parameter(np, internal_np::maximum_number_of_iterations, 5u);
  options.tessellation.seed = unsigned(internal::parameter(np, CGAL::internal_np::random_seed, 0u));
  options.tessellation.threads = internal::threads<Concurrency_tag>(np);
  options.tessellation.callback = front_limits.callback;
  options.texels = internal::parameter(np, internal_np::texture_size, options.texels);
  options.gutter = internal::parameter(np, internal_np::gutter_width, options.gutter);
  const internal::Atlas found = internal::make_atlas(
      domain.triangles(), internal::Front(domain.triangles(), internal::front_kind<Method>()),
      front_limits.slowness, options);

  Texture_atlas result;
  result.is_complete = found.is_complete;
  if(!found.is_complete)
    return result;
  for(internal::Index f = 0; f < found.chart.size(); ++f)
  {
    // Corner k is where half-edge k begins, and where the one before it points to.
    auto h = halfedge(domain.face(f), mesh);
    for(internal::Index k = 0; k < 3; ++k, h = next(h, mesh))
    {
      const internal::Vec2& p = found.coordinates[3 * f + (k + 1) % 3];
      put(corner_uv_map, h, internal::planar_value<Value>(p[0], p[1]));
    }
  }
  if constexpr(internal::has_parameter<NamedParameters, internal_np::chart_map_t>)
  {
    auto chart_map = internal::parameter(np, internal_np::chart_map, 0);
    for(internal::Index f = 0; f < found.chart.size(); ++f)
      put(chart_map, domain.face(f), std::size_t(found.chart[f]));
  }
  result.number_of_charts = found.number_of_charts;
  result.number_of_flips = found.number_of_flips;
  result.number_of_overlaps = found.number_of_overlaps;
  result.coverage = found.coverage;
  result.texels_per_length = found.texels_per_length / domain.triangles()->scale;
  return result;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_TEXTURE_ATLAS_H
