// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_SOURCES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_SOURCES_H

#include <CGAL/Geodesic_processing/Source.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include <cmath>
#include <iterator>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The type of the elements of a range. For a type that is not a range, the type itself.
template <typename T, typename = void>
struct Element
{
  using type = T;
};
template <typename T>
struct Element<T, std::void_t<decltype(*std::begin(std::declval<const T&>()))>>
{
  using type = std::decay_t<decltype(*std::begin(std::declval<const T&>()))>;
};
template <typename T>
using Element_of = typename Element<T>::type;

// Whether T is a location of the domain, or converts to a vertex. Numbers that are not integers do
// not count as vertices.
template <typename Domain, typename T>
inline constexpr bool names_location = std::is_same_v<T, typename Domain::Location> ||
                                       (std::is_convertible_v<T, typename Domain::Vertex> &&
                                        !std::is_floating_point_v<T>);

// Does not compile unless `names_location`. In a static_assert, the compiler prints the sentence
// before the errors that follow from it.
template <typename Domain, typename T>
constexpr bool require_location()
{
  static_assert(names_location<Domain, T>,
                "Pass vertices, surfels or locations of this surface. locate_on_surface() returns "
                "the location of a point.");
  return true;
}

// Converts a vertex or location of the caller to an internal location.
template <typename Domain, typename VertexOrLocation>
Surface_location location(const Domain& domain, const VertexOrLocation& element)
{
  static_assert(require_location<Domain, VertexOrLocation>());
  if constexpr(std::is_same_v<VertexOrLocation, typename Domain::Location>)
    return domain.inner(element);
  else
    return domain.inner_vertex(element);
}

// Converts a vertex, a location, or a range of either to internal locations.
template <typename Domain, typename Range>
std::vector<Surface_location> locations(const Domain& domain, const Range& range)
{
  static_assert(require_location<Domain, Element_of<Range>>());
  std::vector<Surface_location> result;
  if constexpr(names_location<Domain, Range>)
    result.push_back(location(domain, range));
  else
    for(const auto& element : range)
      result.push_back(location(domain, element));
  return result;
}

// Converts a source of the caller to a source of a front, in scaled units. The label is
// `position`. Throws Invalid_argument_error if the offset is not finite, if the polyline is empty,
// or if two consecutive locations are in no common triangle.
template <typename Domain>
internal::Front_source source(const Domain& domain,
                              const Geodesic_processing::Source<typename Domain::Surface>& input,
                              std::size_t position)
{
  using Vertex = typename Domain::Vertex;
  internal::Front_source result;
  if(!std::isfinite(input.offset()))
    throw Invalid_argument_error("The offset of a source is not finite.");
  result.offset = input.offset() / domain.triangles()->scale;
  result.label = static_cast<Index>(position);
  if(const Vertex* vertex = std::get_if<Vertex>(&input.location()))
    result.polyline.push_back(domain.inner_vertex(*vertex));
  else
    for(const auto& element : std::get<1>(input.location()))
      result.polyline.push_back(domain.inner(element));
  if(result.polyline.empty())
    throw Invalid_argument_error("A source is an empty polyline.");
  for(std::size_t i = 1; i < result.polyline.size(); ++i)
    if(common_triangle(*domain.triangles(), result.polyline[i - 1], result.polyline[i]) == none)
      throw Invalid_argument_error(
          "Two consecutive locations of a source have no common triangle.");
  return result;
}

// Converts a vertex, a location, a source, or a range of one of them to sources of a front.
// Appends the label of each source to `labels`. Throws Invalid_argument_error if there is no
// source.
template <typename Domain, typename Sources>
std::vector<internal::Front_source> sources(const Domain& domain, const Sources& input,
                                            std::vector<std::size_t>& labels)
{
  using Source = Geodesic_processing::Source<typename Domain::Surface>;
  if constexpr(!std::is_constructible_v<Source, Element_of<Sources>>)
    static_assert(require_location<Domain, Element_of<Sources>>());
  std::vector<internal::Front_source> result;
  const auto add = [&](const Source& item)
  {
    const std::size_t position = labels.size();
    result.push_back(source(domain, item, position));
    labels.push_back(item.label(position));
  };
  if constexpr(names_location<Domain, Sources> || std::is_same_v<Sources, Source>)
    add(Source(input));
  else
    for(const auto& item : input)
      add(Source(item));
  if(result.empty())
    throw Invalid_argument_error("There is no source.");
  return result;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_SOURCES_H
