// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_VORONOI_DIAGRAM_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_VORONOI_DIAGRAM_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/internal/adaptors/method.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/internal/sampling/voronoi.h>
#include <CGAL/Geodesic_processing/is_supported.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/tags.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingSampling
/// A bisector between two cells of a geodesic Voronoi diagram.
///
/// Its ends are Voronoi vertices, in which three cells meet, or points on the boundary of the
/// surface. If the bisector is closed, its last location equals the first one.
template <typename Surface>
struct Voronoi_bisector
{
  using Location = typename internal::Surface_traits<Surface>::Location;
  using Point_3 = typename internal::Surface_traits<Surface>::Point_3;

  std::size_t left;                ///< the label of the cell on the left, seen from outside
  std::size_t right;               ///< the label of the cell on the right
  std::vector<Location> locations; ///< consecutive ones lie in a common face
  std::vector<Point_3> points;     ///< the points of the locations
};

namespace internal {

// A Voronoi diagram whose cells are numbered in increasing order of the labels of their seeds.
struct Labeled_voronoi
{
  std::vector<std::size_t> labels; // #cells
  Voronoi_diagram cells;

  std::size_t label(Index cell) const
  {
    return cell == none ? (std::numeric_limits<std::size_t>::max)() : labels[cell];
  }
};

// Computes the Voronoi diagram of seeds. Seeds with the same label share a cell.
template <typename Method, typename Domain, typename Seeds, typename NamedParameters>
Labeled_voronoi compute_labeled_voronoi(const Domain& domain, const Seeds& seeds,
                                        const NamedParameters& np)
{
  const Front_limits front_limits = limits(domain, np);
  std::vector<std::size_t> label_of_source;
  std::vector<Front_source> front_sources = sources(domain, seeds, label_of_source);
  std::vector<std::size_t> labels = label_of_source;
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  for(std::size_t i = 0; i < front_sources.size(); ++i)
    front_sources[i].label =
        Index(std::lower_bound(labels.begin(), labels.end(), label_of_source[i]) - labels.begin());
  Voronoi_diagram cells(domain.triangles(), Front(domain.triangles(), read_front_kind<Method>(np)),
                        front_sources, Index(labels.size()), front_limits);
  if(!cells.is_finished())
    throw Cancelled();
  return {std::move(labels), std::move(cells)};
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingSampling
///
/// Computes a geodesic Voronoi diagram: the nearest of several seeds for each vertex or surfel.
///
/// Each face is divided by linear interpolation of the differences of squared distances at its
/// corners. These differences are linear if fronts are circles around their sources. If sources
/// have offsets or a speed is given, distances are not squared. Bisectors are exact if the paths to
/// both seeds unfold to a plane, and of second order otherwise.
///
/// Cells are detected at vertices. A cell that contains no vertex of a face is not resolved inside
/// that face. Voronoi vertices are located to within one face. For n vertices there should be at
/// most n/4 seeds.
///
/// \tparam Method `Euclidean_front` (the default), `Fast_marching` or `Dijkstra`; `Runtime_method`
///         reads the named parameter `method`
/// \tparam Surface as for `geodesic_distances()`
/// \tparam Seeds as `Sources` of `geodesic_distances()`
/// \tparam LabelMap a model of `WritablePropertyMap` with vertices or surfels as keys and
///         `std::size_t` as values
/// \param surface as for `geodesic_distances()`; on a cloud only labels of surfels are available
/// \param seeds a vertex, a surfel, a location, a `Source`, or a nonempty range of one of these;
///        seeds with the same label share a cell
/// \param label_map receives for each vertex or surfel the label of its nearest seed. The default
///        label is the position of the seed in the range. If no seed reaches it, the value is the
///        largest `std::size_t`
/// \param np parameters of `make_domain()`; `maximum_distance`, `speed_map`, `face_speed_map` and
///        `callback` as for `Geodesic_distance_solver::compute()`; and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{face_label_map}
///     \cgalParamDescription{receives for each face the label of the cell that contains its
///       centroid; the largest `std::size_t` unless all of its vertices are reached}
///     \cgalParamType{a model of `WritablePropertyMap` with faces as keys and `std::size_t` as
///       values}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{bisector_output}
///     \cgalParamDescription{an output iterator that takes all bisectors as `Voronoi_bisector`}
///     \cgalParamType{a model of `OutputIterator` for `Voronoi_bisector`}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws as `Geodesic_distance_solver::compute()`
///
/// O(n log n): propagates one front over the whole surface, and one over each cell and its
/// surroundings.
template <typename Method = Euclidean_front, typename Surface, typename Seeds, typename LabelMap,
          typename NamedParameters = internal::Default_parameters>
void geodesic_voronoi_diagram(const Surface& surface, const Seeds& seeds, LabelMap label_map,
                              const NamedParameters& np = NamedParameters())
{
  using internal::Index;
  const auto domain = make_domain(surface, np);
  using Domain_surface = typename std::decay_t<decltype(domain)>::Surface;
  const auto found = internal::compute_labeled_voronoi<Method>(domain, seeds, np);
  const internal::Voronoi_diagram& voronoi = found.cells;
  const auto label = [&](Index cell) { return found.label(cell); };
  domain.write([&](Index v) { return label(voronoi.labels()[v]); }, label_map);

  constexpr bool has_face_labels =
      internal::has_parameter<NamedParameters, internal_np::face_label_map_t>;
  constexpr bool has_bisectors =
      internal::has_parameter<NamedParameters, internal_np::bisector_output_t>;
  static_assert(!internal::Is_cloud<Domain_surface>::value || !(has_face_labels || has_bisectors),
                "Face labels and bisectors need a mesh, because the triangles of a cloud overlap.");
  if constexpr(has_face_labels)
  {
    auto face_label_map = internal::parameter(np, internal_np::face_label_map, 0);
    for(Index f = 0; f < domain.triangles()->number_of_triangles(); ++f)
      put(face_label_map, domain.face(f), label(voronoi.triangle_label(f)));
  }
  if constexpr(has_bisectors)
  {
    auto out = internal::parameter(np, internal_np::bisector_output, 0);
    for(const internal::Voronoi_diagram::Bisector& internal_bisector : voronoi.bisectors())
    {
      Voronoi_bisector<Domain_surface> bisector{
          label(internal_bisector.left), label(internal_bisector.right), {}, {}};
      for(const internal::Surface_location& location : internal_bisector.polyline)
      {
        bisector.locations.push_back(domain.outer(location));
        bisector.points.push_back(domain.point(location));
      }
      *out++ = std::move(bisector);
    }
  }
}

/// \ingroup PkgGeodesicProcessingSampling
///
/// Splits a mesh along the bisectors of `geodesic_voronoi_diagram()`, so that each face of the
/// result lies in one cell.
///
/// Faces keep their orientation. Each cell is the set of faces with its label; it can be viewed as
/// a mesh by `CGAL::Face_filtered_graph`. If a bisector passes through a vertex, faces without area
/// are created.
///
/// \tparam Method as for `geodesic_voronoi_diagram()`
/// \tparam Surface a model of `FaceListGraph`, or its domain
/// \tparam Seeds as `Sources` of `geodesic_distances()`
/// \tparam TriangleMesh a model of `MutableFaceGraph`
/// \tparam FaceLabelMap a model of `WritablePropertyMap` with faces of `TriangleMesh` as keys and
///         `std::size_t` as values
/// \param mesh as for `geodesic_distances()`, but not a cloud
/// \param seeds as for `geodesic_voronoi_diagram()`
/// \param cells a model of `MutableFaceGraph` to which vertices and faces are added
/// \param label_map receives for each new face the label of its cell. If a corner of the original
///        face is not reached, the value is the largest `std::size_t`
/// \param np parameters of `make_domain()`; `maximum_distance`, `speed_map`, `face_speed_map` and
///        `callback` as for `Geodesic_distance_solver::compute()`
/// \throws Unsupported_surface_error if the faces around a vertex cannot be added to `cells`
/// \throws as `Geodesic_distance_solver::compute()`
///
/// O(n log n).
template <typename Method = Euclidean_front, typename Surface, typename Seeds,
          typename TriangleMesh, typename FaceLabelMap,
          typename NamedParameters = internal::Default_parameters>
void geodesic_voronoi_cells(const Surface& mesh, const Seeds& seeds, TriangleMesh& cells,
                            FaceLabelMap label_map, const NamedParameters& np = NamedParameters())
{
  using internal::Index;
  const auto domain = make_domain(mesh, np);
  static_assert(internal::require_support<Function::geodesic_voronoi_cells,
                                          typename std::decay_t<decltype(domain)>::Surface>());
  const auto found = internal::compute_labeled_voronoi<Method>(domain, seeds, np);
  const internal::Voronoi_diagram::Cut_mesh cut = found.cells.cut();

  auto points = get(vertex_point, cells);
  using Point_3 = typename boost::property_traits<decltype(points)>::value_type;
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices;
  for(const internal::Surface_location& location : cut.vertices)
  {
    const auto p = domain.point(location);
    vertices.push_back(add_vertex(cells));
    put(points, vertices.back(), Point_3(p.x(), p.y(), p.z()));
  }
  for(std::size_t f = 0; f < cut.labels.size(); ++f)
  {
    const std::array corners = {vertices[cut.corners[3 * f]], vertices[cut.corners[3 * f + 1]],
                                vertices[cut.corners[3 * f + 2]]};
    const auto face = CGAL::Euler::add_face(corners, cells);
    if(face == boost::graph_traits<TriangleMesh>::null_face())
      throw Unsupported_surface_error(
          "The faces around a vertex cannot be added to the output mesh.");
    put(label_map, face, found.label(cut.labels[f]));
  }
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_VORONOI_DIAGRAM_H
