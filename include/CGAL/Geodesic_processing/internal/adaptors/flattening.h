// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_FLATTENING_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_FLATTENING_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/method.h>
#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>
#include <CGAL/Geodesic_processing/internal/parameterization/base_points.h>
#include <CGAL/Geodesic_processing/internal/parameterization/lle.h>
#include <CGAL/Geodesic_processing/internal/parameterization/mds.h>
#include <CGAL/Geodesic_processing/internal/adaptors/planar_value.h>
#include <CGAL/Geodesic_processing/internal/sampling/sampling.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/internal/adaptors/callback.h>
#include <CGAL/Geodesic_processing/parameters.h>
#include <CGAL/Geodesic_processing/tags.h>

#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

// The common part of all parameterizations by base points.

namespace CGAL::Geodesic_processing::internal {

// Adds the base points of the named parameters to a sampling, or by default samples
// `default_number` vertices by farthest points. Throws Unsupported_surface_error if the surface is
// not connected, and Invalid_argument_error if base points are repeated or their number is out of
// range.
template <typename Domain, typename NamedParameters>
void sample_base_points(const Domain& domain, const NamedParameters& np, std::size_t default_number,
                        Sampling& sampling)
{
  const auto check_is_connected = [&]
  {
    if(!(sampling.covering_radius() < infinity))
      throw Unsupported_surface_error("The surface is not connected.");
  };
  const auto check_number = [](std::size_t number)
  {
    if(number < 3 || number > max_number_of_base_points)
      throw Invalid_argument_error("The number of base points is " + std::to_string(number) +
                                   ", but must be between 3 and " +
                                   std::to_string(max_number_of_base_points) + ".");
  };
  if constexpr(has_parameter<NamedParameters, internal_np::base_points_t>)
  {
    std::vector<bool> is_taken(domain.number_of_vertices(), false);
    for(const auto& vertex : parameter(np, internal_np::base_points, none))
    {
      const Surface_location location = domain.inner_vertex(vertex);
      if(is_taken[location.vertex])
        throw Invalid_argument_error("A base point is given twice.");
      is_taken[location.vertex] = true;
      sampling.add(location);
      check_is_connected();
    }
  }
  else
  {
    Sampling_options options;
    options.number_of_samples = parameter(np, internal_np::number_of_base_points, default_number);
    options.seed = static_cast<unsigned>(parameter(np, CGAL::internal_np::random_seed, 0u));
    check_number(options.number_of_samples);
    sample_farthest_points(sampling, options, [&](double) { check_is_connected(); });
  }
  check_number(sampling.samples().size());
}

// Samples base points, computes the map and writes the image of each vertex to `uv_map`; vertices
// that are not reached get NaN.  Returns the base points. Throws Cancelled if the callback returns
// false.
//
// map(triangles, sampling, front, callback): returns the image of each vertex in scaled units, or
// an empty vector if the callback cancelled
template <typename Method, typename Domain, typename UVMap, typename NamedParameters, typename Map>
std::vector<typename Domain::Vertex> flatten(const Domain& domain, UVMap uv_map,
                                             const NamedParameters& np, std::size_t default_number,
                                             const Map& map)
{
  using Value = typename boost::property_traits<UVMap>::value_type;
  const Surface_arrays& triangles = *domain.triangles();
  const Front front(domain.triangles(), read_front_kind<Method>(np));
  Sampling sampling(domain.triangles(), front, Sample_location::vertex);
  sample_base_points(domain, np, default_number, sampling);

  std::vector<typename Domain::Vertex> base_points;
  const std::vector<Vec2> image = map(triangles, sampling, front, read_callback(np));
  if(image.empty())
    throw Cancelled();
  for(const Surface_location& sample : sampling.samples())
    base_points.push_back(domain.vertex(sample.vertex));
  std::vector<bool> is_known(image.size(), false);
  for(const Index vertex : sampling.sampled_vertices())
    is_known[vertex] = true;
  domain.write(
      [&](Index i)
      {
        constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
        return is_known[i] ? planar_value<Value>(triangles.scale * image[i][0],
                                                 triangles.scale * image[i][1])
                           : planar_value<Value>(unknown, unknown);
      },
      uv_map);
  return base_points;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_FLATTENING_H
