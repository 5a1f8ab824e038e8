// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_FARTHEST_POINT_SAMPLING_H
#define CGAL_GEODESIC_PROCESSING_FARTHEST_POINT_SAMPLING_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/internal/adaptors/method.h>
#include <CGAL/Geodesic_processing/internal/sampling/sampling.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/tags.h>

#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing {

namespace internal {

// Samples a domain as the named parameters specify, and calls `report_sample` with each sample.
template <typename Method, typename Domain, typename NamedParameters, typename Out>
void run_farthest_sampling(const Domain& domain, std::size_t number,
                           Sample_location sample_location, const NamedParameters& np,
                           const Out& report_sample)
{
  const Front_limits front_limits = limits(domain, np);
  const double scale = domain.triangles()->scale;
  const double radius = parameter(np, internal_np::covering_radius, 0.);
  if(!(radius >= 0.))
    throw Invalid_argument_error("The covering radius is negative or not a number.");

  Sampling sampling(domain.triangles(), Front(domain.triangles(), read_front_kind<Method>(np)),
                    sample_location, front_limits.slowness);
  if constexpr(has_parameter<NamedParameters, internal_np::first_samples_t>)
    for(const Surface_location& sample :
        locations(domain, parameter(np, internal_np::first_samples, none)))
      sampling.add(sample);
  Sampling_options options;
  options.number_of_samples = number;
  options.covering_radius = radius / scale;
  options.seed = static_cast<unsigned>(parameter(np, CGAL::internal_np::random_seed, 0u));
  options.callback = front_limits.callback;
  std::vector<std::pair<Surface_location, double>> samples_and_radii;
  const auto add_sample = [&](double current_radius)
  { samples_and_radii.emplace_back(sampling.samples().back(), scale * current_radius); };
  if(!sample_farthest_points(sampling, options, add_sample))
    throw Cancelled();
  [[maybe_unused]] auto radii = parameter(np, internal_np::covering_radius_output, 0);
  for([[maybe_unused]] const auto& [sample, current_radius] : samples_and_radii)
  {
    report_sample(sample);
    if constexpr(has_parameter<NamedParameters, internal_np::covering_radius_output_t>)
      *radii++ = current_radius;
  }
  if constexpr(has_parameter<NamedParameters, internal_np::source_label_map_t>)
    domain.write(
        [&](Index vertex)
        {
          const Index label = sampling.labels()[vertex];
          return label == none ? (std::numeric_limits<std::size_t>::max)() : std::size_t(label);
        },
        parameter(np, internal_np::source_label_map, 0));
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingSampling
///
/// Distributes samples evenly over a surface by farthest point sampling: each new sample has the
/// largest distance to the previous ones. \cgalCite{cgal:pc-grfp-03}
///
/// On a mesh a sample can lie inside a face, at the point in which fronts meet near the farthest
/// vertex (section 3.1 of the paper). If they do not meet, at boundaries and at the tips of cones,
/// the sample is that vertex. On a cloud samples are surfels: with locations in its overlapping
/// triangles, 100 samples of a sphere or a torus covered the surface equally well, within 2 %.
///
/// Components without a sample are sampled before all others. The first sample of a component is
/// the location farthest from one of its vertices. Vertices without faces and surfels without
/// neighbors, such as outliers, are not components: they are never sampled, and no sample reaches
/// them.
///
/// The <em>covering radius</em> is the maximum distance of a vertex or surfel to its nearest
/// sample. It is infinite if a component has no sample, and it never increases. If it becomes zero,
/// fewer samples than requested are returned.
///
/// \tparam Method `Euclidean_front` (the default), `Fast_marching` or `Dijkstra`; `Runtime_method`
///         reads the named parameter `method`
/// \tparam Surface as for `geodesic_distances()`
/// \tparam OutputIterator a model of `OutputIterator` for `Location<Surface>`
/// \param surface as for `geodesic_distances()`
/// \param number the number of samples to add. With `std::numeric_limits<std::size_t>::max()`,
///        samples are added until the covering radius is reached
/// \param samples an output iterator that takes `Location<Surface>`. On a cloud, samples are
///        surfels: the offsets of their locations are zero
/// \param np parameters of `make_domain()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{covering_radius}
///     \cgalParamDescription{sampling stops if the covering radius is at most this value}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{first_samples}
///     \cgalParamDescription{a vertex, a surfel, a location, or a range of these: existing samples.
///       They are neither counted nor written to `samples`. In the labels they are numbered first.
///       If they are the samples of an earlier call, the call continues as if it were the same.}
///     \cgalParamType{a vertex, a surfel, a location, or a range of these}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{random_seed}
///     \cgalParamDescription{selects the vertex from which the first sample is farthest}
///     \cgalParamType{`unsigned`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{speed_map, face_speed_map}
///     \cgalParamDescription{as for `Geodesic_distance_solver::compute()`: samples are denser in
///       regions of lower speed}
///     \cgalParamType{as for `Geodesic_distance_solver::compute()`}
///     \cgalParamDefault{1 everywhere}
///   \cgalParamNEnd
///   \cgalParamNBegin{covering_radius_output}
///     \cgalParamDescription{an output iterator that takes the covering radius after each sample}
///     \cgalParamType{a model of `OutputIterator` for `double`}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{source_label_map}
///     \cgalParamDescription{receives for each vertex or surfel the position of its nearest sample,
///       or the largest `std::size_t` if no sample reaches it}
///     \cgalParamType{a model of `WritablePropertyMap` with vertices or surfels as keys and
///       `std::size_t` as values}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a function that is called with the fraction done. If it returns false,
///       the function throws `Cancelled`}
///     \cgalParamType{`std::function<bool(double)>`}
///     \cgalParamDefault{no callback}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns the output iterator past the last sample
/// \throws Invalid_argument_error if a location, a speed or the covering radius is not usable
/// \throws Cancelled if the callback returns false. Then no sample is written. To keep those that
///         are complete, call the function for a few samples at a time, with `first_samples`
///
/// Adding a sample takes time proportional to the number of vertices in its Voronoi cell at that
/// time. For n vertices, samples 1 to k together take O(n log k) steps of a front. For k = 1,000
/// this is about seven fronts over the whole surface.
template <typename Method = Euclidean_front, typename Surface, typename OutputIterator,
          typename NamedParameters = internal::Default_parameters>
OutputIterator farthest_point_sampling(const Surface& surface, std::size_t number,
                                       OutputIterator samples,
                                       const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  internal::run_farthest_sampling<Method>(domain, number, internal::Sample_location::triangle, np,
                                          [&](const internal::Surface_location& sample)
                                          { *samples++ = domain.outer(sample); });
  return samples;
}

/// \ingroup PkgGeodesicProcessingSampling
///
/// Distributes samples as `farthest_point_sampling()`, but only at vertices or surfels.
///
/// \tparam Method as for `farthest_point_sampling()`
/// \tparam Surface as for `geodesic_distances()`
/// \tparam OutputIterator a model of `OutputIterator` for vertices or surfels
/// \param surface as for `farthest_point_sampling()`
/// \param number as for `farthest_point_sampling()`
/// \param vertices an output iterator that takes vertex descriptors, or indices of surfels
/// \param np as for `farthest_point_sampling()`
/// \returns the output iterator past the last sample
/// \throws as `farthest_point_sampling()`
///
/// Takes the time of `farthest_point_sampling()`.
template <typename Method = Euclidean_front, typename Surface, typename OutputIterator,
          typename NamedParameters = internal::Default_parameters>
OutputIterator farthest_vertex_sampling(const Surface& surface, std::size_t number,
                                        OutputIterator vertices,
                                        const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  internal::run_farthest_sampling<Method>(domain, number, internal::Sample_location::vertex, np,
                                          [&](const internal::Surface_location& sample)
                                          { *vertices++ = domain.vertex(sample.vertex); });
  return vertices;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_FARTHEST_POINT_SAMPLING_H
