// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEXTURE_ATLAS_H
#define CGAL_GEODESIC_PROCESSING_TEXTURE_ATLAS_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>
#include <CGAL/Geodesic_processing/internal/parameterization/atlas.h>
#include <CGAL/Geodesic_processing/internal/adaptors/Reconstructed_domain.h>
#include <CGAL/Geodesic_processing/internal/adaptors/add_faces.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/internal/adaptors/method.h>
#include <CGAL/Geodesic_processing/internal/adaptors/planar_value.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/tags.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingAtlas
/// The summary of an atlas that `texture_atlas()` computed.
struct Texture_atlas
{
  std::size_t number_of_charts = 0;   ///< the number of charts, at least one per component
  std::size_t number_of_flips = 0;    ///< faces whose image is not counterclockwise
  std::size_t number_of_overlaps = 0; ///< charts whose boundary intersects itself
  double coverage = 0.;               ///< the fraction of the unit square that charts cover
  double texels_per_length = 0.;      ///< approximate; equal for all charts

  /// Returns whether no two locations inside charts have the same texture coordinates.
  ///
  /// This is a certificate: both numbers are computed exactly from the coordinates that are
  /// written. If all faces of a disk are counterclockwise and its boundary is mapped to a simple
  /// polygon, the map is injective. O(1).
  bool is_injective() const { return number_of_flips == 0 && number_of_overlaps == 0; }
};

