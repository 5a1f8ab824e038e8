// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Cloud_surface.h"
#include "python/Mesh_surface.h"
#include "python/Remeshing_arguments.h"

#include <CGAL/Geodesic_processing/fill_holes.h>
#include <CGAL/Geodesic_processing/geodesic_delaunay_remeshing.h>

#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace python {

namespace {

using Vertex_index = Mesh::Vertex_index;

// Returns the mesh, the locations of its vertices, the number of added vertices, the number of
// self-intersections, and the ends and the paths of edges.
template <typename Domain>
py::tuple remesh(const Surface<Domain>& surface, const py::tuple& arguments,
                 const py::object& max_deviation, bool do_fit, bool do_avoid_self_intersections,
                 const py::object& too_few_samples, bool has_edge_paths)
{
  using Surface_type = Surface<Domain>;
  using Location = typename Surface_type::Location;
  const double deviation = max_deviation.is_none() ? std::numeric_limits<double>::infinity()
                                                   : number(max_deviation, "max_deviation");
  const auto reaction = choice<GP::Too_few_samples>(
      too_few_samples, "too_few_samples",
      {{"refine", GP::Too_few_samples::refine}, {"raise", GP::Too_few_samples::are_wrong}});
  Remeshing_arguments<Domain> common(surface, arguments);
  Mesh output;
  const auto location_map = output.add_property_map<Vertex_index, Location>("v:location").first;
  std::vector<std::pair<Mesh::Edge_index, GP::Surface_path<typename Surface_type::Input>>>
      edge_paths;
  GP::Remeshing_result found;
  std::shared_ptr<Mesh_surface> result;
  common.run(
      [&](const auto& common_parameters)
      {
        const auto np = common_parameters.maximum_deviation(deviation)
                            .do_fit(do_fit)
                            .do_avoid_self_intersections(do_avoid_self_intersections)
                            .too_few_samples(reaction)
                            .location_map(location_map);
        const std::size_t size = common.number_of_samples();
        found = has_edge_paths
                    ? GP::geodesic_delaunay_remeshing(
                          surface.domain(), size, output,
                          np.edge_path_output(std::back_inserter(edge_paths)))
                    : GP::geodesic_delaunay_remeshing(surface.domain(), size, output, np);
        result = surface_of_mesh(output);
      });
  std::vector<Location> locations;
  for(const Vertex_index v : output.vertices())
    locations.push_back(location_map[v]);
  const py::tuple arrays = Surface_type::location_arrays(locations);
  std::vector<Mesh::Edge_index> edges;
  py::list paths;
  for(const auto& [edge, path] : edge_paths)
  {
    edges.push_back(edge);
    paths.append(Surface_type::path_arrays(path));
  }
  return py::make_tuple(result, arrays[0], arrays[1], found.number_of_added_vertices,
                        found.number_of_self_intersections, edge_array(output, edges), paths);
}

// Returns the mesh, the new faces, and the numbers of holes: all, filled, failed and unfolded.
py::tuple fill_holes(const Mesh_surface& surface, const py::object& max_edges,
                     const py::object& max_perimeter, const py::object& method,
                     const py::object& callback)
{
  constexpr auto unlimited = std::numeric_limits<std::size_t>::max();
  const std::size_t edges =
      max_edges.is_none() ? unlimited : index(max_edges, "number of edges", std::size_t(1) << 32);
  const double perimeter = number(max_perimeter, "max_perimeter");
  const auto filling_method = choice<GP::Hole_filling_method>(
      method, "method",
      {{"minimal-dihedral-angles", GP::Hole_filling_method::minimal_dihedral_angles},
       {"unfolding", GP::Hole_filling_method::unfolding}});
  std::vector<Mesh::Face_index> faces;
  Computation computation(callback);
  const auto np = GP::parameters::maximum_number_of_edges(edges)
                      .maximum_perimeter(perimeter)
                      .hole_filling_method(filling_method)
                      .face_output(std::back_inserter(faces))
                      .callback(computation.callback());
  GP::Hole_filling_result found;
  std::shared_ptr<Mesh_surface> result;
  computation.run(
      [&]
      {
        Mesh mesh = surface.domain().mesh();
        found = GP::fill_holes(mesh, np);
        result = surface_of_mesh(mesh);
      });
  return py::make_tuple(result, index_array(faces), found.number_of_holes, found.number_of_filled,
                        found.number_of_failed, found.number_of_unfolded);
}

} // namespace

void bind_remeshing(Mesh_class& mesh)
{
  mesh.def("remesh", &remesh<Mesh_domain>).def("fill_holes", &fill_holes);
}

void bind_remeshing(Cloud_class& cloud) { cloud.def("remesh", &remesh<Cloud_domain>); }

} // namespace python
