// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_SPEEDS_H
#define CGAL_GEODESIC_PROCESSING_SPEEDS_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/internal/curvature/speeds.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/principal_curvatures.h>

#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \addtogroup PkgGeodesicProcessingSpeeds
/// @{

/// Selects speeds that are low in regions of high curvature: samples concentrate at creases and
/// corners.
struct Edge_attractive
{};

/// Selects speeds that are high in regions of high curvature: samples avoid creases and corners.
struct Edge_repulsive
{};

/// @}

namespace internal {

inline double speed(Edge_attractive, double curvature) { return 1. / (1. + curvature); }
inline double speed(Edge_repulsive, double curvature) { return 1. + curvature; }

template <typename NamedParameters>
double strength(const NamedParameters& np, double default_strength)
{
  const double result = parameter(np, internal_np::strength, default_strength);
  if(!(result >= 0. && result < infinity))
    throw Invalid_argument_error("The strength is negative or not finite.");
  return result;
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingSpeeds
///
/// Computes speeds for `speed_map` from the curvature of the surface, such that samples and Voronoi
/// cells adapt to its shape.
///
/// Let \f$ \tau = |\lambda_1| + |\lambda_2| \f$ be the sum of the absolute principal curvatures, in
/// units of one over the square root of the surface's area. The speed is
/// \f$ 1 / (1 + \mu \tau) \f$ with `Edge_attractive` and \f$ 1 + \epsilon \tau \f$ with
/// `Edge_repulsive`; \f$ \mu \f$ or \f$ \epsilon \f$ is the strength. The speeds are invariant
/// under scaling of the surface. \cgalCite{cgal:pc-grfp-06}
///
/// \tparam Speed `Edge_attractive` (the default) or `Edge_repulsive`
/// \tparam Concurrency_tag `CGAL::Sequential_tag` (the default) or `CGAL::Parallel_tag`; both give
///         the same result
/// \tparam Surface as for `geodesic_distances()`
/// \tparam SpeedMap a model of `WritablePropertyMap` with vertices or surfels as keys and `double`
///         as values
/// \param surface the surface, as for `geodesic_distances()`
/// \param speeds a writable property map that receives a positive number for each vertex or surfel
/// \param np the named parameters of `principal_curvatures()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{strength}
///     \cgalParamDescription{the factor of the curvature in the speed; if it is 0, all speeds are
///       1}
///     \cgalParamType{`double`}
///     \cgalParamDefault{1 / (4 sqrt(pi)), about 0.14: if the curvature is that of a sphere of the
///       same area, the speed is 1/2 with `Edge_attractive` and 2 with `Edge_repulsive`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws Invalid_argument_error if the strength or the radius of the ball is negative or not
///         finite
///
/// O(n b) time for b vertices or surfels per ball.
template <typename Speed = Edge_attractive, typename Concurrency_tag = Sequential_tag,
          typename Surface, typename SpeedMap,
          typename NamedParameters = internal::Default_parameters>
void curvature_speeds(const Surface& surface, SpeedMap speeds,
                      const NamedParameters& np = NamedParameters())
{
  const double strength = internal::strength(np, 1. / internal::sphere_total_curvature);
  const double radius = internal::ball_radius(np);
  const auto domain = make_domain(surface, np);
  const auto curvatures =
      internal::total_curvatures(domain.triangles(), radius / domain.triangles()->scale,
                                 internal::number_of_threads<Concurrency_tag>(np));
  domain.write([&](internal::Index vertex)
               { return internal::speed(Speed(), strength * curvatures[vertex]); },
               speeds);
}

/// \ingroup PkgGeodesicProcessingSpeeds
///
/// Computes speeds for `speed_map` that are high if the mean curvature is similar to that at a
/// given vertex or surfel. Paths that start on a ridge tend to follow ridges.
///
/// The speed is \f$ 1 / (1 + \mu |\sigma - \sigma_0|) \f$ with the strength \f$ \mu \f$.
/// \f$ \sigma = \lambda_1 + \lambda_2 \f$ is twice the mean curvature, in units of one over the
/// square root of the surface's area, and \f$ \sigma_0 \f$ is its value at the given vertex or
/// surfel. The speeds are invariant under scaling of the surface.
/// Figure 15 of \cgalCite{cgal:srgb-emd-14} shows distances of this kind.
///
/// \tparam Concurrency_tag as for `curvature_speeds()`
/// \tparam Surface as for `geodesic_distances()`
/// \tparam Vertex a vertex or surfel
/// \tparam SpeedMap a model of `WritablePropertyMap` with vertices or surfels as keys and `double`
///         as values
/// \param surface the surface, as for `geodesic_distances()`
/// \param vertex a vertex or surfel
/// \param speeds a writable property map that receives a number in (0, 1] for each vertex or surfel
/// \param np as for `curvature_speeds()`
/// \throws Invalid_argument_error as `curvature_speeds()`, and if `vertex` does not belong to the
///         surface
///
/// O(n b) time for b vertices or surfels per ball.
template <typename Concurrency_tag = Sequential_tag, typename Surface, typename Vertex,
          typename SpeedMap, typename NamedParameters = internal::Default_parameters>
void similar_curvature_speeds(const Surface& surface, Vertex vertex, SpeedMap speeds,
                              const NamedParameters& np = NamedParameters())
{
  const double strength = internal::strength(np, 1. / internal::sphere_total_curvature);
  const double radius = internal::ball_radius(np);
  const auto domain = make_domain(surface, np);
  const internal::Index base_index = domain.inner_vertex(vertex).vertex;
  const auto curvature_sums =
      internal::doubled_mean_curvatures(domain.triangles(), radius / domain.triangles()->scale,
                                        internal::number_of_threads<Concurrency_tag>(np));
  domain.write(
      [&](internal::Index vertex) {
        return 1. / (1. + strength * std::abs(curvature_sums[vertex] - curvature_sums[base_index]));
      },
      speeds);
}

/// \ingroup PkgGeodesicProcessingSpeeds
///
/// Computes speeds for `speed_map` from an image, or another function, on the surface. The speed
/// is low if the gradient of the function is large.
///
/// The speed is \f$ 1 / (1 + \mu |\nabla I| / \max |\nabla I|) \f$ with the strength \f$ \mu \f$.
/// It is invariant under scaling of the surface or the image. The norm of the gradient is averaged
/// over the incident faces, or local triangles, of each vertex or surfel.
/// \cgalCite{cgal:pc-grfp-06}
///
/// \tparam Surface as for `geodesic_distances()`
/// \tparam ImageMap a model of `ReadablePropertyMap` with vertices or surfels as keys
/// \tparam SpeedMap a model of `WritablePropertyMap` with vertices or surfels as keys and `double`
///         as values
/// \param surface the surface, as for `geodesic_distances()`
/// \param image a readable property map of vertices or surfels; each value is one number, or has
///        three components, such as `CGAL::IO::Color`
/// \param speeds a writable property map that receives a number in (0, 1] for each vertex or surfel
/// \param np the named parameters of `make_domain()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{strength}
///     \cgalParamDescription{the factor of the relative gradient in the speed; if it is 0, all
///       speeds are 1}
///     \cgalParamType{`double`}
///     \cgalParamDefault{20: at the maximum gradient, samples are 21 times closer to each other
///       than in constant regions of the image}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \pre The image has a value for each vertex or surfel.
/// \throws Invalid_argument_error if a value of the image is not finite, or the strength is
///         negative or not finite
///
/// O(n) time.
template <typename Surface, typename ImageMap, typename SpeedMap,
          typename NamedParameters = internal::Default_parameters>
void image_speeds(const Surface& surface, ImageMap image, SpeedMap speeds,
                  const NamedParameters& np = NamedParameters())
{
  using internal::Index;
  const double strength = internal::strength(np, 20.);
  const auto domain = make_domain(surface, np);
  using Value = typename boost::property_traits<ImageMap>::value_type;
  constexpr bool is_gray = std::is_arithmetic_v<Value>;
  std::vector<std::vector<double>> channels(is_gray ? 1 : 3);
  for(Index vertex = 0; vertex < domain.number_of_vertices(); ++vertex)
    if constexpr(is_gray)
      channels[0].push_back(get(image, domain.vertex(vertex)));
    else
    {
      const Value& color = get(image, domain.vertex(vertex));
      for(int k = 0; k < 3; ++k)
        channels[k].push_back(color[k]);
    }
  const auto gradients =
      internal::relative_gradient_norms(*domain.triangles(), std::move(channels));
  domain.write([&](Index vertex)
               { return internal::speed(Edge_attractive(), strength * gradients[vertex]); },
               speeds);
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_SPEEDS_H
