// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_REGION_TRANSPORT_SOLVER_H
#define CGAL_GEODESIC_PROCESSING_REGION_TRANSPORT_SOLVER_H

#include <CGAL/Geodesic_processing/Earth_movers_solver.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/sources.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing {

namespace internal {

// The sites of sources that are made of sites, each once.
template <typename Domain, typename Region>
std::vector<Index> region_sites(const Domain& domain, const Region& region)
{
  std::vector<std::size_t> labels;
  std::vector<Index> result;
  for(const internal::Source& source : sources(domain, region, labels))
    for(const Location& location : source.polyline)
    {
      Index site = location.site;
      for(std::size_t k = 0; k < 3 && location.triangle != none; ++k)
        if(location.barycentric[k] == 1.)
          site = domain.triangles()->corner[3 * location.triangle + k];
      if(site == none)
        throw Invalid_argument_error("A region has a location that is not at a vertex or surfel.");
      result.push_back(site);
    }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingTransport
///
/// finds out what it costs to move masses to wherever in a region it costs the least, for many masses and
/// one region: ways out of a building, the distance from a curve.
///
/// What arrives where is not given: the marginal is free.  A mass that is alone goes the shortest way to
/// the region; masses do not hinder each other.  The region is made of sites, and of the edges and
/// faces between them; between two parts of it moving costs nothing.
///
/// The potential is zero in the region; elsewhere its absolute value is nowhere above the distance to the
/// region, and close to it wherever masses come from or pass.  Bounds are certified as those of
/// `Earth_movers_solver` are.  \cgalCite{cgal:srgb-emd-14}, section 6.3
///
/// \tparam Surface as for `geodesic_distances()`, not a domain
template <typename Surface>
class Region_transport_solver : public Transport_solution<Surface>
{
  using Base = Transport_solution<Surface>;

public:
  using typename Base::Domain;
  using typename Base::Site;

  /// prepares surface and region, as `Earth_movers_solver` does.
  ///
  /// \param region a site, a range of sites, or sources of sites as those of `border_sources()`
  /// \param np as for `Earth_movers_solver`
  /// \throws as `Earth_movers_solver`
  /// \throws Invalid_argument_error when the region is empty, or has a place that is not at a site of
  ///         the surface
  template <typename Region, typename NamedParameters = internal::Default_parameters>
  Region_transport_solver(const Surface& surface, const Region& region,
                          const NamedParameters& np = NamedParameters())
      : Region_transport_solver(Domain(surface, np), region, np)
  {}
  template <typename Region, typename NamedParameters = internal::Default_parameters>
  Region_transport_solver(const Domain& domain, const Region& region,
                          const NamedParameters& np = NamedParameters())
      : Base(domain, np, internal::region_sites(domain, region))
  {}

  /// finds out what it costs to move masses to the region; what the last call found is forgotten.
  ///
  /// \tparam Method as for `Earth_movers_solver::compute()`
  /// \param from masses, as `Earth_movers_solver` takes them
  /// \param np as for `Earth_movers_solver::compute()`
  /// \throws Invalid_argument_error as `Earth_movers_solver::compute()`, and when masses are on a
  ///         component that has no part of the region
  template <typename Method = Interior_point, typename From,
            typename NamedParameters = internal::Default_parameters>
  Earth_movers_cost compute(const From& from, const NamedParameters& np = NamedParameters())
  {
    const auto options = this->template options<Method>(np);
    this->m_result =
        this->m_kernel->solve_to_region(internal::masses(this->m_domain, from), options);
    return this->cost();
  }

  /// returns whether a way leads from a site to the region.
  bool is_reachable(Site site) const
  {
    return this->m_kernel->reaches_region()[this->m_domain.index(site)];
  }

  /// returns the mass that arrived at a site, zero outside the region.
  double arrival(Site site) const { return this->m_result.arrivals[this->m_domain.index(site)]; }

  /// writes the mass that arrived at each site.
  template <typename ArrivalMap>
  void write_arrivals(ArrivalMap map) const
  {
    this->m_domain.write([&](internal::Index i) { return this->m_result.arrivals[i]; }, map);
  }
};

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_REGION_TRANSPORT_SOLVER_H
