// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_STREAMLINE_TRACER_H
#define CGAL_GEODESIC_PROCESSING_STREAMLINE_TRACER_H

#include <CGAL/Geodesic_processing/Surface_path.h>
#include <CGAL/Geodesic_processing/internal/transport/Earth_movers.h>
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
  Streamline_tracer(const Domain& domain, const internal::Earth_movers& kernel,
                    const internal::Earth_movers_result& found, bool do_straighten)
      : m_domain(domain), m_triangles(kernel.open_triangles()),
        m_lines(std::make_shared<const internal::Streamlines>(kernel.streamlines(found))),
        m_potential(std::make_shared<const internal::Vector>(found.potential)),
        m_do_straighten(do_straighten && kernel.has_own_lengths())
  {}
#endif

  /// returns the line from a site or a location to where a grain of mass goes from there; from where none
  /// is, as far as the flow goes.
  /// \throws Invalid_argument_error when the place is none of the surface's
  ///
  /// O(number of faces, or surfels, passed).
  template <typename Place>
  Streamline<Surface> operator()(const Place& place) const
  {
    internal::Line_shortener shorten(m_triangles);
    return line({internal::location(m_domain, place)}, shorten);
  }

  /// writes lines that stand for equal parts of all the mass that moves: on a mesh they begin at places
  /// that are spread over it.
  template <typename OutputIterator>
  OutputIterator operator()(std::size_t number, OutputIterator out) const
  {
    internal::Line_shortener shorten(m_triangles);
    for(const internal::Grain& grain : m_lines->grains(number))
      *out++ = line(grain, shorten);
    return out;
  }

  /// returns where a grain of mass goes: the end of its line, without pulling that taut.
  template <typename Place>
  Location destination(const Place& place) const
  {
    return m_domain.outer((*m_lines)({internal::location(m_domain, place)}).locations.back());
  }

  /// writes an assignment: for equal parts of all the mass a pair of locations, where it was and where it
  /// will be.
  template <typename OutputIterator>
  OutputIterator assignment(std::size_t number, OutputIterator out) const
  {
    for(const internal::Grain& grain : m_lines->grains(number))
    {
      const internal::Streamline traced = (*m_lines)(grain);
      *out++ = std::pair<Location, Location>(m_domain.outer(traced.locations.front()),
                                             m_domain.outer(traced.locations.back()));
    }
    return out;
  }

private:
  double potential(const internal::Location& location) const
  {
    if(location.triangle == internal::none)
      return (*m_potential)[location.site];
    double result = 0.;
    for(std::size_t k = 0; k < 3; ++k)
      result += location.barycentric[k] *
                (*m_potential)[m_triangles->corner[3 * std::size_t(location.triangle) + k]];
    return result;
  }

  Streamline<Surface> line(const internal::Grain& grain, internal::Line_shortener& shorten) const
  {
    const internal::Streamline traced = (*m_lines)(grain);
    const double growth = potential(traced.locations.back()) - potential(traced.locations.front());
    Streamline<Surface> result{internal::surface_path(
        m_domain,
        m_do_straighten ? shorten(traced.locations, growth / m_triangles->scale) : traced.locations,
        growth)};
    result.has_arrived = traced.has_arrived;
    return result;
  }

  Domain m_domain;
  std::shared_ptr<const internal::Glued_triangles> m_triangles; // where nothing is closed
  std::shared_ptr<const internal::Streamlines> m_lines;
  std::shared_ptr<const internal::Vector> m_potential;
  bool m_do_straighten;
};

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_STREAMLINE_TRACER_H
