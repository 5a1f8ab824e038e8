// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_ESTIMATE_SURFELS_H
#define CGAL_GEODESIC_PROCESSING_ESTIMATE_SURFELS_H

#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/internal/adaptors/read_surfels.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_estimation.h>

#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingDomain
///
/// makes surfels of points: normals of fitted surfaces of second order \cgalCite{cgal:cp-edqpf-05}, oriented
/// along a minimum spanning tree, and radii such that the disks of neighbours overlap.
///
/// \tparam Concurrency_tag `CGAL::Sequential_tag` (the default) or `CGAL::Parallel_tag`: several
///         threads.  The result is the same.
/// \tparam Points a `Point_set_3`, which gets normals and a property `"radius"`, and loses outliers
///         (until `collect_garbage()` they can be had back); or any range, with maps to write to
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{point_map} \cgalParamDescription{of the elements of the range}
///     \cgalParamDefault{that of a `Point_set_3`, else the identity} \cgalParamNEnd
///   \cgalParamNBegin{normal_map} \cgalParamDescription{receives unit vectors}
///     \cgalParamDefault{that of a `Point_set_3`} \cgalParamNEnd
///   \cgalParamNBegin{radius_map} \cgalParamDescription{receives radii}
///     \cgalParamDefault{none, or the property of a `Point_set_3`} \cgalParamNEnd
///   \cgalParamNBegin{number_of_neighbors} \cgalParamDescription{that a normal is estimated from}
///     \cgalParamDefault{18} \cgalParamNEnd
///   \cgalParamNBegin{outlier_percentage} \cgalParamDescription{how many points, those farthest from
///     their neighbours, are outliers} \cgalParamDefault{0} \cgalParamNEnd
///   \cgalParamNBegin{threads} \cgalParamDefault{one, or with `Parallel_tag` all} \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the number of outliers: of a `Point_set_3` they have been removed, in a range they have the
///          radius 0
/// \throws Invalid_argument_error when a coordinate is not finite or a number makes no sense, and
///         Unsupported_surface_error when there are fewer points than neighbours
template <typename Concurrency_tag = Sequential_tag, typename Points,
          typename NamedParameters = internal::Default_parameters>
std::size_t estimate_surfels(Points& points, const NamedParameters& np = NamedParameters())
{
  using internal::parameter;
  constexpr bool has_radii = internal::has_parameter<NamedParameters, internal_np::radius_map_t>;
  const auto estimate = [&](const auto& point_map, auto normal_map, auto radius_map)
  {
    std::vector<internal::Vec3> coordinates;
    for(const auto& element : points)
    {
      const auto& p = get(point_map, element);
      coordinates.push_back(
          {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    }
    auto surfels = internal::estimate_surfels(
        coordinates, parameter(np, internal_np::number_of_neighbors, 18u),
        parameter(np, internal_np::outlier_percentage, 0.), internal::threads<Concurrency_tag>(np));
    using Vector = typename boost::property_traits<decltype(normal_map)>::value_type;
    std::size_t position = 0;
    for(auto&& element : points)
    {
      const auto& n = surfels.normals[position];
      put(normal_map, element, Vector(n[0], n[1], n[2]));
      if constexpr(!std::is_same_v<decltype(radius_map), int>)
        put(radius_map, element, surfels.radii[position]);
      ++position;
    }
    return surfels.removed;
  };
  if constexpr(internal::is_point_set<Points>)
  {
    points.add_normal_map();
    const auto radii = [&]
    {
      if constexpr(has_radii)
        return parameter(np, internal_np::radius_map, 0);
      else
        return points.template add_property_map<double>("radius", 0.).first;
    }();
    const std::vector<std::size_t> removed =
        estimate(parameter(np, CGAL::internal_np::point_map, points.point_map()),
                 parameter(np, CGAL::internal_np::normal_map, points.normal_map()), radii);
    std::vector<typename Points::Index> outliers;
    for(const std::size_t position : removed)
      outliers.push_back(*(points.begin() + std::ptrdiff_t(position)));
    for(const auto& outlier : outliers)
      points.remove(outlier);
    return outliers.size();
  }
  else
  {
    using Element = std::decay_t<decltype(*points.begin())>;
    return estimate(
               parameter(np, CGAL::internal_np::point_map, CGAL::Identity_property_map<Element>()),
               CGAL::parameters::get_parameter(internal::plain(np), CGAL::internal_np::normal_map),
               parameter(np, internal_np::radius_map, 0))
        .size();
  }
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_ESTIMATE_SURFELS_H
