// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Cloud_surface.h"
#include "python/Solver.h"
#include "python/read_surface.h"
#include "python/vectors.h"

#include <CGAL/Geodesic_processing/estimate_surfels.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace python {

namespace {

template <typename Function>
auto map_of(const Function& f)
{
  return boost::make_function_property_map<std::size_t>(f);
}

// Constructs the domain of a cloud that is read by functions of an index. If `normal_of` is empty,
// normals are estimated.
std::shared_ptr<Cloud_surface>
make_surface(std::size_t size, const std::function<Kernel::Point_3(std::size_t)>& point_of,
             const std::function<Kernel::Vector_3(std::size_t)>& normal_of,
             const std::function<double(std::size_t)>& radius_of,
             const std::function<bool(double)>& callback)
{
  const Cloud cloud{size};
  std::vector<Kernel::Vector_3> estimated;
  auto given_normal_of = normal_of;
  if(!normal_of)
  {
    estimated.resize(size);
    GP::estimate_surfels<CGAL::Parallel_tag>(cloud,
                                             GP::parameters::point_map(map_of(point_of))
                                                 .normal_map(CGAL::make_property_map(estimated))
                                                 .callback(callback));
    given_normal_of = [&](std::size_t i) { return estimated[i]; };
  }
  const auto np = GP::parameters::point_map(map_of(point_of))
                      .normal_map(map_of(given_normal_of))
                      .callback(callback);
  const auto domain = [&]
  {
    return radius_of ? GP::make_domain<CGAL::Parallel_tag>(cloud, np.radius_map(map_of(radius_of)))
                     : GP::make_domain<CGAL::Parallel_tag>(cloud, np);
  };
  return std::make_shared<Cloud_surface>(domain(), size);
}

// Returns a function that reads points or vectors, or an empty function if there are none.
template <typename Value>
std::function<Value(std::size_t)> reader(const std::optional<Numbers>& numbers)
{
  if(!numbers)
    return {};
  return [&numbers = *numbers](std::size_t i)
  { return Value(numbers(i, 0), numbers(i, 1), numbers(i, 2)); };
}

std::shared_ptr<Cloud_surface> cloud_of_arrays(const py::object& P, const py::object& normals,
                                               const py::object& radii, const py::object& callback)
{
  const std::optional<Numbers> points(std::in_place, P, "P", Shape{any, 3});
  const auto size = py::ssize_t(points->size());
  std::optional<Numbers> normal_array, radius_array;
  if(!normals.is_none())
    normal_array.emplace(normals, "normals", Shape{size, 3});
  std::function<double(std::size_t)> radius_of;
  if(!radii.is_none())
  {
    radius_array.emplace(radii, "radii", Shape{size});
    radius_of = [&radius_array](std::size_t i) { return (*radius_array)(i); };
  }
  std::shared_ptr<Cloud_surface> result;
  Computation computation(callback);
  computation.run(
      [&]
      {
        result =
            make_surface(points->size(), reader<Kernel::Point_3>(points),
                         reader<Kernel::Vector_3>(normal_array), radius_of, computation.callback());
      });
  return result;
}

// Not public: Points of the caller have round-off errors when they are converted to the frame of a
// domain. No public function uses the points in this frame.
using GP::internal::Framed_surfels;

// Returns the points in the frame of the cloud, the normals and the radii, and the origin and the
// scale of the frame. The radii are None if they were not given.
py::tuple content(const Cloud_surface& surface)
{
  const Framed_surfels found = surface.domain().framed_surfels();
  py::object radii = py::none();
  if(!found.input.radii.empty())
    radii = number_array(found.input.radii);
  return py::make_tuple(point_array(found.input.points), point_array(found.input.normals), radii,
                        coordinate_array(found.frame.origin), found.frame.scale);
}

// Returns the rows of an array with three columns.
std::vector<std::array<double, 3>> rows_of(const py::object& object, const std::string& name)
{
  const Numbers numbers(object, name, {any, 3});
  std::vector<std::array<double, 3>> result;
  for(std::size_t i = 0; i < numbers.size(); ++i)
    result.push_back({numbers(i, 0), numbers(i, 1), numbers(i, 2)});
  return result;
}

// Returns the cloud of a content. Its results are those of the original cloud, to the last bit.
std::shared_ptr<Cloud_surface> cloud_of_content(const py::object& points, const py::object& normals,
                                                const py::object& radii, const py::object& origin,
                                                const py::object& scale)
{
  Framed_surfels surfels;
  surfels.input = {rows_of(points, "points"), rows_of(normals, "normals"), {}};
  if(!radii.is_none())
    surfels.input.radii = numbers_of(radii, "radii");
  const Kernel::Vector_3 o = vector(origin, "origin");
  surfels.frame = {{o[0], o[1], o[2]}, number(scale, "scale")};
  const std::size_t size = surfels.input.points.size();
  std::shared_ptr<Cloud_surface> result;
  Computation computation;
  const auto np =
      GP::parameters::number_of_threads(parse_threads(py::none())).callback(computation.callback());
  computation.run(
      [&]
      {
        result = std::make_shared<Cloud_surface>(Cloud_domain(Cloud{size}, std::move(surfels), np),
                                                 size);
      });
  return result;
}

// Returns the labels of surfels.
py::array_t<std::int64_t> voronoi(const Cloud_surface& surface, const py::object& seeds,
                                  const py::object& method, const py::object& speed,
                                  const py::object& callback)
{
  const auto sources = surface.sources(seeds, py::none());
  const std::optional<Numbers> speeds = surface.vertex_speeds(speed);
  py::array_t<std::int64_t> labels(py::ssize_t(surface.number_of_points()));
  Computation computation(callback);
  const auto np = GP::parameters::method(parse_method(method))
                      .speed_map(Cloud_surface::speed_map(speeds))
                      .callback(computation.callback());
  const auto map = label_map<std::size_t>(labels);
  computation.run(
      [&] { GP::geodesic_voronoi_diagram<Runtime_method>(surface.domain(), sources, map, np); });
  return labels;
}

} // namespace

