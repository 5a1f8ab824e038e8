// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Mesh_surface.h"
#include "python/Vector_map.h"
#include "python/isoline_tuples.h"

#include <CGAL/Geodesic_processing/geodesic_ball.h>
#include <CGAL/Geodesic_processing/geodesic_diameter.h>
#include <CGAL/Geodesic_processing/geodesic_distance_derivatives.h>

#include <cstddef>
#include <limits>

namespace python {

namespace {

// Returns the faces, the area and the circles of a ball.
py::tuple ball(const Mesh_surface& surface, const py::object& center_list, const py::object& radius,
               const py::object& callback)
{
  const auto centers = surface.sources(center_list, py::none());
  const double maximum = number(radius, "radius");
  GP::Geodesic_ball<Mesh> result;
  Computation computation(callback);
  const auto np = GP::parameters::callback(computation.callback());
  computation.run([&] { result = GP::geodesic_ball(surface.domain(), centers, maximum, np); });
  py::array_t<std::int64_t> faces(py::ssize_t(result.faces.size()));
  std::int64_t* next = faces.mutable_data();
  for(const Mesh::Face_index face : result.faces)
    *next++ = std::int64_t(std::size_t(face));
  return py::make_tuple(faces, result.area, isoline_tuples(result.circles));
}

// The arguments of diameter() and radius().
struct Bound_options
{
  Bound_options(const py::object& tolerance, const py::object& maximum)
      : relative_tolerance(number(tolerance, "relative_tolerance")),
        max_iterations(index(maximum, "maximum number of iterations",
                             std::numeric_limits<std::ptrdiff_t>::max()))
  {}
  auto parameters(Computation& computation) const
  {
    return GP::parameters::relative_tolerance(relative_tolerance)
        .maximum_number_of_iterations(max_iterations)
        .callback(computation.callback());
  }

  double relative_tolerance;
  std::size_t max_iterations;
};

// Returns the bounds, the ends of a long path, and how the computation ended.
py::tuple diameter(const Mesh_surface& surface, const py::object& tolerance,
                   const py::object& maximum, const py::object& callback)
{
  const Bound_options options(tolerance, maximum);
  GP::Geodesic_diameter<Mesh> result;
  Computation computation(callback);
  const auto np = options.parameters(computation);
  computation.run([&] { result = GP::geodesic_diameter(surface.domain(), np); });
  return py::make_tuple(result.lower, result.upper, std::size_t(result.from),
                        std::size_t(result.to), result.is_converged, result.number_of_iterations);
}

// Returns the bounds, the center and its farthest vertex, and how the computation ended.
py::tuple radius(const Mesh_surface& surface, const py::object& tolerance,
                 const py::object& maximum, const py::object& callback)
{
  const Bound_options options(tolerance, maximum);
  GP::Geodesic_radius<Mesh> result;
  Computation computation(callback);
  const auto np = options.parameters(computation);
  computation.run([&] { result = GP::geodesic_radius(surface.domain(), np); });
  return py::make_tuple(result.lower, result.upper, std::size_t(result.center),
                        std::size_t(result.farthest), result.is_converged,
                        result.number_of_iterations);
}

const char* name_of(GP::Differentiability differentiability)
{
  switch(differentiability)
  {
  case GP::Differentiability::differentiable:
    return "differentiable";
  case GP::Differentiability::unreachable:
    return "unreachable";
  case GP::Differentiability::coincident:
    return "coincident";
  case GP::Differentiability::near_vertex:
    return "near-vertex";
  case GP::Differentiability::second_path:
    break;
  }
  return "second-path";
}

// Returns the distance, its differentiability, the gradients with respect to both locations, and
// the vertices with the gradients with respect to them.
py::tuple distance_derivatives(const Mesh_surface& surface, const py::object& source,
                               const py::object& target, const py::object& vertex_tolerance,
                               const py::object& second_path_tolerance)
{
  const auto from = surface.vertex_or_location(source), to = surface.vertex_or_location(target);
  const auto np =
      GP::parameters::vertex_tolerance(number(vertex_tolerance, "vertex_tolerance"))
          .second_path_tolerance(number(second_path_tolerance, "second_path_tolerance"));
  GP::Geodesic_distance_derivatives<Mesh> result;
  Computation().run(
      [&]
      {
        std::visit([&](const auto& a, const auto& b)
                   { result = GP::geodesic_distance_derivatives(surface.domain(), a, b, np); },
                   from, to);
      });
  py::array_t<std::int64_t> vertices(py::ssize_t(result.vertex_gradients.size()));
  py::array_t<double> gradients(Shape{vertices.size(), 3});
  const Vector_output_map<std::size_t> rows{gradients.mutable_data()};
  for(std::size_t i = 0; i < result.vertex_gradients.size(); ++i)
  {
    const auto& [vertex, gradient] = result.vertex_gradients[i];
    vertices.mutable_at(i) = std::int64_t(std::size_t(vertex));
    put(rows, i, gradient);
  }
  return py::make_tuple(result.distance, name_of(result.differentiability),
                        vector_components(result.source_gradient),
                        vector_components(result.target_gradient), vertices, gradients);
}

} // namespace

void bind_measures(Mesh_class& mesh)
{
  mesh.def("ball", &ball)
      .def("diameter", &diameter)
      .def("radius", &radius)
      .def("distance_derivatives", &distance_derivatives);
}

} // namespace python
