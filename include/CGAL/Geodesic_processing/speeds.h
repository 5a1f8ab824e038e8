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

/// chooses speeds that are low where the surface bends: samples gather at creases and corners.
struct Edge_attractive
{};

/// chooses speeds that are high where the surface bends: creases and corners are left alone.
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
/// makes speeds for `speed_map` from the curvature of the surface, such that samples and cells adapt to
/// its shape.
///
/// With \f$ \tau = |\lambda_1| + |\lambda_2| \f$ of the principal curvatures, in units of one over the
/// square root of the surface's area, the speed is \f$ 1 / (1 + \mu \tau) \f$ with `Edge_attractive` and
/// \f$ 1 + \epsilon \tau \f$ with `Edge_repulsive`; \f$ \mu \f$ or \f$ \epsilon \f$ is the strength.
/// Scaling the surface changes nothing. \cgalCite{cgal:pc-grfp-06}
///
/// \tparam Speed `Edge_attractive` (the default) or `Edge_repulsive`
/// \tparam Concurrency_tag `CGAL::Sequential_tag` (the default) or `CGAL::Parallel_tag`; the result is
///         the same
/// \param surface as for `geodesic_distances()`
/// \param speeds receives a positive number for each site
/// \param np what `principal_curvatures()` takes, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{strength}
///     \cgalParamDescription{0 makes all speeds 1}
///     \cgalParamDefault{1 / (4 sqrt(pi)), about 0.14: what bends like a sphere of the same area has half
///       the speed of a plane, or twice its speed} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws Invalid_argument_error when the strength or the radius of the ball is negative or not finite
///
/// O(n b) for balls of b sites.
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
                                 internal::threads<Concurrency_tag>(np));
  domain.write([&](internal::Index vertex)
               { return internal::speed(Speed(), strength * curvatures[vertex]); },
               speeds);
}

/// \ingroup PkgGeodesicProcessingSpeeds
///
/// makes speeds for `speed_map` that are high where the surface bends as it does at a place: what starts on
/// a ridge stays on ridges.
///
/// The speed is \f$ 1 / (1 + \mu |\sigma - \sigma_0|) \f$, where \f$ \sigma = \lambda_1 + \lambda_2 \f$ is
/// twice the mean curvature, in units of one over the square root of the surface's area,
/// \f$ \sigma_0 \f$ that of the place, and \f$ \mu \f$ the strength.  Scaling the surface changes nothing.
/// Figure 15 of \cgalCite{cgal:srgb-emd-14} has distances of this kind.
///
/// \tparam Concurrency_tag as for `curvature_speeds()`
/// \param surface as for `geodesic_distances()`
/// \param vertex a vertex or surfel
/// \param speeds receives a number in (0, 1] for each site
/// \param np as for `curvature_speeds()`
/// \throws Invalid_argument_error as `curvature_speeds()`, and when the place is none of the surface's
///
/// O(n b) for balls of b sites.
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
                                        internal::threads<Concurrency_tag>(np));
  domain.write(
      [&](internal::Index vertex) {
        return 1. / (1. + strength * std::abs(curvature_sums[vertex] - curvature_sums[base_index]));
      },
      speeds);
}

/// \ingroup PkgGeodesicProcessingSpeeds
///
/// makes speeds for `speed_map` from an image on the surface, or any other function: low where it varies.
///
/// The speed is \f$ 1 / (1 + \mu |\nabla I| / \max |\nabla I|) \f$ with the strength \f$ \mu \f$: scaling
/// the surface or the image changes nothing.  The size of the gradient is averaged over the faces, or
/// local triangles, at each site. \cgalCite{cgal:pc-grfp-06}
///
/// \param surface as for `geodesic_distances()`
/// \param image a readable property map of sites; its values are numbers, or have three of them, like
///        `CGAL::IO::Color`
/// \param speeds receives a number in (0, 1] for each site
/// \param np what `make_domain()` takes, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{strength}
///     \cgalParamDescription{0 makes all speeds 1}
///     \cgalParamDefault{20: there samples are 21 times closer to each other than where the image is plain} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws Invalid_argument_error when a value of the image is not finite, or the strength is negative or
///         not finite
///
/// O(n).
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
