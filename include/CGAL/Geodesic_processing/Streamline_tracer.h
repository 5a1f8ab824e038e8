// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_STREAMLINE_TRACER_H
#define CGAL_GEODESIC_PROCESSING_STREAMLINE_TRACER_H

#include <CGAL/Geodesic_processing/Surface_path.h>
#include <CGAL/Geodesic_processing/internal/transport/Multilevel_transport_solver.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <cstddef>
#include <memory>
#include <utility>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingTransport
///
/// Stores a path along which a flow transports mass. Its `front_distance` is the increase of the
/// potential from its start to its end, interpolated linearly in faces. If these ends are vertices
/// or surfels, no path between them is shorter.
template <typename Surface>
struct Streamline : Surface_path<Surface>
{
  bool has_arrived = false; ///< whether it ends at a target mass
};

/// \ingroup PkgGeodesicProcessingTransport
///
/// Traces the streamlines of the flow that a solver computed: the trajectory of each particle of
/// mass from its source to its target. The velocity is the flow divided by the density of the
/// mass. A tracer is returned by `Transport_solution::streamlines()`. \cgalCite{cgal:dm-pdejd-90}
///
/// On a mesh, masses are spread over the faces incident to their vertices, and the flow that leaves
/// a face enters the adjacent one. Hence streamlines do not cross, and the map from sources to
/// targets preserves mass. On a cloud, the flow moves along graph edges. Streamlines begin and end
/// at point masses if the masses are points.
///
/// The streamlines of an optimal flow are shortest paths. The traced lines zigzag with the edges,
/// and are therefore shortened. The potential gives a lower bound of their length. If a shortened
/// line on a mesh is more than one percent longer than this bound, `Geodesic_path_finder` computes
/// a path between its ends. The shorter of the two is returned.
///
/// A tracer can be used by several threads, and does not depend on the solver.
///
/// \tparam Surface as for `geodesic_distances()`, not a domain
template <typename Surface>
class Streamline_tracer
{
public:
  using Domain = internal::Domain_of<Surface>;
  using Location = typename Domain::Location;

#ifndef DOXYGEN_RUNNING
  Streamline_tracer(const Domain& domain, const internal::Multilevel_transport_solver& solver,
                    const internal::Transport_result& found, bool do_straighten)
      : m_domain(domain), m_triangles(solver.open_triangles()),
        m_streamlines(std::make_shared<const internal::Streamlines>(solver.streamlines(found))),
        m_potential(std::make_shared<const internal::Vector>(found.potential)),
        m_do_straighten(do_straighten && solver.has_surface_metric())
  {}
#endif

  /// Traces the streamline from a vertex, surfel or location to the target of the mass there. If
  /// there is no mass, the line follows the flow to its end.
  /// \tparam Vertex_or_location a vertex, a surfel or a location
  /// \param location a vertex, a surfel or a location
  /// \returns the streamline
  /// \throws Invalid_argument_error if the location is not on the surface
  ///
  /// O(number of crossed faces or surfels).
  template <typename Vertex_or_location>
  Streamline<Surface> operator()(const Vertex_or_location& location) const
  {
    internal::Line_shortener shortener(m_triangles);
    return line({internal::location(m_domain, location)}, shortener);
  }

  /// Writes `number` streamlines, each for an equal fraction of the mass that is moved, the first
  /// distribution of the query. On a mesh they begin at locations that are distributed over this
  /// mass. The line of a mass that is at its target already has one point and the length zero.
  /// Each takes O(number of crossed faces or surfels) time. If there is no mass, nothing is
  /// written.
  /// \tparam OutputIterator a model of `OutputIterator` for `Streamline<Surface>`
  /// \param number the number of streamlines
  /// \param out receives the streamlines
  /// \returns the output iterator past the last streamline
  template <typename OutputIterator>
  OutputIterator operator()(std::size_t number, OutputIterator out) const
  {
    internal::Line_shortener shortener(m_triangles);
    for(const internal::Streamline_seed& seed : m_streamlines->seeds(number))
      *out++ = line(seed, shortener);
    return out;
  }

  /// Returns the target of the mass at a location: the end of its streamline. The line is not
  /// shortened. Takes O(number of crossed faces or surfels) time.
  /// \tparam Vertex_or_location a vertex, a surfel or a location
  /// \param location a vertex, a surfel or a location
  /// \throws Invalid_argument_error if the location is not on the surface
  template <typename Vertex_or_location>
  Location destination(const Vertex_or_location& location) const
  {
    return m_domain.outer(
        (*m_streamlines)({internal::location(m_domain, location)}).locations.back());
  }

  /// Writes an assignment of sources to targets: a pair of locations for each of `number` equal
  /// fractions of the mass that is moved. Each takes the time of `destination()`.
  /// \tparam OutputIterator a model of `OutputIterator` for pairs of locations
  /// \param number the number of pairs
  /// \param out receives the pairs
  /// \returns the output iterator past the last pair
  template <typename OutputIterator>
  OutputIterator assignment(std::size_t number, OutputIterator out) const
  {
    for(const internal::Streamline_seed& seed : m_streamlines->seeds(number))
    {
      const internal::Streamline streamline = (*m_streamlines)(seed);
      *out++ = std::pair<Location, Location>(m_domain.outer(streamline.locations.front()),
                                             m_domain.outer(streamline.locations.back()));
    }
    return out;
  }

private:
  double potential(const internal::Surface_location& location) const
  {
    if(location.triangle == internal::none)
      return (*m_potential)[location.vertex];
    double result = 0.;
    for(std::size_t k = 0; k < 3; ++k)
      result += location.barycentric[k] *
                (*m_potential)[m_triangles->corner[3 * std::size_t(location.triangle) + k]];
    return result;
  }

  Streamline<Surface> line(const internal::Streamline_seed& seed,
                           internal::Line_shortener& shortener) const
  {
    const internal::Streamline streamline = (*m_streamlines)(seed);
    const double potential_difference =
        potential(streamline.locations.back()) - potential(streamline.locations.front());
    Streamline<Surface> result{internal::surface_path(
        m_domain,
        m_do_straighten ? shortener(streamline.locations, potential_difference / m_triangles->scale)
                        : streamline.locations,
        potential_difference)};
    result.has_arrived = streamline.has_arrived;
    return result;
  }

  Domain m_domain;
  std::shared_ptr<const internal::Surface_arrays> m_triangles; // twins removed along obstacles
  std::shared_ptr<const internal::Streamlines> m_streamlines;
  std::shared_ptr<const internal::Vector> m_potential;
  bool m_do_straighten;
};

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_STREAMLINE_TRACER_H
