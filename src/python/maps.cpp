// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Cloud_surface.h"
#include "python/Mesh_surface.h"
#include "python/vectors.h"

#include <CGAL/Geodesic_processing/exponential_map.h>
#include <CGAL/Geodesic_processing/karcher_mean.h>
#include <CGAL/Geodesic_processing/logarithmic_map.h>
#include <CGAL/Geodesic_processing/straightest_geodesic.h>

namespace python {

namespace {

// Returns vectors, axes, reached vertices, faces that are cut and their number, and the number of
// inverted faces. `Map` is a Logarithmic_map.
template <typename Map, typename Domain, typename NamedParameters>
py::tuple log_map_by(const Surface<Domain>& surface, const py::object& base_object,
                     const py::object& up, const NamedParameters& np)
{
  using Vertex = typename Surface<Domain>::Vertex;
  const auto base = surface.vertex_or_location(base_object);
  py::array_t<double> uv = uv_array(surface);
  const UV_output_map<Vertex> output{uv.mutable_data()};
  std::optional<Map> map;
  with_up_direction(up, np,
                    [&](const auto& parameters)
                    {
                      Computation().run(
                          [&]
                          {
                            map.emplace(surface.domain());
                            std::visit([&](const auto& b) { map->compute(b, parameters); }, base);
                            map->write(output);
                          });
                    });
  std::vector<Mesh::Face_index> cut_faces;
  if constexpr(!Surface<Domain>::is_cloud)
    map->for_each_cut_face([&](Mesh::Face_index face) { cut_faces.push_back(face); });
  return py::make_tuple(uv, frame_arrays(map->frame()), index_array(map->reached()),
                        index_array(cut_faces), map->number_of_cut_faces(), map->number_of_flips());
}

template <typename Domain>
py::tuple log_map(const Surface<Domain>& surface, const py::object& base, const py::object& radius,
                  const py::object& up, const py::object& method, const py::object& stencil_length,
                  const py::object& stencil_size, const py::object& number_of_smoothing_steps,
                  const py::object& number_of_base_refinements)
{
  using Input = typename Surface<Domain>::Input;
  const double maximum_distance =
      radius.is_none() ? std::numeric_limits<double>::infinity() : number(radius, "radius");
  const auto np =
      GP::parameters::maximum_distance(maximum_distance)
          // The default length is chosen if it is 0.
          .stencil_length(stencil_length.is_none() ? 0. : number(stencil_length, "stencil_length"))
          .stencil_size(size_number(stencil_size, "stencil_size"))
          .number_of_smoothing_steps(
              size_number(number_of_smoothing_steps, "number of smoothing steps"))
          .number_of_base_refinements(
              size_number(number_of_base_refinements, "number of base refinements"));
  const std::string name =
      py::isinstance<py::str>(method) ? method.cast<std::string>() : std::string();
  if(name == "gradient")
    return log_map_by<GP::Logarithmic_map<Input>>(surface, base, up, np);
  if(name == "discrete-exponential")
    return log_map_by<GP::Logarithmic_map<Input, GP::Discrete_exponential>>(surface, base, up, np);
  if(name != "exact")
    reject("method is not gradient, exact or discrete-exponential.");
  if constexpr(Surface<Domain>::is_cloud)
    throw GP::Unsupported_surface_error("Exact tangent vectors need a mesh, because the triangles "
                                        "of a cloud are not connected.");
  else
    return log_map_by<GP::Logarithmic_map<Input, GP::Exact>>(surface, base, up, np);
}

// Calls f with a function that returns the location of a tangent vector.
template <typename Domain, typename Base, typename NamedParameters, typename Function>
void with_exponential(const Domain& domain, const Base& base, const NamedParameters& np,
                      const Function& f)
{
  if constexpr(Surface<Domain>::is_cloud)
  {
    // It fits a surface to the cloud only once. A map of the base point alone has its axes.
    GP::Logarithmic_map<Cloud, GP::Discrete_exponential> map(domain);
    map.compute(base, np.maximum_distance(0.));
    f([&](const UV& uv) { return map.exponential(uv); });
  }
  else
    f([&](const UV& uv) { return GP::exponential_map(domain, base, uv, np); });
}

// Returns the locations of tangent vectors.
template <typename Domain>
py::tuple exp_map(const Surface<Domain>& surface, const py::object& base_object,
                  const py::object& uv, const py::object& up)
{
  const auto base = surface.vertex_or_location(base_object);
  const Numbers vectors(uv, "uv", {any, 2});
  std::vector<typename Surface<Domain>::Location> result;
  result.reserve(vectors.size());
  Computation computation;
  const auto proceed = computation.callback();
  const auto append_locations = [&](const auto& exponential)
  {
    for(std::size_t i = 0; i < vectors.size(); ++i)
    {
      if(!proceed(double(i) / double(vectors.size())))
        throw GP::Cancelled();
      result.push_back(exponential(UV{vectors(i, 0), vectors(i, 1)}));
    }
  };
  with_up_direction(up, GP::parameters::number_of_threads(1u),
                    [&](const auto& np)
                    {
                      computation.run(
                          [&]
                          {
                            std::visit(
                                [&](const auto& b)
                                { with_exponential(surface.domain(), b, np, append_locations); },
                                base);
                          });
                    });
  return Surface<Domain>::location_arrays(result);
}

// Returns points, indices, coordinates, the length, and whether the path is cut.
template <typename Domain>
py::tuple trace(const Surface<Domain>& surface, const py::object& start, const py::object& vector_,
                const py::object& length)
{
  const auto from = surface.vertex_or_location(start);
  const Kernel::Vector_3 direction = vector(vector_, "vector");
  const double path_length = length.is_none()
                                 ? std::hypot(direction.x(), direction.y(), direction.z())
                                 : number(length, "length");
  GP::Straightest_geodesic<typename Surface<Domain>::Input> path;
  Computation().run(
      [&]
      {
        path = std::visit(
            [&](const auto& location) {
              return GP::straightest_geodesic(surface.domain(), location, direction, path_length);
            },
            from);
      });
  return py::make_tuple(point_array(path.points), Surface<Domain>::location_arrays(path.locations),
                        path.length, path.is_cut_by_boundary);
}

std::vector<double> weights_of(const py::object& weights, std::size_t size)
{
  std::vector<double> result(size, 1.);
  if(!weights.is_none())
  {
    const Numbers values(weights, "weights", {py::ssize_t(size)});
    for(std::size_t i = 0; i < size; ++i)
      result[i] = values(i);
  }
  return result;
}

// Calls f with named parameters, to which `initial_location` is added if it is not None.
template <typename Domain, typename NamedParameters, typename Function>
void with_initial_location(const Surface<Domain>& surface, const py::object& initial_location,
                           const NamedParameters& np, const Function& f)
{
  if(initial_location.is_none())
    return f(np);
  std::visit([&](const auto& location) { f(np.initial_location(location)); },
             surface.vertex_or_location(initial_location));
}

// Returns the location, the point and the other members of the mean.
template <typename Domain>
py::tuple karcher_mean(const Surface<Domain>& surface, const py::object& points,
                       const py::object& weights, const py::object& initial_location,
                       const py::object& tolerance, const py::object& max_iterations,
                       const py::object& threads, const py::object& callback)
{
  constexpr bool is_cloud = Surface<Domain>::is_cloud;
  const auto positions = surface.vertices_or_locations(points, "points");
  // The defaults of the library
  const double default_tolerance = is_cloud ? 1e-5 : 1e-8;
  Computation computation(callback);
  const auto np =
      GP::parameters::weights(weights_of(weights, positions.size()))
          .tolerance(tolerance.is_none() ? default_tolerance : number(tolerance, "tolerance"))
          .maximum_number_of_iterations(size_number(max_iterations, "number of iterations"))
          .number_of_threads(parse_threads(threads))
          .callback(computation.callback());
  GP::Karcher_mean<typename Surface<Domain>::Input> mean;
  with_initial_location(
      surface, initial_location, np,
      [&](const auto& parameters)
      {
        Surface<Domain>::with_targets(
            positions,
            [&](const auto& range) {
              computation.run([&]
                              { mean = GP::karcher_mean(surface.domain(), range, parameters); });
            },
            "points");
      });
  return py::make_tuple(Surface<Domain>::location_arrays({mean.location}),
                        coordinate_array(mean.point), mean.value, mean.gradient_norm,
                        mean.is_converged, mean.number_of_iterations);
}

template <typename Domain>
void bind(py::class_<Surface<Domain>, std::shared_ptr<Surface<Domain>>>& surface)
{
  surface.def("log_map", &log_map<Domain>)
      .def("exp_map", &exp_map<Domain>)
      .def("trace", &trace<Domain>)
      .def("karcher_mean", &karcher_mean<Domain>);
}

} // namespace

void bind_maps(Mesh_class& mesh) { bind<Mesh_domain>(mesh); }
void bind_maps(Cloud_class& cloud) { bind<Cloud_domain>(cloud); }

} // namespace python
