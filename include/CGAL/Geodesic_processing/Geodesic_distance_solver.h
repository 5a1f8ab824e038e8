// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_DISTANCE_SOLVER_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_DISTANCE_SOLVER_H

#include <CGAL/Geodesic_processing/Source.h>
#include <CGAL/Geodesic_processing/Surface_path.h>
#include <CGAL/Geodesic_processing/internal/sources.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/tags.h>

#include <functional>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing {

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
  using Site = typename Domain::Site;
  using Location = typename Domain::Location;

  /// prepares the surface; `np` is what `make_domain()` takes.
  template <typename NamedParameters = internal::Default_parameters>
  explicit Geodesic_distance_solver(const Surface& surface,
                                    const NamedParameters& np = NamedParameters())
      : Geodesic_distance_solver(Domain(surface, np))
  {}
  explicit Geodesic_distance_solver(const Domain& domain)
      : m_domain(domain), m_engine(domain.triangles())
  {}

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
    const internal::Index none = internal::none;
    internal::Front_limits limits;
    const double maximum =
        internal::parameter(np, internal_np::maximum_distance, internal::infinity);
    if(!(maximum >= 0.))
      throw Invalid_argument_error("The maximum distance is negative or not a number.");
    limits.maximum_distance = maximum / scale();
    limits.callback =
        internal::parameter(np, CGAL::internal_np::callback, std::function<bool(double)>());
    if constexpr(internal::has_parameter<NamedParameters, internal_np::targets_t>)
      limits.targets =
          internal::locations(m_domain, internal::parameter(np, internal_np::targets, none));
    if constexpr(internal::has_parameter<NamedParameters, internal_np::speed_map_t>)
      limits.slowness = std::make_shared<const std::vector<double>>(
          m_domain.slowness(internal::parameter(np, internal_np::speed_map, none)));
    m_labels.clear();
    m_sources = internal::sources(m_domain, sources, m_labels);
    return m_engine.run(m_sources, limits);
  }

  /// \name The last computation
  /// @{

  /// returns the distance of a site, +infinity where no source reaches.
  double distance(Site site) const { return scale() * m_engine.distance(m_domain.index(site)); }
  /// returns the distance anywhere on the surface.
  double distance(const Location& location) const
  {
    return scale() * m_engine.distance(m_domain.inner(location));
  }
  /// returns the label of the nearest source, the largest `std::size_t` where none reaches.
  std::size_t source_label(Site site) const { return label(m_domain.index(site)); }
  /// returns a neighbour nearer to the source, next to which the shortest path arrives; the site
  /// itself at sources and where none reaches.
  Site predecessor(Site site) const { return m_domain.site(before(m_domain.index(site))); }
  /// returns the sites reached, nearly in the order of their distances.
  std::vector<Site> reached() const
  {
    std::vector<Site> result;
    result.reserve(m_engine.reached().size());
    for(const internal::Index index : m_engine.reached())
      result.push_back(m_domain.site(index));
    return result;
  }
  /// returns the path from a site or a location to its nearest source; empty where none reaches.
  /// With `Exact` it is as long as the distance.
  template <typename Place>
  Surface_path<Surface> path(const Place& from) const
  {
    const internal::Location inner = internal::location(m_domain, from);
    const double distance = scale() * m_engine.distance(inner);
    // Only triangles without area keep an exact path from being found.
    if constexpr(std::is_same_v<Method, Exact>)
      if(const auto path = m_engine.path(inner); !path.empty())
        return internal::surface_path(m_domain, path, distance);
    return internal::surface_path(m_domain,
                                  internal::path_to_sources(
                                      *m_domain.triangles(), inner, m_sources,
                                      [&](internal::Index i) { return m_engine.distance(i); },
                                      [&](internal::Index i) { return m_engine.predecessor(i); },
                                      [&](internal::Index i) { return m_engine.source(i); }),
                                  distance);
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
    m_domain.write([&](internal::Index i) { return m_domain.site(before(i)); }, map);
  }
  /// @}

private:
  double scale() const { return m_domain.triangles()->scale; }
  std::size_t label(internal::Index index) const
  {
    const internal::Index source = m_engine.source(index);
    return source == internal::none ? (std::numeric_limits<std::size_t>::max)() : m_labels[source];
  }
  internal::Index before(internal::Index index) const
  {
    const internal::Index predecessor = m_engine.predecessor(index);
    return predecessor == internal::none ? index : predecessor;
  }

  Domain m_domain;
  internal::Engine<Method> m_engine;
  std::vector<internal::Source> m_sources;
  std::vector<std::size_t> m_labels;
};

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_DISTANCE_SOLVER_H
