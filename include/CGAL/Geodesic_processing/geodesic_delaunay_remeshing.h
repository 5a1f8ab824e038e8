// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_DELAUNAY_REMESHING_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_DELAUNAY_REMESHING_H

#include <CGAL/Geodesic_processing/Geodesic_path_finder.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/Reconstructed_domain.h>
#include <CGAL/Geodesic_processing/internal/remeshing/remeshing.h>
#include <CGAL/Geodesic_processing/internal/adaptors/remeshing_options.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingRemeshing
/// The action if the requested number of samples is too small for a valid result.
enum class Too_few_samples
{
  refine, ///< add samples in the regions that need them
  /// throw `Invalid_argument_error`. Its message states how many samples `refine` uses. If that
  /// number is requested, the samples are others, which can be too few again
  are_wrong
};

/// \ingroup PkgGeodesicProcessingRemeshing
/// The summary of a remeshing.
struct Remeshing_result
{
  std::size_t number_of_added_vertices = 0; ///< number of vertices beyond the requested number
  /// Number of pairs of intersecting faces, as CGAL's `self_intersections()` counts them, but at
  /// most the number of faces. Computed only if self-intersections were to be avoided.
  std::size_t number_of_self_intersections = 0;
};

/// \ingroup PkgGeodesicProcessingRemeshing
///
/// Computes the geodesic Delaunay triangulation of samples on a mesh: a coarser or finer mesh of
/// the same surface, with well-shaped triangles. \cgalCite{cgal:pc-grfp-03}
///
/// From a clean surfel cloud it computes a coarse reconstruction. The input surface is then the
/// result of `advancing_front_surface_reconstruction()` on the cloud. Its triangles are as small as
/// the spacing of the surfels, so that gaps remain open.
///
/// Vertices lie on the input, unless `do_fit` is set. Samples are distributed as by
/// `farthest_point_sampling()`. On boundary cycles they have equal spacing. Corners of the boundary
/// are samples too, unless they are closer to each other than half of the spacing.
///
/// Two samples are connected by an edge if their Voronoi cells are adjacent. Three samples form a
/// face if their cells meet. Each connected component of the result has the genus, boundary cycles
/// and orientation of the input component. No two faces have the same vertices. Isolated vertices
/// are omitted. If the input has non-manifold vertices, the surface is separated there.
///
/// If faces of the result intersect, they are too far from the input, and samples are added there.
/// Close sheets of the input thus remain separate. Self-intersections of the input cannot be
/// removed in this way and remain. If ten rounds do not help, none of their samples are kept.
///
/// If four cells almost meet at a location, the edge that gives the larger minimum angle is chosen.
///
/// If cells are not disks, or meet in more than one arc, samples are added until the result has the
/// topology of the input. If the input has too few vertices to separate cells, its edges are split
/// at their midpoints as often as necessary. This does not change the surface.
///
/// \tparam Surface as for `geodesic_distances()`
/// \tparam OutputMesh a model of `MutableFaceGraph`
/// \param surface a model of `FaceListGraph`, all of whose faces are triangles, a model of
///        `SurfelRange`, or the domain of one
/// \param number the number of vertices; 0 requests one vertex, to which those are added
///        that the topology requires. This need not be the minimum
/// \param output a model of `MutableFaceGraph`, to which the vertices and faces are added
/// \param np parameters of `make_domain()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{too_few_samples}
///     \cgalParamDescription{the reaction to samples that are too few for the topology}
///     \cgalParamType{`Too_few_samples`}
///     \cgalParamDefault{`Too_few_samples::refine`}
///   \cgalParamNEnd
///   \cgalParamNBegin{first_samples}
///     \cgalParamDescription{a vertex, a location, or a range of these, which become the first
///       samples. They are included in `number`, and they are the first vertices of the output, in
///       this order}
///     \cgalParamType{a vertex, a surfel, a location, or a range of these}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{speed_map, face_speed_map}
///     \cgalParamDescription{as for `Geodesic_distance_solver::compute()`, but positive: triangles
///       are smaller in regions of lower speed}
///     \cgalParamType{as for `Geodesic_distance_solver::compute()`}
///     \cgalParamDefault{1 everywhere}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_relaxation_steps}
///     \cgalParamDescription{the number of Lloyd steps, which move samples to the centroids of
///       their cells and improve the shape of triangles. Each takes at most the time of one front
///       over the surface. First samples and samples on the boundary and on kept edges are fixed.
///       If samples move, the first half of them is placed by stratified random sampling instead of
///       farthest point sampling. Finally, samples are moved slightly in the output triangulation.
///       From 30 steps on, cells are determined on smaller triangles, which takes up to twice the
///       time}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{random_seed}
///     \cgalParamDescription{selects the vertex from which the first sample is farthest, and the
///       locations of stratified random samples}
///     \cgalParamType{`unsigned`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_deviation}
///     \cgalParamDescription{the maximum distance between input and output. It is measured from the
///       vertices of the input to the faces of the output. It is also measured from the centroids,
///       edge midpoints and vertices of the output's faces to the input. Vertices are added if a
///       distance is larger. Other locations on faces are not tested.}
///     \cgalParamType{`double`}
///     \cgalParamDefault{infinite}
///   \cgalParamNEnd
///   \cgalParamNBegin{do_fit}
///     \cgalParamDescription{whether vertices are moved off the surface to reduce the squared
///       distances of the input's vertices to the faces. They move by a fraction of the distance
///       between faces and surface. Vertices on the boundary and on kept edges are fixed.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{do_avoid_self_intersections}
///     \cgalParamDescription{whether vertices are added if faces intersect}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{sharp_angle}
///     \cgalParamDescription{an angle in degrees. Edges whose dihedral angle deviates from flat by
///       at least this angle are kept. They form polylines, and each polyline becomes a chain of
///       edges through samples at equal spacing and at its corners}
///     \cgalParamType{`double`, in degrees}
///     \cgalParamDefault{180: no edge is sharp}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{a property map that states for each edge of the input whether it is
///       kept in the same way. Supported for a mesh, but not for its domain}
///     \cgalParamType{a model of `ReadablePropertyMap` with edges of the mesh as keys and `bool` as
///       values}
///     \cgalParamDefault{no edge is constrained}
///   \cgalParamNEnd
///   \cgalParamNBegin{curve_spacing}
///     \cgalParamDescription{the approximate maximum distance between adjacent samples on the
///       boundary and on kept edges. It is approximate because each piece between two corners has
///       equal spacing. More samples are added if it exceeds the distance between samples
///       elsewhere.}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0: the distance between samples elsewhere}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_spacing_map}
///     \cgalParamDescription{the spacing for each edge of the input, used if the edge is kept; 0
///       selects `curve_spacing`. Supported for a mesh, but not for its domain}
///     \cgalParamType{a model of `ReadablePropertyMap` with edges of the mesh as keys and `double`
///       as values}
///     \cgalParamDefault{0 for all edges}
///   \cgalParamNEnd
///   \cgalParamNBegin{location_map}
///     \cgalParamDescription{receives for each vertex of the output the `Location<Surface>` of its
///       sample. On a cloud, samples are on the reconstructed surface, not necessarily at surfels:
///       the location is the closest one on the cloud}
///     \cgalParamType{a model of `WritablePropertyMap` with vertices of the output as keys and
///       `Location<Surface>` as values}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_path_output}
///     \cgalParamDescription{an output iterator that takes, for each edge of the output, a pair of
///       the edge and a `Surface_path`. The path leads from the edge's source to its target. It is
///       locally shortest}
///     \cgalParamType{a model of `OutputIterator` for pairs of an edge and a `Surface_path`}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a function that is called with the fraction done. If it returns false,
///       the function throws `Cancelled`}
///     \cgalParamType{`std::function<bool(double)>`}
///     \cgalParamDefault{no callback}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \pre Property maps have a value for each of their keys.
/// \returns a summary of the result
/// \throws Invalid_argument_error if a location or a speed is not usable, or if a nonzero number is
///         too small and `Too_few_samples::are_wrong` is set. The output is then unchanged
/// \throws Unsupported_surface_error if no surface can be reconstructed from the surfels of a
///         cloud, if it has too many components, or if 400 rounds of additional samples, 20 of
///         which may split edges of the surface instead, do not make the topology of the
///         result that of the surface. These rounds also end if they have
///         split edges until there are 20,000 vertices, and four times as many as before
/// \throws Cancelled if the callback returns false
///
/// Takes about the time of the sampling.
template <typename Surface, typename OutputMesh,
          typename NamedParameters = internal::Default_parameters>
