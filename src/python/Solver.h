// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PYTHON_SOLVER_H
#define GEODESIC_PYTHON_SOLVER_H

#include "python/Speeds.h"
#include "python/Surface.h"

#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace python {

// A solver as Python sees it. One thread at a time uses it.
template <typename Domain>
class Solver
{
public:
  using Surface_type = Surface<Domain>;
  using Vertex = typename Surface_type::Vertex;
  using Location = typename Surface_type::Location;
  using Vertex_or_location = typename Surface_type::Vertex_or_location;

  Solver(std::shared_ptr<Surface_type> surface, const py::object& method,
         const py::object& callback)
      : m_surface(std::move(surface))
  {
    Computation computation(callback);
    const auto np = GP::parameters::method(parse_method(method)).callback(computation.callback());
    computation.run([&] { m_solver.emplace(m_surface->domain(), np); });
  }

  std::size_t number_of_points() const { return m_surface->number_of_points(); }

  void compute(const py::object& source_list, const py::object& maximum,
               const py::object& target_list, const py::object& speed, const py::object& face_speed,
               const py::object& offsets, const py::object& relative_tolerance,
               const py::object& callback)
  {
    const auto sources = m_surface->sources(source_list, offsets);
    const double maximum_distance = number(maximum, "max_distance");
    const double tolerance = number(relative_tolerance, "relative_tolerance");
    const Speeds<Domain> speeds(*m_surface, speed, face_speed);
    Computation computation(callback);
    m_surface->with_targets(m_surface->targets(target_list),
                            [&](const auto& positions)
                            {
                              const auto np = GP::parameters::maximum_distance(maximum_distance)
                                                  .targets(positions)
                                                  .relative_tolerance(tolerance)
                                                  .callback(computation.callback());
                              run(computation, sources, speeds.add_to(np));
                            });
  }

  // Writes the distance of each vertex to an array.
  void write_distances(py::array_t<double> out)
  {
    const Output_map<Vertex, double> map{out.mutable_data(),
                                         out.strides(0) / std::ptrdiff_t(sizeof(double))};
    use([&] { m_solver->write_distances(map); });
  }

  // Returns the distance of each vertex or location.
  py::object distances(const py::object& object)
  {
    const auto positions = m_surface->vertices_or_locations(object, "locations");
    py::array_t<double> result(py::ssize_t(positions.size()));
    double* const values = result.mutable_data();
    use(
        [&]
        {
          std::vector<Location> locations;
          std::vector<std::size_t> rows;
          for(std::size_t i = 0; i < positions.size(); ++i)
            if(const Vertex* vertex = std::get_if<Vertex>(&positions[i]))
              values[i] = m_solver->distance(*vertex);
            else
            {
              locations.push_back(std::get<Location>(positions[i]));
              rows.push_back(i);
            }
          std::vector<double> found;
          m_solver->distances(locations, std::back_inserter(found));
          for(std::size_t i = 0; i < rows.size(); ++i)
            values[rows[i]] = found[i];
        });
    if(Surface_type::is_single(object))
      return py::float_(values[0]);
    return std::move(result);
  }

  py::tuple path(const py::object& from)
  {
    const Vertex_or_location start = m_surface->vertex_or_location(from);
    GP::Surface_path<typename Surface_type::Input> result;
    use([&]
        { std::visit([&](const auto& position) { result = m_solver->path(position); }, start); });
    return Surface_type::path_arrays(result);
  }

  py::array_t<std::int64_t> labels()
  {
    py::array_t<std::int64_t> result(py::ssize_t(m_surface->number_of_points()));
    const auto map = label_map<Vertex>(result);
    use([&] { m_solver->write_source_labels(map); });
    return result;
  }

  py::array_t<std::int64_t> reached()
  {
    std::vector<Vertex> vertices;
    use([&] { vertices = m_solver->reached(); });
    return index_array(vertices);
  }

private:
  template <typename Sources, typename NamedParameters>
  void run(Computation& computation, const Sources& sources, const NamedParameters& np)
  {
    computation.run(
        [&]
        {
          const std::lock_guard<Guard> lock(m_guard);
          m_solver->compute(sources, np);
        });
  }
  // Calls f() without the GIL, while no other thread uses the solver.
  template <typename Function>
  void use(const Function& f)
  {
    Computation().run(
        [&]
        {
          const std::lock_guard<Guard> lock(m_guard);
          f();
        });
  }

  std::shared_ptr<Surface_type> m_surface;
  Guard m_guard;
  std::optional<GP::Geodesic_distance_solver<typename Surface_type::Input, Runtime_method>>
      m_solver;
};

// Adds the members that surfaces and solvers of meshes and clouds share.
template <typename Domain>
py::class_<Surface<Domain>, std::shared_ptr<Surface<Domain>>>
bind_surface(py::module_& module, const char* surface_name, const char* solver_name)
{
  using Surface_type = Surface<Domain>;
  using Solver_type = Solver<Domain>;
  py::class_<Surface_type, std::shared_ptr<Surface_type>> surface(module, surface_name);
  surface.def_property_readonly("number_of_points", &Surface_type::number_of_points)
      .def_property_readonly("number_of_faces", &Surface_type::number_of_faces)
      .def("locate", &Surface_type::locate)
      .def("points", &Surface_type::points)
      .def("vertices", &Surface_type::vertices)
      .def("paths", &Surface_type::paths)
      .def("distance_matrix", &Surface_type::distance_matrix)
      .def("sparse_distance_matrix", &Surface_type::sparse_distance_matrix)
      .def("farthest_points", &Surface_type::farthest_points)
      .def("farthest_vertices", &Surface_type::farthest_vertices)
      .def("solver", [](const std::shared_ptr<Surface_type>& self, const py::object& method,
                        const py::object& callback)
           { return std::make_unique<Solver_type>(self, method, callback); });
  py::class_<Solver_type>(module, solver_name)
      .def_property_readonly("number_of_points", &Solver_type::number_of_points)
      .def("compute", &Solver_type::compute)
      .def("write_distances", &Solver_type::write_distances)
      .def("distances", &Solver_type::distances)
      .def("path", &Solver_type::path)
      .def("labels", &Solver_type::labels)
      .def("reached", &Solver_type::reached);
  return surface;
}

} // namespace python

#endif // GEODESIC_PYTHON_SOLVER_H
