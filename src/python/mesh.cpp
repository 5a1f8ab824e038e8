// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Mesh_surface.h"
#include "python/Solver.h"
#include "python/read_surface.h"

#include <boost/range/adaptor/transformed.hpp>
#include <boost/range/irange.hpp>

#include <array>

namespace python {

namespace {

// Constructs the domain of a soup that is read by two functions: the point of an index, and the
// corner k of a polygon.
template <typename Point_of, typename Polygon_of>
std::shared_ptr<Mesh_surface>
make_surface(std::size_t number_of_points, const Point_of& point_of, std::size_t number_of_polygons,
             const Polygon_of& polygon_of, const std::optional<double>& merge_tolerance,
             bool do_remove_degenerate_faces, const std::function<bool(double)>& callback)
{
  using boost::adaptors::transformed;
  const auto points = boost::irange<std::size_t>(0, number_of_points) | transformed(point_of);
  const auto polygons = boost::irange<std::size_t>(0, number_of_polygons) | transformed(polygon_of);
  const auto np =
      GP::parameters::do_remove_degenerate_faces(do_remove_degenerate_faces).callback(callback);
  const auto domain = [&]
  {
    return merge_tolerance ? GP::make_domain<CGAL::Parallel_tag>(
                                 points, polygons, np.merge_tolerance(*merge_tolerance))
                           : GP::make_domain<CGAL::Parallel_tag>(points, polygons, np);
  };
  return std::make_shared<Mesh_surface>(domain(), number_of_points);
}

// Polygons as rows of an array, or as one list of corners and the position of the first corner of
// each polygon.
class Polygons
{
public:
  // Throws Invalid_argument_error. `offsets` are None, or one number more than there are polygons.
  Polygons(const py::object& F, const py::object& offsets)
      : m_corners(F, "F", offsets.is_none() ? Shape{any, any} : Shape{any})
  {
    if(offsets.is_none())
    {
      if(m_corners.row_size() < 3)
        reject("F has fewer than three columns.");
      return;
    }
    m_offsets.emplace(offsets, "offsets", Shape{any});
    bool is_valid = (*m_offsets)(0) == 0 &&
                    (*m_offsets)(m_offsets->size() - 1) == std::int64_t(m_corners.size());
    for(std::size_t i = 1; i < m_offsets->size(); ++i)
      is_valid = is_valid && (*m_offsets)(i - 1) <= (*m_offsets)(i);
    if(!is_valid)
      reject("offsets are not the increasing positions of the first corners in F.");
  }

