// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Cloud_surface.h"
#include "python/Mesh_surface.h"
#include "python/Vector_map.h"
#include "python/transport_arguments.h"

#include <CGAL/Geodesic_processing/Region_transport_solver.h>
#include <CGAL/Geodesic_processing/Transport_barycenter_solver.h>
#include <CGAL/Geodesic_processing/Transport_metric.h>
#include <CGAL/Geodesic_processing/geodesic_barycenter.h>
#include <CGAL/Geodesic_processing/hodge_decomposition.h>

namespace python {

namespace {

// Returns the number of vectors of a field: those of faces or surfels.
template <typename Domain>
std::size_t field_size(const Surface<Domain>& surface)
{
  return Surface<Domain>::is_cloud ? surface.number_of_points() : surface.number_of_faces();
}

// The keys of a field.
template <typename Domain>
using Field_key =
    std::conditional_t<Surface<Domain>::is_cloud, std::size_t, typename Mesh::Face_index>;

// The arrays to which a solution is written.
template <typename Domain>
struct Solution_arrays
{
  explicit Solution_arrays(const Surface<Domain>& surface)
      : potential(py::ssize_t(surface.number_of_points())), flow(vector_array(field_size(surface)))
  {}
  template <typename Solution>
  void write(const Solution& solution)
  {
    solution.write_potential(potential_map);
    solution.write_flow(flow_map);
  }

