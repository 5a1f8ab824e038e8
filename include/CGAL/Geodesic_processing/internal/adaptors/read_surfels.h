// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_READ_SURFELS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_READ_SURFELS_H

#include <CGAL/Geodesic_processing/Location.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/Index.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include <CGAL/Geodesic_processing/internal/mesh/morton_order.h>
#include <CGAL/Geodesic_processing/parameters.h>

#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Whether the surfels of a range are identified by indices of a Point_set_3; otherwise by their
// positions in the range.
template <typename SurfelRange>
inline constexpr bool is_point_set =
    !std::is_same_v<typename Surface_traits<SurfelRange>::Vertex, std::size_t>;

// The descriptors of the surfels of a range, and their positions in it.
template <typename SurfelRange>
class Surfel_descriptors
{
public:
  using Vertex = typename Surface_traits<SurfelRange>::Vertex;

  Surfel_descriptors() = default;
  explicit Surfel_descriptors(const SurfelRange& range)
      : m_size(std::size_t(std::distance(range.begin(), range.end())))
  {
    if constexpr(is_point_set<SurfelRange>)
    {
      m_descriptors.reserve(m_size);
      m_position_of_index.reserve(m_size);
      for(const auto& element : range)
      {
        const std::size_t index = element;
        if(index >= m_position_of_index.size())
          m_position_of_index.resize(index + 1, none);
        m_position_of_index[index] = static_cast<Index>(m_descriptors.size());
        m_descriptors.push_back(element);
      }
    }
  }

  std::size_t size() const { return m_size; }
  Vertex operator[](std::size_t position) const
  {
    if constexpr(is_point_set<SurfelRange>)
      return m_descriptors[position];
    else
      return position;
  }
  std::size_t position(Vertex descriptor) const
  {
    if constexpr(is_point_set<SurfelRange>)
      return m_position_of_index[descriptor];
    else
      return descriptor;
  }
  // Throws Invalid_argument_error if the range has no such surfel.
  void check_descriptor(Vertex descriptor) const
  {
    bool is_of_range = std::size_t(descriptor) < m_size;
    if constexpr(is_point_set<SurfelRange>)
      is_of_range = std::size_t(descriptor) < m_position_of_index.size() &&
                    m_position_of_index[descriptor] != none;
    if(!is_of_range)
      throw Invalid_argument_error("A surfel is not in the cloud.");
  }

private:
  std::size_t m_size = 0;
  // Of a Point_set_3: the index of each position in the range, and the position of each index.
  std::vector<Vertex> m_descriptors;
  std::vector<Index> m_position_of_index;
};

struct Surfel_input
{
  std::vector<Vec3> points, normals; // #surfels
  std::vector<double> radii;         // #surfels, or empty
};

// Surfels with unit normals whose points are relative to the origin of a frame; see Surfel_options.
struct Framed_surfels
{
  Surfel_input input;
  Frame frame;
};

// Reads the surfels of a range by the property maps of named parameters, by default those of the
// range. Throws Unsupported_surface_error if there are no normals.
template <typename SurfelRange, typename NamedParameters>
Surfel_input read_surfels(const SurfelRange& range, const NamedParameters& np)
{
  Surfel_input result;
  const auto coordinates = [](const auto& p) -> Vec3 {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  };
  const auto read = [&](const auto& point_map, const auto& normal_map)
  {
    constexpr bool has_radii = has_parameter<NamedParameters, internal_np::radius_map_t>;
    [[maybe_unused]] const auto radius_map = parameter(np, internal_np::radius_map, 0);
    const std::size_t size = std::size_t(std::distance(range.begin(), range.end()));
    result.points.reserve(size);
    result.normals.reserve(size);
    if constexpr(has_radii)
      result.radii.reserve(size);
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
        throw Unsupported_surface_error(
            "The point set has no normals: estimate them by estimate_surfels().");
    const auto point_map = parameter(np, CGAL::internal_np::point_map, range.point_map());
    if constexpr(has_normals)
      read(point_map, CGAL::parameters::get_parameter(plain(np), CGAL::internal_np::normal_map));
    else
      read(point_map, range.normal_map());
  }
  else
  {
    static_assert(has_normals, "A range of surfels requires the named parameter normal_map. "
                               "estimate_surfels() computes normals. If the points are those of a "
                               "mesh, pass the mesh or make_domain(points, polygons) instead.");
    using Element = std::decay_t<decltype(*range.begin())>;
    read(parameter(np, CGAL::internal_np::point_map, CGAL::Identity_property_map<Element>()),
         CGAL::parameters::get_parameter(plain(np), CGAL::internal_np::normal_map));
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_READ_SURFELS_H
