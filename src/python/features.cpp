// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Cloud_surface.h"
#include "python/Mesh_surface.h"

#include <CGAL/Geodesic_processing/feature_distance.h>

#include <cstddef>
#include <optional>

namespace python {

namespace {

// Returns the distances, and the integral: value, bounds, estimate, number of iterations, residual,
// and whether it has converged.
template <typename Domain>
py::tuple feature_distance(const Surface<Domain>& surface, const py::object& feature,
                           bool do_fix_masses, const py::object& speed,
                           const py::object& refinements, const py::object& tolerance,
                           const py::object& callback)
{
  const auto sources = surface.sources(feature, py::none());
  const std::optional<Numbers> speeds = surface.vertex_speeds(speed);
  std::optional<unsigned> number_of_refinements;
  if(!refinements.is_none())
    number_of_refinements = unsigned(index(refinements, "number of refinements", 17));
  py::array_t<double> distances(py::ssize_t(surface.number_of_points()));
  const Output_map<typename Surface<Domain>::Vertex, double> map{distances.mutable_data(), 1};
  Computation computation(callback);
  const auto np = GP::parameters::do_fix_masses(do_fix_masses)
                      .speed_map(Surface<Domain>::speed_map(speeds))
                      .number_of_refinements(number_of_refinements)
                      .tolerance(number(tolerance, "tolerance"))
                      .callback(computation.callback());
  GP::Earth_movers_cost cost;
  computation.run([&] { cost = GP::feature_distance(surface.domain(), sources, map, np); });
  return py::make_tuple(distances, cost.value, cost.lower, cost.upper, cost.estimate,
                        cost.number_of_iterations, cost.residual, cost.is_converged);
}

} // namespace

void bind_features(Mesh_class& mesh)
{
  mesh.def("feature_distance", &feature_distance<Mesh_domain>);
}

void bind_features(Cloud_class& cloud)
{
  cloud.def("feature_distance", &feature_distance<Cloud_domain>);
}

} // namespace python
