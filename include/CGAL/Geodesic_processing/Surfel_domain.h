// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_SURFEL_DOMAIN_H
#define CGAL_GEODESIC_PROCESSING_SURFEL_DOMAIN_H

#include <CGAL/Geodesic_processing/Location.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/adaptors/callback.h>
#include <CGAL/Geodesic_processing/internal/adaptors/read_surfels.h>
#include <CGAL/Geodesic_processing/internal/core/slowness.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingDomain
///
/// Represents a surfel cloud for all algorithms of this package: a proximity graph, and local
/// triangles with weights, which overlap. It is returned by `make_domain()` and can be passed to
/// functions instead of the cloud. It is immutable, and copies are cheap, since they share the
/// data.
///
/// A domain stores the indices of the cloud, but does not refer to the cloud. It takes about 260
/// bytes per surfel, 8 more if it is a `Point_set_3`.
///
/// \tparam SurfelRange a model of the concept `SurfelRange`
template <typename SurfelRange>
class Surfel_domain
{
public:
  using Surface = SurfelRange;
  using Traits = internal::Surface_traits<Surface>;
  using Vertex = typename Traits::Vertex;     ///< the index of a `Point_set_3`, or `std::size_t`
  using Location = typename Traits::Location; ///< a `Surfel_location`
  using Point_3 = typename Traits::Point_3;
  using Vector_3 = typename Traits::Vector_3;

  /// Constructs the domain by reading the cloud once. O(n log n).
  ///
  /// \param surfels the cloud
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{point_map}
  ///     \cgalParamDescription{the points of the elements of the range}
  ///     \cgalParamType{a model of `ReadablePropertyMap` with the elements of the range as keys and
  ///       3D points as values}
  ///     \cgalParamDefault{the point map of a `Point_set_3`, otherwise the identity}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{normal_map}
  ///     \cgalParamDescription{the normals, of any positive length}
  ///     \cgalParamType{a model of `ReadablePropertyMap` with the elements of the range as keys and
  ///       3D vectors as values}
  ///     \cgalParamDefault{the normal map of a `Point_set_3`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{radius_map}
  ///     \cgalParamDescription{the radii of the surfels. The property `"radius"` that
  ///       `estimate_surfels()` adds to a `Point_set_3` is not used unless it is passed}
  ///     \cgalParamType{a model of `ReadablePropertyMap` with the elements of the range as keys and
  ///       `double` as values}
  ///     \cgalParamDefault{the distance to the 8th neighbor, divided by the square root of two}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{number_of_threads}
  ///     \cgalParamDescription{the number of threads}
  ///     \cgalParamType{`unsigned`}
  ///     \cgalParamDefault{1}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{callback}
  ///     \cgalParamDescription{a function that is called with 0 between the steps of the construction;
  ///       if it returns false, the function throws `Cancelled`}
  ///     \cgalParamType{`std::function<bool(double)>`}
  ///     \cgalParamDefault{no callback}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \pre Property maps have a value for each element of the range.
  /// \throws Unsupported_surface_error if there are no normals, or if there are more than
  ///         2<SUP>25</SUP> surfels
  /// \throws Invalid_argument_error if a coordinate or a radius is not finite, a radius is
  ///         negative, or a normal has no direction
  template <typename NamedParameters = internal::Default_parameters>
  explicit Surfel_domain(const SurfelRange& surfels, const NamedParameters& np = NamedParameters());

  /// Returns the number of surfels. O(1).
  std::size_t number_of_vertices() const { return m_data->descriptors.size(); }

  /// Returns the point of the tangent plane at a location. O(1).
  /// \param location a location on the cloud
  /// \throws Invalid_argument_error if the surfel is not in the cloud or the offset is not finite
  Point_3 point(const Location& location) const;

  /// Returns the axes to which the offsets of a surfel refer: two unit vectors in its tangent
  /// plane, whose cross product is its unit normal. They depend on the normal only. O(1).
  /// \param surfel a surfel
  /// \throws Invalid_argument_error if the surfel is not in the cloud
  std::array<Vector_3, 2> axes(Vertex surfel) const;

