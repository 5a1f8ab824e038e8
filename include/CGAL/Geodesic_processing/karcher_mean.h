// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_KARCHER_MEAN_H
#define CGAL_GEODESIC_PROCESSING_KARCHER_MEAN_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/callback.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/internal/adaptors/trace_on_cloud.h>
#include <CGAL/Geodesic_processing/internal/adaptors/weights.h>
#include <CGAL/Geodesic_processing/internal/log_map/coarse_mean.h>
#include <CGAL/Geodesic_processing/internal/log_map/karcher_mean.h>
#include <CGAL/Geodesic_processing/internal/log_map/karcher_mean_on_cloud.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <CGAL/Origin.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingDistances
/// The result of `karcher_mean()`.
template <typename Surface>
struct Karcher_mean
{
  using Location = typename internal::Surface_traits<Surface>::Location;
  using Point_3 = typename internal::Surface_traits<Surface>::Point_3;

  /// The mean. On a cloud, it is the projection of `point` to the tangent plane of the nearest
  /// surfel. At a vertex without faces, its face is the null face.
  Location location;
  Point_3 point = ORIGIN; ///< the point of the mean; on a cloud, a point of the fitted surface
  double value = 0.;      ///< the weighted sum of squared distances
  /// The norm of the gradient of half the `value` divided by the sum of the weights, a length. At a
  /// vertex or at the boundary of a mesh, minus the smallest directional derivative, or 0 if no
  /// direction decreases the `value`.
  double gradient_norm = 0.;
  bool is_converged = false;            ///< whether `gradient_norm` is within the `tolerance`
  std::size_t number_of_iterations = 0; ///< the number of steps
};

