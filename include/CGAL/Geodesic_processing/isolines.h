// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_ISOLINES_H
#define CGAL_GEODESIC_PROCESSING_ISOLINES_H

#include <CGAL/Geodesic_processing/internal/adaptors/callback.h>
#include <CGAL/Geodesic_processing/internal/adaptors/isovalues.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/paths/isolines.h>
#include <CGAL/Geodesic_processing/is_supported.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingPaths
/// A line of constant value on a mesh.
///
/// Larger values are on the left, seen from outside. If the line is closed, its last location
/// equals the first one. Otherwise its ends are on the boundary, or on edges of faces with a vertex
/// whose value is infinite or not a number.
template <typename Surface>
struct Isoline
{
  using Location = typename internal::Surface_traits<Surface>::Location;
  using Point_3 = typename internal::Surface_traits<Surface>::Point_3;

  double value = 0.;               ///< the value on the line
  bool is_closed = false;          ///< whether the line is a closed curve
  std::vector<Location> locations; ///< at least two; consecutive ones differ and share a face
  std::vector<Point_3> points;     ///< the points of the locations
  double length = 0.;              ///< the length of the polyline
};

/// \ingroup PkgGeodesicProcessingPaths
///
/// Computes the isolines of a function on a mesh, for example the offset curves of a point or of
/// the boundary from the result of `geodesic_distances()` \cgalCite{cgal:pc-grfp-03}.
///
/// The function is given at the vertices and is linear in each face. Isolines are maximal: they are
/// closed or end on the boundary, or on edges of faces that have a vertex without a finite value.
/// A vertex with the isovalue itself counts as above the isovalue. Therefore, for each isovalue:
/// - A face with a vertex below the isovalue and another vertex that is not below it is crossed by
///   exactly one isoline. Other faces are not crossed.
/// - The interior of an edge is crossed at most once.
/// - Isolines do not cross each other. If all values are finite, they are the boundary of the set
///   of points above the isovalue, without the part that is on the boundary of the mesh.
/// - If no vertex has the isovalue, isolines have no point in common. Otherwise, isolines can meet
///   in such vertices and run along the edges between them.
/// - If the value of a vertex is the isovalue and all adjacent vertices are below it, the set of
///   points above the isovalue is this vertex, and it has no isoline.
///
/// With linear interpolation of geodesic distances, the distance of a point of an isoline from its
/// source differs from the isovalue by O(h<SUP>2</SUP>) for edges of length h. With the named
/// parameter `do_fit_circles`, the vertices of isolines are exact where fronts are circles around a
/// source in the unfolded plane of an edge.
///
/// \tparam Surface a model of `FaceListGraph`, or its domain
/// \tparam ValueMap a model of `ReadablePropertyMap` with vertices as keys and numbers as values
/// \tparam Isovalues a model of `Range` whose elements are numbers
/// \tparam OutputIterator a model of `OutputIterator` for `Isoline<Surface_of<Surface>>`
/// \param mesh as for `geodesic_distances()`, but not a cloud
/// \param value_map the values of the vertices; they can be infinite or not a number
/// \param isovalues the values of the isolines, in any order
/// \param out takes the isolines in the order of the isovalues. For each isovalue, open isolines
///        precede closed ones
/// \param np parameters of `make_domain()`; and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{do_fit_circles}
///     \cgalParamDescription{whether values are interpolated along edges like distances from a
///       point in the plane, instead of linearly. If the values are geodesic distances from points,
///       isolines are more accurate, in particular near the points. Negative values are
///       interpolated linearly. The faces that an isoline crosses do not depend on this parameter.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a function that is called with the completed fraction before each
///       isovalue; if it returns false, the function throws `Cancelled`}
///     \cgalParamType{`std::function<bool(double)>`}
///     \cgalParamDefault{no callback}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \pre The property map has a value for each vertex.
/// \returns the output iterator after the last isoline
/// \throws Invalid_argument_error if an isovalue is infinite or not a number
/// \throws Cancelled if the callback returns false. Then nothing is written
/// \throws as `make_domain()`
///
/// O(n log k + m) for n vertices, k isovalues and m locations.
template <typename Surface, typename ValueMap, typename Isovalues, typename OutputIterator,
          typename NamedParameters = internal::Default_parameters>
OutputIterator isolines(const Surface& mesh, ValueMap value_map, const Isovalues& isovalues,
                        OutputIterator out, const NamedParameters& np = NamedParameters())
{
  static_assert(internal::require_support<Function::isolines, Surface>());
  const auto domain = make_domain(mesh, np);
  const internal::Surface_arrays& triangles = *domain.triangles();
  const std::vector<double> values = internal::function_values(domain, value_map);
  const std::vector<double> levels = internal::checked_isovalues(isovalues);
  for(const internal::Isoline& line :
      internal::find_isolines(triangles, values, levels, internal::edge_interpolation(np),
                              internal::read_throwing_callback(np)))
  {
    Isoline<typename std::decay_t<decltype(domain)>::Surface> isoline;
    isoline.value = levels[line.level];
    isoline.is_closed = line.is_closed;
    for(const internal::Surface_location& location : line.polyline)
    {
      isoline.locations.push_back(domain.outer(location));
      isoline.points.push_back(domain.point(location));
    }
    isoline.length = triangles.scale * internal::polyline_length(triangles, line.polyline);
    *out++ = std::move(isoline);
  }
  return out;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_ISOLINES_H
