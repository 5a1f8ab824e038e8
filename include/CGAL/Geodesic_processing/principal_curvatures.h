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
/// how much a surface bends at a site, at the least and at the most, and where to: positive where it is
/// convex seen from where the normals point, in the inverse of the coordinates' unit.
template <typename Surface>
struct Principal_curvatures
{
  using Vector_3 = typename internal::Surface_traits<Surface>::Vector_3;

  double min_curvature = 0., max_curvature = 0.;
  /// unit vectors, perpendicular to each other; zero where there is no surface.
  Vector_3 min_direction = NULL_VECTOR, max_direction = NULL_VECTOR;
};

namespace internal {

// The radius of a ball that named parameters ask for; 0 when they leave it to the kernel.
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
/// estimates the principal curvatures and their directions at each site.
///
/// On a mesh they are those of the normal cycles of the edges, their dihedral angles, averaged over a
/// geodesic ball \cgalCite{cgal:csm-rdtnc-03}; normals are those of faces, counterclockwise.  On a
/// cloud a surface of second order is fitted to the surfels of the ball \cgalCite{cgal:cp-edqpf-05}.
/// The larger the ball, the less noise and detail.
///
/// \tparam Concurrency_tag `CGAL::Sequential_tag` (the default) or `CGAL::Parallel_tag`; the result is
///         the same
/// \param surface as for `geodesic_distances()`
/// \param curvatures receives a `Principal_curvatures<Surface>` for each site
/// \param np what `make_domain()` takes, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{ball_radius}
///     \cgalParamDescription{the radius of the ball; it grows where it has too few surfels to fit to}
///     \cgalParamDefault{three times the mean length of the edges at the site} \cgalParamNEnd
///   \cgalParamNBegin{threads}
///     \cgalParamDescription{how many, with `Parallel_tag`}
///     \cgalParamDefault{as many as there are processors} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws Invalid_argument_error when the radius is negative or not a number
///
/// O(n b) for balls of b sites.
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
                                          internal::threads<Concurrency_tag>(np));
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
