// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Cloud_surface.h"
#include "python/Mesh_surface.h"

#include <CGAL/Geodesic_processing/geodesic_centroidal_tessellation.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

namespace python {

namespace {

// Returns the labels of faces or surfels, the locations of centers, and the energies.
template <typename Domain>
py::tuple segment(const Surface<Domain>& surface, const py::object& n, bool make_disks,
                  const py::object& max_iterations, const py::object& seed,
                  const py::object& method, const py::object& speed, const py::object& threads,
                  const py::object& callback)
{
  using Surface_type = Surface<Domain>;
  using Element = std::conditional_t<Surface_type::is_cloud, std::size_t, Mesh::Face_index>;
  const std::size_t size = index(n, "number of cells", std::size_t(1) << 31);
  const std::size_t number_of_steps =
      index(max_iterations, "number of iterations", std::size_t(1) << 32);
  const std::optional<Numbers> speeds = surface.vertex_speeds(speed);
  py::array_t<std::int64_t> labels(
      py::ssize_t(Surface_type::is_cloud ? surface.number_of_points() : surface.number_of_faces()));
  std::vector<typename Surface_type::Location> centers;
  std::vector<double> energies;
  Computation computation(callback);
  const auto np = GP::parameters::do_make_discs(make_disks)
                      .maximum_number_of_iterations(unsigned(number_of_steps))
                      .random_seed(parse_seed(seed))
                      .method(parse_method(method))
                      .number_of_threads(parse_threads(threads))
                      .center_output(std::back_inserter(centers))
                      .energy_output(std::back_inserter(energies))
                      .speed_map(Surface_type::speed_map(speeds))
                      .callback(computation.callback());
  const auto map = label_map<Element>(labels);
  computation.run(
      [&]
      {
        GP::geodesic_centroidal_tessellation<Runtime_method, CGAL::Parallel_tag>(surface.domain(),
                                                                                 size, map, np);
      });
  const py::tuple locations = Surface_type::location_arrays(centers);
  return py::make_tuple(labels, locations[0], locations[1], number_array(energies));
}

// Returns the mesh that is cut along the bisectors, and the cell of each of its faces.
py::tuple voronoi_cells(const Mesh_surface& surface, const py::object& seeds,
                        const py::object& maximum, const py::object& speed,
                        const py::object& callback)
{
  const auto sources = surface.sources(seeds, py::none());
  const double maximum_distance = number(maximum, "max_distance");
  const std::optional<Numbers> speeds = surface.vertex_speeds(speed);
  Computation computation(callback);
  const auto np = GP::parameters::maximum_distance(maximum_distance)
                      .speed_map(Mesh_surface::speed_map(speeds))
                      .callback(computation.callback());
  Mesh cells;
  const auto labels = cells.add_property_map<Mesh::Face_index, std::size_t>("f:label").first;
  std::shared_ptr<Mesh_surface> result;
  computation.run(
      [&]
      {
        GP::geodesic_voronoi_cells(surface.domain(), sources, cells, labels, np);
        result = surface_of_mesh(cells);
      });
  py::array_t<std::int64_t> face_labels(py::ssize_t(cells.number_of_faces()));
  const auto map = label_map<Mesh::Face_index>(face_labels);
  for(const Mesh::Face_index face : cells.faces())
    put(map, face, std::int64_t(labels[face]));
  return py::make_tuple(result, face_labels);
}

} // namespace

void bind_sampling(Mesh_class& mesh)
{
  mesh.def("segment", &segment<Mesh_domain>).def("voronoi_cells", &voronoi_cells);
}

void bind_sampling(Cloud_class& cloud) { cloud.def("segment", &segment<Cloud_domain>); }

} // namespace python
