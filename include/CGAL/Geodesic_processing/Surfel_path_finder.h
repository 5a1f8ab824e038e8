// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_SURFEL_PATH_FINDER_H
#define CGAL_GEODESIC_PROCESSING_SURFEL_PATH_FINDER_H

#include <CGAL/Geodesic_processing/Surface_path.h>
#include <CGAL/Geodesic_processing/internal/paths/Cloud_path_finder.h>
#include <CGAL/Geodesic_processing/internal/adaptors/path_options.h>
#include <CGAL/Geodesic_processing/internal/adaptors/read_surfels.h>
#include <CGAL/Geodesic_processing/parameters.h>
#include <CGAL/Geodesic_processing/surfel_variants.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingPaths
///
/// a path on a cloud.  Each of its locations names the surfel nearest to it on its sheet; `length` is that of the
/// polyline, never longer than `start_length`, and `front_distance` that of the curve through its
/// points: the geodesic distance.
template <typename SurfelRange>
struct Surfel_path : Surface_path<SurfelRange>
{
  std::vector<typename internal::Surface_traits<SurfelRange>::Vertex>
      start; ///< the surfels of the chain of arcs that it started from
  double start_length =
      0.; ///< of that chain, or where arcs cut the surface short of the curve over it
  std::size_t number_of_control_points = 0; ///< the curve has about four points for each
  std::vector<Path_energy_level> levels;    ///< from coarse to fine
};

/// \ingroup PkgGeodesicProcessingPaths
///
/// finds geodesic paths on a cloud of surfels, clean or noisy, one pair after the other.
///
/// A short chain of arcs of a proximity graph is made a geodesic by minimizing an energy
/// \cgalCite{cgal:rdsk-asg-06}, with few control points first and then more, on a surface that is
/// fitted to the surfels where the path comes by.  It ends at one and a half radii from the last
/// surfel: no path crosses a gap, or changes to another sheet.  No point of a path is farther from the
/// nearest surfel than the 95th percentile of the spacing there, of the distances to their sixth neighbours
/// among the 60 surfels around; and from one point to the next the surfels are joined by a short chain of
/// arcs.  Copies share the cloud and the
/// graph, and may search at the same time.
///
/// \tparam SurfelRange a model of `SurfelRange`
template <typename SurfelRange>
class Surfel_path_finder
{
public:
  using Surface = SurfelRange;
  using Traits = internal::Surface_traits<Surface>;
  using Vertex = typename Traits::Vertex;
  using Location = typename Traits::Location;
  using Point_3 = typename Traits::Point_3;

  /// reads the cloud once: O(n log n).
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{point_map} \cgalParamDescription{of the elements of the range}
  ///     \cgalParamDefault{that of a `Point_set_3`, else the identity} \cgalParamNEnd
  ///   \cgalParamNBegin{normal_map} \cgalParamDescription{of any positive length}
  ///     \cgalParamDefault{that of a `Point_set_3`} \cgalParamNEnd
  ///   \cgalParamNBegin{radius_map} \cgalParamDescription{how far surfels reach}
  ///     \cgalParamDefault{the distance to the 8th neighbour over the square root of two}
  ///     \cgalParamNEnd
  ///   \cgalParamNBegin{surfel_path_method} \cgalParamDescription{a `Surfel_path_method`}
  ///     \cgalParamDefault{`projected_quadrics`} \cgalParamNEnd
  ///   \cgalParamNBegin{surfel_noise} \cgalParamDescription{a `Surfel_noise`}
  ///     \cgalParamDefault{`removed_when_found`} \cgalParamNEnd
  ///   \cgalParamNBegin{surfel_graph} \cgalParamDescription{a `Surfel_graph`}
  ///     \cgalParamDefault{`extended_spheres`} \cgalParamNEnd
  ///   \cgalParamNBegin{surfel_search} \cgalParamDescription{a `Surfel_search`}
  ///     \cgalParamDefault{`coarse_to_fine`} \cgalParamNEnd
  ///   \cgalParamNBegin{number_of_control_points} \cgalParamDescription{at most; paths of a few
  ///     surfels have fewer, and those over sharp edges more} \cgalParamDefault{75} \cgalParamNEnd
  ///   \cgalParamNBegin{node_weight} \cgalParamDescription{of the squared distances of control points,
  ///     the \f$ \alpha \f$ of the energy} \cgalParamDefault{0.7} \cgalParamNEnd
  ///   \cgalParamNBegin{segment_weight} \cgalParamDescription{of those of the middles of segments, its
  ///     \f$ \beta \f$} \cgalParamDefault{0.7} \cgalParamNEnd
  ///   \cgalParamNBegin{threads} \cgalParamDefault{1} \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws as `Surfel_domain`, and Invalid_argument_error when a weight is negative
  template <typename NamedParameters = internal::Default_parameters>
  explicit Surfel_path_finder(const SurfelRange& surfels,
                              const NamedParameters& np = NamedParameters());

