// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Cloud_surface.h"
#include "python/Mesh_surface.h"

#include <CGAL/Geodesic_processing/distortion.h>
#include <CGAL/Geodesic_processing/minimize_distortion.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace python {

namespace {

// The images of vertices or surfels in the plane: the rows of an array.
template <typename Key>
struct UV_map
{
  using key_type = Key;
  using value_type = std::array<double, 2>;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  const Numbers* numbers;

  friend value_type get(const UV_map& map, Key key)
  {
    return {(*map.numbers)(std::size_t(key), 0), (*map.numbers)(std::size_t(key), 1)};
  }
};

// The images of the corners of faces: row 3 f + k is the image of corner k of face f, which the
// halfedge points to.
struct Corner_uv_map
{
  using key_type = Mesh::Halfedge_index;
  using value_type = std::array<double, 2>;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  const Mesh* mesh;
  const Numbers* numbers;

  friend value_type get(const Corner_uv_map& map, Mesh::Halfedge_index h)
  {
    const Mesh::Face_index face = map.mesh->face(h);
    // The halfedge of a face starts at corner 0 and points to corner 1.
    const Mesh::Halfedge_index first = map.mesh->halfedge(face);
    const std::size_t k = h == first ? 1 : h == map.mesh->next(first) ? 2 : 0;
    const std::size_t row = 3 * std::size_t(face) + k;
    return {(*map.numbers)(row, 0), (*map.numbers)(row, 1)};
  }
};

// The images of vertices in an array in C order, which are read and written.
struct UV_array_map
{
  using key_type = Mesh::Vertex_index;
  using value_type = std::array<double, 2>;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;

  double* data;

  friend value_type get(const UV_array_map& map, Mesh::Vertex_index v)
  {
    return {map.data[2 * std::size_t(v)], map.data[2 * std::size_t(v) + 1]};
  }
  friend void put(const UV_array_map& map, Mesh::Vertex_index v, const value_type& uv)
  {
    std::copy(uv.begin(), uv.end(), map.data + 2 * std::size_t(v));
  }
};

// Reads a UV map, and calls f(map). If `has_corners`, its rows are the corners of the faces.
template <typename Domain, typename Function>
void with_uv_map(const Surface<Domain>& surface, const py::object& uv, bool has_corners,
                 const Function& f)
{
  const std::size_t size = has_corners ? 3 * surface.number_of_faces() : surface.number_of_points();
  const Numbers numbers(uv, "uv", {py::ssize_t(size), 2});
  if constexpr(!Surface<Domain>::is_cloud)
    if(has_corners)
      return Computation().run([&] { f(Corner_uv_map{&surface.domain().mesh(), &numbers}); });
  Computation().run([&] { f(UV_map<typename Surface<Domain>::Vertex>{&numbers}); });
}

std::function<double(const GP::Face_distortion&)> parse_measure(const py::object& measure)
{
  using Measure = double (GP::Face_distortion::*)() const;
  using Face = GP::Face_distortion;
  return choice<Measure>(measure, "measure",
                         {{"mips", &Face::mips},
                          {"symmetric-mips", &Face::symmetric_mips},
                          {"conformal", &Face::conformal},
                          {"green-lagrange", &Face::green_lagrange},
                          {"dirichlet", &Face::dirichlet},
                          {"l2-stretch", &Face::l2_stretch},
                          {"linf-stretch", &Face::linf_stretch},
                          {"symmetric-stretch", &Face::symmetric_stretch},
                          {"symmetric-dirichlet", &Face::symmetric_dirichlet},
                          {"riemannian", &Face::riemannian}});
}

// Returns the integral, the area, the mean, the maximum, the location of the maximum, and the
// numbers of triangles and of flips.
template <typename Domain>
py::tuple surface_distortion(const Surface<Domain>& surface, const py::object& uv, bool has_corners,
                             const py::object& measure)
{
  const auto function = parse_measure(measure);
  GP::Surface_distortion<typename Surface<Domain>::Input> found;
  with_uv_map(surface, uv, has_corners,
              [&](const auto& map)
              { found = GP::surface_distortion(surface.domain(), map, function); });
  std::vector<typename Surface<Domain>::Location> location;
  if(found.number_of_triangles > 0)
    location.push_back(found.worst_location);
  return py::make_tuple(found.integral, found.area, found.mean(), found.worst,
                        Surface<Domain>::location_arrays(location), found.number_of_triangles,
                        found.number_of_flips);
}

// Returns the singular values, whether the images are inverted, and the areas of all faces.
py::tuple face_distortion(const Mesh_surface& surface, const py::object& uv, bool has_corners)
{
  const auto size = py::ssize_t(surface.number_of_faces());
  py::array_t<double> sigma_1(size), sigma_2(size), area(size);
  py::array_t<bool> is_inverted(size);
  double *const first = sigma_1.mutable_data(), *const second = sigma_2.mutable_data(),
                *const areas = area.mutable_data();
  bool* const flags = is_inverted.mutable_data();
  with_uv_map(surface, uv, has_corners,
              [&](const auto& map)
              {
                for(std::size_t f = 0; f < surface.number_of_faces(); ++f)
                {
                  const GP::Face_distortion found = GP::face_distortion(
                      Mesh::Face_index(Mesh::size_type(f)), surface.domain(), map);
                  first[f] = found.sigma_1;
                  second[f] = found.sigma_2;
                  flags[f] = found.is_inverted;
                  areas[f] = found.area;
                }
              });
  return py::make_tuple(sigma_1, sigma_2, is_inverted, area);
}

// Returns the images of the vertices, the numbers of flips before and after, the number of
// iterations, and the energy.
py::tuple minimize_distortion(const Mesh_surface& surface, const py::object& uv,
                              const py::object& max_iterations, const py::object& callback)
{
  const auto size = py::ssize_t(surface.number_of_points());
  const Numbers numbers(uv, "uv", {size, 2});
  py::array_t<double> result(Shape{size, 2});
  double* const data = result.mutable_data();
  for(std::size_t i = 0; i < numbers.size(); ++i)
    for(std::size_t k = 0; k < 2; ++k)
      data[2 * i + k] = numbers(i, k);
  Computation computation(callback);
  const auto np = GP::parameters::maximum_number_of_iterations(
                      index(max_iterations, "number of iterations", std::size_t(1) << 32))
                      .callback(computation.callback());
  GP::Distortion_minimum found;
  computation.run([&]
                  { found = GP::minimize_distortion(surface.domain(), UV_array_map{data}, np); });
  return py::make_tuple(result, found.number_of_flips_before, found.number_of_flips,
                        found.number_of_iterations, found.symmetric_dirichlet);
}

} // namespace

void bind_distortion(Mesh_class& mesh)
{
  mesh.def("surface_distortion", &surface_distortion<Mesh_domain>)
      .def("face_distortion", &face_distortion)
      .def("minimize_distortion", &minimize_distortion);
}

void bind_distortion(Cloud_class& cloud)
{
  cloud.def("surface_distortion", &surface_distortion<Cloud_domain>);
}

} // namespace python
