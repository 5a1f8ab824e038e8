// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_DIAMETER_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_DIAMETER_H

#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/callback.h>
#include <CGAL/Geodesic_processing/internal/distances/diameter.h>
#include <CGAL/Geodesic_processing/is_supported.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <cstddef>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingDistances
/// The eccentricity of a source: the largest distance of a vertex or surfel from it.
template <typename Surface>
struct Geodesic_eccentricity
{
  using Vertex = typename internal::Surface_traits<Surface>::Vertex;

  double value = 0.;          ///< the eccentricity
  Vertex farthest = Vertex(); ///< a vertex or surfel at this distance
};

/// \ingroup PkgGeodesicProcessingDistances
/// Bounds of the diameter of a mesh: of the largest distance between two vertices.
template <typename Surface>
struct Geodesic_diameter
{
  using Vertex = typename internal::Surface_traits<Surface>::Vertex;

  double lower = 0.;      ///< the distance between `from` and `to`
  double upper = 0.;      ///< the diameter is at most this value
  Vertex from = Vertex(); ///< one end of a long shortest path
  Vertex to = Vertex();   ///< the other end
  /// Whether `upper` is at most `lower` times 1 + `relative_tolerance`
  bool is_converged = false;
  std::size_t number_of_iterations = 0; ///< the number of vertices whose distances were computed
};

/// \ingroup PkgGeodesicProcessingDistances
/// Bounds of the radius of a mesh: of the smallest eccentricity of a vertex.
template <typename Surface>
struct Geodesic_radius
{
  using Vertex = typename internal::Surface_traits<Surface>::Vertex;

  double lower = 0.;          ///< the radius is at least this value
  double upper = 0.;          ///< the eccentricity of `center`
  Vertex center = Vertex();   ///< a vertex from which no vertex is farther than `upper`
  Vertex farthest = Vertex(); ///< a vertex that is farthest from the center
  /// Whether `upper` is at most `lower` times 1 + `relative_tolerance`
  bool is_converged = false;
  std::size_t number_of_iterations = 0; ///< the number of vertices whose distances were computed
};

