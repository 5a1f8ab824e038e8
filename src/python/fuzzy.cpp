// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Cloud_surface.h"
#include "python/Mesh_surface.h"

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

// Calls f with named parameters, to which `width` is added unless it is None.
template <typename NamedParameters, typename Function>
void with_width(const py::object& width, const NamedParameters& np, const Function& f)
{
  if(width.is_none())
    f(np);
  else
    f(np.width(number(width, "width")));
}

// Returns the likelihoods of vertices, and the members of the cost.
template <typename Domain>
py::tuple fuzzy_geodesic(const Surface<Domain>& surface, const py::object& a, const py::object& b,
                         const py::object& width, const py::object& tolerance,
                         const py::object& number_of_refinements, const py::object& speed,
                         const py::object& callback)
{
  using Vertex = typename Surface<Domain>::Vertex;
  const auto p = read_location(surface, a), q = read_location(surface, b);
  const std::optional<Numbers> speeds = surface.vertex_speeds(speed);
  unsigned refinements;
  if(number_of_refinements.is_none())
    // Not public: Named parameters are types, so that number_of_refinements cannot be omitted at run
    // time.
    refinements = GP::internal::default_number_of_refinements(*surface.domain().triangles());
  else // more than 30 refinements exceed all limits
    refinements = unsigned(index(number_of_refinements, "number of refinements", 31));
  py::array_t<double> likelihoods(py::ssize_t(surface.number_of_points()));
  const Output_map<Vertex, double> map{likelihoods.mutable_data(), 1};
  Computation computation(callback);
  GP::Earth_movers_cost cost;
  with_width(width,
             GP::parameters::tolerance(number(tolerance, "tolerance"))
                 .number_of_refinements(refinements)
                 .speed_map(Surface<Domain>::speed_map(speeds))
                 .callback(computation.callback()),
             [&](const auto& np) {
               computation.run([&] { cost = GP::fuzzy_geodesic(surface.domain(), p, q, map, np); });
             });
  return py::make_tuple(likelihoods, cost.value, cost.lower, cost.upper, cost.estimate,
                        cost.number_of_iterations, cost.residual, cost.is_converged);
}

// Returns the likelihoods of vertices.
template <typename Domain>
py::array_t<double> fuzzy_geodesic_by_distances(const Surface<Domain>& surface, const py::object& a,
                                                const py::object& b, const py::object& width,
                                                const py::object& speed, const py::object& callback)
{
  using Vertex = typename Surface<Domain>::Vertex;
  const auto p = read_location(surface, a), q = read_location(surface, b);
  const std::optional<Numbers> speeds = surface.vertex_speeds(speed);
  py::array_t<double> likelihoods(py::ssize_t(surface.number_of_points()));
  const Output_map<Vertex, double> map{likelihoods.mutable_data(), 1};
  Computation computation(callback);
  with_width(width,
             GP::parameters::speed_map(Surface<Domain>::speed_map(speeds))
                 .callback(computation.callback()),
             [&](const auto& np) {
               computation.run(
                   [&] { GP::fuzzy_geodesic_by_distances(surface.domain(), p, q, map, np); });
             });
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
