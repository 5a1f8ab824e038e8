// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_READ_SURFELS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_READ_SURFELS_H

#include <CGAL/Geodesic_processing/Location.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/Glued_triangles.h>
#include <CGAL/Geodesic_processing/internal/core/spatial.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

template <typename SurfelRange>
inline constexpr bool is_point_set =
    !std::is_same_v<typename Surface_traits<SurfelRange>::Site, std::size_t>;

// The descriptors of a range's surfels, and their places in it.
template <typename SurfelRange>
class Surfel_sites
{
public:
  using Site = typename Surface_traits<SurfelRange>::Site;

  Surfel_sites() = default;
  explicit Surfel_sites(const SurfelRange& range)
  {
    for(const auto& element : range)
      if constexpr(is_point_set<SurfelRange>)
      {
        const std::size_t index = element;
        if(index >= m_place_of_index.size())
          m_place_of_index.resize(index + 1, none);
        m_place_of_index[index] = static_cast<Index>(m_sites.size());
        m_sites.push_back(element);
      }
      else
      {
        (void)element;
        m_sites.push_back(m_sites.size());
      }
  }

  std::size_t size() const { return m_sites.size(); }
  Site operator[](std::size_t place) const { return m_sites[place]; }
  std::size_t place(Site site) const
  {
    if constexpr(is_point_set<SurfelRange>)
      return m_place_of_index[site];
    else
      return site;
  }
  // Throws Invalid_argument_error when there is no such surfel.
  void check(Site site) const
  {
    bool is_ours = std::size_t(site) < m_sites.size();
    if constexpr(is_point_set<SurfelRange>)
      is_ours = std::size_t(site) < m_place_of_index.size() && m_place_of_index[site] != none;
    if(!is_ours)
      throw Invalid_argument_error("A surfel is none of the cloud's.");
  }

private:
  std::vector<Site> m_sites;           // #surfels, in the order of the range
  std::vector<Index> m_place_of_index; // of Point_set_3: the place of an index in it
};

struct Surfel_arrays
{
  std::vector<Spatial> points, normals; // #surfels
  std::vector<double> radii;            // #surfels, or empty
};

// The surfels of a range, by the maps of named parameters or its own.
// Throws Unsupported_surface_error when there are no normals.
template <typename SurfelRange, typename NamedParameters>
Surfel_arrays read_surfels(const SurfelRange& range, const NamedParameters& np)
{
  Surfel_arrays result;
  const auto coordinates = [](const auto& p) -> Spatial {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  };
  const auto read = [&](const auto& point_map, const auto& normal_map)
  {
    constexpr bool has_radii = has_parameter<NamedParameters, internal_np::radius_map_t>;
    [[maybe_unused]] const auto radius_map = parameter(np, internal_np::radius_map, 0);
    for(const auto& element : range)
    {
      result.points.push_back(coordinates(get(point_map, element)));
      result.normals.push_back(coordinates(get(normal_map, element)));
      if constexpr(has_radii)
        result.radii.push_back(get(radius_map, element));
    }
  };
  constexpr bool has_normals = has_parameter<NamedParameters, CGAL::internal_np::normal_t>;
  if constexpr(is_point_set<SurfelRange>)
  {
    if constexpr(!has_normals)
      if(!range.has_normal_map())
        throw Unsupported_surface_error("The point set has no normals: estimate them first, for "
                                        "instance by CGAL::jet_estimate_normals().");
    const auto point_map = parameter(np, CGAL::internal_np::point_map, range.point_map());
    if constexpr(has_normals)
      read(point_map, CGAL::parameters::get_parameter(plain(np), CGAL::internal_np::normal_map));
    else
      read(point_map, range.normal_map());
  }
  else
  {
    static_assert(has_normals,
                  "A range of surfels needs a normal_map; the points of a mesh need the "
                  "mesh, not its range of points.");
    using Element = std::decay_t<decltype(*range.begin())>;
    read(parameter(np, CGAL::internal_np::point_map, CGAL::Identity_property_map<Element>()),
         CGAL::parameters::get_parameter(plain(np), CGAL::internal_np::normal_map));
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_READ_SURFELS_H
