// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Cloud_surface.h"
#include "python/Mesh_surface.h"

#include <CGAL/Geodesic_processing/speeds.h>

#include <array>
#include <cstddef>
#include <memory>
#include <utility>

namespace python {

namespace {

// Writes curvatures to arrays in C order.
template <typename Surface_type>
struct Curvature_map
{
  using key_type = typename Surface_type::Vertex;
  using value_type = GP::Principal_curvatures<typename Surface_type::Input>;
  using reference = value_type&;
  using category = boost::writable_property_map_tag;

  double *min_curvature, *max_curvature, *min_direction, *max_direction;

  friend void put(const Curvature_map& map, key_type vertex, const value_type& value)
  {
    const auto i = std::size_t(vertex);
    map.min_curvature[i] = value.min_curvature;
    map.max_curvature[i] = value.max_curvature;
    for(int k = 0; k < 3; ++k)
    {
      map.min_direction[3 * i + std::size_t(k)] = value.min_direction[k];
      map.max_direction[3 * i + std::size_t(k)] = value.max_direction[k];
    }
  }
};

// An image on a surface: each row of an array is a color.
template <typename Key>
struct Color_map
{
  using key_type = Key;
  using value_type = std::array<double, 3>;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  const Numbers* numbers;

  friend value_type get(const Color_map& map, Key key)
  {
    const Numbers& rows = *map.numbers;
    const auto i = std::size_t(key);
    return {rows(i, 0), rows(i, 1), rows(i, 2)};
  }
};

// Calls f(np) with the strength in the named parameters, if it is given.
template <typename NamedParameters, typename Function>
void with_strength(const py::object& strength, const NamedParameters& np, const Function& f)
{
  if(strength.is_none())
    f(np);
  else
    f(np.strength(number(strength, "strength")));
}

// Returns the radius of the ball; by default 0, for which the library selects the radius.
double parse_radius(const py::object& radius)
{
  return radius.is_none() ? 0. : number(radius, "ball_radius");
}

// Returns the minimum and maximum curvatures and their directions.
template <typename Domain>
py::tuple principal_curvatures(const Surface<Domain>& surface, const py::object& radius,
                               const py::object& threads)
{
  const auto size = py::ssize_t(surface.number_of_points());
  py::array_t<double> min_curvature(size), max_curvature(size), min_direction(Shape{size, 3}),
      max_direction(Shape{size, 3});
  const Curvature_map<Surface<Domain>> map{
      min_curvature.mutable_data(), max_curvature.mutable_data(), min_direction.mutable_data(),
      max_direction.mutable_data()};
  const auto np =
      GP::parameters::ball_radius(parse_radius(radius)).number_of_threads(parse_threads(threads));
  Computation().run([&]
                    { GP::principal_curvatures<CGAL::Parallel_tag>(surface.domain(), map, np); });
  return py::make_tuple(min_curvature, max_curvature, min_direction, max_direction);
}

// Calls f(map, np) with the map of the returned speeds, and named parameters of curvatures.
template <typename Domain, typename Function>
py::array_t<double> speeds(const Surface<Domain>& surface, const py::object& strength,
                           const py::object& radius, const py::object& threads, const Function& f)
{
  py::array_t<double> result(py::ssize_t(surface.number_of_points()));
  const Output_map<typename Surface<Domain>::Vertex, double> map{result.mutable_data(), 1};
  with_strength(
      strength,
      GP::parameters::ball_radius(parse_radius(radius)).number_of_threads(parse_threads(threads)),
      [&](const auto& np) { Computation().run([&] { f(map, np); }); });
  return result;
}

template <typename Domain>
py::array_t<double> curvature_speeds(const Surface<Domain>& surface, const py::object& kind,
                                     const py::object& strength, const py::object& radius,
                                     const py::object& threads)
{
  const bool is_repulsive =
      choice<bool>(kind, "kind", {{"attractive", false}, {"repulsive", true}});
  return speeds(
      surface, strength, radius, threads,
      [&](const auto& map, const auto& np)
      {
        if(is_repulsive)
          GP::curvature_speeds<GP::Edge_repulsive, CGAL::Parallel_tag>(surface.domain(), map, np);
        else
          GP::curvature_speeds<GP::Edge_attractive, CGAL::Parallel_tag>(surface.domain(), map, np);
      });
}

template <typename Domain>
py::array_t<double> similar_curvature_speeds(const Surface<Domain>& surface,
                                             const py::object& vertex, const py::object& strength,
                                             const py::object& radius, const py::object& threads)
{
  const auto base = surface.vertex(index(vertex, "vertex", surface.number_of_points()));
  return speeds(surface, strength, radius, threads,
                [&](const auto& map, const auto& np) {
                  GP::similar_curvature_speeds<CGAL::Parallel_tag>(surface.domain(), base, map, np);
                });
}

template <typename Domain>
py::array_t<double> image_speeds(const Surface<Domain>& surface, const py::object& image,
                                 const py::object& strength)
{
  using Vertex = typename Surface<Domain>::Vertex;
  const auto size = py::ssize_t(surface.number_of_points());
  const bool is_gray = is_flat(image);
  const Numbers values(image, "image", is_gray ? Shape{size} : Shape{size, 3});
  return speeds(surface, strength, py::none(), py::none(),
                [&](const auto& map, const auto& np)
                {
                  if(is_gray)
                    GP::image_speeds(surface.domain(), Number_map<Vertex>{&values}, map, np);
                  else
                    GP::image_speeds(surface.domain(), Color_map<Vertex>{&values}, map, np);
                });
}

template <typename Domain>
void define(py::class_<Surface<Domain>, std::shared_ptr<Surface<Domain>>>& surface)
{
  surface.def("principal_curvatures", &principal_curvatures<Domain>)
      .def("curvature_speeds", &curvature_speeds<Domain>)
      .def("similar_curvature_speeds", &similar_curvature_speeds<Domain>)
      .def("image_speeds", &image_speeds<Domain>);
}

} // namespace

void bind_curvature(Mesh_class& mesh) { define<Mesh_domain>(mesh); }
void bind_curvature(Cloud_class& cloud) { define<Cloud_domain>(cloud); }

} // namespace python
