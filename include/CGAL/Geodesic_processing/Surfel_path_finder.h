// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_SURFEL_PATH_FINDER_H
#define CGAL_GEODESIC_PROCESSING_SURFEL_PATH_FINDER_H

#include <CGAL/Geodesic_processing/Surface_path.h>
#include <CGAL/Geodesic_processing/Surfel_domain.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/paths/Cloud_path_finder.h>
#include <CGAL/Geodesic_processing/internal/adaptors/path_options.h>
#include <CGAL/Geodesic_processing/internal/adaptors/read_surfels.h>
#include <CGAL/Geodesic_processing/is_supported.h>
#include <CGAL/Geodesic_processing/parameters.h>
#include <CGAL/Geodesic_processing/surfel_variants.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingPaths
///
/// A path on a surfel cloud. Each location refers to the surfel nearest to it on the same sheet.
/// `length` is the length of the polyline, which cuts corners, and at most `initial_length`.
/// `front_distance` is the length of the smooth curve through its points, and the more accurate
/// estimate of the geodesic distance. If `do_enforce_guarantees` is `false`, both are the length of
/// the polyline, which can exceed `initial_length`.
template <typename SurfelRange>
struct Surfel_path : Surface_path<SurfelRange>
{
  /// The surfels of the graph path from which the minimization starts.
  std::vector<typename internal::Surface_traits<SurfelRange>::Vertex> initial_path;
  /// The length of a smooth curve along the graph path. Arcs between consecutive surfels form the
  /// curve. If the shortened path is longer, because the arcs do not follow the surface, the curve
  /// is projected to the surface instead.
  double initial_length = 0.;
  std::size_t number_of_control_points = 0; ///< the curve has about four points per control point
  std::vector<Path_energy_level> levels;    ///< the levels of the minimization, from coarse to fine
};

/// \ingroup PkgGeodesicProcessingPaths
/// The result of `geodesic_path()`: a `Surfel_path` on a cloud, a `Surface_path` on a mesh.
template <typename Surface>
using Geodesic_path = std::conditional_t<internal::Is_cloud<Surface>::value, Surfel_path<Surface>,
                                         Surface_path<Surface>>;

/// \ingroup PkgGeodesicProcessingPaths
///
/// Computes geodesic paths between pairs of surfels or locations on a clean or noisy surfel cloud.
///
/// A short path in a proximity graph is deformed to a geodesic by minimizing an energy
/// \cgalCite{cgal:rdsk-asg-06}. The number of control points increases from level to level. The
/// surface is fitted to the surfels along the path and ends at 1.5 radii from the last surfel.
///
/// If `do_enforce_guarantees` is `true`, paths neither cross gaps nor change to another sheet. The
/// distance of each point of a path to the nearest surfel is at most the 95th percentile of the
/// local spacing. The percentile is computed for the 60 surfels nearest to the point. The spacing
/// of a surfel is the distance to its sixth nearest surfel. The surfels of consecutive points are
/// joined by short graph paths.
///
/// Copies share the cloud and the graph, and different copies can search concurrently.
///
/// Members that do not state their time take O(1) time.
///
/// \tparam SurfelRange a model of `SurfelRange`
template <typename SurfelRange>
class Surfel_path_finder
{
  static_assert(internal::require_support<Function::Surfel_path_finder, SurfelRange>());

public:
  using Surface = SurfelRange;
  using Traits = internal::Surface_traits<Surface>;
  using Vertex = typename Traits::Vertex;
  using Location = typename Traits::Location;
  using Point_3 = typename Traits::Point_3;

