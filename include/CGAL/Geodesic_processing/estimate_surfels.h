// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_ESTIMATE_SURFELS_H
#define CGAL_GEODESIC_PROCESSING_ESTIMATE_SURFELS_H

#include <CGAL/Geodesic_processing/internal/adaptors/callback.h>
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
/// Estimates the normals and radii of points, so that they become surfels. Normals are those of
/// fitted quadrics \cgalCite{cgal:cp-edqpf-05}. They are oriented along a minimum spanning tree
/// (Hoppe and others 1992). In each component, the normal of the highest point (in z) points
/// upwards, hence normals point outwards if the points are from a closed surface. The radii are
/// such that the disks of neighbors overlap.
///
/// \tparam Concurrency_tag `CGAL::Sequential_tag` (the default), or `CGAL::Parallel_tag` for
///         several threads. The results are identical.
/// \tparam Points a `Point_set_3`, or any range with writable property maps. A `Point_set_3` gets
///         normals and a property `"radius"`, and its outliers are removed. They can be restored
///         until `collect_garbage()` is called.
/// \param points the points
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{point_map}
///     \cgalParamDescription{the points of the elements of the range}
///     \cgalParamType{a model of `ReadablePropertyMap` with the elements of the range as keys and
///       3D points as values}
///     \cgalParamDefault{the point map of a `Point_set_3`, otherwise the identity}
///   \cgalParamNEnd
///   \cgalParamNBegin{normal_map}
///     \cgalParamDescription{receives unit vectors}
///     \cgalParamType{a model of `WritablePropertyMap` with the elements of the range as keys and
///       3D vectors as values}
///     \cgalParamDefault{the normal map of a `Point_set_3`}
///   \cgalParamNEnd
///   \cgalParamNBegin{radius_map}
///     \cgalParamDescription{receives radii}
///     \cgalParamType{a model of `WritablePropertyMap` with the elements of the range as keys and
///       `double` as values}
///     \cgalParamDefault{the property `"radius"` of a `Point_set_3`; for a range, radii are not
///       written}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_neighbors}
///     \cgalParamDescription{the number of neighbors from which a normal is estimated, at least 6}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{18}
///   \cgalParamNEnd
///   \cgalParamNBegin{outlier_percentage}
///     \cgalParamDescription{the percentage of the points that are outliers: the points farthest
///       from their neighbors}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_threads}
///     \cgalParamDescription{the number of threads}
///     \cgalParamType{`unsigned`}
///     \cgalParamDefault{one; all with `Parallel_tag`}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a function that is called with 0 between the steps of the construction;
///       if it returns false, the function throws `Cancelled`}
///     \cgalParamType{`std::function<bool(double)>`}
///     \cgalParamDefault{no callback}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \pre The point map has a value for each element of the range.
/// \returns the number of outliers. They are removed from a `Point_set_3`; in a range, their radius
///          is 0.
/// \throws Invalid_argument_error if a coordinate is not finite, the number of neighbors is below
///         6, or the percentage is not in [0, 100]
/// \throws Unsupported_surface_error if the number of remaining points does not exceed the number
///         of neighbors
/// \throws Cancelled if the callback returns false
///
/// O(n log n) for n points.
template <typename Concurrency_tag = Sequential_tag, typename Points,
          typename NamedParameters = internal::Default_parameters>
std::size_t estimate_surfels(Points& points, const NamedParameters& np = NamedParameters())
{
  static_assert(internal::Is_cloud<Points>::value,
                "Surfels are estimated from a range of points. Meshes and domains have normals.");
  using internal::parameter;
  constexpr bool has_radii = internal::has_parameter<NamedParameters, internal_np::radius_map_t>;
  const auto estimate = [&](const auto& point_map)
  {
    std::vector<internal::Vec3> coordinates;
    for(const auto& element : points)
    {
      const auto& p = get(point_map, element);
      coordinates.push_back(
          {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    }
    return internal::estimate_surfels(
        coordinates, parameter(np, internal_np::number_of_neighbors, 18u),
        parameter(np, internal_np::outlier_percentage, 0.),
        internal::number_of_threads<Concurrency_tag>(np), internal::read_throwing_callback(np));
  };
  const auto write =
      [&](const internal::Estimated_surfels& surfels, auto normal_map, auto radius_map)
  {
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
  };
  if constexpr(internal::is_point_set<Points>)
  {
    const auto surfels = estimate(parameter(np, CGAL::internal_np::point_map, points.point_map()));
    points.add_normal_map();
    const auto radii = [&]
    {
      if constexpr(has_radii)
        return parameter(np, internal_np::radius_map, 0);
      else
        return points.template add_property_map<double>("radius", 0.).first;
    }();
    write(surfels, parameter(np, CGAL::internal_np::normal_map, points.normal_map()), radii);
    std::vector<typename Points::Index> outliers;
    for(const std::size_t position : surfels.removed)
      outliers.push_back(*(points.begin() + std::ptrdiff_t(position)));
    for(const auto& outlier : outliers)
      points.remove(outlier);
    return outliers.size();
  }
  else
  {
    using Element = std::decay_t<decltype(*points.begin())>;
    const auto surfels = estimate(
        parameter(np, CGAL::internal_np::point_map, CGAL::Identity_property_map<Element>()));
    write(surfels,
          CGAL::parameters::get_parameter(internal::plain(np), CGAL::internal_np::normal_map),
          parameter(np, internal_np::radius_map, 0));
    return surfels.removed.size();
  }
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_ESTIMATE_SURFELS_H
