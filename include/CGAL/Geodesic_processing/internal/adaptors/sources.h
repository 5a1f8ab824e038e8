// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SOURCES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SOURCES_H

#include <CGAL/Geodesic_processing/Source.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/Glued_triangles.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include <cmath>
#include <type_traits>
#include <variant>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A site, or a location, as the kernels know it.
template <typename Domain, typename Place>
Location location(const Domain& domain, const Place& place)
{
  if constexpr(std::is_same_v<Place, typename Domain::Location>)
    return domain.inner(place);
  else
    return domain.inner_site(place);
}

template <typename Domain, typename T>
inline constexpr bool is_place = std::is_same_v<T, typename Domain::Location> ||
                                 std::is_same_v<T, typename Domain::Site> ||
                                 (std::is_integral_v<T> &&
                                  std::is_convertible_v<T, typename Domain::Site>);

// A site, a location, or a range of one of them.
template <typename Domain, typename Places>
std::vector<Location> locations(const Domain& domain, const Places& places)
{
  std::vector<Location> result;
  if constexpr(is_place<Domain, Places>)
    result.push_back(location(domain, places));
  else
    for(const auto& place : places)
      result.push_back(location(domain, place));
  return result;
}

// A source as the kernels know it, with lengths in the domain's scale.
template <typename Domain>
internal::Source source(const Domain& domain,
                        const Geodesic_processing::Source<typename Domain::Surface>& from,
                        std::size_t position)
{
  using Site = typename Domain::Site;
  internal::Source result;
  if(!std::isfinite(from.offset()))
    throw Invalid_argument_error("The offset of a source is not finite.");
  result.offset = from.offset() / domain.triangles()->scale;
  result.label = static_cast<Index>(position);
  if(const Site* site = std::get_if<Site>(&from.place()))
    result.polyline.push_back(domain.inner_site(*site));
  else
    for(const auto& place : std::get<1>(from.place()))
      result.polyline.push_back(domain.inner(place));
  if(result.polyline.empty())
    throw Invalid_argument_error("A source is an empty polyline.");
  for(std::size_t i = 1; i < result.polyline.size(); ++i)
    if(common_triangle(*domain.triangles(), result.polyline[i - 1], result.polyline[i]) == none)
      throw Invalid_argument_error(
          "Two consecutive locations of a source lie in no common triangle.");
  return result;
}

// A site, a location, a source, or a range of one of them; labels receives one label for each.
template <typename Domain, typename Sources>
std::vector<internal::Source> sources(const Domain& domain, const Sources& from,
                                      std::vector<std::size_t>& labels)
{
  using Source = Geodesic_processing::Source<typename Domain::Surface>;
  std::vector<internal::Source> result;
  const auto add = [&](const Source& one)
  {
    const std::size_t position = labels.size();
    result.push_back(source(domain, one, position));
    labels.push_back(one.label(position));
  };
  if constexpr(is_place<Domain, Sources> || std::is_same_v<Sources, Source>)
    add(Source(from));
  else
    for(const auto& one : from)
      add(Source(one));
  if(result.empty())
    throw Invalid_argument_error("There is no source.");
  return result;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SOURCES_H
