// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_DISTANCE_DERIVATIVES_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_DISTANCE_DERIVATIVES_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/internal/distances/distance_derivatives.h>
#include <CGAL/Geodesic_processing/is_supported.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <CGAL/Origin.h>

#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing {

#ifndef DOXYGEN_RUNNING
using internal::Differentiability;
#else

/// \ingroup PkgGeodesicProcessingDistances
/// Whether a distance is differentiable, or the first test that fails. The tests are made in this
/// order.
enum class Differentiability
{
  differentiable, ///< all tests succeed
  unreachable,    ///< no path connects both locations
  coincident,     ///< both locations are the same point, up to round-off errors
  /// The shortest path is too close to a vertex. It crosses an edge at a distance from one of its
  /// ends that is less than `vertex_tolerance` times the length of the edge. Or it bends at a
  /// vertex, and on one side its angle exceeds \f$ \pi \f$ by less than `vertex_tolerance`. On the
  /// boundary, only the angle on the surface counts. The ends of the path may be at vertices.
  /// Close to vertices, the derivative exists as a rule, but the second derivative does not
  near_vertex,
  /// There is a second locally shortest path that crosses other edges, or bends at other vertices.
  /// It is longer than the distance by at most `second_path_tolerance` times the distance. The
  /// test also fails if the search for this path exceeds 2<SUP>20</SUP> windows
  second_path
};
#endif

/// \ingroup PkgGeodesicProcessingDistances
/// The distance between two locations on a mesh and its derivatives. These have no unit, since they
/// are lengths divided by lengths.
template <typename Surface>
struct Geodesic_distance_derivatives
{
  using Vertex = typename internal::Surface_traits<Surface>::Vertex;
  using Vector_3 = typename internal::Surface_traits<Surface>::Vector_3;

  /// The distance; +infinity if no path connects both locations
  double distance = std::numeric_limits<double>::infinity();
  /// Whether the distance is differentiable. If it is `near_vertex` or `second_path`, the
  /// derivatives are those of one shortest path
  Differentiability differentiability = Differentiability::unreachable;
  /// The gradient with respect to the source: the unit tangent vector that points away from the
  /// path, in the face in which the path begins
  Vector_3 source_gradient = NULL_VECTOR;
  /// The gradient with respect to the target, as `source_gradient`
  Vector_3 target_gradient = NULL_VECTOR;
  /// The gradients with respect to the positions of vertices. Both locations move with the vertices
  /// of their faces: their barycentric coordinates are constant. The vertices are in the order of
  /// the path, from the source to the target. All other vertices have gradient zero
  std::vector<std::pair<Vertex, Vector_3>> vertex_gradients;

  /// Returns whether the distance is differentiable. O(1).
  bool is_differentiable() const { return differentiability == Differentiability::differentiable; }
};

/// \ingroup PkgGeodesicProcessingDistances
///
/// Computes the exact distance between two locations on a mesh and its derivatives with respect to
/// source, target and vertices.
///
/// The shortest path crosses edges at points that minimize its length. Therefore only the motion of
/// its ends and of the vertices of these edges contributes. For a point of the path with unit
/// vectors `u` from the previous point and `w` to the next point, each vertex of its edge or face
/// has the term `u - w` times its barycentric coordinate.
///
/// If all vertices are translated, the distance is constant: the sum of `vertex_gradients` is zero.
/// If all vertices are scaled, the distance is scaled: the sum of the scalar products of
/// `vertex_gradients` and positions is the distance.
///
/// Distances are not differentiable everywhere. `Differentiability` states the tests that are made
/// and the cases that they reject. If a source or target is a vertex or on an edge,
/// `vertex_gradients` is defined as elsewhere, and `source_gradient` and `target_gradient` are
/// gradients in the face of the path.
///
/// \tparam Surface a model of `FaceListGraph`, or its domain
/// \tparam SourceLocation, TargetLocation a vertex or a `Location<Surface>`
/// \param mesh as for `geodesic_distances()`, but not a cloud
/// \param source, target vertices or locations
/// \param np parameters of `make_domain()`; and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_tolerance}
///     \cgalParamDescription{the minimum distance of crossed edges from their ends, as a fraction
///       of the length of the edge, and the minimum excess, in radians, of the angles at vertices
///       where the path bends; see `Differentiability::near_vertex`}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`1e-4`}
///   \cgalParamNEnd
///   \cgalParamNBegin{second_path_tolerance}
///     \cgalParamDescription{the minimum excess of the length of another path, as a fraction of the
///       distance; see `Differentiability::second_path`}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`1e-6`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns the distance and its derivatives
/// \throws Invalid_argument_error if a location is invalid, or if a tolerance is negative or not a
///         number
/// \throws Unsupported_surface_error if degenerate faces prevent the construction of the path
/// \throws as `make_domain()`
///
/// Takes one exact distance computation that stops at the target, and a search for a second path
/// near the first one, after `make_domain()`.
template <typename Surface, typename SourceLocation, typename TargetLocation,
          typename NamedParameters = internal::Default_parameters>
Geodesic_distance_derivatives<Surface_of<Surface>>
geodesic_distance_derivatives(const Surface& mesh, const SourceLocation& source,
                              const TargetLocation& target,
                              const NamedParameters& np = NamedParameters())
{
  static_assert(internal::require_support<Function::geodesic_distance_derivatives, Surface>());
  using Result = Geodesic_distance_derivatives<Surface_of<Surface>>;
  const auto domain = make_domain(mesh, np);
  internal::Derivative_tolerances tolerances;
  tolerances.vertex = internal::parameter(np, internal_np::vertex_tolerance, tolerances.vertex);
  tolerances.second_path =
      internal::parameter(np, internal_np::second_path_tolerance, tolerances.second_path);
  if(!(tolerances.vertex >= 0. && tolerances.second_path >= 0.))
    throw Invalid_argument_error("A tolerance is negative or not a number.");
  const internal::Distance_derivatives derivatives =
      internal::distance_derivatives(domain.triangles(), internal::location(domain, source),
                                     internal::location(domain, target), tolerances);
  const auto vector = [](const internal::Vec3& v)
  { return typename Result::Vector_3(v[0], v[1], v[2]); };
  Result result;
  result.distance = domain.triangles()->scale * derivatives.distance;
  result.differentiability = derivatives.differentiability;
  result.source_gradient = vector(derivatives.source_gradient);
  result.target_gradient = vector(derivatives.target_gradient);
  for(const auto& [vertex, gradient] : derivatives.vertex_gradients)
    result.vertex_gradients.emplace_back(domain.vertex(vertex), vector(gradient));
  return result;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_DISTANCE_DERIVATIVES_H