  std::size_t number_of_surfels() const { return m_descriptors->size(); }

  /// between which there are no paths.
  std::size_t number_of_components() const { return cloud().number_of_components; }
  /// below `number_of_components()`.
  std::size_t component(Vertex surfel) const
  {
    return cloud().component[tangent_location(surfel).vertex];
  }

  /// of arcs, each counted once.
  std::size_t number_of_edges() const { return cloud().graph.target.size() / 2; }
  /// calls `f(surfel, surfel)` for the two ends of each arc.
  template <typename Function>
  void for_each_edge(Function f) const;

  /// the median of how far a surfel rises over its neighbours, in spacings; 0 when noise is `kept`.
  double noise() const { return m_finder.fitted_cloud()->noise(); }

  /// \name A surfel as paths see it: where noise has been removed
  /// @{
  Point_3 point(Vertex surfel) const
  {
    return outer_point(cloud().point[tangent_location(surfel).vertex]);
  }
  typename Traits::Vector_3 normal(Vertex surfel) const
  {
    const auto& n = cloud().normal[tangent_location(surfel).vertex];
    return {n[0], n[1], n[2]};
  }
  double radius(Vertex surfel) const
  {
    return cloud().frame.scale * cloud().radius[tangent_location(surfel).vertex];
  }
  /// @}

  /// returns the location nearest to a point in space.  O(log n) on most clouds.
  /// \throws Invalid_argument_error when a coordinate is not finite or the cloud is empty
  template <typename Point>
  Location locate(const Point& point) const
  {
    return outer(internal::locate(
        cloud().tree, cloud().point, cloud().normal, cloud().radius, cloud().frame,
        {CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z())}));
  }

  /// returns a path from one surfel or location to another; empty when they are not connected.
  /// \throws Invalid_argument_error when a surfel is none of the cloud's, or an offset not finite
  template <typename FromLocation, typename ToLocation>
  Surfel_path<SurfelRange> operator()(const FromLocation& from, const ToLocation& to)
  {
    return outer(m_finder(tangent_location(from), tangent_location(to)));
  }

  /// \name Between the cloud and the kernels
  /// @{
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
  /// @}

private:
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

namespace internal {

template <typename NamedParameters>
Cloud_path_options cloud_path_options(const NamedParameters& np)
{
  Cloud_path_options result;
  result.cloud.graph = parameter(np, internal_np::surfel_graph, result.cloud.graph);
  result.cloud.threads = parameter(np, internal_np::threads, 1u);
  result.method = parameter(np, internal_np::surfel_path_method, result.method);
  result.noise = parameter(np, internal_np::surfel_noise, result.noise);
  result.search = parameter(np, internal_np::surfel_search, result.search);
  result.path = path_options(np);
  return result;
}

template <typename SurfelRange, typename NamedParameters>
Cloud_path_finder make_path_finder(const SurfelRange& range, const NamedParameters& np)
{
  Surfel_input arrays = read_surfels(range, np);
  return Cloud_path_finder(std::make_shared<const Fitted_cloud>(
      std::move(arrays.points), std::move(arrays.normals), arrays.radii, cloud_path_options(np)));
}

} // namespace internal

template <typename SurfelRange>
template <typename NamedParameters>
Surfel_path_finder<SurfelRange>::Surfel_path_finder(const SurfelRange& range,
                                                    const NamedParameters& np)
    : m_descriptors(std::make_shared<const internal::Surfel_descriptors<SurfelRange>>(range)),
      m_finder(internal::make_path_finder(range, np))
{}

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
  for(const internal::Index vertex : found.start)
    result.start.push_back(outer_vertex(vertex));
  result.length = scale * path.polyline_length;
  result.front_distance = path.points.empty() ? internal::infinity : scale * path.length;
  result.start_length = scale * found.start_length;
  result.number_of_control_points = path.number_of_control_points;
  for(Path_energy_level level : path.levels)
  {
    level.first_energy *= scale * scale;
    level.last_energy *= scale * scale;
    result.levels.push_back(level);
  }
  return result;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_SURFEL_PATH_FINDER_H