namespace internal {

// The locations whose weight is positive.
struct Weighted_locations
{
  std::vector<std::size_t> positions; // in the caller's range
  std::vector<Surface_location> locations;
  std::vector<double> weights;
};

template <typename Domain, typename Locations, typename NamedParameters>
Weighted_locations weighted_locations(const Domain& domain, const Locations& input,
                                      const NamedParameters& np)
{
  const std::vector<Surface_location> all = locations(domain, input);
  if(all.empty())
    throw Invalid_argument_error("The range of locations is empty.");
  const std::vector<double> all_weights = weights(np, all.size());
  Weighted_locations result;
  for(std::size_t i = 0; i < all.size(); ++i)
    if(all_weights[i] > 0.)
    {
      result.positions.push_back(i);
      result.locations.push_back(all[i]);
      result.weights.push_back(all_weights[i]);
    }
  return result;
}

// Reads the parameters that both kernels have.
template <typename Options, typename NamedParameters>
Options mean_options(const NamedParameters& np)
{
  Options result;
  result.tolerance = parameter(np, internal_np::tolerance, result.tolerance);
  if(!(result.tolerance >= 0.))
    throw Invalid_argument_error("The tolerance is negative or not a number.");
  result.maximum_number_of_iterations =
      parameter(np, internal_np::maximum_number_of_iterations, result.maximum_number_of_iterations);
  result.callback = read_throwing_callback(np);
  return result;
}

template <typename Domain, typename Locations, typename NamedParameters>
Karcher_mean<typename Domain::Surface> mean_on_mesh(const Domain& domain, const Locations& input,
                                                    const NamedParameters& np)
{
  const Weighted_locations used = weighted_locations(domain, input, np);
  auto options = mean_options<Mean_options>(np);
  if constexpr(has_parameter<NamedParameters, internal_np::initial_location_t>)
    options.initial_location = location(domain, parameter(np, internal_np::initial_location, 0));
  const Mean_location mean =
      karcher_mean(domain.triangles(), used.locations, used.weights, options);
  const double scale = domain.triangles()->scale;
  return {domain.outer(mean.location), domain.point(mean.location), scale * scale * mean.value,
          scale * mean.gradient_norm,  mean.is_converged,           mean.number_of_iterations};
}

template <typename Domain, typename Locations, typename NamedParameters>
Karcher_mean<typename Domain::Surface> mean_on_cloud(const Domain& domain, const Locations& input,
                                                     const NamedParameters& np)
{
  using Point_3 = typename Domain::Point_3;
  const Weighted_locations used = weighted_locations(domain, input, np);
  auto options = mean_options<Cloud_mean_options>(np);
  options.number_of_threads = parameter(np, internal_np::number_of_threads, 1u);
  const auto start = [&]
  {
    if constexpr(has_parameter<NamedParameters, internal_np::initial_location_t>)
      return traced_location(domain, parameter(np, internal_np::initial_location, 0));
    else
      return traced_location(domain, domain.outer(coarse_mean(domain.triangles(), used.locations,
                                                              used.weights, options.callback)));
  };
  const Tangent_location initial_location = start();
  std::vector<Tangent_location> locations;
  for(const Surface_location& location : used.locations)
    locations.push_back(traced_location(domain, domain.outer(location)));

  Surfel_input surfels = domain.surfel_input();
  Cloud_path_options path_options;
  path_options.cloud.number_of_threads = options.number_of_threads;
  const Cloud_path_finder finder(std::make_shared<const Fitted_cloud>(
      std::move(surfels.points), std::move(surfels.normals), surfels.radii, path_options));
  const Cloud_mean mean =
      karcher_mean_on_cloud(finder, locations, used.weights, initial_location, options);
  return {outer_location(domain, mean.location),
          Point_3(mean.point[0], mean.point[1], mean.point[2]),
          mean.value,
          mean.gradient_norm,
          mean.is_converged,
          mean.number_of_iterations};
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingDistances
///
/// Computes the Karcher mean of locations: a location of the surface at which the weighted sum of
/// squared geodesic distances to them has a local minimum \cgalCite{cgal:k-rcmms-77}.
///
/// It differs from `geodesic_barycenter()`, which returns the best vertex or surfel. The mean of
/// mass distributions is computed by `transport_barycenter()`.
///
/// <b>Uniqueness.</b> Let the Gauss curvature of a smooth surface be at most K, and let all
/// locations be in a ball of a radius less than half of min(injectivity radius, &pi; / &radic;K).
/// Then the sum has exactly one minimizer, and it is in this ball \cgalCite{cgal:a-rlpcm-11}. For
/// half of this radius, the sum is also convex in the ball \cgalCite{cgal:k-rcmms-77}. Otherwise,
/// there can be several local minima, and the result is one to which the initial location leads.
/// On a mesh, these conditions refer to the smooth surface that it approximates.
///
/// <b>On a mesh</b>, distances and directions are exact. A minimum can be at a vertex only if the
/// angles of its faces sum to at least 2 &pi;, or to at least &pi; at the boundary. There, the
/// directional derivative is minimized over all directions.
///
/// <b>On a cloud</b>, distances are lengths of geodesics on the surface that
/// `straightest_geodesic()` uses. Where no geodesic ends at a location, for example because of a
/// hole, the path of `Surfel_path_finder` is used.
///
/// The function does not support speeds.
///
/// \tparam Surface a model of `FaceListGraph`, a model of `SurfelRange`, or its domain
/// \tparam Locations a vertex, a surfel or a `Location<Surface>`, or a range of these
/// \param surface a mesh, a cloud or a domain
/// \param locations a nonempty range of vertices (or surfels) or of locations
/// \param np the named parameters of `make_domain()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{weights}
///     \cgalParamDescription{a range of nonnegative numbers, one for each location, not all zero}
///     \cgalParamType{a range of `double`}
///     \cgalParamDefault{1 each}
///   \cgalParamNEnd
///   \cgalParamNBegin{initial_location}
///     \cgalParamDescription{the location at which the iteration starts}
///     \cgalParamType{a vertex, a surfel or a location}
///     \cgalParamDefault{the best one of at most eight candidates. They are the local minima of the
///       sum among all vertices and at most 16 of the locations, if the other locations are replaced
///       by the nearest of the 16}
///   \cgalParamNEnd
///   \cgalParamNBegin{tolerance}
///     \cgalParamDescription{the iteration ends if `gradient_norm` is at most this fraction of the
///       distance to the farthest location. If that distance is less than 10<SUP>-5</SUP> of the
///       extent of the surface, it is replaced by the latter}
///     \cgalParamType{`double`}
///     \cgalParamDefault{10<SUP>-8</SUP> on a mesh, 10<SUP>-5</SUP> on a cloud}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_iterations}
///     \cgalParamDescription{the maximum number of steps}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{100}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a function that is called with the completed fraction; if it returns
///       false, the computation is canceled}
///     \cgalParamType{`std::function<bool(double)>`}
///     \cgalParamDefault{no callback}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_threads}
///     \cgalParamDescription{on a cloud, the number of threads}
///     \cgalParamType{`unsigned`}
///     \cgalParamDefault{1}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns a `Karcher_mean`
/// \throws Invalid_argument_error if there is no location, if a location is not on the surface, if
///         a weight is negative or not finite, if all weights are zero, if the tolerance is
///         negative, or if the locations of positive weight and the initial location are not in one
///         component
/// \throws Unsupported_surface_error if exact distances exceed their limit of windows
/// \throws Cancelled if the callback returns false
///
/// On a mesh, an iteration takes one exact computation, up to the farthest location, for all
/// locations together: O(m<SUP>1.5</SUP>) time in practice for m vertices in between. In addition,
/// it takes linear time in the number of faces between the mean and each location. On a cloud, an
/// iteration traces about two geodesics for each location, and computes a path for each location
/// at the beginning and at the end. With quasi-Newton steps, 3 to 10 iterations are usual.
template <typename Surface, typename Locations,
          typename NamedParameters = internal::Default_parameters>
Karcher_mean<Surface_of<Surface>> karcher_mean(const Surface& surface, const Locations& locations,
                                               const NamedParameters& np = NamedParameters())
{
  static_assert(!internal::has_parameter<NamedParameters, internal_np::speed_map_t> &&
                    !internal::has_parameter<NamedParameters, internal_np::face_speed_map_t>,
                "karcher_mean() does not support speeds, because directions need exact distances.");
  const auto domain = make_domain(surface, np);
  if constexpr(internal::Is_cloud<Surface_of<Surface>>::value)
    return internal::mean_on_cloud(domain, locations, np);
  else
    return internal::mean_on_mesh(domain, locations, np);
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_KARCHER_MEAN_H
