// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Cloud_surface.h"
#include "python/Mesh_surface.h"
#include "python/transport_arguments.h"

#include <CGAL/Geodesic_processing/fuzzy_geodesic.h>

#include <algorithm>

namespace python {

namespace {

// Reads a vertex or location as a location, so that functions of two of them are compiled once.
template <typename Domain>
typename Surface<Domain>::Location read_location(const Surface<Domain>& surface,
                                                 const py::object& object)
{
  using Location = typename Surface<Domain>::Location;
  using Vertex = typename Surface<Domain>::Vertex;
  const auto position = surface.vertex_or_location(object);
  if(const Location* const location = std::get_if<Location>(&position))
    return *location;
  const Vertex vertex = std::get<Vertex>(position);
  if constexpr(Surface<Domain>::is_cloud)
    return {vertex, {0., 0.}};
  else
  {
    // Not public: No public function returns the location of a vertex.
    const Location location = surface.domain().outer(surface.domain().inner_vertex(vertex));
    if(location.first == Mesh::null_face())
      reject("The vertex " + std::to_string(std::size_t(vertex)) + " has no face.");
    return location;
  }
}

// Reads a width; empty for None, which stands for the default.
std::optional<double> width_of(const py::object& width)
{
  return width.is_none() ? std::nullopt : std::optional(number(width, "width"));
}

// Returns the likelihoods of vertices, and the members of the cost.
template <typename Domain>
py::tuple fuzzy_geodesic(const Surface<Domain>& surface, const py::object& a, const py::object& b,
                         const py::object& width, const py::object& method,
                         const py::object& tolerance, const py::object& number_of_refinements,
                         const py::object& speed, const py::object& callback)
{
  using Vertex = typename Surface<Domain>::Vertex;
  const auto p = read_location(surface, a), q = read_location(surface, b);
  const std::optional<Numbers> speeds = surface.vertex_speeds(speed);
  py::array_t<double> likelihoods(py::ssize_t(surface.number_of_points()));
  const Output_map<Vertex, double> map{likelihoods.mutable_data(), 1};
  Computation computation(callback);
  GP::Earth_movers_cost cost;
  const auto np = GP::parameters::width(width_of(width))
                      .tolerance(number(tolerance, "tolerance"))
                      .number_of_refinements(refinements(number_of_refinements))
                      .speed_map(Surface<Domain>::speed_map(speeds))
                      .callback(computation.callback());
  with_transport_method(
      parse_transport_method(method),
      [&]([[maybe_unused]] auto tag)
      {
        computation.run(
            [&] { cost = GP::fuzzy_geodesic<decltype(tag)>(surface.domain(), p, q, map, np); });
      });
  return py::make_tuple(likelihoods, cost.value, cost.lower, cost.upper, cost.estimate,
                        cost.number_of_iterations, cost.residual, cost.is_converged);
}

// Returns the likelihoods of vertices.
template <typename Domain>
py::array_t<double> fuzzy_geodesic_by_distances(const Surface<Domain>& surface, const py::object& a,
                                                const py::object& b, const py::object& width,
                                                const py::object& method, const py::object& speed,
                                                const py::object& callback)
{
  using Vertex = typename Surface<Domain>::Vertex;
  const auto p = read_location(surface, a), q = read_location(surface, b);
  const std::optional<Numbers> speeds = surface.vertex_speeds(speed);
  py::array_t<double> likelihoods(py::ssize_t(surface.number_of_points()));
  const Output_map<Vertex, double> map{likelihoods.mutable_data(), 1};
  Computation computation(callback);
  const auto np = GP::parameters::width(width_of(width))
                      .method(parse_method(method))
                      .speed_map(Surface<Domain>::speed_map(speeds))
                      .callback(computation.callback());
  computation.run(
      [&] { GP::fuzzy_geodesic_by_distances<Runtime_method>(surface.domain(), p, q, map, np); });
  return likelihoods;
}

template <typename Domain>
void bind(py::class_<Surface<Domain>, std::shared_ptr<Surface<Domain>>>& surface)
{
  surface.def("fuzzy_geodesic", &fuzzy_geodesic<Domain>)
      .def("fuzzy_geodesic_by_distances", &fuzzy_geodesic_by_distances<Domain>);
}

} // namespace

void bind_fuzzy(Mesh_class& mesh) { bind<Mesh_domain>(mesh); }
void bind_fuzzy(Cloud_class& cloud) { bind<Cloud_domain>(cloud); }

} // namespace python