namespace internal {

// Computes the atlas of a mesh or of a reconstructed surface as the named parameters specify.
template <typename Method, typename Concurrency_tag, typename Domain, typename NamedParameters>
Atlas compute_atlas(const Domain& domain, std::size_t number, const NamedParameters& np)
{
  if(number == 0)
    throw Invalid_argument_error("The number of charts must be positive.");
  const Front_limits front_limits = limits(domain, np);
  Atlas_options options;
  options.tessellation.number_of_cells = number;
  options.tessellation.max_steps = parameter(np, internal_np::maximum_number_of_iterations, 5u);
  options.tessellation.seed = unsigned(parameter(np, CGAL::internal_np::random_seed, 0u));
  options.tessellation.number_of_threads = number_of_threads<Concurrency_tag>(np);
  options.tessellation.callback = front_limits.callback;
  options.texels = parameter(np, internal_np::texture_size, options.texels);
  options.gutter = parameter(np, internal_np::gutter_width, options.gutter);
  Atlas result =
      make_atlas(domain.triangles(), Front(domain.triangles(), read_front_kind<Method>(np)),
                 front_limits.slowness, options);
  if(!result.is_complete)
    throw Cancelled();
  return result;
}

// Writes the texture coordinates and the charts of a mesh and returns the summary.
//
// first_halfedge  a function of a triangle of the atlas: the halfedge that begins at its corner 0
// scale           the unit of the arrays
template <typename TriangleMesh, typename First_halfedge, typename UVMap, typename NamedParameters>
Texture_atlas write_atlas(const Atlas& atlas, const TriangleMesh& mesh,
                          const First_halfedge& first_halfedge, double scale, UVMap& corner_uv_map,
                          const NamedParameters& np)
{
  using Value = typename boost::property_traits<UVMap>::value_type;
  [[maybe_unused]] auto chart_map = parameter(np, internal_np::chart_map, 0);
  for(Index f = 0; f < atlas.chart.size(); ++f)
  {
    // Halfedge k begins at corner k, so it points to corner k + 1.
    auto h = first_halfedge(f);
    for(Index k = 0; k < 3; ++k, h = next(h, mesh))
    {
      const Vec2& p = atlas.coordinates[3 * f + (k + 1) % 3];
      put(corner_uv_map, h, planar_value<Value>(p[0], p[1]));
    }
    if constexpr(has_parameter<NamedParameters, internal_np::chart_map_t>)
      put(chart_map, face_of(h, mesh), std::size_t(atlas.chart[f]));
  }
  Texture_atlas result;
  result.number_of_charts = atlas.number_of_charts;
  result.number_of_flips = atlas.number_of_flips;
  result.number_of_overlaps = atlas.number_of_overlaps;
  result.coverage = atlas.coverage;
  result.texels_per_length = atlas.texels_per_length / scale;
  return result;
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingAtlas
///
/// Computes a texture atlas: cuts a mesh into charts of about equal size, flattens them, and packs
/// them into the unit square. \cgalCite{cgal:pc-grfgm-05}
///
/// Charts are the disks of `geodesic_centroidal_tessellation()`. Each is flattened as by
/// `geodesic_lle()` and `minimize_distortion()`, so no face is inverted. If the boundary of its
/// image intersects itself, the chart is split in two between the locations that intersect. All
/// charts have the same scale, and are packed as large as the packing allows.
///
/// Each corner of a face has its own coordinates, because the coordinates of a vertex differ
/// between the charts that meet in it.
///
/// \tparam Method `Euclidean_front` (the default), `Fast_marching` or `Dijkstra`, used for the
///         tessellation
/// \tparam Concurrency_tag `CGAL::Sequential_tag` (the default) or `CGAL::Parallel_tag`, which
///         processes several charts at a time, with the same result
/// \tparam Mesh a model of `FaceListGraph`, or its domain
/// \tparam UVMap a model of `WritablePropertyMap` with halfedges as keys and `Point_2` or arrays of
///         two numbers as values
/// \param mesh a triangle mesh, or its domain, of any topology, with any number of components and
///        boundary cycles
/// \param number the initial number of charts. More are created if cells are not disks, or if
///        charts would overlap themselves or stretch lengths by a mean factor of two. Components
///        without a chart also get one
/// \param corner_uv_map receives for each halfedge of a face the texture coordinates of the corner
///        that it points to: `Point_2` or arrays of two numbers, in the unit square
/// \param np parameters of `make_domain()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{texture_size}
///     \cgalParamDescription{texels along each edge of the texture, 16 to 16,384; the unit of the
///       gutter}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{1024}
///   \cgalParamNEnd
///   \cgalParamNBegin{gutter_width}
///     \cgalParamDescription{minimum number of texels between two charts along one of the axes.
///       Half as many are kept at the boundary of the texture. Bilinear lookup needs three}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{4}
///   \cgalParamNEnd
///   \cgalParamNBegin{chart_map}
///     \cgalParamDescription{a property map that receives the index of the chart of each face,
///       starting at 0}
///     \cgalParamType{a model of `WritablePropertyMap` with faces as keys and `std::size_t` as
///       values}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_iterations}
///     \cgalParamDescription{maximum number of steps of the tessellation}
///     \cgalParamType{`unsigned`}
///     \cgalParamDefault{5}
///   \cgalParamNEnd
///   \cgalParamNBegin{speed_map, face_speed_map}
///     \cgalParamDescription{as for `Geodesic_distance_solver::compute()`: charts are smaller in
///       regions of lower speed}
///     \cgalParamType{as for `Geodesic_distance_solver::compute()`}
///     \cgalParamDefault{1 everywhere}
///   \cgalParamNEnd
///   \cgalParamNBegin{random_seed}
///     \cgalParamDescription{as for `farthest_point_sampling()`}
///     \cgalParamType{`unsigned`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_threads}
///     \cgalParamDescription{number of threads with `CGAL::Parallel_tag`}
///     \cgalParamType{`unsigned`}
///     \cgalParamDefault{all hardware threads}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a function that is called with the fraction done. If it returns false,
///       the function throws `Cancelled`}
///     \cgalParamType{`std::function<bool(double)>`}
///     \cgalParamDefault{no callback}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns a summary with the certificate of injectivity
/// \throws Invalid_argument_error if a number is zero or out of range, a speed is not usable, or
///         the texture has too few texels for the charts
///
/// The tessellation and Newton's method each take about half of the time. Newton's method
/// factorizes a sparse matrix with two unknowns per vertex of a chart, at most 20 times.
template <typename Method = Euclidean_front, typename Concurrency_tag = Sequential_tag,
          typename Mesh, typename UVMap, typename NamedParameters = internal::Default_parameters,
          std::enable_if_t<internal::is_named_parameters<NamedParameters>, bool> = true>
Texture_atlas texture_atlas(const Mesh& mesh, std::size_t number, UVMap corner_uv_map,
                            const NamedParameters& np = NamedParameters())
{
  static_assert(!internal::Is_cloud<Surface_of<Mesh>>::value,
                "Texture coordinates need faces, which a cloud does not have: pass a mesh that "
                "receives the reconstructed surface as third argument.");
  using Halfedge = typename boost::graph_traits<Surface_of<Mesh>>::halfedge_descriptor;
  static_assert(internal::is_keyed_by<UVMap, Halfedge>,
                "Texture coordinates belong to corners of faces: corner_uv_map is a property map "
                "with halfedges as keys.");
  const auto domain = make_domain(mesh, np);
  const internal::Atlas atlas =
      internal::compute_atlas<Method, Concurrency_tag>(domain, number, np);
  return internal::write_atlas(
      atlas, domain.mesh(),
      [&](internal::Index f) { return halfedge(domain.face(f), domain.mesh()); },
      domain.triangles()->scale, corner_uv_map, np);
}

/// \ingroup PkgGeodesicProcessingAtlas
///
/// Computes a texture atlas of a cloud: reconstructs a mesh, as `geodesic_delaunay_remeshing()`,
/// and computes its atlas.
///
/// \tparam Method as for a mesh
/// \tparam Concurrency_tag as for a mesh
/// \tparam Cloud a model of `SurfelRange`, or its domain
/// \tparam OutputMesh a model of `MutableFaceGraph`
/// \tparam UVMap as for a mesh, with halfedges of `OutputMesh` as keys
/// \param cloud a clean cloud, or its domain
/// \param number as for a mesh
/// \param output receives the reconstructed mesh. Its vertices are surfels
/// \param corner_uv_map receives for each halfedge of a new face of `output` the texture
///        coordinates of the corner that it points to
/// \param np as for a mesh, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{location_map}
///     \cgalParamDescription{receives for each vertex of `output` its location on the cloud}
///     \cgalParamType{a model of `WritablePropertyMap` with vertices of `output` as keys and
///       `Location<Cloud>` as values}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns as for a mesh
/// \throws Unsupported_surface_error if no surface can be reconstructed from the surfels, or if it
///         has too many components
/// \throws as for a mesh
///
/// The time is that for a mesh, and O(n log n) for the reconstruction.
template <typename Method = Euclidean_front, typename Concurrency_tag = Sequential_tag,
          typename Cloud, typename OutputMesh, typename UVMap,
          typename NamedParameters = internal::Default_parameters,
          std::enable_if_t<!internal::is_named_parameters<UVMap>, bool> = true>
Texture_atlas texture_atlas(const Cloud& cloud, std::size_t number, OutputMesh& output,
                            UVMap corner_uv_map, const NamedParameters& np = NamedParameters())
{
  static_assert(internal::Is_cloud<Surface_of<Cloud>>::value,
                "An output mesh is needed only for a cloud: a mesh has faces of its own.");
  const internal::Reconstructed_domain<Surface_of<Cloud>> domain(make_domain(cloud, np));
  const internal::Atlas atlas =
      internal::compute_atlas<Method, Concurrency_tag>(domain, number, np);

  const internal::Used_triangles used = internal::used_triangles(*domain.triangles());
  std::vector<typename boost::graph_traits<OutputMesh>::vertex_descriptor> vertices;
  internal::add_faces(used.points, used.triangles, output, &vertices);
  if constexpr(internal::has_parameter<NamedParameters, internal_np::location_map_t>)
  {
    auto location_map = internal::parameter(np, internal_np::location_map, 0);
    for(std::size_t i = 0; i < vertices.size(); ++i)
      put(location_map, vertices[i],
          Location<Surface_of<Cloud>>{domain.vertex(used.vertices[i]), {0., 0.}});
  }
  return internal::write_atlas(
      atlas, output,
      [&](internal::Index f)
      {
        const auto& corners = used.triangles[f];
        return halfedge(vertices[corners[0]], vertices[corners[1]], output).first;
      },
      domain.triangles()->scale, corner_uv_map, np);
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_TEXTURE_ATLAS_H
