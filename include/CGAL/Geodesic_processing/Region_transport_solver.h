// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_REGION_TRANSPORT_SOLVER_H
#define CGAL_GEODESIC_PROCESSING_REGION_TRANSPORT_SOLVER_H

#include <CGAL/Geodesic_processing/Earth_movers_solver.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing {

namespace internal {

// An exit for each source: sites, or a curve.
template <typename Domain, typename Region, typename NamedParameters>
Transport_region transport_region(const Domain& domain, const Region& region,
                                  const NamedParameters& np)
{
  std::vector<std::size_t> labels;
  Transport_region result;
  for(const internal::Front_source& source : sources(domain, region, labels))
  {
    std::vector<Index> vertices;
    for(const Surface_location& location : source.polyline)
      if(const Index vertex = vertex_of(*domain.triangles(), location); vertex != none)
        vertices.push_back(vertex);
    if(vertices.size() < source.polyline.size())
    {
      vertices.clear();
      result.curves.resize(result.exits.size());
      result.curves.push_back(source.polyline);
    }
    result.exits.push_back(std::move(vertices));
  }
  if(!result.curves.empty())
    result.curves.resize(result.exits.size());
  for(const double capacity : parameter(np, internal_np::capacities, std::vector<double>()))
    result.capacity.push_back(capacity);
  result.spreading_weight = parameter(np, internal_np::spreading_weight, 0.);
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
/// faces between them, and on a mesh also of curves and of locations in faces; between two parts of it
/// moving costs nothing.
///
/// Faces that a curve passes are divided along it, so that it costs no more to be met within a face than
/// at a vertex; what arrives there is told of the face's vertices, in the parts that barycentric
/// coordinates are.
///
/// The potential is zero in the region; elsewhere its absolute value is nowhere above the distance to the
/// region, and close to it wherever masses come from or pass.  Bounds are certified as those of
/// `Earth_movers_solver` are.  \cgalCite{cgal:srgb-emd-14}, section 6.3
///
/// Each source of the region is an exit, and there may be limits: how much goes through each, and a price
/// for crowding that spreads what arrives.  Then moving between exits is not for nothing, the potential
/// tells what it costs one more mass to go: it is zero where the last one went, and below where exits
/// are full, by what more room would save.
///
/// \tparam Surface as for `geodesic_distances()`, not a domain
template <typename Surface>
class Region_transport_solver : public Transport_solution<Surface>
{
  using Base = Transport_solution<Surface>;

public:
  using typename Base::Domain;
  using typename Base::Vertex;

  /// prepares surface and region, as `Earth_movers_solver` does.
  ///
  /// \param region a site, a location, a source, or a range of one of them: see `Source`
  /// \param np as for `Earth_movers_solver`, and
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{capacities}
  ///     \cgalParamDescription{a range of `double`: the mass that may arrive at each source of the
  ///       region, in their order; positive, infinite for no limit}
  ///     \cgalParamDefault{no limits} \cgalParamNEnd
  ///   \cgalParamNBegin{spreading_weight}
  ///     \cgalParamDescription{what the integral of the square of the density of what arrives is
  ///       multiplied with, to be paid as well; the area of a source is that of a third of the faces
  ///       around its sites}
  ///     \cgalParamDefault{0} \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws as `Earth_movers_solver`
  /// \throws Invalid_argument_error when the region is empty, or has a place that is none of the surface's,
  ///         or on a cloud not at a surfel; when there are limits, but not one for each source, one is not
  ///         positive, or two sources share a site
  template <typename Region, typename NamedParameters = internal::Default_parameters>
  Region_transport_solver(const Surface& surface, const Region& region,
                          const NamedParameters& np = NamedParameters())
      : Region_transport_solver(Domain(surface, np), region, np)
  {}
  template <typename Region, typename NamedParameters = internal::Default_parameters>
  Region_transport_solver(const Domain& domain, const Region& region,
                          const NamedParameters& np = NamedParameters())
      : Base(domain, np, internal::transport_region(domain, region, np))
  {}

  /// finds out what it costs to move masses to the region; what the last call found is forgotten.
  ///
  /// \tparam Method as for `Earth_movers_solver::compute()`; with limits `Interior_point`
  /// \param from masses, as `Earth_movers_solver` takes them
  /// \param np as for `Earth_movers_solver::compute()`
  /// \throws Invalid_argument_error as `Earth_movers_solver::compute()`, and when masses are on a
  ///         component that has no part of the region, or exits too small for them
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
  bool is_reachable(Vertex vertex) const
  {
    return this->m_kernel->is_region_reachable()[this->m_domain.index(vertex)];
  }

  /// returns the mass that arrived at a site, zero away from the region.
  double arrival(Vertex vertex) const
  {
    return this->m_result.arrivals[this->m_domain.index(vertex)];
  }

  /// writes the mass that arrived at each site.
  template <typename ArrivalMap>
  void write_arrivals(ArrivalMap map) const
  {
    this->m_domain.write([&](internal::Index i) { return this->m_result.arrivals[i]; }, map);
  }
};

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_REGION_TRANSPORT_SOLVER_H