  std::size_t size() const { return m_offsets ? m_offsets->size() - 1 : m_corners.size(); }
  std::size_t number_of_corners(std::size_t f) const
  {
    return m_offsets ? std::size_t((*m_offsets)(f + 1) - (*m_offsets)(f)) : m_corners.row_size();
  }
  std::int64_t corner(std::size_t f, std::size_t k) const
  {
    return m_offsets ? m_corners(std::size_t((*m_offsets)(f)) + k) : m_corners(f, k);
  }

private:
  Integers m_corners;
  std::optional<Integers> m_offsets;
};

std::shared_ptr<Mesh_surface> mesh_of_arrays(const py::object& V, const py::object& F,
                                             const py::object& offsets,
                                             const py::object& merge_tolerance,
                                             bool do_remove_degenerate_faces,
                                             const py::object& callback)
{
  const Numbers points(V, "V", {any, 3});
  const Polygons polygons(F, offsets);
  std::optional<double> tolerance;
  if(!merge_tolerance.is_none())
    tolerance = number(merge_tolerance, "merge_tolerance");
  const auto point_of = [&](std::size_t i)
  { return Kernel::Point_3(points(i, 0), points(i, 1), points(i, 2)); };
  const auto polygon_of = [&](std::size_t f)
  {
    return boost::irange<std::size_t>(0, polygons.number_of_corners(f)) |
           boost::adaptors::transformed([&polygons, f](std::size_t k)
                                        { return polygons.corner(f, k); });
  };
  std::shared_ptr<Mesh_surface> result;
  Computation computation(callback);
  computation.run(
      [&]
      {
        result = make_surface(points.size(), point_of, polygons.size(), polygon_of, tolerance,
                              do_remove_degenerate_faces, computation.callback());
      });
  return result;
}

// Returns the positions of the points at the corners of each face.
py::array_t<std::int64_t> faces(const Mesh_surface& surface)
{
  const std::size_t number_of_faces = surface.number_of_faces();
  py::array_t<std::int64_t> result(Shape{py::ssize_t(number_of_faces), 3});
  std::int64_t* next = result.mutable_data();
  for(std::size_t f = 0; f < number_of_faces; ++f)
    for(const std::size_t corner : surface.domain().corners(Mesh::Face_index(Mesh::size_type(f))))
      *next++ = std::int64_t(corner);
  return result;
}

py::dict report(const Mesh_surface& surface)
{
  const GP::Soup_report& report = surface.domain().report();
  py::dict result;
  const auto add = [&](const char* name, std::size_t value) { result[name] = value; };
  add("number_of_merged_points", report.number_of_merged_points);
  add("number_of_triangulated_polygons", report.number_of_triangulated_polygons);
  add("number_of_degenerate_faces", report.number_of_degenerate_faces);
  add("number_of_duplicate_triangles", report.number_of_duplicate_triangles);
  add("number_of_triangles_without_area", report.number_of_triangles_without_area);
  add("number_of_reversed_triangles", report.number_of_reversed_triangles);
  add("number_of_split_edges", report.number_of_split_edges);
  add("number_of_nonmanifold_points", report.number_of_nonmanifold_points);
  add("number_of_components", report.number_of_components);
  add("number_of_boundary_cycles", report.number_of_boundary_cycles);
  add("genus", report.genus);
  return result;
}

// Returns the locations of each boundary cycle.
py::list border_sources(const Mesh_surface& surface)
{
  std::vector<Mesh_surface::Source> sources;
  Computation().run([&] { GP::border_sources(surface.domain(), std::back_inserter(sources)); });
  py::list result;
  for(const Mesh_surface::Source& source : sources)
    result.append(Mesh_surface::location_arrays(std::get<1>(source.location())));
  return result;
}

// Returns the labels of vertices and faces, and the bisectors.
py::tuple voronoi(const Mesh_surface& surface, const py::object& seeds, const py::object& method,
                  const py::object& speed, const py::object& callback)
{
  using Vertex = Mesh_surface::Vertex;
  const auto sources = surface.sources(seeds, py::none());
  const std::optional<Numbers> speeds = surface.vertex_speeds(speed);
  py::array_t<std::int64_t> labels(py::ssize_t(surface.number_of_points()));
  py::array_t<std::int64_t> face_labels(py::ssize_t(surface.number_of_faces()));
  std::vector<GP::Voronoi_bisector<Mesh>> bisectors;
  Computation computation(callback);
  const auto np = GP::parameters::method(parse_method(method))
                      .face_label_map(label_map<Mesh::Face_index>(face_labels))
                      .bisector_output(std::back_inserter(bisectors))
                      .speed_map(Mesh_surface::speed_map(speeds))
                      .callback(computation.callback());
  const auto map = label_map<Vertex>(labels);
  computation.run(
      [&] { GP::geodesic_voronoi_diagram<Runtime_method>(surface.domain(), sources, map, np); });
  py::list lines;
  for(const auto& bisector : bisectors)
  {
    const py::tuple locations = Mesh_surface::location_arrays(bisector.locations);
    lines.append(py::make_tuple(bisector.left, bisector.right, point_array(bisector.points),
                                locations[0], locations[1]));
  }
  return py::make_tuple(labels, face_labels, lines);
}

} // namespace

std::shared_ptr<Mesh_surface> surface_of_mesh(const Mesh& mesh)
{
  const auto point_of = [&](std::size_t i) { return mesh.point(Mesh::Vertex_index(i)); };
  const auto polygon_of = [&](std::size_t f)
  { return mesh.vertices_around_face(mesh.halfedge(Mesh::Face_index(f))); };
  return make_surface(mesh.number_of_vertices(), point_of, mesh.number_of_faces(), polygon_of,
                      std::nullopt, false, nullptr);
}

std::shared_ptr<Mesh_surface>
surface_of_triangles(const std::vector<Kernel::Point_3>& points,
                     const std::vector<std::array<std::size_t, 3>>& triangles)
{
  return make_surface(
      points.size(), [&](std::size_t i) { return points[i]; }, triangles.size(),
      [&](std::size_t f) { return triangles[f]; }, std::nullopt, false, nullptr);
}

py::object mesh_of_file(const program::Surface_file& file)
{
  const auto point_of = [&](std::size_t i)
  { return Kernel::Point_3(file.points[i][0], file.points[i][1], file.points[i][2]); };
  const auto polygon_of = [&](std::size_t f)
  {
    return boost::make_iterator_range(file.corners.data() + file.polygon_begin[f],
                                      file.corners.data() + file.polygon_begin[f + 1]);
  };
  std::shared_ptr<Mesh_surface> result;
  Computation computation;
  computation.run(
      [&]
      {
        result = make_surface(file.points.size(), point_of, file.number_of_polygons(), polygon_of,
                              std::nullopt, false, computation.callback());
      });
  return py::cast(result);
}

void bind_mesh(py::module_& module)
{
  Mesh_class mesh = bind_surface<Mesh_domain>(module, "Mesh", "Mesh_solver");
  mesh.def("faces", &faces)
      .def("report", &report)
      .def("border_sources", &border_sources)
      .def("voronoi", &voronoi);
  bind_atlas(mesh);
  bind_base_meshes(module, mesh);
  bind_curvature(mesh);
  bind_curves(mesh);
  bind_decals(mesh);
  bind_distortion(mesh);
  bind_features(mesh);
  bind_flattening(mesh);
  bind_fuzzy(mesh);
  bind_maps(mesh);
  bind_measures(mesh);
  bind_remeshing(mesh);
  bind_sampling(mesh);
  bind_transport(mesh);
  bind_volumes(module, mesh);
  bind_wavelets(module, mesh);
  module.def("make_mesh", &mesh_of_arrays);
}

} // namespace python
