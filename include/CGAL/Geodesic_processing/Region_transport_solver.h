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

// Creates an exit for each source of the region, from its vertices or, if it has other locations,
// from its polyline. Reads `capacities` and `spreading_weight`. Throws Invalid_argument_error
// as sources().
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
/// Computes the minimum cost of moving mass distributions to one region, for example the exits of
/// a building, or a curve.
///
/// The distribution of arriving masses is a variable: each mass takes a shortest path to the
/// region. The region consists of vertices or surfels, and of the edges and faces between them.
/// It can also contain curves and locations inside faces, or on a cloud between surfels. Moving
/// within the region costs nothing.
///
/// Faces that a curve crosses are split along the curve, so that mass arrives inside a face as
/// easily as at a vertex. Arrivals inside a face are distributed to its vertices by barycentric
/// coordinates. On a cloud this is done in one local triangle at the location. Consecutive
/// locations of a curve on a cloud must be in a common local triangle. For longer curves, pass a
/// range of locations.
///
/// The potential is zero in the region. Elsewhere its absolute value is a lower bound of the
/// distance to the region. At each vertex that mass starts from or passes, this bound is close to
/// the distance. The bounds of the cost are certified as in `Earth_movers_solver`.
/// \cgalCite{cgal:srgb-emd-14}, section 6.3
///
/// Each source of the region is an exit. Exits can have capacities, and a price for the density
/// of arriving mass spreads the arrivals. With such limits moving between exits has a cost. The
/// potential is then minus the marginal cost, the cost of one more unit of mass. At exits without
/// price it is zero if capacity is left. At full exits it is negative, by the amount that one
/// more unit of capacity saves.
///
/// Members that do not state their time take O(1) time.
///
/// \tparam Surface as for `geodesic_distances()`, not a domain
template <typename Surface>
class Region_transport_solver : public Transport_solution<Surface>
{
  using Base = Transport_solution<Surface>;

public:
  using typename Base::Domain;
  using typename Base::Vertex;

  /// Embeds the curves of the region and factorizes as `Earth_movers_solver`, which takes most of
  /// the time.
  ///
  /// \tparam Region a vertex, a surfel, a location, a `Source`, or a range of one of these
  /// \param surface the surface, as for `geodesic_distances()`
  /// \param region a vertex or surfel, a location, a `Source`, or a range of one of these
  /// \param np named parameters of `Earth_movers_solver`, and the following
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{capacities}
  ///     \cgalParamDescription{the maximum mass that can arrive at each source of the region:
  ///       positive, infinite for no limit}
  ///     \cgalParamType{a range of `double`}
  ///     \cgalParamDefault{no limits}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{spreading_weight}
  ///     \cgalParamDescription{a weight: the integral of the squared density of arriving mass,
  ///       times this weight, is added to the cost. The area of a source is a third of the area of
  ///       the faces incident to its vertices}
  ///     \cgalParamType{`double`}
  ///     \cgalParamDefault{0}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws as `Earth_movers_solver`
  /// \throws Invalid_argument_error if the region is empty, if a location is not on the surface,
  ///         or if two consecutive locations of a source have no common triangle
  /// \throws Invalid_argument_error if the number of capacities is not the number of sources, if
  ///         a capacity is not positive, or if two sources with limits share a vertex
  template <typename Region, typename NamedParameters = internal::Default_parameters>
  Region_transport_solver(const Surface& surface, const Region& region,
                          const NamedParameters& np = NamedParameters())
      : Region_transport_solver(Domain(surface, np), region, np)
  {}
  /// Uses an existing `domain`, which is shared. The time, `Region`, `region` and `np` are as for a
  /// surface.
  /// \throws as for a surface, except for the exceptions of `make_domain()`
  template <typename Region, typename NamedParameters = internal::Default_parameters>
  Region_transport_solver(const Domain& domain, const Region& region,
                          const NamedParameters& np = NamedParameters())
      : Base(domain, np, internal::transport_region(domain, region, np))
  {}

  /// Computes the minimum cost of moving masses to the region, and replaces the result of the
  /// last call.
  ///
  /// \tparam Method as for `Earth_movers_solver::compute()`; only `Interior_point` if there are
  ///   limits
  /// \tparam From a mass distribution as accepted by `Earth_movers_solver`
  /// \param from a mass distribution as accepted by `Earth_movers_solver`
  /// \param np named parameters of `Earth_movers_solver::compute()`
  /// \pre Property maps have a value for each of their keys.
  /// \returns the cost with certified bounds
  /// \throws Invalid_argument_error as `Earth_movers_solver::compute()`
  /// \throws Invalid_argument_error if a component with mass has no source of the region, or if
  ///         the capacity of its sources is too small
  /// \throws Cancelled if the callback returns false
  ///
  /// Takes 10 to 25 iterations of O(n<SUP>1.5</SUP>) each.
  template <typename Method = Interior_point, typename From,
            typename NamedParameters = internal::Default_parameters>
  Earth_movers_cost compute(const From& from, const NamedParameters& np = NamedParameters())
  {
    return compute(internal::transport_method<Method>(), from, np);
  }
#ifndef DOXYGEN_RUNNING
  template <typename From, typename NamedParameters>
  Earth_movers_cost compute(internal::Transport_method method, const From& from,
                            const NamedParameters& np)
  {
    const auto options = this->options(method, np);
    this->m_result =
        this->m_kernel->solve_to_region(internal::masses(this->m_domain, from), options);
    return this->cost();
  }
#endif

  /// Returns whether a path leads from a vertex or surfel to the region.
  /// \param vertex a vertex or surfel of the surface
  bool is_reachable(Vertex vertex) const
  {
    return this->m_kernel->is_region_reachable()[this->m_domain.index(vertex)];
  }

  /// Returns the mass that arrives at a vertex or surfel, which is not negative; zero outside of
  /// the region. Mass that arrives on an edge of the region is divided between its endpoints.
  /// \param vertex a vertex or surfel of the surface
  /// \throws Invalid_argument_error if there was no query
  double arrival(Vertex vertex) const
  {
    return this->last_result().arrivals[this->m_domain.index(vertex)];
  }

  /// Writes the mass that arrives at each vertex or surfel, a `double`, to a property map. O(n).
  /// \tparam ArrivalMap a model of `WritablePropertyMap` with vertices or surfels as keys
  /// \param map receives the arriving masses
  /// \throws Invalid_argument_error if there was no query
  template <typename ArrivalMap>
  void write_arrivals(ArrivalMap map) const
  {
    const internal::Vector& arrivals = this->last_result().arrivals;
    this->m_domain.write([&](internal::Index i) { return arrivals[i]; }, map);
  }
};

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_REGION_TRANSPORT_SOLVER_H
