// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Cloud_surface.h"
#include "python/Mesh_surface.h"
#include "python/Remeshing_arguments.h"

#include <CGAL/Geodesic_processing/geodesic_base_mesh.h>
#include <CGAL/Geodesic_processing/parameterize_over_base.h>
#include <CGAL/Geodesic_processing/semi_regular_remeshing.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace python {

namespace {

GP::Base_coordinates parse_coordinates(const py::object& word)
{
  return choice<GP::Base_coordinates>(word, "coordinates",
                                      {{"heron", GP::Base_coordinates::heron},
                                       {"mean-value", GP::Base_coordinates::mean_value},
                                       {"uniform", GP::Base_coordinates::uniform}});
}

// A location on the surface that consists of the base faces.
Mesh_surface::Location location_of(const GP::Base_location& location)
{
  return {Mesh::Face_index(Mesh::size_type(location.face)), location.barycentric};
}

// Writes the base locations of vertices to arrays of faces and barycentric coordinates.
template <typename Vertex>
struct Base_location_map
{
  using key_type = Vertex;
  using value_type = GP::Base_location;
  using reference = const GP::Base_location&;
  using category = boost::writable_property_map_tag;

  std::int64_t* faces;
  double* coordinates;

  friend void put(const Base_location_map& map, Vertex vertex, const GP::Base_location& location)
  {
    const auto i = std::size_t(vertex);
    map.faces[i] = std::int64_t(location.face);
    std::copy(location.barycentric.begin(), location.barycentric.end(), map.coordinates + 3 * i);
  }
};

// The map between a surface and a base mesh as Python sees it. It is immutable.
template <typename Domain>
class Base_map
{
  using Surface_type = Surface<Domain>;
  using Map = GP::Base_parameterization<typename Surface_type::Input>;

public:
  Base_map(std::shared_ptr<Surface_type> surface, const py::tuple& arguments,
           const py::object& coordinates)
      : m_surface(std::move(surface)), m_vertex_faces(py::ssize_t(m_surface->number_of_points())),
        m_vertex_coordinates(Shape{py::ssize_t(m_surface->number_of_points()), 3})
  {
    const GP::Base_coordinates kind = parse_coordinates(coordinates);
    Remeshing_arguments<Domain> common(*m_surface, arguments);
    // These values remain at vertices without faces.
    std::fill_n(m_vertex_faces.mutable_data(), m_vertex_faces.size(), -1);
    std::fill_n(m_vertex_coordinates.mutable_data(), m_vertex_coordinates.size(),
                std::numeric_limits<double>::quiet_NaN());
    const Base_location_map<typename Surface_type::Vertex> locations{
        m_vertex_faces.mutable_data(), m_vertex_coordinates.mutable_data()};
    common.run(
        [&](const auto& np)
        {
          m_map.emplace(GP::parameterize_over_base(m_surface->domain(), common.number_of_samples(),
                                                   locations, np.base_coordinates(kind)));
          build_base();
        });
  }

  // Returns the base mesh.
  std::shared_ptr<Mesh_surface> base() const { return m_base; }
  // Returns the base location of each vertex of the surface.
  py::tuple vertex_locations() const
  {
    return py::make_tuple(m_vertex_faces, m_vertex_coordinates);
  }
  // Returns the locations of the base vertices on the surface.
  py::tuple base_vertices() const
  {
    std::vector<typename Surface_type::Location> result;
    for(std::size_t v = 0; v < m_map->number_of_base_vertices(); ++v)
      result.push_back(m_map->base_vertex(v));
    return Surface_type::location_arrays(result);
  }
  std::size_t number_of_flips() const { return m_map->number_of_flips(); }
  std::size_t number_of_repaired_faces() const { return m_map->number_of_repaired_faces(); }

  // Maps locations of the surface to the base mesh.
  py::tuple map(const py::object& locations) const
  {
    const auto positions = m_surface->vertices_or_locations(locations, "locations");
    std::vector<Mesh_surface::Location> result;
    Computation().run(
        [&]
        {
          for(const auto& position : positions)
            result.push_back(location_of(
                std::visit([&](const auto& where) { return (*m_map)(where); }, position)));
        });
    return Mesh_surface::location_arrays(result);
  }
  // Maps locations of the base mesh to the surface.
  py::tuple inverse(const py::object& locations) const
  {
    std::vector<typename Surface_type::Location> result;
    for_each_base_location(locations, [&](const GP::Base_location& location)
                           { result.push_back(m_map->inverse(location)); });
    return Surface_type::location_arrays(result);
  }
  // Maps locations of the base mesh to points of the surface.
  py::array_t<double> points(const py::object& locations) const
  {
    std::vector<Kernel::Point_3> result;
    for_each_base_location(locations, [&](const GP::Base_location& location)
                           { result.push_back(m_map->point(location)); });
    return point_array(result);
  }

private:
  void build_base()
  {
    m_corner.resize(m_map->number_of_base_vertices());
    std::vector<std::array<std::size_t, 3>> triangles;
    for(std::size_t f = 0; f < m_map->number_of_base_faces(); ++f)
    {
      triangles.push_back(m_map->base_face(f));
      for(std::size_t k = 0; k < 3; ++k)
      {
        GP::Base_location& corner = m_corner[triangles[f][k]];
        corner = {f, {0., 0., 0.}};
        corner.barycentric[k] = 1.;
      }
    }
    std::vector<Kernel::Point_3> points;
    for(const GP::Base_location& corner : m_corner)
      points.push_back(m_map->point(corner));
    m_base = surface_of_triangles(points, triangles);
  }
  // Calls f(location) for each location of the base mesh, without the GIL.
  template <typename Function>
  void for_each_base_location(const py::object& locations, const Function& f) const
  {
    const auto positions = m_base->vertices_or_locations(locations, "locations");
    Computation().run(
        [&]
        {
          for(const auto& position : positions)
            if(const auto* vertex = std::get_if<Mesh_surface::Vertex>(&position))
              f(m_corner[std::size_t(*vertex)]);
            else
            {
              const auto& location = std::get<Mesh_surface::Location>(position);
              f(GP::Base_location{std::size_t(location.first), location.second});
            }
        });
  }

