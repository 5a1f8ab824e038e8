// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_DELAUNAY_REMESHING_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_DELAUNAY_REMESHING_H

#include <CGAL/Geodesic_processing/Geodesic_path_finder.h>
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
/// what to do when so many samples cannot make what is asked for.
enum class Too_few_samples
{
  refine,   ///< add some where they are missing
  are_wrong ///< throw `Invalid_argument_error`, which says how many it takes
};

/// \ingroup PkgGeodesicProcessingRemeshing
/// what became of a remeshing.
struct Remeshing_result
{
  std::size_t added = 0; ///< vertices beyond the number asked for
  /// pairs of faces that intersect though they were not to, as CGAL's `self_intersections()` counts them,
  /// but no more than there are faces
  std::size_t self_intersections = 0;
  bool is_finished = true; ///< false when the callback cancelled it; then the output is untouched
};

/// \ingroup PkgGeodesicProcessingRemeshing
///
/// covers a mesh with samples and joins them by the geodesic Delaunay triangulation: a coarser, or a
/// finer, mesh of the same surface, of even triangles. \cgalCite{cgal:pc-grfp-03}  Of a clean surfel
/// cloud it makes a coarse reconstruction: of the surface that `advancing_front_surface_reconstruction()`
/// lays through it, with triangles as small as the cloud's own, so that gaps stay open.
///
/// Vertices lie on the input, unless they are to fit it: samples spread as by `farthest_point_sampling()`, and along its borders
/// at equal steps and at their corners, if these are not nearer to each other than half of a step. They
/// have an edge where their Voronoi cells meet, and a face where three of these do. The result has the
/// topology of the input, component by component: genus, borders, orientation; no two faces have the
/// same vertices. Isolated vertices are left out, and where the input pinches at a vertex it is taken
/// apart there.
///
/// Where faces intersect they are too far from the input, and get more samples, too: near to each other
/// sheets of it stay apart. What intersects itself in the input cannot be cured so, and is left; where ten
/// rounds are in vain, none of their samples are kept.
///
/// Where four cells almost meet in a place, edges are those that make the least angle larger.
///
/// Cells that are not discs, or meet in more than an arc, get more samples until the result is that
/// surface. Where the input has too few vertices to tell cells apart, its edges are halved, as often as
/// it takes; the surface stays the same.
///
/// \param surface a model of `FaceListGraph`, all of whose faces are triangles, a model of
///        `SurfelRange`, or the domain of one
/// \param number of vertices; 0 asks for as few as it takes
/// \param output any model of `MutableFaceGraph`, to which the vertices and faces are added
/// \param np what `make_domain()` takes, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{too_few_samples}
///     \cgalParamDescription{a `Too_few_samples`}
///     \cgalParamDefault{`Too_few_samples::refine`} \cgalParamNEnd
///   \cgalParamNBegin{first_samples}
///     \cgalParamDescription{a vertex, a location, or a range of them: the first of the samples}
///     \cgalParamDefault{none} \cgalParamNEnd
///   \cgalParamNBegin{speed_map}
///     \cgalParamDescription{as for `geodesic_distances()`, but positive: triangles are smaller where
///       the speed is lower}
///     \cgalParamDefault{1 everywhere} \cgalParamNEnd
///   \cgalParamNBegin{number_of_relaxation_steps}
///     \cgalParamDescription{how often samples move to the centres of their cells, which makes triangles
///       more even; each takes no longer than a front over the whole surface. First samples and
///       those on borders and kept edges stay. Where samples move, the first half of them are strewn
///       instead of spread, and at last each moves a little more between its neighbours; for 30 steps and
///       more, cells are told apart on smaller triangles, which takes up to twice the time}
///     \cgalParamDefault{0} \cgalParamNEnd
///   \cgalParamNBegin{random_seed}
///     \cgalParamDescription{of the vertex from which the first sample is farthest, and of the places where
///       samples are strewn}
///     \cgalParamDefault{0} \cgalParamNEnd
///   \cgalParamNBegin{maximum_deviation}
///     \cgalParamDescription{how far vertices of the input may be from the faces of the output, and the centres
///       of these faces, the middles of their edges and their vertices from the faces of the input:
///       vertices are added where they are farther. Elsewhere on faces it is not measured.}
///     \cgalParamDefault{infinite} \cgalParamNEnd
///   \cgalParamNBegin{do_fit}
///     \cgalParamDescription{whether vertices leave the surface, by a part of what separates faces from
///       it, such that the input's vertices are near to faces in the sense of least squares. Those on
///       borders and kept edges stay.}
///     \cgalParamDefault{`false`} \cgalParamNEnd
///   \cgalParamNBegin{do_avoid_self_intersections}
///     \cgalParamDescription{whether vertices are added where faces intersect}
///     \cgalParamDefault{`true`} \cgalParamNEnd
///   \cgalParamNBegin{sharp_angle}
///     \cgalParamDescription{in degrees: edges at which the surface bends by at least as much are kept,
///       and so are the chains that they form: each becomes a chain of edges, through samples at equal
///       steps and at its corners}
///     \cgalParamDefault{180: none is} \cgalParamNEnd
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{tells of each edge of the input whether it is kept likewise; with a mesh, not
///       with its domain}
///     \cgalParamDefault{no edge is} \cgalParamNEnd
///   \cgalParamNBegin{curve_spacing}
///     \cgalParamDescription{how far apart samples on borders and kept edges are at most to be: about, as
///       each piece between two corners has steps of one length. More come where this is farther than
///       samples off the curves are from each other.}
///     \cgalParamDefault{0: as far as all the others} \cgalParamNEnd
///   \cgalParamNBegin{edge_spacing_map}
///     \cgalParamDescription{the same for each edge of the input, which matters where it is kept; 0
///       stands for `curve_spacing`; with a mesh, not with its domain}
///     \cgalParamDefault{0 for all} \cgalParamNEnd
///   \cgalParamNBegin{location_map}
///     \cgalParamDescription{receives for each vertex of the output the `Location<Surface>` of its
///       sample}
///     \cgalParamNEnd
///   \cgalParamNBegin{edge_path_output}
///     \cgalParamDescription{an output iterator that takes, for each edge of the output, a pair of it and
///       a `Surface_path` from its source to its target: a geodesic, straight in every face}
///     \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a `std::function<bool(double)>` that is told the fraction done and cancels
///       by returning false} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws Invalid_argument_error when a location or a speed is not usable, or a number that is not 0 is too
///         small and that is wrong; the output is untouched
/// \throws Unsupported_surface_error when no surface can be laid through the surfels of a cloud, or
///         one of too many parts
///
/// Takes about as long as the sampling.
template <typename Surface, typename OutputMesh,
          typename NamedParameters = internal::Default_parameters>
Remeshing_result geodesic_delaunay_remeshing(const Surface& surface, std::size_t number,
                                             OutputMesh& output,
                                             const NamedParameters& np = NamedParameters())
{
  const auto input_domain = make_domain(surface, np);
  const auto& domain = internal::manifold_domain(input_domain);
  internal::Remeshing_options options = internal::remeshing_options(surface, domain, number, np);
  options.does_avoid_self_intersections =
      internal::parameter(np, internal_np::do_avoid_self_intersections, true);
  const internal::Remeshing found = internal::remesh(domain.triangles(), options);
  Remeshing_result result;
  result.is_finished = found.is_finished;
  if(!found.is_finished)
    return result;
  result.self_intersections = found.number_of_self_intersections;
  result.added = found.samples.size() - (std::min)(number, found.samples.size());
  if(number > 0 && result.added > 0 &&
     internal::parameter(np, internal_np::too_few_samples, Too_few_samples::refine) !=
         Too_few_samples::refine)
    throw Invalid_argument_error(
        "With " + std::to_string(number) +
        " samples there is no mesh like the one that is asked for: it takes " +
        std::to_string(found.samples.size()) + ".");

  using Graph = boost::graph_traits<OutputMesh>;
  using Vertex = typename Graph::vertex_descriptor;
  const auto points = get(CGAL::vertex_point, output);
  using Point = typename boost::property_traits<std::decay_t<decltype(points)>>::value_type;
  std::vector<Vertex> vertices;
  for(std::size_t i = 0; i < found.samples.size(); ++i)
  {
    const auto& p = found.points[i];
    vertices.push_back(add_vertex(output));
    put(points, vertices.back(), Point(p[0], p[1], p[2]));
    if constexpr(internal::has_parameter<NamedParameters, internal_np::location_map_t>)
      put(internal::parameter(np, internal_np::location_map, 0), vertices.back(),
          domain.outer(found.samples[i]));
  }
  std::vector<std::array<Vertex, 3>> faces;
  for(const auto& f : found.triangles)
    faces.push_back({vertices[f[0]], vertices[f[1]], vertices[f[2]]});
  CGAL::Euler::add_faces(faces, output);

  if constexpr(internal::has_parameter<NamedParameters, internal_np::edge_path_output_t>)
  {
    auto out = internal::parameter(np, internal_np::edge_path_output, 0);
    Geodesic_path_finder<typename std::decay_t<decltype(input_domain)>::Surface> path(input_domain);
    for(std::size_t i = 0; i < found.triangles.size(); ++i)
      for(int k = 0; k < 3; ++k)
      {
        const internal::Index a = found.triangles[i][k], b = found.triangles[i][(k + 1) % 3];
        const auto h = halfedge(vertices[a], vertices[b], output).first;
        // Once for both faces.
        if(a < b || is_border(opposite(h, output), output))
        {
          const auto e = edge(h, output);
          const bool is_forward = source(halfedge(e, output), output) == vertices[a];
          *out++ = std::make_pair(e, path(domain.outer(found.samples[is_forward ? a : b]),
                                          domain.outer(found.samples[is_forward ? b : a])));
        }
      }
  }
  return result;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_DELAUNAY_REMESHING_H