  /// Reads the cloud and builds the proximity graph. O(n log n) time.
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
  ///     \cgalParamDescription{the radii of the surfels' disks}
  ///     \cgalParamType{a model of `ReadablePropertyMap` with the elements of the range as keys and
  ///       `double` as values}
  ///     \cgalParamDefault{the distance to the 8th nearest neighbor divided by the square root of
  ///       two}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{surfel_path_method}
  ///     \cgalParamDescription{the method}
  ///     \cgalParamType{`Surfel_path_method`}
  ///     \cgalParamDefault{`projected_quadrics`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{surfel_noise}
  ///     \cgalParamDescription{the treatment of noise}
  ///     \cgalParamType{`Surfel_noise`}
  ///     \cgalParamDefault{`removed_when_found`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{surfel_graph}
  ///     \cgalParamDescription{the proximity graph}
  ///     \cgalParamType{`Surfel_graph`}
  ///     \cgalParamDefault{`extended_spheres`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{surfel_search}
  ///     \cgalParamDescription{the search for the path that initializes the result}
  ///     \cgalParamType{`Surfel_search`}
  ///     \cgalParamDefault{`coarse_to_fine`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{number_of_control_points}
  ///     \cgalParamDescription{the maximum number of control points. Paths of a few surfels have
  ///       fewer, and paths across sharp edges can have more}
  ///     \cgalParamType{`std::size_t`}
  ///     \cgalParamDefault{75}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{node_weight}
  ///     \cgalParamDescription{the weight \f$ \alpha \f$ of the control points' squared distances
  ///       in the energy}
  ///     \cgalParamType{`double`}
  ///     \cgalParamDefault{0.7}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{segment_weight}
  ///     \cgalParamDescription{the weight \f$ \beta \f$ of the squared distances of the segments'
  ///       midpoints in the energy}
  ///     \cgalParamType{`double`}
  ///     \cgalParamDefault{0.7}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{do_enforce_guarantees}
  ///     \cgalParamDescription{whether a path is changed or replaced if it is longer than the
  ///       initial path, crosses a gap or changes to another sheet. If `false`, the
  ///       points of the path are the control points that minimize the energy. They are not
  ///       projected to the surface, unless the method does, and no smooth curve is fitted to them.
  ///       Use it to compare methods}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{`true`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{number_of_threads}
  ///     \cgalParamDescription{the number of threads}
  ///     \cgalParamType{`unsigned`}
  ///     \cgalParamDefault{1}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \pre Property maps have a value for each element of the range.
  /// \throws as `Surfel_domain`
  /// \throws Invalid_argument_error if a weight is negative or not finite, or if the number of
  ///         control points is zero
  template <typename NamedParameters = internal::Default_parameters>
  explicit Surfel_path_finder(const SurfelRange& surfels,
                              const NamedParameters& np = NamedParameters())
      : Surfel_path_finder(internal::Surfel_descriptors<SurfelRange>(surfels),
                           internal::read_surfels(surfels, np), np)
  {}
  /// Uses the surfels of a `domain`. The time and `np` are as for a cloud, except for property
  /// maps.
  /// \throws Invalid_argument_error as for a cloud
  template <typename NamedParameters = internal::Default_parameters>
  explicit Surfel_path_finder(const Surfel_domain<SurfelRange>& domain,
                              const NamedParameters& np = NamedParameters())
      : Surfel_path_finder(domain.descriptors(), domain.surfel_input(), np)
  {}

  /// Returns the number of surfels.
  std::size_t number_of_surfels() const { return m_descriptors->size(); }

  /// Returns the number of connected components of the graph. No path joins different components.
  std::size_t number_of_components() const { return cloud().number_of_components; }
  /// Returns the component of a surfel, a number smaller than `number_of_components()`.
  /// \param surfel a surfel of the cloud
  /// \throws Invalid_argument_error if the surfel does not belong to the cloud
  std::size_t component(Vertex surfel) const
  {
    return cloud().component[tangent_location(surfel).vertex];
  }

  /// Returns the number of edges of the graph; each is counted once.
  std::size_t number_of_edges() const { return cloud().graph.target.size() / 2; }
  /// Calls `f(surfel, surfel)` with the two endpoints of each edge of the graph, once per edge.
  /// Takes linear time in the number of edges.
  /// \tparam Function a function object
  /// \param f a function of two surfels
  template <typename Function>
  void for_each_edge(Function f) const;

  /// Returns the noise level: the median, over all surfels, of the median height of a surfel's
  /// neighbors. Heights are divided by the spacing. Returns 0 if `surfel_noise` is `kept`.
  double noise() const { return m_finder.fitted_cloud()->noise(); }

