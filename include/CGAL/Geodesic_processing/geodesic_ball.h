// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_BALL_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_BALL_H

#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/paths/ball_area.h>
#include <CGAL/Geodesic_processing/is_supported.h>
#include <CGAL/Geodesic_processing/isolines.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <iterator>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingPaths
/// The points of a mesh whose distance to the nearest source is at most a radius.
template <typename Surface>
struct Geodesic_ball
{
  using Face = typename boost::graph_traits<Surface>::face_descriptor;

  std::vector<Face> faces; ///< the faces whose three corners are in the ball
  double area = 0.;        ///< the area of the ball, in squared units of the coordinates
  /// The boundary of the ball, without the part that is on the boundary of the mesh. The ball is on
  /// the right.
  std::vector<Isoline<Surface>> circles;
};

namespace internal {

// Returns the vertices whose distances determine a ball: the corners of the faces with a source or
// with a vertex in the ball, and of the faces that are adjacent to these.
template <typename Domain, typename Solver, typename Sources>
std::vector<Index> vertices_of_ball(const Domain& domain, const Solver& solver,
                                    const Sources& input)
{
  const Surface_arrays& t = *domain.triangles();
  std::vector<Index> faces;
  for(const auto& vertex : solver.reached())
  {
    const Index v = domain.index(vertex);
    for(Index i = t.ring_begin[v]; i < t.ring_begin[v + 1]; ++i)
      faces.push_back(t.ring[i] / 3);
  }
  std::vector<std::size_t> labels;
  for(const Front_source& source : sources(domain, input, labels))
    for(const Surface_location& location : source.polyline)
      for(const Index face : triangles_at(t, canonical(t, location)))
        faces.push_back(face);
  std::vector<Index> result;
  for(const Index face : faces)
    for(const Index h : {3 * face, 3 * face + 1, 3 * face + 2})
    {
      result.push_back(t.corner[h]);
      if(t.twin[h] != none)
        result.push_back(t.corner[previous_halfedge(t.twin[h])]);
    }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingPaths
///
/// Computes the geodesic ball around sources: its faces, its area, and the geodesic circle that
/// bounds it.
///
/// Distances are exact. The circle consists of isolines with the named parameter `do_fit_circles`
/// of `isolines()`. It crosses an edge at most once. If no vertex is in the ball, there is no
/// circle.
///
/// The area is exact up to round-off errors in each face whose distances are those of one point in
/// its unfolded plane: on flat and developable surfaces, in all faces that do not meet the cut
/// locus. There, also the part of a face beyond an edge with both ends outside of the ball counts.
/// In the other faces, the ball is bounded by the polyline of the circle. For edges of length h,
/// the relative error of the area is then O(h<SUP>2</SUP>).
///
/// \tparam Surface a model of `FaceListGraph`, or its domain
/// \tparam Sources as for `geodesic_distances()`
/// \param mesh as for `geodesic_distances()`, but not a cloud
/// \param sources a vertex, a location, a `Source`, or a non-empty range of one of these: the
///        center or the centers
/// \param radius the radius, finite and not negative
/// \param np the named parameters of `make_domain()`, and `callback` as for
///        `Geodesic_distance_solver::compute()`
/// \returns a `Geodesic_ball`
/// \throws Invalid_argument_error if the radius is negative or not finite, or if a source is
/// invalid
/// \throws Unsupported_surface_error if exact distances exceed their limit of windows
/// \throws Cancelled if the callback returns false
///
/// After `make_domain()`, O(n) time for n faces to find the faces of the ball, and two distance
/// computations that end at the vertices near the circle.
template <typename Surface, typename Sources,
          typename NamedParameters = internal::Default_parameters>
Geodesic_ball<Surface_of<Surface>> geodesic_ball(const Surface& mesh, const Sources& sources,
                                                 double radius,
                                                 const NamedParameters& np = NamedParameters())
{
  static_assert(internal::require_support<Function::geodesic_ball, Surface>());
  static_assert(!internal::has_parameter<NamedParameters, internal_np::speed_map_t> &&
                    !internal::has_parameter<NamedParameters, internal_np::face_speed_map_t>,
                "geodesic_ball() does not support speeds, because areas need exact distances.");
  if(!(radius >= 0. && radius < internal::infinity))
    throw Invalid_argument_error("The radius of a ball is negative or not finite.");
  const auto domain = make_domain(mesh, np);
  using Domain = std::decay_t<decltype(domain)>;
  using Vertex = typename Domain::Vertex;

  Geodesic_distance_solver<typename Domain::Surface, Exact> solver(domain, np);
  const auto callback = internal::read_callback(np);
  solver.compute(sources, parameters::maximum_distance(radius).callback(callback));
  const std::vector<internal::Index> vertices = internal::vertices_of_ball(domain, solver, sources);
  std::vector<Vertex> targets;
  for(const internal::Index v : vertices)
    targets.push_back(domain.vertex(v));
  solver.compute(sources, parameters::targets(targets).callback(callback));

  const double scale = domain.triangles()->scale;
  std::vector<double> distances(domain.number_of_vertices(), internal::infinity);
  for(const internal::Index v : vertices)
    distances[v] = solver.distance(domain.vertex(v)) / scale;
  const internal::Ball ball =
      internal::measure_ball(*domain.triangles(), distances, radius / scale);
  Geodesic_ball<typename Domain::Surface> result;
  for(const internal::Index triangle : ball.triangles)
    result.faces.push_back(domain.face(triangle));
  result.area = scale * scale * ball.area;
  isolines(domain,
           boost::make_function_property_map<Vertex>(
               [&](const Vertex& v) -> double { return scale * distances[domain.index(v)]; }),
           std::array<double, 1>{radius}, std::back_inserter(result.circles),
           parameters::do_fit_circles(true));
  return result;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_BALL_H
