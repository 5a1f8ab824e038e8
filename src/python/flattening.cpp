// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Cloud_surface.h"
#include "python/Mesh_surface.h"
#include "python/corner_maps.h"
#include "python/vectors.h"

#include <CGAL/Geodesic_processing/distortion.h>
#include <CGAL/Geodesic_processing/geodesic_lle.h>
#include <CGAL/Geodesic_processing/geodesic_mds.h>
#include <CGAL/Geodesic_processing/mean_value_coordinates.h>
#include <CGAL/Geodesic_processing/minimize_distortion.h>

#include <functional>

namespace python {

namespace {

GP::Flattening_start parse_start(const py::object& name)
{
  return choice<GP::Flattening_start>(name, "flattening_start",
                                      {{"best", GP::Flattening_start::best},
                                       {"lle", GP::Flattening_start::lle},
                                       {"mds", GP::Flattening_start::mds}});
}

// Calls f with named parameters, to which the base points or their number are added unless they are
// None.
template <typename Domain, typename NamedParameters, typename Function>
void with_base_points(const Surface<Domain>& surface, const py::object& count,
                      const py::object& base_points, const NamedParameters& np, const Function& f)
{
  if(!count.is_none() && !base_points.is_none())
    reject("number_of_base_points and base_points cannot be combined.");
  if(!count.is_none())
    return f(np.number_of_base_points(size_number(count, "number of base points")));
  if(base_points.is_none())
    return f(np);
  const Integers vertices(base_points, "base_points", {any});
  std::vector<typename Surface<Domain>::Vertex> result;
  for(std::size_t i = 0; i < vertices.size(); ++i)
    result.push_back(
        surface.vertex(checked_index(vertices(i), "vertex", surface.number_of_points())));
  f(np.base_points(result));
}

// Returns a callback that maps the completed fraction of one of two stages.
std::function<bool(double)> stage(const std::function<bool(double)>& callback, double begin,
                                  double end)
{
  return [=](double fraction) { return callback(begin + fraction * (end - begin)); };
}

// Returns the image of each vertex, and the base points. If `is_injective`, a mesh is flattened
// without inverted faces.
template <typename Domain>
py::tuple lle(const Surface<Domain>& surface, bool is_injective, const py::object& count,
              const py::object& base_points, const py::object& neighbors, const py::object& start,
              const py::object& rigid_steps, const py::object& method, const py::object& seed,
              const py::object& callback)
{
  using Vertex = typename Surface<Domain>::Vertex;
  py::array_t<double> uv = uv_array(surface);
  const UV_output_map<Vertex> map{uv.mutable_data()};
  std::vector<Vertex> found;
  Computation computation(callback);
  const auto progress = computation.callback();
  const auto np = GP::parameters::flattening_start(parse_start(start))
                      .number_of_rigid_steps(size_number(rigid_steps, "number of rigid steps"))
                      .method(parse_method(method))
                      .random_seed(unsigned(size_number(seed, "seed")))
                      .callback(stage(progress, 0., is_injective ? 0.5 : 1.));
  const auto flatten = [&](const auto& parameters)
  {
    computation.run(
        [&]
        {
          found = GP::geodesic_lle<Runtime_method>(surface.domain(), map, parameters);
          if constexpr(!Surface<Domain>::is_cloud)
            if(is_injective)
              GP::minimize_distortion(surface.domain(), map,
                                      GP::parameters::callback(stage(progress, 0.5, 1.)));
        });
  };
  with_base_points(
      surface, count, base_points, np,
      [&](const auto& parameters)
      {
        if(neighbors.is_none())
          flatten(parameters);
        else
          flatten(parameters.number_of_neighbors(size_number(neighbors, "number of neighbors")));
      });
  return py::make_tuple(uv, index_array(found));
}

// Returns the image of each vertex, and the base points.
template <typename Domain>
py::tuple mds(const Surface<Domain>& surface, const py::object& count,
              const py::object& base_points, const py::object& method, const py::object& seed,
              const py::object& callback)
{
  using Vertex = typename Surface<Domain>::Vertex;
  py::array_t<double> uv = uv_array(surface);
  const UV_output_map<Vertex> map{uv.mutable_data()};
  std::vector<Vertex> found;
  Computation computation(callback);
  with_base_points(surface, count, base_points,
                   GP::parameters::random_seed(unsigned(size_number(seed, "seed")))
                       .method(parse_method(method))
                       .callback(computation.callback()),
                   [&](const auto& np) {
                     computation.run(
                         [&]
                         { found = GP::geodesic_mds<Runtime_method>(surface.domain(), map, np); });
                   });
  return py::make_tuple(uv, index_array(found));
}

template <typename Domain, typename UVMap>
py::tuple distortion_of(const Surface<Domain>& surface, const UVMap& map)
{
  GP::Flattening_distortion result;
  Computation().run([&] { result = GP::flattening_distortion(surface.domain(), map); });
  return py::make_tuple(result.conformal, result.authalic, result.symmetric_dirichlet,
                        result.l2_stretch, result.linf_stretch, result.number_of_flips,
                        result.number_of_triangles);
}

// Returns the members of Flattening_distortion for the images of vertices.
template <typename Domain>
py::tuple flattening_distortion(const Surface<Domain>& surface, const py::object& uv)
{
  const Numbers values(uv, "uv", {py::ssize_t(surface.number_of_points()), 2});
  return distortion_of(surface, UV_map<typename Surface<Domain>::Vertex>{&values});
}

// Returns the members of Flattening_distortion for the images of corners.
py::tuple corner_distortion(const Mesh_surface& surface, const py::object& corner_uv)
{
  const Numbers values(corner_uv, "uv", {py::ssize_t(surface.number_of_faces()), 6});
  return distortion_of(surface, Corner_map(surface.domain(), values));
}

// Returns a row of coordinates for each point.
py::array_t<double> mean_value_coordinates(const Mesh_surface& surface, const py::object& points,
                                           const py::object& callback)
{
  const Numbers numbers(points, "points", {any, 3});
  const std::size_t row_size = surface.number_of_points();
  py::array_t<double> result(Shape{py::ssize_t(numbers.size()), py::ssize_t(row_size)});
  double* row = result.mutable_data();
  Computation computation(callback);
  const auto proceed = computation.callback();
  computation.run(
      [&]
      {
        for(std::size_t i = 0; i < numbers.size(); ++i, row += row_size)
        {
          if(!proceed(double(i) / double(numbers.size())))
            throw GP::Cancelled();
          const Kernel::Point_3 point(numbers(i, 0), numbers(i, 1), numbers(i, 2));
          GP::mean_value_coordinates(surface.domain(), point,
                                     Output_map<Mesh_surface::Vertex, double>{row, 1});
        }
      });
  return result;
}

template <typename Domain>
void bind(py::class_<Surface<Domain>, std::shared_ptr<Surface<Domain>>>& surface)
{
  surface.def("lle", &lle<Domain>)
      .def("mds", &mds<Domain>)
      .def("flattening_distortion", &flattening_distortion<Domain>);
}

} // namespace

void bind_flattening(Mesh_class& mesh)
{
  bind<Mesh_domain>(mesh);
  mesh.def("corner_distortion", &corner_distortion)
      .def("mean_value_coordinates", &mean_value_coordinates);
}
void bind_flattening(Cloud_class& cloud) { bind<Cloud_domain>(cloud); }

} // namespace python
