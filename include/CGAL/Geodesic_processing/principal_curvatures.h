// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_PRINCIPAL_CURVATURES_H
#define CGAL_GEODESIC_PROCESSING_PRINCIPAL_CURVATURES_H

#include <CGAL/Geodesic_processing/internal/curvature/curvature.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <CGAL/Origin.h>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingCurvature
/// The principal curvatures of a vertex or surfel, and the principal directions. The unit of the
/// curvatures is the inverse of the coordinates' unit. They are positive if the surface is convex:
/// if it bends away from the normal, as a sphere with outward normals.
template <typename Surface>
struct Principal_curvatures
{
  using Vector_3 = typename internal::Surface_traits<Surface>::Vector_3;

  double min_curvature = 0.; ///< the smaller principal curvature
  double max_curvature = 0.; ///< the larger principal curvature
  /// The unit vector in space in whose direction the curvature is `min_curvature`; zero if the
  /// curvature is undefined, as at isolated vertices.
  Vector_3 min_direction = NULL_VECTOR;
  /// The unit vector for `max_curvature`, orthogonal to `min_direction`; zero if undefined.
  Vector_3 max_direction = NULL_VECTOR;
};

namespace internal {

// Returns the named parameter `ball_radius`; 0 if it is not given, so that the kernel uses its
// default. Throws Invalid_argument_error if it is negative or not a number.
template <typename NamedParameters>
double ball_radius(const NamedParameters& np)
{
  const double radius = parameter(np, internal_np::ball_radius, 0.);
  if(!(radius >= 0.))
    throw Invalid_argument_error("The radius of the ball is negative or not a number.");
  return radius;
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingCurvature
///
/// Estimates the principal curvatures and directions at each vertex or surfel.
///
/// On a mesh, the curvature tensor of the edges' normal cycles is averaged over a geodesic ball
/// \cgalCite{cgal:csm-rdtnc-03}. Normal cycles depend on the dihedral angles of the edges. Face
/// normals follow the counterclockwise orientation. On a cloud, a quadric is fitted to the surfels
/// of the ball \cgalCite{cgal:cp-edqpf-05}. A larger ball reduces both noise and detail.
///
/// \tparam Concurrency_tag `CGAL::Sequential_tag` (the default) or `CGAL::Parallel_tag`; both give
///         the same result
/// \tparam Surface as for `geodesic_distances()`
/// \tparam CurvatureMap a model of `WritablePropertyMap` with vertices or surfels as keys and
///         `Principal_curvatures<Surface>` as values
/// \param surface the surface, as for `geodesic_distances()`
/// \param curvatures a writable property map that receives a `Principal_curvatures<Surface>` for
///        each vertex or surfel
/// \param np the named parameters of `make_domain()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{ball_radius}
///     \cgalParamDescription{the radius of the ball; on a cloud, it is enlarged if the ball has too
///       few surfels for the fit}
///     \cgalParamType{`double`}
///     \cgalParamDefault{three times the mean length of the incident edges}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_threads}
///     \cgalParamDescription{the number of threads, used with `Parallel_tag`}
///     \cgalParamType{`unsigned`}
///     \cgalParamDefault{the number of hardware threads}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws Invalid_argument_error if the radius is negative or not a number
///
/// O(n b) time for b vertices or surfels per ball.
template <typename Concurrency_tag = Sequential_tag, typename Surface, typename CurvatureMap,
          typename NamedParameters = internal::Default_parameters>
void principal_curvatures(const Surface& surface, CurvatureMap curvatures,
                          const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  using Result = Principal_curvatures<typename decltype(domain)::Surface>;
  const double radius = internal::ball_radius(np);
  const double scale = domain.triangles()->scale;
  const auto found = internal::curvatures(domain.triangles(), radius / scale,
                                          internal::number_of_threads<Concurrency_tag>(np));
  const auto vector = [](const internal::Vec3& v)
  { return typename Result::Vector_3(v[0], v[1], v[2]); };
  domain.write(
      [&](internal::Index vertex)
      {
        const internal::Curvature& curvature = found[vertex];
        return Result{curvature.min_curvature / scale, curvature.max_curvature / scale,
                      vector(curvature.min_direction), vector(curvature.max_direction)};
      },
      curvatures);
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_PRINCIPAL_CURVATURES_H
