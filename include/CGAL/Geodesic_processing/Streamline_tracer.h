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
/// a way along which a flow moves mass.  Its `front_distance` is by how much the potential grows: no path
/// between its ends is shorter.
template <typename Surface>
struct Streamline : Surface_path<Surface>
{
  bool has_arrived = false; ///< whether mass is missing where it ends
};

/// \ingroup PkgGeodesicProcessingTransport
///
/// follows the flow that a solver found: each grain of mass from where it was to where it will be, at the speed
/// that flow over mass is.  Made by `Transport_solution::streamlines()`.  \cgalCite{cgal:dm-pdejd-90}
///
/// On a mesh masses are spread over the faces around their vertices, and what leaves a face enters the next
/// one, so that lines do not cross, and as many arrive as there is mass.  On a cloud the flow goes along arcs.
/// They begin and end where masses are points.
///
/// Lines of the best flow are shortest paths; those that are traced zigzag with the edges, and are pulled
/// taut.  On a mesh one that is more than a percent longer than the potential proves gives way to the path that
/// `Geodesic_path_finder` finds between its ends, if that is shorter.
///
/// It may be used in several threads, and does not depend on the solver any more.
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

  /// returns the line from a site or a location to where a grain of mass goes from there; from where none
  /// is, as far as the flow goes.
  /// \throws Invalid_argument_error when the place is none of the surface's
  ///
  /// O(number of faces, or surfels, passed).
  template <typename Vertex_or_location>
  Streamline<Surface> operator()(const Vertex_or_location& location) const
  {
    internal::Line_shortener shortener(m_triangles);
    return line({internal::location(m_domain, location)}, shortener);
  }

  /// writes lines that stand for equal parts of all the mass that moves: on a mesh they begin at places
  /// that are spread over it.
  template <typename OutputIterator>
  OutputIterator operator()(std::size_t number, OutputIterator out) const
  {
    internal::Line_shortener shortener(m_triangles);
    for(const internal::Streamline_seed& seed : m_streamlines->seeds(number))
      *out++ = line(seed, shortener);
    return out;
  }

  /// returns where a grain of mass goes: the end of its line, without pulling that taut.
  template <typename Vertex_or_location>
  Location destination(const Vertex_or_location& location) const
  {
    return m_domain.outer(
        (*m_streamlines)({internal::location(m_domain, location)}).locations.back());
  }

  /// writes an assignment: for equal parts of all the mass a pair of locations, where it was and where it
  /// will be.
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
  std::shared_ptr<const internal::Surface_arrays> m_triangles; // where nothing is closed
  std::shared_ptr<const internal::Streamlines> m_streamlines;
  std::shared_ptr<const internal::Vector> m_potential;
  bool m_do_straighten;
};

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_STREAMLINE_TRACER_H