py::object cloud_of_file(const program::Surface_file& file)
{
  const auto point_of = [&](std::size_t i)
  { return Kernel::Point_3(file.points[i][0], file.points[i][1], file.points[i][2]); };
  std::function<Kernel::Vector_3(std::size_t)> normal_of;
  if(!file.normals.empty())
    normal_of = [&](std::size_t i)
    { return Kernel::Vector_3(file.normals[i][0], file.normals[i][1], file.normals[i][2]); };
  std::function<double(std::size_t)> radius_of;
  if(const auto radii = file.properties.find("radius"); radii != file.properties.end())
    radius_of = [values = &radii->second](std::size_t i) { return (*values)[i]; };
  std::shared_ptr<Cloud_surface> result;
  Computation computation;
  computation.run(
      [&]
      {
        result = make_surface(file.points.size(), point_of, normal_of, radius_of,
                              computation.callback());
      });
  return py::cast(result);
}

void bind_cloud(py::module_& module)
{
  Cloud_class cloud = bind_surface<Cloud_domain>(module, "Cloud", "Cloud_solver");
  cloud.def("voronoi", &voronoi).def("content", &content);
  bind_atlas(cloud);
  bind_base_meshes(module, cloud);
  bind_curvature(cloud);
  bind_curves(cloud);
  bind_decals(cloud);
  bind_distortion(cloud);
  bind_features(cloud);
  bind_flattening(cloud);
  bind_fuzzy(cloud);
  bind_maps(cloud);
  bind_remeshing(cloud);
  bind_sampling(cloud);
  bind_transport(cloud);
  module.def("make_cloud", &cloud_of_arrays);
  module.def("cloud_of_content", &cloud_of_content);
}

} // namespace python
