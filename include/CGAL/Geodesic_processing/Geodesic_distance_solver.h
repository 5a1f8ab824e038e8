// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_DISTANCE_SOLVER_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_DISTANCE_SOLVER_H

#include <CGAL/Geodesic_processing/Source.h>
#include <CGAL/Geodesic_processing/Surface_path.h>
#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/tags.h>

#include <CGAL/Origin.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingPaths
/// how the shortest path to a place leaves its source: where the place lies on the exact logarithmic map.
template <typename Surface>
struct Geodesic_departure
{
  using Location = typename internal::Surface_traits<Surface>::Location;
  using Vector_3 = typename internal::Surface_traits<Surface>::Vector_3;

  Location from;                    ///< where on the source
  Vector_3 direction = NULL_VECTOR; ///< a unit vector; zero where there is no path or no way to go
  /// of the direction around `from`, in radians, counterclockwise from a direction that all departures
  /// from there have in common.
  double polar_angle = 0.;
  /// without the source's offset; infinite where there is no path.
  double length = internal::infinity;
};

/// \ingroup PkgGeodesicProcessingDistances
///
/// answers many queries for distances on one surface.
///
/// What a query costs depends on the sites that it reaches, not on the size of the surface; `Heat` is
/// global.  Copies share the domain, and may compute at the same time.  On a mesh the fronts prepare a
/// copy of each vertex's surroundings, which takes less time than a query over the whole mesh; with it
/// and the answer they take about 280 bytes per vertex beside the domain.
///
/// \tparam Surface as for `geodesic_distances()`, not a domain
/// \tparam Method as for `geodesic_distances()`
template <typename Surface, typename Method = Euclidean_front>
class Geodesic_distance_solver
{
  static_assert(!internal::Is_cloud<Surface>::value || !std::is_same_v<Method, Exact>,
                "Exact distances need a mesh; a surfel cloud has no edges to cross.");

public:
  using Domain = internal::Domain_of<Surface>;
  using Vertex = typename Domain::Vertex;
  using Location = typename Domain::Location;

  /// prepares the surface; `np` is what `make_domain()` takes.
  template <typename NamedParameters = internal::Default_parameters>
  explicit Geodesic_distance_solver(const Surface& surface,
                                    const NamedParameters& np = NamedParameters())
      : Geodesic_distance_solver(Domain(surface, np))
  {}
  explicit Geodesic_distance_solver(const Domain& domain)
      : Geodesic_distance_solver(domain, internal::distance_method<Method>())
  {}
#ifndef DOXYGEN_RUNNING
  Geodesic_distance_solver(const Domain& domain, internal::Distance_method method)
      : m_domain(domain), m_engine(method, domain.triangles())
  {}
#endif

  const Domain& domain() const { return m_domain; }

  /// computes distances to the sources; what the last call found is forgotten.
  ///
  /// \param sources a site, a location, a `Source`, or a range of one of these, not empty
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{maximum_distance} \cgalParamDescription{sites farther away are not reached}
  ///     \cgalParamDefault{infinity} \cgalParamNEnd
  ///   \cgalParamNBegin{targets}
  ///     \cgalParamDescription{a site, a location, or a range of them: the computation may stop when
  ///       they are final} \cgalParamDefault{none} \cgalParamNEnd
  ///   \cgalParamNBegin{speed_map}
  ///     \cgalParamDescription{the speed of the front at vertices or in faces, finite and not
  ///       negative, zero at obstacles; a triangle takes the mean of 1/speed of its corners}
  ///     \cgalParamDefault{1 everywhere} \cgalParamNEnd
  ///   \cgalParamNBegin{callback}
  ///     \cgalParamDescription{a `std::function<bool(double)>` that is told the fraction done and
  ///       cancels by returning false} \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \returns false if the callback cancelled it; then only sites whose distance was final are reached
  /// \throws Invalid_argument_error when there is no source, when an offset, a location, a speed or
  ///         the maximum distance is not usable
  /// \throws Unsupported_surface_error when the method takes no speeds
  template <typename Sources, typename NamedParameters = internal::Default_parameters>
  bool compute(const Sources& sources, const NamedParameters& np = NamedParameters())
  {
    const internal::Front_limits limits = internal::limits(m_domain, np);
    m_labels.clear();
    m_sources = internal::sources(m_domain, sources, m_labels);
    return m_engine.run(m_sources, limits);
  }

  /// \name The last computation
  /// @{