  /// \name Surfels after Noise Removal
  /// @{
  /// Returns the position of a surfel.
  /// \param surfel a surfel of the cloud
  /// \throws Invalid_argument_error if the surfel does not belong to the cloud
  Point_3 point(Vertex surfel) const
  {
    return outer_point(cloud().point[tangent_location(surfel).vertex]);
  }
  /// Returns the unit normal of a surfel.
  /// \param surfel a surfel of the cloud
  /// \throws Invalid_argument_error if the surfel does not belong to the cloud
  typename Traits::Vector_3 normal(Vertex surfel) const
  {
    const auto& n = cloud().normal[tangent_location(surfel).vertex];
    return {n[0], n[1], n[2]};
  }
  /// Returns the radius of a surfel, in the unit of the coordinates.
  /// \param surfel a surfel of the cloud
  /// \throws Invalid_argument_error if the surfel does not belong to the cloud
  double radius(Vertex surfel) const
  {
    return cloud().frame.scale * cloud().radius[tangent_location(surfel).vertex];
  }
  /// @}

  /// Returns the location nearest to a point in space. O(log n) time on most clouds.
  /// \tparam Point a `Point_3` of any kernel
  /// \param point the point
  /// \throws Invalid_argument_error if a coordinate is not finite or the cloud is empty
  template <typename Point>
  Location locate(const Point& point) const
  {
    return outer(internal::locate(
        cloud().tree, cloud().point, cloud().normal, cloud().radius, cloud().frame,
        {CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z())}));
  }

  /// Returns a path from one surfel or location to another; empty if they are not connected. The
  /// search takes O(m log m) time for m visited surfels. The first search also allocates about 40
  /// bytes per surfel, which later ones reuse. The minimization takes time proportional
  /// to the number of control points in each iteration.
  /// \tparam FromLocation, ToLocation a surfel or a location
  /// \param from, to surfels or locations
  /// \throws Invalid_argument_error if a surfel does not belong to the cloud, or if an offset is
  ///         not finite
  template <typename FromLocation, typename ToLocation>
  Surfel_path<SurfelRange> operator()(const FromLocation& from, const ToLocation& to)
  {
    return outer(m_finder(tangent_location(from), tangent_location(to)));
  }
  /// Shortens a polyline to a geodesic with the same ends; empty if consecutive locations are not
  /// connected. Short graph paths join them, which together are the initial path.
  /// Takes time as `operator()` for each pair of consecutive locations.
  ///
  /// \tparam Polyline a range of surfels or of locations
  /// \param polyline a range of at least two surfels or of at least two locations
  /// \returns the path
  /// \throws Invalid_argument_error if there are fewer than two, and as `operator()`
  template <typename Polyline>
  Surfel_path<SurfelRange> shorten(const Polyline& polyline);

  /// \cond INTERNAL
  // Access for the kernels.
  internal::Tangent_location tangent_location(Vertex surfel) const
  {
    m_descriptors->check_descriptor(surfel);
    return {cloud().internal_vertex[m_descriptors->position(surfel)], {0., 0.}};
  }
  internal::Tangent_location tangent_location(const Location& location) const;
  Location outer(const internal::Tangent_location& location) const
  {
    const double scale = cloud().frame.scale;
    return {outer_vertex(location.vertex),
            {scale * location.offset[0], scale * location.offset[1]}};
  }
  Surfel_path<SurfelRange> outer(const internal::Cloud_path& found) const;
  const internal::Cloud_path_finder& kernel() const { return m_finder; }
  /// \endcond

private:
  template <typename NamedParameters>
  Surfel_path_finder(internal::Surfel_descriptors<SurfelRange> descriptors,
                     internal::Surfel_input surfels, const NamedParameters& np);
  const internal::Surfel_cloud& cloud() const { return m_finder.fitted_cloud()->cloud(); }
  Vertex outer_vertex(internal::Index vertex) const
  {
    return (*m_descriptors)[cloud().caller_vertex[vertex]];
  }
  Point_3 outer_point(const internal::Vec3& p) const
  {
    const auto& [origin, scale] = cloud().frame;
    return {origin[0] + scale * p[0], origin[1] + scale * p[1], origin[2] + scale * p[2]};
  }

  std::shared_ptr<const internal::Surfel_descriptors<SurfelRange>> m_descriptors;
  internal::Cloud_path_finder m_finder;
};

/// \cond INTERNAL

