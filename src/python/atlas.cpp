// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Cloud_surface.h"
#include "python/Mesh_surface.h"
#include "python/Speeds.h"
#include "python/corner_maps.h"

#include <CGAL/Geodesic_processing/bake_atlas.h>
#include <CGAL/Geodesic_processing/texture_atlas.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>

namespace python {

namespace {

py::tuple summary(const GP::Texture_atlas& atlas)
{
  return py::make_tuple(atlas.number_of_charts, atlas.number_of_flips, atlas.number_of_overlaps,
                        atlas.coverage, atlas.texels_per_length);
}

template <typename Surface, typename OutputMap, typename... Arguments>
GP::Texture_atlas parallel_atlas(const Surface& surface, std::size_t number, OutputMap&& output_map,
                                 const Arguments&... arguments)
{
  return GP::texture_atlas<Runtime_method, CGAL::Parallel_tag>(
      surface, number, std::forward<OutputMap>(output_map), arguments...);
}

// Returns None for the faces, which are those of the surface, the texture coordinates of corners,
// the charts of faces, and the summary.
template <typename NamedParameters>
py::tuple compute_atlas(const Mesh_surface& surface, std::size_t number, Computation& computation,
                        const NamedParameters& np)
{
  const auto number_of_faces = py::ssize_t(surface.number_of_faces());
  py::array_t<double> uv(Shape{number_of_faces, 3, 2});
  py::array_t<std::int64_t> charts(number_of_faces);
  const Corner_output_map uv_map(surface.domain(), uv.mutable_data());
  const auto parameters = np.chart_map(label_map<Mesh::Face_index>(charts));
  GP::Texture_atlas atlas;
  computation.run([&] { atlas = parallel_atlas(surface.domain(), number, uv_map, parameters); });
  return py::make_tuple(py::none(), uv, charts, summary(atlas));
}

// Returns the faces of the reconstructed mesh, whose corners are surfels, and the rest as for a
// mesh.
template <typename NamedParameters>
py::tuple compute_atlas(const Cloud_surface& surface, std::size_t number, Computation& computation,
                        const NamedParameters& np)
{
  Mesh mesh;
  const auto uv_map = mesh.add_property_map<Mesh::Halfedge_index, UV>("h:uv").first;
  const auto chart_map = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:chart").first;
  const auto locations =
      mesh.add_property_map<Mesh::Vertex_index, Cloud_surface::Location>("v:location").first;
  const auto parameters = np.chart_map(chart_map).location_map(locations);
  GP::Texture_atlas atlas;
  computation.run([&]
                  { atlas = parallel_atlas(surface.domain(), number, mesh, uv_map, parameters); });
  const auto number_of_faces = py::ssize_t(mesh.number_of_faces());
  py::array_t<std::int64_t> faces(Shape{number_of_faces, 3});
  py::array_t<double> uv(Shape{number_of_faces, 3, 2});
  py::array_t<std::int64_t> charts(number_of_faces);
  std::int64_t* next_corner = faces.mutable_data();
  double* next_coordinate = uv.mutable_data();
  std::int64_t* next_chart = charts.mutable_data();
  for(const Mesh::Face_index face : mesh.faces())
  {
    *next_chart++ = std::int64_t(chart_map[face]);
    for(const Mesh::Halfedge_index h : CGAL::halfedges_around_face(mesh.halfedge(face), mesh))
    {
      *next_corner++ = std::int64_t(locations[mesh.target(h)].surfel);
      next_coordinate = std::copy(uv_map[h].begin(), uv_map[h].end(), next_coordinate);
    }
  }
  return py::make_tuple(faces, uv, charts, summary(atlas));
}

template <typename Domain>
py::tuple atlas(const Surface<Domain>& surface, const py::object& charts,
                const py::object& texture_size, const py::object& gutter_width,
                const py::object& method, const py::object& speed, const py::object& face_speed,
                const py::object& max_iterations, const py::object& seed, const py::object& threads,
                const py::object& callback)
{
  const Speeds<Domain> speeds(surface, speed, face_speed);
  Computation computation(callback);
  const auto np =
      speeds.add_to(GP::parameters::texture_size(size_number(texture_size, "texture size"))
                        .gutter_width(size_number(gutter_width, "gutter width"))
                        .method(parse_method(method))
                        .maximum_number_of_iterations(
                            unsigned(size_number(max_iterations, "number of iterations")))
                        .random_seed(unsigned(size_number(seed, "seed")))
                        .number_of_threads(parse_threads(threads))
                        .callback(computation.callback()));
  return compute_atlas(surface, size_number(charts, "number of charts"), computation, np);
}

// Returns, for each texel of a texture, the position of its location, or -1 if it shows none, and
// the locations. The first row is the highest one.
py::tuple texel_locations(const Mesh_surface& surface, const py::object& corner_uv,
                          const py::object& texture_size, const py::object& gutter_width)
{
  const Numbers values(corner_uv, "corner_uv", {py::ssize_t(surface.number_of_faces()), 6});
  for(std::size_t f = 0; f < values.size(); ++f)
    for(std::size_t k = 0; k < 6; ++k)
      if(!std::isfinite(values(f, k)))
        reject("corner_uv has a coordinate that is not finite.");
  const std::size_t size = size_number(texture_size, "texture size");
  const auto np = GP::parameters::gutter_width(size_number(gutter_width, "gutter width"))
                      .background(GP::Decal_color{-1., 0., 0., 0.});
  std::vector<Mesh_surface::Location> locations;
  // The colors are the numbers of the locations: color maps are evaluated for all of them together.
  const auto number_of_location = [&](const Mesh_surface::Location& location)
  {
    locations.push_back(location);
    return GP::Decal_color{double(locations.size() - 1), 0., 0., 0.};
  };
  std::vector<GP::Decal_color> texels;
  Computation().run(
      [&]
      {
        texels = GP::bake_atlas(surface.domain(), Corner_map(surface.domain(), values),
                                number_of_location, size, np);
      });
  py::array_t<std::int64_t> numbers(Shape{py::ssize_t(size), py::ssize_t(size)});
  std::int64_t* next = numbers.mutable_data();
  for(std::size_t row = size; row-- > 0;)
    for(std::size_t column = 0; column < size; ++column)
      *next++ = std::int64_t(texels[row * size + column][0]);
  return py::make_tuple(numbers, Mesh_surface::location_arrays(locations));
}

} // namespace

void bind_atlas(Mesh_class& mesh)
{
  mesh.def("atlas", &atlas<Mesh_domain>).def("texel_locations", &texel_locations);
}
void bind_atlas(Cloud_class& cloud) { cloud.def("atlas", &atlas<Cloud_domain>); }

} // namespace python