  /// \cond INTERNAL
  // Conversion between the cloud and the kernels.
  std::shared_ptr<const internal::Surface_arrays> triangles() const
  {
    return {m_data, &m_data->surfels.arrays};
  }
  const internal::Surfel_arrays& surfels() const { return m_data->surfels; }
  const internal::Surfel_descriptors<Surface>& descriptors() const { return m_data->descriptors; }
  internal::Surfel_input surfel_input() const;
  internal::Framed_surfels framed_surfels() const;
  template <typename NamedParameters>
  Surfel_domain(const SurfelRange& range, internal::Framed_surfels surfels,
                const NamedParameters& np);
  internal::Index index(Vertex surfel) const;
  Vertex vertex(internal::Index index) const
  {
    return m_data->descriptors[m_data->surfels.caller_vertex[index]];
  }
  internal::Surface_location inner(const Location& location) const;
  internal::Surface_location inner_vertex(Vertex surfel) const;
  Location outer(const internal::Surface_location& location) const;
  Point_3 point(const internal::Surface_location& location) const;
  template <typename SpeedMap>
  std::vector<double> slowness(SpeedMap speed) const;
  // Writes a value for each surfel to a property map. values maps an internal index to a value.
  template <typename Values, typename PropertyMap>
  void write(const Values& values, PropertyMap map) const
  {
    static_assert(internal::is_keyed_by<PropertyMap, Vertex>,
                  "An output map is a property map with surfels as keys. "
                  "CGAL::make_property_map() makes a map of a vector.");
    using Value = typename boost::property_traits<PropertyMap>::value_type;
    static_assert(std::is_constructible_v<Value, decltype(values(internal::Index()))>,
                  "The values of an output map must be constructible from the results, for "
                  "example from double.");
    for(std::size_t i = 0; i < number_of_vertices(); ++i)
      put(map, m_data->descriptors[i],
          static_cast<Value>(values(m_data->surfels.internal_vertex[i])));
  }
  /// \endcond

private:
  template <typename NamedParameters>
  void build(const SurfelRange& range, internal::Surfel_input input,
             const std::optional<internal::Frame>& frame, const NamedParameters& np);
  template <typename Point_of>
  internal::Surfel_input surfel_input(const Point_of& point_of) const;
  internal::Tangent_location scaled(const Location& location) const;

  struct Data
  {
    internal::Surfel_arrays surfels;
    internal::Surfel_descriptors<Surface> descriptors;
    bool has_given_radii = false;
  };
  std::shared_ptr<const Data> m_data;
};

/// \cond INTERNAL

template <typename SurfelRange>
template <typename NamedParameters>
Surfel_domain<SurfelRange>::Surfel_domain(const SurfelRange& range, const NamedParameters& np)
{
  static_assert(!internal::has_parameter<NamedParameters, CGAL::internal_np::geom_traits_t>,
                "The kernel is that of the range, see Surfel_kernel: geom_traits is not used.");
  build(range, internal::read_surfels(range, np), std::nullopt, np);
}

// Builds the domain again from framed_surfels(). Both are equal to the last bit.
template <typename SurfelRange>
template <typename NamedParameters>
Surfel_domain<SurfelRange>::Surfel_domain(const SurfelRange& range,
                                          internal::Framed_surfels surfels,
                                          const NamedParameters& np)
{
  build(range, std::move(surfels.input), surfels.frame, np);
}

template <typename SurfelRange>
template <typename NamedParameters>
void Surfel_domain<SurfelRange>::build(const SurfelRange& range, internal::Surfel_input input,
                                       const std::optional<internal::Frame>& frame,
                                       const NamedParameters& np)
{
  internal::Surfel_options options;
  options.frame = frame;
  options.number_of_threads = internal::parameter(np, internal_np::number_of_threads, 1u);
  options.callback = internal::read_throwing_callback(np);
  auto data = std::make_shared<Data>();
  data->descriptors = internal::Surfel_descriptors<Surface>(range);
  data->has_given_radii = !input.radii.empty();
  data->surfels = internal::build_surfel_arrays(std::move(input.points), std::move(input.normals),
                                                input.radii, options);
  m_data = std::move(data);
}

// Returns the points, normals and radii from which the domain was built, in the order of the range.
// Points are equal up to round-off errors, and normals are unit vectors.
template <typename SurfelRange>
internal::Surfel_input Surfel_domain<SurfelRange>::surfel_input() const
{
  return surfel_input(
      [&t = m_data->surfels.arrays](internal::Index vertex) {
        return internal::coordinates(t, {internal::none, vertex, {}});
      });
}