  std::shared_ptr<Surface_type> m_surface;
  std::optional<Map> m_map;
  std::shared_ptr<Mesh_surface> m_base;
  std::vector<GP::Base_location> m_corner; // #base vertices: one of the corners
  py::array_t<std::int64_t> m_vertex_faces;
  py::array_t<double> m_vertex_coordinates;
};

// Returns the base mesh, the divided mesh, the base face of each of its faces, and the number of
// added vertices.
template <typename Domain>
py::tuple base_mesh(const Surface<Domain>& surface, const py::tuple& arguments)
{
  Remeshing_arguments<Domain> common(surface, arguments);
  Mesh base, divided;
  const auto base_faces =
      divided.add_property_map<Mesh::Face_index, Mesh::Face_index>("f:base").first;
  GP::Remeshing_result found;
  std::shared_ptr<Mesh_surface> base_surface, divided_surface;
  common.run(
      [&](const auto& np)
      {
        found = GP::geodesic_base_mesh(surface.domain(), common.number_of_samples(), base, divided,
                                       base_faces, np);
        base_surface = surface_of_mesh(base);
        divided_surface = surface_of_mesh(divided);
      });
  std::vector<Mesh::Face_index> labels;
  for(const Mesh::Face_index face : divided.faces())
    labels.push_back(base_faces[face]);
  return py::make_tuple(base_surface, divided_surface, index_array(labels),
                        found.number_of_added_vertices);
}

// Returns the corners of faces with the same number of corners.
py::array_t<std::int64_t> corner_array(const Mesh& mesh, std::size_t number_of_corners)
{
  py::array_t<std::int64_t> result(
      Shape{py::ssize_t(mesh.number_of_faces()), py::ssize_t(number_of_corners)});
  std::int64_t* next = result.mutable_data();
  for(const Mesh::Face_index face : mesh.faces())
    for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(face)))
      *next++ = std::int64_t(std::size_t(v));
  return result;
}

// Returns the mesh, the corners of its faces, the level of each vertex, and the numbers of levels,
// of base faces and of flips, and the deviation.
template <typename Domain>
py::tuple semi_regular(const Surface<Domain>& surface, const py::tuple& arguments,
                       const py::object& coordinates, const py::object& levels, bool use_quads,
                       const py::object& max_deviation)
{
  // More levels have too many halfedges for any mesh.
  const auto number_of_levels = unsigned(index(levels, "number of levels", 16));
  std::optional<double> deviation;
  if(!max_deviation.is_none())
    deviation = number(max_deviation, "max_deviation");
  const GP::Base_coordinates kind = parse_coordinates(coordinates);
  Remeshing_arguments<Domain> common(surface, arguments);
  Mesh output;
  const auto level = output.add_property_map<Mesh::Vertex_index, std::size_t>("v:level").first;
  GP::Semi_regular_result found;
  std::shared_ptr<Mesh_surface> result;
  common.run(
      [&](const auto& common_parameters)
      {
        const auto np =
            common_parameters.base_coordinates(kind).level_map(level).subdivision_scheme(
                use_quads ? GP::Subdivision_scheme::quads : GP::Subdivision_scheme::triangles);
        const auto remesh = [&](const auto& all)
        {
          found = GP::semi_regular_remeshing(surface.domain(), common.number_of_samples(),
                                             number_of_levels, output, all);
        };
        // No value of the parameter requests all levels.
        if(deviation)
          remesh(np.maximum_deviation(*deviation));
        else
          remesh(np);
        result = surface_of_mesh(output);
      });
  std::vector<std::size_t> vertex_levels;
  for(const Mesh::Vertex_index v : output.vertices())
    vertex_levels.push_back(level[v]);
  return py::make_tuple(result, corner_array(output, use_quads ? 4 : 3), index_array(vertex_levels),
                        found.number_of_levels, found.number_of_base_faces, found.number_of_flips,
                        found.deviation);
}

template <typename Domain>
void define(py::module_& module, const char* map_name,
            py::class_<Surface<Domain>, std::shared_ptr<Surface<Domain>>>& surface)
{
  using Map = Base_map<Domain>;
  py::class_<Map>(module, map_name)
      .def("base", &Map::base)
      .def("base_vertices", &Map::base_vertices)
      .def("vertex_locations", &Map::vertex_locations)
      .def("number_of_flips", &Map::number_of_flips)
      .def("number_of_repaired_faces", &Map::number_of_repaired_faces)
      .def("map", &Map::map)
      .def("inverse", &Map::inverse)
      .def("points", &Map::points);
  surface.def("base_mesh", &base_mesh<Domain>)
      .def("semi_regular", &semi_regular<Domain>)
      .def("parameterize_over_base", [](const std::shared_ptr<Surface<Domain>>& self,
                                        const py::tuple& arguments, const py::object& coordinates)
           { return std::make_unique<Map>(self, arguments, coordinates); });
}

} // namespace

void bind_base_meshes(py::module_& module, Mesh_class& mesh)
{
  define<Mesh_domain>(module, "Mesh_base_map", mesh);
}

void bind_base_meshes(py::module_& module, Cloud_class& cloud)
{
  define<Cloud_domain>(module, "Cloud_base_map", cloud);
}

} // namespace python
