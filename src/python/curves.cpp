// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Cloud_surface.h"
#include "python/Mesh_surface.h"
#include "python/isoline_tuples.h"

#include <CGAL/Geodesic_processing/geodesic_curves.h>
#include <CGAL/Geodesic_processing/geodesic_loops.h>
#include <CGAL/Geodesic_processing/geodesic_polyline.h>
#include <CGAL/Geodesic_processing/isolines.h>
#include <CGAL/Geodesic_processing/split_at_isolines.h>

namespace python {

namespace {

using Vertex = Mesh_surface::Vertex;

py::list isolines(const Mesh_surface& surface, const py::object& values, const py::object& levels,
                  bool do_fit_circles, const py::object& callback)
{
  const Numbers value_array(values, "values", {py::ssize_t(surface.number_of_points())});
  const std::vector<double> isovalues = numbers_of(levels, "levels");
  std::vector<GP::Isoline<Mesh>> lines;
  Computation computation(callback);
  const auto np = GP::parameters::do_fit_circles(do_fit_circles).callback(computation.callback());
  computation.run(
      [&]
      {
        GP::isolines(surface.domain(), Number_map<Vertex>{&value_array}, isovalues,
                     std::back_inserter(lines), np);
      });
  return isoline_tuples(lines);
}

// Returns the surface of a split mesh, the labels of its faces, the locations of its vertices, and
// the ends of its edges on isolines.
py::tuple split_at_isolines(const Mesh_surface& surface, const py::object& values,
                            const py::object& levels, bool do_fit_circles)
{
  const Numbers value_array(values, "values", {py::ssize_t(surface.number_of_points())});
  const std::vector<double> isovalues = numbers_of(levels, "levels");
  Mesh split;
  const auto label_map = split.add_property_map<Mesh::Face_index, std::size_t>("f:label").first;
  const auto location_map =
      split.add_property_map<Mesh::Vertex_index, Mesh_surface::Location>("v:location").first;
  const auto edge_map = split.add_property_map<Mesh::Edge_index, bool>("e:is_on_isoline").first;
  std::shared_ptr<Mesh_surface> result;
  Computation().run(
      [&]
      {
        GP::split_at_isolines(surface.domain(), Number_map<Vertex>{&value_array}, isovalues, split,
                              label_map,
                              GP::parameters::do_fit_circles(do_fit_circles)
                                  .location_map(location_map)
                                  .edge_is_constrained_map(edge_map));
        result = surface_of_mesh(split);
      });
  py::array_t<std::int64_t> labels(py::ssize_t(split.number_of_faces()));
  for(const Mesh::Face_index face : split.faces())
    labels.mutable_at(std::size_t(face)) = std::int64_t(label_map[face]);
  std::vector<Mesh_surface::Location> locations;
  for(const Mesh::Vertex_index vertex : split.vertices())
    locations.push_back(location_map[vertex]);
  std::vector<Mesh::Edge_index> edges;
  for(const Mesh::Edge_index edge : split.edges())
    if(edge_map[edge])
      edges.push_back(edge);
  return py::make_tuple(result, labels, Mesh_surface::location_arrays(locations),
                        edge_array(split, edges));
}

// Returns the path through points, and the rows of these points.
template <typename Domain>
py::tuple polyline(const Surface<Domain>& surface, const py::object& points, bool do_close)
{
  const auto positions = surface.vertices_or_locations(points, "points");
  GP::Geodesic_polyline<typename Surface<Domain>::Input> result;
  surface.with_positions(positions,
                         [&](const auto& locations)
                         {
                           Computation().run(
                               [&]
                               {
                                 result = GP::geodesic_polyline(surface.domain(), locations,
                                                                GP::parameters::do_close(do_close));
                               });
                         });
  py::array_t<std::int64_t> corners(py::ssize_t(result.corners.size()));
  std::copy(result.corners.begin(), result.corners.end(), corners.mutable_data());
  return py::make_tuple(Surface<Domain>::path_arrays(result), corners);
}

template <typename Domain>
py::tuple shorten_polyline(Surface<Domain>& surface, const py::object& points)
{
  const auto positions = surface.vertices_or_locations(points, "points");
  GP::Geodesic_path<typename Surface<Domain>::Input> result;
  surface.with_positions(
      positions,
      [&](const auto& locations)
      {
        Computation().run(
            [&] { surface.use_finder([&](auto& finder) { result = finder.shorten(locations); }); });
      });
  return Surface<Domain>::path_arrays(result);
}

// Returns points, faces, barycentric coordinates and length of a loop.
py::tuple loop_arrays(const GP::Geodesic_loop<Mesh>& loop)
{
  const py::tuple locations = Mesh_surface::location_arrays(loop.locations);
  return py::make_tuple(point_array(loop.points), locations[0], locations[1], loop.length);
}

py::tuple shorten_loop(const Mesh_surface& surface, const py::object& points)
{
  const auto positions = surface.vertices_or_locations(points, "points");
  GP::Geodesic_loop<Mesh> result;
  surface.with_positions(
      positions, [&](const auto& locations)
      { Computation().run([&] { result = GP::shorten_loop(surface.domain(), locations); }); });
  return loop_arrays(result);
}

py::list loop_basis(const Mesh_surface& surface, bool do_shorten)
{
  std::vector<GP::Geodesic_loop<Mesh>> loops;
  Computation().run(
      [&]
      {
        GP::loop_basis(surface.domain(), std::back_inserter(loops),
                       GP::parameters::do_shorten(do_shorten));
      });
  py::list result;
  for(const GP::Geodesic_loop<Mesh>& loop : loops)
    result.append(loop_arrays(loop));
  return result;
}

py::tuple shortest_noncontractible_loop(const Mesh_surface& surface, const py::object& through)
{
  const auto location = surface.vertex_or_location(through);
  GP::Geodesic_loop<Mesh> result;
  Computation().run(
      [&]
      {
        std::visit([&](const auto& position)
                   { result = GP::shortest_noncontractible_loop(surface.domain(), position); },
                   location);
      });
  return loop_arrays(result);
}

// The number of points of a curve doubles in each subdivision, so that the library limits it.
unsigned number_of_subdivisions(const py::object& object)
{
  return unsigned(index(object, "number of subdivisions", 21));
}

py::tuple bezier_curve(const Mesh_surface& surface, const py::object& control_points,
                       const py::object& subdivisions, const py::object& callback)
{
  const auto positions = surface.vertices_or_locations(control_points, "control_points");
  GP::Surface_path<Mesh> result;
  Computation computation(callback);
  const auto np = GP::parameters::number_of_subdivisions(number_of_subdivisions(subdivisions))
                      .callback(computation.callback());
  surface.with_positions(
      positions,
      [&](const auto& locations) {
        computation.run([&]
                        { result = GP::geodesic_bezier_curve(surface.domain(), locations, np); });
      });
  return Mesh_surface::path_arrays(result);
}

py::tuple spline(const Mesh_surface& surface, const py::object& control_points,
                 const py::object& degree, bool is_closed, const py::object& subdivisions,
                 const py::object& callback)
{
  const auto positions = surface.vertices_or_locations(control_points, "control_points");
  GP::Surface_path<Mesh> result;
  Computation computation(callback);
  // The library has no limit. A larger degree is a mistake that would exhaust the memory.
  const auto np = GP::parameters::number_of_subdivisions(number_of_subdivisions(subdivisions))
                      .degree(unsigned(index(degree, "degree", 1001)))
                      .is_closed(is_closed)
                      .callback(computation.callback());
  surface.with_positions(
      positions, [&](const auto& locations)
      { computation.run([&] { result = GP::geodesic_spline(surface.domain(), locations, np); }); });
  return Mesh_surface::path_arrays(result);
}

} // namespace

void bind_curves(Mesh_class& mesh)
{
  mesh.def("isolines", &isolines)
      .def("split_at_isolines", &split_at_isolines)
      .def("polyline", &polyline<Mesh_domain>)
      .def("shorten_polyline", &shorten_polyline<Mesh_domain>)
      .def("shorten_loop", &shorten_loop)
      .def("loop_basis", &loop_basis)
      .def("shortest_noncontractible_loop", &shortest_noncontractible_loop)
      .def("bezier_curve", &bezier_curve)
      .def("spline", &spline);
}

void bind_curves(Cloud_class& cloud)
{
  cloud.def("polyline", &polyline<Cloud_domain>)
      .def("shorten_polyline", &shorten_polyline<Cloud_domain>);
}

} // namespace python