// Returns the surfels in the frame of the arrays. The scale is a power of two, so that there are no
// round-off errors.
template <typename SurfelRange>
internal::Framed_surfels Surfel_domain<SurfelRange>::framed_surfels() const
{
  using namespace internal;
  const Surface_arrays& t = m_data->surfels.arrays;
  return {surfel_input([&t](Index vertex) { return t.scale * t.point[vertex]; }),
          {t.origin, m_data->surfels.frame_scale}};
}

template <typename SurfelRange>
template <typename Point_of>
internal::Surfel_input Surfel_domain<SurfelRange>::surfel_input(const Point_of& point_of) const
{
  const internal::Surfel_arrays& surfels = m_data->surfels;
  internal::Surfel_input result;
  for(const internal::Index i : surfels.internal_vertex)
  {
    result.points.push_back(point_of(i));
    result.normals.push_back(surfels.arrays.normal[i]);
    if(m_data->has_given_radii)
      result.radii.push_back(surfels.arrays.scale * surfels.radius[i]);
  }
  return result;
}

template <typename SurfelRange>
internal::Index Surfel_domain<SurfelRange>::index(Vertex surfel) const
{
  return m_data->surfels.internal_vertex[m_data->descriptors.position(surfel)];
}

template <typename SurfelRange>
internal::Surface_location Surfel_domain<SurfelRange>::inner_vertex(Vertex surfel) const
{
  m_data->descriptors.check_descriptor(surfel);
  return {internal::none, index(surfel), {}};
}

template <typename SurfelRange>
internal::Surface_location Surfel_domain<SurfelRange>::inner(const Location& location) const
{
  return internal::to_surface_location(m_data->surfels.arrays, scaled(location));
}

// Converts a location of the caller to scaled units.
template <typename SurfelRange>
internal::Tangent_location Surfel_domain<SurfelRange>::scaled(const Location& location) const
{
  const double scale = m_data->surfels.arrays.scale;
  const auto [u, v] = location.offset;
  if(!(std::abs(u) < internal::infinity) || !(std::abs(v) < internal::infinity))
    throw Invalid_argument_error("The offset of a location is not finite.");
  return {inner_vertex(location.surfel).vertex, {u / scale, v / scale}};
}

template <typename SurfelRange>
typename Surfel_domain<SurfelRange>::Location
Surfel_domain<SurfelRange>::outer(const internal::Surface_location& location) const
{
  const internal::Surface_arrays& t = m_data->surfels.arrays;
  const internal::Tangent_location tangent_location = internal::to_tangent_location(t, location);
  return {vertex(tangent_location.vertex),
          {tangent_location.offset[0] * t.scale, tangent_location.offset[1] * t.scale}};
}

template <typename SurfelRange>
typename Surfel_domain<SurfelRange>::Point_3
Surfel_domain<SurfelRange>::point(const Location& location) const
{
  using namespace internal;
  const Surface_arrays& t = m_data->surfels.arrays;
  const auto p = t.origin + t.scale * position(t, scaled(location));
  return Point_3(p[0], p[1], p[2]);
}

template <typename SurfelRange>
std::array<typename Surfel_domain<SurfelRange>::Vector_3, 2>
Surfel_domain<SurfelRange>::axes(Vertex surfel) const
{
  const auto [u, v] =
      internal::tangent_frame(m_data->surfels.arrays.normal[inner_vertex(surfel).vertex]);
  return {Vector_3(u[0], u[1], u[2]), Vector_3(v[0], v[1], v[2])};
}

template <typename SurfelRange>
typename Surfel_domain<SurfelRange>::Point_3
Surfel_domain<SurfelRange>::point(const internal::Surface_location& location) const
{
  const auto p = internal::coordinates(m_data->surfels.arrays, location);
  return Point_3(p[0], p[1], p[2]);
}

template <typename SurfelRange>
template <typename SpeedMap>
std::vector<double> Surfel_domain<SurfelRange>::slowness(SpeedMap speed) const
{
  std::vector<double> values(number_of_vertices());
  for(std::size_t i = 0; i < values.size(); ++i)
    values[m_data->surfels.internal_vertex[i]] = get(speed, m_data->descriptors[i]);
  return internal::mean_over_corners(m_data->surfels.arrays,
                                     internal::slowness_of(std::move(values)));
}
/// \endcond

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_SURFEL_DOMAIN_H
