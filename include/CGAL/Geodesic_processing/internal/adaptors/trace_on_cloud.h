// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_TRACE_ON_CLOUD_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_TRACE_ON_CLOUD_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/read_surfels.h>
#include <CGAL/Geodesic_processing/internal/paths/Cloud_tracer.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include <cmath>
#include <type_traits>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

// Fits a surface to the surfels of a domain. O(n log n).
template <typename Domain>
Cloud_tracer make_cloud_tracer(const Domain& domain, unsigned number_of_threads)
{
  Surfel_input surfels = domain.surfel_input();
  return Cloud_tracer(std::move(surfels.points), std::move(surfels.normals), surfels.radii,
                      number_of_threads);
}

// Converts a surfel or a location of the caller to a location of a tracer. Throws
// Invalid_argument_error if the surfel is not in the cloud or the offset is not finite.
template <typename Domain, typename SurfelOrLocation>
Tangent_location traced_location(const Domain& domain, const SurfelOrLocation& element)
{
  const auto position = [&](const typename Domain::Vertex& surfel)
  { return domain.surfels().caller_vertex[domain.inner_vertex(surfel).vertex]; };
  if constexpr(std::is_same_v<SurfelOrLocation, typename Domain::Location>)
  {
    if(!std::isfinite(element.offset[0]) || !std::isfinite(element.offset[1]))
      throw Invalid_argument_error("The offset of a location is not finite.");
    return {position(element.surfel), element.offset};
  }
  else
    return {position(element), {0., 0.}};
}

// Converts a location of a tracer to a location of the caller.
template <typename Domain>
typename Domain::Location outer_location(const Domain& domain, const Tangent_location& location)
{
  return {domain.vertex(domain.surfels().internal_vertex[location.vertex]), location.offset};
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_TRACE_ON_CLOUD_H
