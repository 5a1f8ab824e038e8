// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_VORONOI_DIAGRAM_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_VORONOI_DIAGRAM_H

#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/internal/sampling/voronoi.h>
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
/// part of the line between two cells of a geodesic Voronoi diagram: from one place where three cells
/// meet, or from where the surface ends, to the next; or closed, then its last location is the first.
template <typename Surface>
struct Voronoi_bisector
{
  using Location = typename internal::Surface_traits<Surface>::Location;
  using Point_3 = typename internal::Surface_traits<Surface>::Point_3;

  std::size_t left;                ///< the label of the cell on the left, seen from outside
  std::size_t right;               ///< the label of the cell on the right
  std::vector<Location> locations; ///< consecutive ones lie in a common face
  std::vector<Point_3> points;     ///< the same in space
};

namespace internal {

// The cells of seeds, which have numbers in the order of their labels.
struct Labeled_voronoi
{
  std::vector<std::size_t> labels; // #cells
  Voronoi_diagram cells;

  std::size_t label(Index cell) const
  {
    return cell == none ? (std::numeric_limits<std::size_t>::max)() : labels[cell];
  }
};

template <typename Method, typename Domain, typename Seeds, typename NamedParameters>
Labeled_voronoi compute_labeled_voronoi(const Domain& domain, const Seeds& seeds,
                                        const NamedParameters& np)
{
  static_assert(is_front<Method>,
                "Cells are found by fronts: Euclidean_front, Fast_marching or Dijkstra.");
  const Front_limits front_limits = limits(domain, np);
  std::vector<std::size_t> label_of_source;
  std::vector<Front_source> front_sources = sources(domain, seeds, label_of_source);
  std::vector<std::size_t> labels = label_of_source;
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  for(std::size_t i = 0; i < front_sources.size(); ++i)
    front_sources[i].label =
        Index(std::lower_bound(labels.begin(), labels.end(), label_of_source[i]) - labels.begin());
  Voronoi_diagram cells(domain.triangles(), Front(domain.triangles(), front_kind<Method>()),
                        front_sources, Index(labels.size()), front_limits);
  return {std::move(labels), std::move(cells)};
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingSampling
///
/// finds the cells of a geodesic Voronoi diagram: which of several seeds is nearest.
///
/// Each face is divided by what is known of the distances at its corners: differences of squared
/// distances, linear where fronts are circles about their sources. The line between two cells is exact
/// wherever the way to both seeds unfolds to a plane, and of second order elsewhere. Cells are told
/// apart by vertices: one that comes to no vertex of a face is not seen in it, and where three cells meet
/// is known to within a face; for n vertices there should not be more than n/4 seeds.
///
/// \tparam Method `Euclidean_front` (the default), `Fast_marching` or `Dijkstra`
/// \param surface as for `geodesic_distances()`; on a cloud there are labels of surfels only
/// \param seeds a site, a location, a `Source`, or a range of one of these, not empty; those of one label
///        have a cell together
/// \param label_map receives for each site the label of its nearest seed, by default its position in the
///        range; the largest `std::size_t` where none reaches
/// \param np what `make_domain()` takes, `maximum_distance`, `speed_map` and `callback` as
///        `Geodesic_distance_solver::compute()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{face_label_map}
///     \cgalParamDescription{receives for each face the label of the cell that its centre lies in; the
///       largest `std::size_t` unless all of its vertices are reached} \cgalParamNEnd
///   \cgalParamNBegin{bisector_output}
///     \cgalParamDescription{an output iterator that takes `Voronoi_bisector`: all lines between cells}
///     \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns false if the callback cancelled it; then cells are too small
/// \throws as `Geodesic_distance_solver::compute()`
///
/// O(n log n): one front over the whole surface, and one over each cell and what is next to it.
template <typename Method = Euclidean_front, typename Surface, typename Seeds, typename LabelMap,
          typename NamedParameters = internal::Default_parameters>
bool geodesic_voronoi_diagram(const Surface& surface, const Seeds& seeds, LabelMap label_map,
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
                "A surfel cloud has no faces, and no lines between cells: its triangles overlap.");
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
  return voronoi.is_finished();
}

/// \ingroup PkgGeodesicProcessingSampling
///
/// cuts a mesh along the lines between the cells of `geodesic_voronoi_diagram()`: each face of the result
/// lies in one cell.
///
/// Faces keep their orientation.  A cell is the mesh of its faces, for instance as a
/// `CGAL::Face_filtered_graph`.  Where a line passes a vertex faces are without area.
///
/// \tparam Method as for `geodesic_voronoi_diagram()`
/// \param mesh as for `geodesic_distances()`, no cloud
/// \param seeds as for `geodesic_voronoi_diagram()`
/// \param cells a model of `MutableFaceGraph` to which vertices and faces are added
/// \param label_map receives for each new face the label of its cell; the largest `std::size_t` unless
///        all corners of the face that it is part of are reached
/// \param np what `make_domain()` takes, `maximum_distance`, `speed_map` and `callback` as
///        `Geodesic_distance_solver::compute()`
/// \returns false if the callback cancelled it; then cells are too small
/// \throws Unsupported_surface_error when the faces around a vertex cannot be put together again
/// \throws as `Geodesic_distance_solver::compute()`
///
/// O(n log n).
template <typename Method = Euclidean_front, typename Surface, typename Seeds,
          typename TriangleMesh, typename FaceLabelMap,
          typename NamedParameters = internal::Default_parameters>
bool geodesic_voronoi_cells(const Surface& mesh, const Seeds& seeds, TriangleMesh& cells,
                            FaceLabelMap label_map, const NamedParameters& np = NamedParameters())
{
  using internal::Index;
  const auto domain = make_domain(mesh, np);
  static_assert(!internal::Is_cloud<typename std::decay_t<decltype(domain)>::Surface>::value,
                "A surfel cloud has no faces to cut: its triangles overlap.");
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
      throw Unsupported_surface_error("The faces around a vertex cannot be put together again.");
    put(label_map, face, found.label(cut.labels[f]));
  }
  return found.cells.is_finished();
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_VORONOI_DIAGRAM_H