Remeshing_result geodesic_delaunay_remeshing(const Surface& surface, std::size_t number,
                                             OutputMesh& output,
                                             const NamedParameters& np = NamedParameters())
{
  const auto input_domain = make_domain(surface, np);
  const auto& domain = internal::manifold_domain(input_domain);
  internal::Remeshing_options options = internal::remeshing_options(domain, number, np);
  options.does_avoid_self_intersections =
      internal::parameter(np, internal_np::do_avoid_self_intersections, true);
  const internal::Remeshing found = internal::remesh(domain.triangles(), options);
  if(!found.is_finished)
    throw Cancelled();
  Remeshing_result result;
  result.number_of_self_intersections = found.number_of_self_intersections;
  result.number_of_added_vertices = found.samples.size() - (std::min)(number, found.samples.size());
  if(number > 0 && result.number_of_added_vertices > 0 &&
     internal::parameter(np, internal_np::too_few_samples, Too_few_samples::refine) !=
         Too_few_samples::refine)
    throw Invalid_argument_error(std::to_string(number) +
                                 " samples are too few: additional ones in the regions that "
                                 "need them make " +
                                 std::to_string(found.samples.size()) + " samples.");

  using Graph = boost::graph_traits<OutputMesh>;
  using Vertex = typename Graph::vertex_descriptor;
  const auto points = get(CGAL::vertex_point, output);
  using Point = typename boost::property_traits<std::decay_t<decltype(points)>>::value_type;
  [[maybe_unused]] auto location_map = internal::parameter(np, internal_np::location_map, 0);
  std::vector<Vertex> vertices;
  for(std::size_t i = 0; i < found.samples.size(); ++i)
  {
    const auto& p = found.points[i];
    vertices.push_back(add_vertex(output));
    put(points, vertices.back(), Point(p[0], p[1], p[2]));
    if constexpr(internal::has_parameter<NamedParameters, internal_np::location_map_t>)
      put(location_map, vertices.back(), domain.outer(found.samples[i]));
  }
  std::vector<std::array<Vertex, 3>> faces;
  for(const auto& f : found.triangles)
    faces.push_back({vertices[f[0]], vertices[f[1]], vertices[f[2]]});
  CGAL::Euler::add_faces(faces, output);

  if constexpr(internal::has_parameter<NamedParameters, internal_np::edge_path_output_t>)
  {
    auto out = internal::parameter(np, internal_np::edge_path_output, 0);
    internal::Shortest_path_finder finder(input_domain.triangles());
    for(std::size_t i = 0; i < found.triangles.size(); ++i)
      for(int k = 0; k < 3; ++k)
      {
        const internal::Index a = found.triangles[i][k], b = found.triangles[i][(k + 1) % 3];
        const auto h = halfedge(vertices[a], vertices[b], output).first;
        // Reports an edge with two faces only once.
        if(a < b ||
           face(opposite(h, output), output) == boost::graph_traits<OutputMesh>::null_face())
        {
          const auto e = edge(h, output);
          const bool is_forward = source(halfedge(e, output), output) == vertices[a];
          *out++ = std::make_pair(
              e, internal::surface_path(
                     input_domain,
                     finder.locally_shortest_path(
                         input_domain.inner(domain.outer(found.samples[is_forward ? a : b])),
                         input_domain.inner(domain.outer(found.samples[is_forward ? b : a])))));
        }
      }
  }
  return result;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_DELAUNAY_REMESHING_H