namespace internal {

template <typename NamedParameters>
Cloud_path_options cloud_path_options(const NamedParameters& np)
{
  Cloud_path_options result;
  result.cloud.graph = parameter(np, internal_np::surfel_graph, result.cloud.graph);
  result.cloud.number_of_threads = parameter(np, internal_np::number_of_threads, 1u);
  result.method = parameter(np, internal_np::surfel_path_method, result.method);
  result.noise = parameter(np, internal_np::surfel_noise, result.noise);
  result.search = parameter(np, internal_np::surfel_search, result.search);
  result.path = path_options(np);
  result.do_enforce_guarantees =
      parameter(np, internal_np::do_enforce_guarantees, result.do_enforce_guarantees);
  return result;
}

} // namespace internal

template <typename SurfelRange>
template <typename NamedParameters>
Surfel_path_finder<SurfelRange>::Surfel_path_finder(
    internal::Surfel_descriptors<SurfelRange> descriptors, internal::Surfel_input surfels,
    const NamedParameters& np)
    : m_descriptors(std::make_shared<const internal::Surfel_descriptors<SurfelRange>>(
          std::move(descriptors))),
      m_finder(std::make_shared<const internal::Fitted_cloud>(
          std::move(surfels.points), std::move(surfels.normals), surfels.radii,
          internal::cloud_path_options(np)))
{}

template <typename SurfelRange>
template <typename Polyline>
Surfel_path<SurfelRange> Surfel_path_finder<SurfelRange>::shorten(const Polyline& polyline)
{
  std::vector<internal::Tangent_location> locations;
  for(const auto& element : polyline)
    locations.push_back(tangent_location(element));
  if(locations.size() < 2)
    throw Invalid_argument_error("A polyline has fewer than two points.");
  return outer(m_finder.shorten(locations));
}

template <typename SurfelRange>
template <typename Function>
void Surfel_path_finder<SurfelRange>::for_each_edge(Function f) const
{
  const internal::Proximity_graph& graph = cloud().graph;
  for(internal::Index vertex = 0; vertex + 1 < graph.begin.size(); ++vertex)
    for(internal::Index e = graph.begin[vertex]; e < graph.begin[vertex + 1]; ++e)
      if(graph.target[e] > vertex)
        f(outer_vertex(vertex), outer_vertex(graph.target[e]));
}

template <typename SurfelRange>
internal::Tangent_location
Surfel_path_finder<SurfelRange>::tangent_location(const Location& location) const
{
  internal::Tangent_location result = tangent_location(location.surfel);
  for(int k = 0; k < 2; ++k)
  {
    if(!std::isfinite(location.offset[k]))
      throw Invalid_argument_error("The offset of a location is not finite.");
    result.offset[k] = location.offset[k] / cloud().frame.scale;
  }
  return result;
}

template <typename SurfelRange>
Surfel_path<SurfelRange>
Surfel_path_finder<SurfelRange>::outer(const internal::Cloud_path& found) const
{
  const double scale = cloud().frame.scale;
  const internal::Shortened_path& path = found.path;
  Surfel_path<SurfelRange> result;
  for(const internal::Projection& foot : path.points)
  {
    result.locations.push_back(outer(m_finder.fitted_cloud()->location(foot)));
    result.points.push_back(outer_point(foot.point));
  }
  for(const internal::Index vertex : found.initial_path)
    result.initial_path.push_back(outer_vertex(vertex));
  result.length = scale * path.polyline_length;
  result.front_distance = path.points.empty() ? internal::infinity : scale * path.length;
  if(!path.points.empty())
  {
    using internal::operator-;
    constexpr double round_off = 1e-12; // of the frame of the cloud
    const double straight_distance =
        internal::norm(path.points.back().point - path.points.front().point);
    result.lower = scale * (std::max)(0., straight_distance - round_off);
  }
  result.initial_length = scale * found.initial_length;
  result.number_of_control_points = path.number_of_control_points;
  for(Path_energy_level level : path.levels)
  {
    level.first_energy *= scale * scale;
    level.last_energy *= scale * scale;
    result.levels.push_back(level);
  }
  return result;
}
/// \endcond

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_SURFEL_PATH_FINDER_H