  /// returns the distance of a site, +infinity where no source reaches.
  double distance(Vertex vertex) const
  {
    return scale() * m_engine.distance(m_domain.index(vertex));
  }
  /// returns the distance anywhere on the surface.
  double distance(const Location& location) const
  {
    return scale() * m_engine.distance(m_domain.inner(location));
  }
  /// returns the label of the nearest source, the largest `std::size_t` where none reaches.
  std::size_t source_label(Vertex vertex) const { return label(m_domain.index(vertex)); }
  /// returns a neighbour nearer to the source, next to which the shortest path arrives; the site
  /// itself at sources and where none reaches.
  Vertex predecessor(Vertex vertex) const
  {
    return m_domain.vertex(predecessor_index(m_domain.index(vertex)));
  }
  /// returns the sites reached, nearly in the order of their distances.
  std::vector<Vertex> reached() const
  {
    std::vector<Vertex> result;
    result.reserve(m_engine.reached().size());
    for(const internal::Index index : m_engine.reached())
      result.push_back(m_domain.vertex(index));
    return result;
  }
  /// returns the path from a site or a location to its nearest source; empty where none reaches.
  /// With `Exact` it is as long as the distance.
  template <typename QueryLocation>
  Surface_path<Surface> path(const QueryLocation& from) const
  {
    const internal::Surface_location inner = internal::location(m_domain, from);
    const double distance = scale() * m_engine.distance(inner);
    // Only triangles without area keep an exact path from being found.
    if(const internal::Window_propagation* windows = m_engine.windows())
      if(const auto path = windows->path(inner); !path.empty())
        return internal::surface_path(m_domain, path, distance);
    return internal::surface_path(m_domain,
                                  internal::path_to_sources(
                                      *m_domain.triangles(), inner, m_sources,
                                      [&](internal::Index i) { return m_engine.distance(i); },
                                      [&](internal::Index i) { return m_engine.predecessor(i); },
                                      [&](internal::Index i) { return m_engine.source(i); }),
                                  distance);
  }

  /// returns all shortest paths from a site or a location to the sources, two or more on the cut locus;
  /// at most 64.  Only with `Exact`.
  ///
  /// \param tolerance paths longer by this part of the distance count as shortest; far smaller than an
  ///        edge, it makes up for rounding.
  template <typename QueryLocation>
  std::vector<Surface_path<Surface>> shortest_paths(const QueryLocation& from,
                                                    double tolerance = 1e-9) const
  {
    static_assert(std::is_same_v<Method, Exact>, "All shortest paths are known to Exact alone.");
    const internal::Surface_location inner = internal::location(m_domain, from);
    const double distance = scale() * m_engine.distance(inner);
    std::vector<Surface_path<Surface>> result;
    for(const auto& path : m_engine.windows()->paths(inner, tolerance))
      result.push_back(internal::surface_path(m_domain, path, distance));
    return result;
  }
  /// returns how the shortest path to a site or a location leaves its source.  Only with `Exact`.
  template <typename QueryLocation>
  Geodesic_departure<Surface> departure(const QueryLocation& to) const
  {
    static_assert(std::is_same_v<Method, Exact>, "Departures are known to Exact alone.");
    const internal::Departure found =
        m_engine.windows()->departure(internal::location(m_domain, to));
    Geodesic_departure<Surface> result;
    if(!(found.length < internal::infinity))
      return result;
    result.from = m_domain.outer(found.from);
    result.polar_angle = found.polar_angle;
    result.length = scale() * found.length;
    const auto first_segment = m_domain.point(found.next) - m_domain.point(found.from);
    const double x = to_double(first_segment.x()), y = to_double(first_segment.y()),
                 z = to_double(first_segment.z());
    if(const double size = std::hypot(x, y, z); size > 0.)
      result.direction = typename Domain::Vector_3(x / size, y / size, z / size);
    return result;
  }

  template <typename DistanceMap>
  void write_distances(DistanceMap map) const
  {
    m_domain.write([&](internal::Index i) { return scale() * m_engine.distance(i); }, map);
  }
  template <typename LabelMap>
  void write_source_labels(LabelMap map) const
  {
    m_domain.write([&](internal::Index i) { return label(i); }, map);
  }
  template <typename PredecessorMap>
  void write_predecessors(PredecessorMap map) const
  {
    m_domain.write([&](internal::Index i) { return m_domain.vertex(predecessor_index(i)); }, map);
  }
  /// @}

private:
  double scale() const { return m_domain.triangles()->scale; }
  std::size_t label(internal::Index index) const
  {
    const internal::Index source = m_engine.source(index);
    return source == internal::none ? (std::numeric_limits<std::size_t>::max)() : m_labels[source];
  }
  internal::Index predecessor_index(internal::Index index) const
  {
    const internal::Index predecessor = m_engine.predecessor(index);
    return predecessor == internal::none ? index : predecessor;
  }

  Domain m_domain;
  internal::Distance_engine m_engine;
  std::vector<internal::Front_source> m_sources;
  std::vector<std::size_t> m_labels;
};

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_DISTANCE_SOLVER_H
