// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_FARTHEST_POINT_SAMPLING_H
#define CGAL_GEODESIC_PROCESSING_FARTHEST_POINT_SAMPLING_H

#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/internal/sampling/sampling.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/tags.h>

#include <limits>
#include <type_traits>

namespace CGAL::Geodesic_processing {

namespace internal {

// The samples of a domain that named parameters ask for, one after another handed to `out`.
template <typename Method, typename Domain, typename NamedParameters, typename Out>
void run_farthest_sampling(const Domain& domain, std::size_t number,
                           Sample_location sample_location, const NamedParameters& np,
                           const Out& report_sample)
{
  static_assert(is_front<Method>,
                "Samples are spread by fronts: Euclidean_front, Fast_marching or Dijkstra.");
  const Front_limits front_limits = limits(domain, np);
  const double scale = domain.triangles()->scale;
  const double radius = parameter(np, internal_np::covering_radius, 0.);
  if(!(radius >= 0.))
    throw Invalid_argument_error("The covering radius is negative or not a number.");

  Sampling sampling(domain.triangles(), Front(domain.triangles(), front_kind<Method>()),
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
  [[maybe_unused]] auto radii = parameter(np, internal_np::covering_radius_output, 0);
  sample_farthest_points(
      sampling, options,
      [&](double current_radius)
      {
        report_sample(sampling.samples().back());
        if constexpr(has_parameter<NamedParameters, internal_np::covering_radius_output_t>)
          *radii++ = scale * current_radius;
      });
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
/// spreads samples evenly over a surface: each one where the distance to those before it is largest.
/// \cgalCite{cgal:pc-grfp-03}
///
/// On a mesh a sample may lie inside a face, where the fronts that come to the farthest vertex meet
/// (section 3.1 of the paper); where they do not, at borders and at the tips of cones, it is that vertex.
/// On a cloud samples are surfels.  A component without a sample is sampled before any other, first at
/// a place as far as can be from one of its vertices.  Vertices without faces and surfels without neighbors, such
/// as outliers, are no components: no sample is there, and none reaches them.
///
/// The <em>covering radius</em> is the largest distance of a vertex or a surfel from its nearest sample,
/// infinite as long as a component has none; it never grows.  Fewer samples than asked for are found
/// when it is zero.
///
/// \tparam Method `Euclidean_front` (the default), `Fast_marching` or `Dijkstra`
/// \param surface as for `geodesic_distances()`
/// \param number how many samples to add; as many as the covering radius takes with
///        `std::numeric_limits<std::size_t>::max()`
/// \param samples an output iterator that takes `Location<Surface>`
/// \param np what `make_domain()` takes, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{covering_radius}
///     \cgalParamDescription{stops when the covering radius is not larger than this}
///     \cgalParamDefault{0} \cgalParamNEnd
///   \cgalParamNBegin{first_samples}
///     \cgalParamDescription{a site, a location, or a range of them: samples that are there already.
///       They are neither counted nor written; where labels are asked for they come first.}
///     \cgalParamDefault{none} \cgalParamNEnd
///   \cgalParamNBegin{random_seed}
///     \cgalParamDescription{of the vertex from which the first sample is farthest}
///     \cgalParamDefault{0} \cgalParamNEnd
///   \cgalParamNBegin{speed_map}
///     \cgalParamDescription{as for `geodesic_distances()`: samples are denser where the speed is lower}
///     \cgalParamDefault{1 everywhere} \cgalParamNEnd
///   \cgalParamNBegin{covering_radius_output}
///     \cgalParamDescription{an output iterator that takes the covering radius after each sample}
///     \cgalParamNEnd
///   \cgalParamNBegin{source_label_map}
///     \cgalParamDescription{receives for each site the position of its nearest sample; the largest
///       `std::size_t` where none reaches} \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a `std::function<bool(double)>` that is told the fraction done and cancels
///       by returning false; what was found until then is written} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns the output iterator behind the last sample
/// \throws Invalid_argument_error when a location, a speed or the covering radius is not usable
///
/// A sample costs in proportion to the vertices that it is nearest to when it comes.  Samples 1 to k of
/// n vertices take O(n log k) steps of a front together, about as many as seven fronts over the whole
/// surface for k = 1,000.
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
/// is `farthest_point_sampling()` with samples at vertices or surfels only.
///
/// \param vertices an output iterator that takes vertex descriptors, or indices of surfels
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