namespace internal {

// Reads the parameters of geodesic_diameter() and geodesic_radius().
template <typename NamedParameters>
Diameter_options diameter_options(const NamedParameters& np)
{
  static_assert(!has_parameter<NamedParameters, internal_np::speed_map_t> &&
                    !has_parameter<NamedParameters, internal_np::face_speed_map_t>,
                "Bounds of the diameter and of the radius do not support speeds, because they need "
                "exact distances.");
  Diameter_options result;
  result.relative_tolerance = parameter(np, internal_np::relative_tolerance, 0.01);
  if(!(result.relative_tolerance >= 0.))
    throw Invalid_argument_error("The relative tolerance is negative or not a number.");
  result.max_number_of_queries =
      parameter(np, internal_np::maximum_number_of_iterations, std::size_t(100));
  if(result.max_number_of_queries == 0)
    throw Invalid_argument_error("The maximum number of iterations is zero.");
  result.callback = read_throwing_callback(np);
  return result;
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingDistances
///
/// Computes the eccentricity of a vertex: the largest distance of a vertex or surfel from it, and
/// where it is attained. Vertices or surfels that are not reached are ignored.
///
/// \tparam Method as for `geodesic_distances()`
/// \tparam Surface as for `geodesic_distances()`
/// \tparam Sources as for `geodesic_distances()`
/// \param surface as for `geodesic_distances()`
/// \param sources a vertex, a surfel or a location. With several sources, the distance is that to
///        the nearest source, and the eccentricity is their covering radius
/// \param np the named parameters of `geodesic_distances()`
/// \returns a `Geodesic_eccentricity`
/// \throws as `geodesic_distances()`
///
/// Takes one distance computation. If several vertices or surfels are farthest, the result does not
/// depend on the number of threads.
template <typename Method = Automatic, typename Surface, typename Sources,
          typename NamedParameters = internal::Default_parameters>
Geodesic_eccentricity<Surface_of<Surface>>
geodesic_eccentricity(const Surface& surface, const Sources& sources,
                      const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  Geodesic_distance_solver<Surface_of<Surface>, Method> solver(domain, np);
  solver.compute(sources, np);
  Geodesic_eccentricity<Surface_of<Surface>> result;
  bool is_first = true;
  for(const auto& vertex : solver.reached())
  {
    const double distance = solver.distance(vertex);
    if(distance < internal::infinity && (is_first || distance > result.value))
    {
      result.value = distance;
      result.farthest = vertex;
      is_first = false;
    }
  }
  if(is_first)
    throw Invalid_argument_error("No vertex is reached from the sources.");
  return result;
}

/// \ingroup PkgGeodesicProcessingDistances
///
/// Bounds the diameter of a mesh: the largest distance between two vertices of one component.
///
/// Distances from a few vertices bound the distances between all pairs of vertices by the triangle
/// inequality. Distances are computed from more vertices until the bounds agree to the tolerance.
/// Both bounds are certain up to the errors that `Exact` states.
///
/// If the mesh has several components, the diameter is the largest one of them. Vertices without
/// faces are ignored.
///
/// \tparam Surface a model of `FaceListGraph`, or its domain
/// \param mesh as for `geodesic_distances()`, but not a cloud
/// \param np the named parameters of `make_domain()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{relative_tolerance}
///     \cgalParamDescription{the computation ends if `upper` is at most `lower` times one plus this
///       number. With zero, the result is the exact diameter}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0.01}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_iterations}
///     \cgalParamDescription{the maximum number of vertices of each component from which
///       distances are computed, positive. The bounds are also valid if it is reached}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{100}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a function that is called with the completed fraction; if it returns
///       false, the computation is canceled}
///     \cgalParamType{`std::function<bool(double)>`}
///     \cgalParamDefault{no callback}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns a `Geodesic_diameter`
/// \throws Invalid_argument_error if a parameter is invalid
/// \throws Unsupported_surface_error if the mesh has no faces, or if exact distances exceed their
///         limit of windows
/// \throws Cancelled if the callback returns false
///
/// Takes one exact computation on a component for each iteration; 5 to 15 are usual for a component
/// and a tolerance of 1 %. Takes 128 bytes per vertex of a component for each eight iterations.
template <typename Surface, typename NamedParameters = internal::Default_parameters>
Geodesic_diameter<Surface_of<Surface>>
geodesic_diameter(const Surface& mesh, const NamedParameters& np = NamedParameters())
{
  static_assert(internal::require_support<Function::geodesic_diameter, Surface>());
  const auto domain = make_domain(mesh, np);
  const double scale = domain.triangles()->scale;
  const internal::Diameter_bounds bounds =
      internal::bound_diameter(domain.triangles(), internal::diameter_options(np));
  Geodesic_diameter<Surface_of<Surface>> result;
  result.lower = scale * bounds.lower;
  result.upper = scale * bounds.upper;
  result.from = domain.vertex(bounds.from);
  result.to = domain.vertex(bounds.to);
  result.is_converged = bounds.is_converged;
  result.number_of_iterations = bounds.number_of_queries;
  return result;
}

/// \ingroup PkgGeodesicProcessingDistances
///
/// Bounds the radius of a mesh: the smallest eccentricity of a vertex. A vertex with this
/// eccentricity is a center of the mesh.
///
/// If the eccentricity of a vertex s is known, that of each vertex v differs from it by at most the
/// distance of v from s, and is at least this distance. Distances are computed from more vertices
/// until the bounds agree to the tolerance. Both bounds are certain up to the errors that `Exact`
/// states.
///
/// If the mesh has several components, eccentricities are those in the components, and the radius
/// is the largest radius of a component. Vertices without faces are ignored.
///
/// \tparam Surface a model of `FaceListGraph`, or its domain
/// \param mesh as for `geodesic_distances()`, but not a cloud
/// \param np as for `geodesic_diameter()`
/// \returns a `Geodesic_radius`
/// \throws as `geodesic_diameter()`
///
/// Takes one exact computation on a component for each iteration, and 8 bytes per vertex. The
/// number of iterations depends on the surface. If all eccentricities are similar, as on a sphere,
/// the bounds converge slowly: the samples must cover the surface with a radius of the requested
/// accuracy.
template <typename Surface, typename NamedParameters = internal::Default_parameters>
Geodesic_radius<Surface_of<Surface>> geodesic_radius(const Surface& mesh,
                                                     const NamedParameters& np = NamedParameters())
{
  static_assert(internal::require_support<Function::geodesic_radius, Surface>());
  const auto domain = make_domain(mesh, np);
  const double scale = domain.triangles()->scale;
  const internal::Radius_bounds bounds =
      internal::bound_radius(domain.triangles(), internal::diameter_options(np));
  Geodesic_radius<Surface_of<Surface>> result;
  result.lower = scale * bounds.lower;
  result.upper = scale * bounds.upper;
  result.center = domain.vertex(bounds.center);
  result.farthest = domain.vertex(bounds.farthest);
  result.is_converged = bounds.is_converged;
  result.number_of_iterations = bounds.number_of_queries;
  return result;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_DIAMETER_H