  py::array_t<double> potential, flow;
  // Their addresses are read here, because the solution is written without the GIL.
  Output_map<typename Surface<Domain>::Vertex, double> potential_map{potential.mutable_data(), 1};
  Vector_output_map<Field_key<Domain>> flow_map{flow.mutable_data()};
};

// Returns the cost, the potential and the flow of a transport between two mass distributions.
template <typename Domain>
py::tuple emd(const Surface<Domain>& surface, const py::tuple& from, const py::tuple& to,
              const py::tuple& setup_arguments, const py::tuple& query_arguments,
              const py::object& callback)
{
  const Mass_distribution a = mass_distribution(surface, from, "a"),
                          b = mass_distribution(surface, to, "b");
  const Transport_setup<Domain> setup(surface, setup_arguments);
  const Transport_query query(query_arguments);
  Solution_arrays<Domain> arrays(surface);
  GP::Earth_movers_cost cost;
  Computation computation(callback);
  const auto np = setup.parameters();
  computation.run(
      [&]
      {
        GP::Earth_movers_solver<typename Surface<Domain>::Input> solver(surface.domain(), np);
        cost = query.compute(solver, computation, a, b);
        arrays.write(solver);
      });
  return py::make_tuple(cost_tuple(cost), arrays.potential, arrays.flow);
}

GP::Transport_flow parse_transport_flow(const py::object& name, std::size_t basis_size)
{
  if(name.is_none())
    return basis_size == 0 ? GP::Transport_flow::gradient : GP::Transport_flow::balanced;
  if(py::isinstance<py::str>(name))
  {
    if(name.cast<std::string>() == "gradient")
      return GP::Transport_flow::gradient;
    if(name.cast<std::string>() == "balanced")
      return GP::Transport_flow::balanced;
  }
  reject("transport_flow is not gradient or balanced.");
}

// Returns the cost, the flow and the number of eigenfunctions of a transport whose flow is
// restricted to a basis.
template <typename Domain>
py::tuple spectral_emd(const Surface<Domain>& surface, const py::tuple& from, const py::tuple& to,
                       const py::object& basis, const py::object& transport_flow,
                       const py::object& tolerance, const py::object& maximum, bool do_normalize,
                       const py::object& callback)
{
  const Mass_distribution a = mass_distribution(surface, from, "a"),
                          b = mass_distribution(surface, to, "b");
  // No basis has more eigenfunctions than the surface has points.
  const std::size_t requested_size =
      index(basis, "number of eigenfunctions", surface.number_of_points() + 1);
  const auto kind =
      GP::parameters::transport_flow(parse_transport_flow(transport_flow, requested_size));
  const double relative_gap = number(tolerance, "tolerance");
  const unsigned iterations = max_iterations(maximum);
  py::array_t<double> flow = vector_array(field_size(surface));
  const Vector_output_map<Field_key<Domain>> flow_map{flow.mutable_data()};
  std::size_t basis_size = 0;
  GP::Earth_movers_cost cost;
  Computation computation(callback);
  const auto np = GP::parameters::tolerance(relative_gap)
                      .maximum_number_of_iterations(iterations)
                      .do_normalize(do_normalize)
                      .flow_map(flow_map)
                      .callback(computation.callback());
  computation.run(
      [&]
      {
        const GP::Transport_metric<typename Surface<Domain>::Input> metric(surface.domain(),
                                                                           requested_size, kind);
        cost = metric.cost(a, b, np);
        basis_size = metric.basis_size();
      });
  return py::make_tuple(cost_tuple(cost), flow, basis_size);
}

// Returns the bounds of the cost, the distances, how the computation ended, and the masses and the
// density of the barycenter.
template <typename Domain>
py::tuple barycenter(const Surface<Domain>& surface, const py::list& masses,
                     const py::object& weights, const py::tuple& setup_arguments,
                     const py::object& tolerance, const py::object& maximum, bool do_normalize,
                     const py::object& callback)
{
  std::vector<Mass_distribution> given;
  for(const py::handle pair : masses)
    given.push_back(mass_distribution(surface, py::reinterpret_borrow<py::tuple>(pair), "masses"));
  const Transport_setup<Domain> setup(surface, setup_arguments);
  py::array_t<double> result(py::ssize_t(surface.number_of_points())), density(result.size());
  using Map = Output_map<typename Surface<Domain>::Vertex, double>;
  const Map mass_map{result.mutable_data(), 1}, density_map{density.mutable_data(), 1};
  GP::Transport_barycenter_cost cost;
  Computation computation(callback);
  const auto query = GP::parameters::weights(weights_of(weights, given.size()))
                         .tolerance(number(tolerance, "tolerance"))
                         .maximum_number_of_iterations(max_iterations(maximum))
                         .do_normalize(do_normalize)
                         .callback(computation.callback());
  const auto np = setup.parameters();
  computation.run(
      [&]
      {
        GP::Transport_barycenter_solver<typename Surface<Domain>::Input> solver(surface.domain(),
                                                                                np);
        cost = solver.compute(given, query);
        solver.write_masses(mass_map);
        solver.write_density(density_map);
      });
  return py::make_tuple(
      cost.value, cost.lower, cost.upper,
      py::array_t<double>(py::ssize_t(cost.distances.size()), cost.distances.data()),
      cost.number_of_iterations, cost.residual, cost.is_converged, result, density);
}

// Returns the vertex, the value and the weighted sum of squared distances at each vertex.
template <typename Domain>
py::tuple geodesic_barycenter(const Surface<Domain>& surface, const py::object& locations,
                              const py::object& weights, const py::object& method,
                              const py::object& speed, const py::object& face_speed,
                              const py::object& callback)
{
  using Vertex = typename Surface<Domain>::Vertex;
  const auto positions = surface.sources(locations, py::none());
  const Speeds<Domain> speeds(surface, speed, face_speed);
  py::array_t<double> objective(py::ssize_t(surface.number_of_points()));
  Computation computation(callback);
  const auto np =
      speeds.add_to(GP::parameters::weights(weights_of(weights, positions.size()))
                        .method(parse_method(method))
                        .objective_map(Output_map<Vertex, double>{objective.mutable_data(), 1})
                        .callback(computation.callback()));
  std::optional<GP::Geodesic_barycenter<Vertex>> result;
  computation.run(
      [&] { result = GP::geodesic_barycenter<Runtime_method>(surface.domain(), positions, np); });
  return py::make_tuple(std::size_t(result->vertex), result->value, objective);
}

// Reads the capacities of a region. There are no limits if the result is empty.
std::vector<double> capacities_of(const py::object& capacities, std::size_t number_of_exits)
{
  return capacities.is_none() ? std::vector<double>()
                              : numbers_of(capacities, "capacities", py::ssize_t(number_of_exits));
}

// Returns the cost, the arriving masses, the potential and the flow of a transport to a region.
template <typename Domain>
py::tuple transport_to_region(const Surface<Domain>& surface, const py::tuple& masses,
                              const py::object& region, const py::object& capacities,
                              const py::object& spreading_weight, const py::tuple& setup_arguments,
                              const py::tuple& query_arguments, const py::object& callback)
{
  const Mass_distribution from = mass_distribution(surface, masses, "masses");
  const auto exits = surface.sources(region, py::none());
  const std::vector<double> limits = capacities_of(capacities, exits.size());
  const double weight = number(spreading_weight, "spreading_weight");
  const Transport_setup<Domain> setup(surface, setup_arguments);
  const Transport_query query(query_arguments);
  Solution_arrays<Domain> arrays(surface);
  py::array_t<double> arrivals(py::ssize_t(surface.number_of_points()));
  const Output_map<typename Surface<Domain>::Vertex, double> arrival_map{arrivals.mutable_data(),
                                                                         1};
  GP::Earth_movers_cost cost;
  Computation computation(callback);
  const auto np = setup.parameters();
  computation.run(
      [&]
      {
        GP::Region_transport_solver<typename Surface<Domain>::Input> solver(
            surface.domain(), exits, np.capacities(limits).spreading_weight(weight));
        cost = query.compute(solver, computation, from);
        arrays.write(solver);
        solver.write_arrivals(arrival_map);
      });
  return py::make_tuple(cost_tuple(cost), arrivals, arrays.potential, arrays.flow);
}

// Returns for each streamline its path, and whether it has arrived. There are as many streamlines
// as seeds, or `count` of them if there are no seeds.
template <typename Domain>
py::list streamlines(const Surface<Domain>& surface, const py::tuple& from, const py::tuple& to,
                     const py::object& count, const py::object& seed_list, bool do_straighten,
                     const py::tuple& setup_arguments, const py::tuple& query_arguments,
                     const py::object& callback)
{
  using Input = typename Surface<Domain>::Input;
  const Mass_distribution a = mass_distribution(surface, from, "a"),
                          b = mass_distribution(surface, to, "b");
  const std::size_t number_of_lines =
      count.is_none() ? 0 : index(count, "number of streamlines", std::size_t(1) << 31);
  std::vector<typename Surface<Domain>::Vertex_or_location> seeds;
  if(!seed_list.is_none())
    seeds = surface.vertices_or_locations(seed_list, "seeds");
  const Transport_setup<Domain> setup(surface, setup_arguments);
  const Transport_query query(query_arguments);
  std::vector<GP::Streamline<Input>> lines;
  Computation computation(callback);
  const auto np = setup.parameters();
  computation.run(
      [&]
      {
        GP::Earth_movers_solver<Input> solver(surface.domain(), np);
        query.compute(solver, computation, a, b);
        const auto trace = solver.streamlines(GP::parameters::do_straighten(do_straighten));
        if(seeds.empty())
          trace(number_of_lines, std::back_inserter(lines));
        for(const auto& seed : seeds)
          std::visit([&](const auto& position) { lines.push_back(trace(position)); }, seed);
      });
  py::list result;
  for(const auto& line : lines)
    result.append(py::make_tuple(Surface<Domain>::path_arrays(line), line.has_arrived));
  return result;
}

// Returns the components of a field on a mesh and their potentials.
py::tuple hodge_decomposition(const Mesh_surface& surface, const py::object& field)
{
  using Vertex = Mesh_surface::Vertex;
  using Face = Mesh::Face_index;
  const std::size_t size = surface.number_of_faces();
  const Numbers vectors(field, "field", {py::ssize_t(size), 3});
  py::array_t<double> gradient = vector_array(size), rotation = vector_array(size),
                      harmonic = vector_array(size);
  py::array_t<double> gradient_potential(py::ssize_t(surface.number_of_points()));
  py::array_t<double> vertex_rotation_potential(gradient_potential.size());
  const Vector_output_map<Face> gradient_map{gradient.mutable_data()},
      rotation_map{rotation.mutable_data()}, harmonic_map{harmonic.mutable_data()};
  std::vector<double> rotation_potential;
  const auto potentials = GP::parameters::gradient_potential_map(
                              Output_map<Vertex, double>{gradient_potential.mutable_data(), 1})
                              .vertex_rotation_potential_map(Output_map<Vertex, double>{
                                  vertex_rotation_potential.mutable_data(), 1});
  Computation().run(
      [&]
      {
        rotation_potential.resize(surface.domain().mesh().number_of_edges());
        GP::hodge_decomposition(
            surface.domain(), Vector_map<Face>{&vectors}, gradient_map, rotation_map, harmonic_map,
            potentials.rotation_potential_map(
                Output_map<Mesh::Edge_index, double>{rotation_potential.data(), 1}));
      });
  const Mesh& mesh = surface.domain().mesh();
  const std::vector<Mesh::Edge_index> edges(mesh.edges().begin(), mesh.edges().end());
  return py::make_tuple(
      gradient, rotation, harmonic, gradient_potential, edge_array(mesh, edges),
      py::array_t<double>(py::ssize_t(rotation_potential.size()), rotation_potential.data()),
      vertex_rotation_potential);
}

// Returns the gradient component of a field on a cloud, the remainder and the potential.
py::tuple hodge_decomposition(const Cloud_surface& surface, const py::object& field)
{
  const std::size_t size = surface.number_of_points();
  const Numbers vectors(field, "field", {py::ssize_t(size), 3});
  py::array_t<double> gradient = vector_array(size), remainder = vector_array(size);
  py::array_t<double> potential{Shape{py::ssize_t(size)}};
  const Vector_output_map<std::size_t> gradient_map{gradient.mutable_data()},
      remainder_map{remainder.mutable_data()};
  const Output_map<std::size_t, double> potential_map{potential.mutable_data(), 1};
  Computation().run(
      [&]
      {
        GP::hodge_decomposition(surface.domain(), Vector_map<std::size_t>{&vectors}, gradient_map,
                                remainder_map,
                                GP::parameters::gradient_potential_map(potential_map));
      });
  return py::make_tuple(gradient, remainder, potential);
}

// Adds the functions that meshes and clouds share.
template <typename Domain, typename Class>
void bind_transport_of(Class& surface)
{
  surface.def("emd", &emd<Domain>)
      .def("spectral_emd", &spectral_emd<Domain>)
      .def("barycenter", &barycenter<Domain>)
      .def("geodesic_barycenter", &geodesic_barycenter<Domain>)
      .def("transport_to_region", &transport_to_region<Domain>)
      .def("streamlines", &streamlines<Domain>)
      .def("hodge_decomposition", [](const Surface<Domain>& self, const py::object& field)
           { return hodge_decomposition(self, field); });
}

} // namespace

void bind_transport(Mesh_class& mesh) { bind_transport_of<Mesh_domain>(mesh); }
void bind_transport(Cloud_class& cloud) { bind_transport_of<Cloud_domain>(cloud); }

} // namespace python
