// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_VIEW_SURFACE_QUERIES_H
#define GEODESIC_VIEW_SURFACE_QUERIES_H

#include "view/Queries.h"

#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>
#include <CGAL/Geodesic_processing/Geodesic_path_finder.h>
#include <CGAL/Geodesic_processing/decal.h>
#include <CGAL/Geodesic_processing/farthest_point_sampling.h>
#include <CGAL/Geodesic_processing/geodesic_voronoi_diagram.h>

#include <iterator>
#include <map>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace view {

namespace GP = CGAL::Geodesic_processing;

using program::Cloud;
using program::Kernel;
using program::Mesh;

// The page chooses the method at run time.
using GP::Distance_method;
using GP::Runtime_method;

// Returns the method of a name. Throws Invalid_argument_error if it is unknown.
inline Distance_method to_method(const std::string& name)
{
  static const std::map<std::string, Distance_method> methods = {
      {"exact", Distance_method::exact},
      {"euclidean", Distance_method::euclidean_front},
      {"fast-marching", Distance_method::fast_marching},
      {"dijkstra", Distance_method::dijkstra},
      {"heat", Distance_method::heat}};
  const auto found = methods.find(name);
  if(found == methods.end())
    throw GP::Invalid_argument_error("There is no method " + name + ".");
  return found->second;
}

// A readable property map of numbers at vertices or surfels.
template <typename Key>
struct Value_map
{
  using key_type = Key;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;

  const std::vector<double>* values;
  friend double get(const Value_map& map, const Key& key)
  {
    return (*map.values)[std::size_t(key)];
  }
};

// A writable property map at vertices or surfels. Values are converted to elements of an array.
template <typename Key, typename Value, typename Element>
struct Output_map
{
  using key_type = Key;
  using value_type = Value;
  using reference = Value;
  using category = boost::writable_property_map_tag;

  std::vector<Element>* elements;
  friend void put(const Output_map& map, const Key& key, const Value& value)
  {
    (*map.elements)[std::size_t(key)] = static_cast<Element>(value);
  }
};

template <typename Points>
std::vector<Point> coordinates_of(const Points& points)
{
  std::vector<Point> result;
  result.reserve(points.size());
  for(const auto& p : points)
    result.push_back(program::coordinates(p));
  return result;
}

// The queries of a mesh or a cloud, as far as they do not differ.
//
// Domain  Mesh_domain<Mesh> or Surfel_domain<Cloud>
template <typename Domain>
class Surface_queries : public Queries
{
public:
  using Surface = typename Domain::Surface;
  using Vertex = typename Domain::Vertex;
  using Location = typename Domain::Location;
  static constexpr bool is_mesh = std::is_same_v<Surface, Mesh>;

  Surface_queries(const program::Surface& surface, Domain domain)
      : m_domain(std::move(domain)), m_number_of_vertices(surface.file.points.size())
  {}

  std::vector<double> distances(const std::vector<Place>& sources, const std::string& method,
                                double limit, const Callback& callback) override
  {
    const Distance_method kind = to_method(method);
    if(!is_mesh && kind == Distance_method::exact)
      throw GP::Unsupported_surface_error("The method exact needs a mesh.");
    Solver& solver =
        m_solvers.try_emplace(kind, m_domain, GP::parameters::method(kind)).first->second;
    solver.compute(positions(sources), GP::parameters::maximum_distance(limit).callback(callback));
    std::vector<double> result(m_number_of_vertices);
    solver.write_distances(Output_map<Vertex, double, double>{&result});
    return result;
  }

  Samples samples(std::size_t number, const Callback& callback) const override
  {
    Samples result;
    std::vector<Location> locations;
    GP::farthest_point_sampling(
        m_domain, number, std::back_inserter(locations),
        GP::parameters::covering_radius_output(std::back_inserter(result.radii))
            .callback(callback));
    for(const Location& location : locations)
    {
      result.points.push_back(program::coordinates(m_domain.point(location)));
      result.places.push_back(place(location));
    }
    return result;
  }

  Decal decal(const Place& center, const Point& up, double width, double height) override
  {
    if(!m_placer)
      m_placer.emplace(m_domain);
    const auto np = GP::parameters::up_direction(Kernel::Vector_3(up[0], up[1], up[2]));
    const auto placed = std::visit([&](const auto& position)
                                   { return m_placer->place(position, width, height, np); },
                                   this->position(center));
    Decal result;
    if constexpr(is_mesh)
      for(const auto& [face, coordinates] : placed.faces)
      {
        result.faces.push_back(static_cast<std::uint32_t>(face));
        result.corner_uv.insert(result.corner_uv.end(), coordinates.begin(), coordinates.end());
      }
    for(const auto& [covered, coordinates] : placed.vertices)
    {
      result.vertices.push_back(static_cast<std::uint32_t>(covered));
      result.vertex_uv.push_back(coordinates);
    }
    return result;
  }

protected:
  using Position = std::variant<Vertex, Location>;
  using Solver = GP::Geodesic_distance_solver<Surface, Runtime_method>;

  static Vertex vertex(std::size_t i)
  {
    if constexpr(is_mesh)
      return Vertex(static_cast<typename Mesh::size_type>(i));
    else
      return Vertex(i);
  }
  // Throws Invalid_argument_error if the surface does not have the vertex.
  Position position(const Place& place) const
  {
    if constexpr(is_mesh)
      if(place.is_in_face)
        return Location{Mesh::Face_index(static_cast<Mesh::size_type>(place.element)),
                        place.weights};
    if(place.element >= m_number_of_vertices)
      throw GP::Invalid_argument_error("A vertex does not exist.");
    return vertex(place.element);
  }
  std::vector<GP::Source<Surface>> positions(const std::vector<Place>& places) const
  {
    std::vector<GP::Source<Surface>> result;
    for(const Place& place : places)
      std::visit([&](const auto& position) { result.emplace_back(position); }, position(place));
    return result;
  }

  // Returns the nearest seed of each vertex or surfel.
  std::vector<std::uint32_t> labels(const std::vector<GP::Source<Surface>>& seeds,
                                    const Callback& callback) const
  {
    std::vector<std::uint32_t> result(m_number_of_vertices, no_label);
    // The largest std::size_t means that there is no label. It becomes no_label.
    GP::geodesic_voronoi_diagram(m_domain, seeds,
                                 Output_map<Vertex, std::size_t, std::uint32_t>{&result},
                                 GP::parameters::callback(callback));
    return result;
  }

  template <typename Finder>
  Path find_path(Finder& finder, const Place& from, const Place& to, bool is_shortest) const
  {
    const auto search = [&](const auto& a, const auto& b)
    { return is_shortest ? finder(a, b) : finder.locally_shortest_path(a, b); };
    const auto found = std::visit(search, position(from), position(to));
    return {coordinates_of(found.points), found.length};
  }

  const Domain& domain() const { return m_domain; }
  std::size_t number_of_vertices() const { return m_number_of_vertices; }

private:
  static Place place(const Location& location)
  {
    if constexpr(is_mesh)
      return {std::size_t(location.first), true, location.second};
    else
      return {std::size_t(location.surfel)};
  }

  Domain m_domain;
  std::size_t m_number_of_vertices;
  std::map<Distance_method, Solver> m_solvers;
  std::optional<GP::Decal_placer<Surface>> m_placer;
};

} // namespace view

#endif // GEODESIC_VIEW_SURFACE_QUERIES_H
