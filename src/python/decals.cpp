// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "python/Cloud_surface.h"
#include "python/Mesh_surface.h"
#include "python/vectors.h"

#include <CGAL/Geodesic_processing/decal.h>

#include <CGAL/IO/Color.h>

#include <algorithm>

namespace python {

namespace {

// A view of an array of uint8 whose last extent is three (red, green, blue) or four (and opacity).
// It is read without a copy, with any strides.
class Bytes
{
public:
  // number_of_extents  3 for an image, 2 for a list of colors
  Bytes(const py::object& object, const std::string& name, py::ssize_t number_of_extents)
  {
    const std::string shape =
        number_of_extents == 3 ? "(h, w, 3) or (h, w, 4)" : "(n, 3) or (n, 4)";
    if(!py::isinstance<py::array_t<std::uint8_t>>(object))
      reject(name + " is not an array of uint8.");
    m_array = py::reinterpret_borrow<py::array>(object);
    if(m_array.ndim() != number_of_extents ||
       (m_array.shape(number_of_extents - 1) != 3 && m_array.shape(number_of_extents - 1) != 4))
      reject(name + " does not have the shape " + shape + ".");
    if(m_array.size() == 0)
      reject(name + " is empty.");
    m_data = static_cast<const std::uint8_t*>(m_array.data());
    m_strides.assign(m_array.strides(), m_array.strides() + number_of_extents);
  }

  std::size_t extent(py::ssize_t k) const { return std::size_t(m_array.shape(k)); }
  std::size_t number_of_channels() const { return extent(m_array.ndim() - 1); }

  // Returns a channel of color i of a list, or of pixel (i, j) of an image. Colors are opaque
  // unless they have an opacity.
  std::uint8_t operator()(std::size_t channel, std::size_t i, std::size_t j = 0) const
  {
    if(channel == number_of_channels())
      return 255;
    std::ptrdiff_t offset =
        std::ptrdiff_t(i) * m_strides.front() + std::ptrdiff_t(channel) * m_strides.back();
    if(m_strides.size() == 3)
      offset += std::ptrdiff_t(j) * m_strides[1];
    return m_data[offset];
  }

private:
  py::array m_array;
  const std::uint8_t* m_data = nullptr;
  std::vector<py::ssize_t> m_strides;
};

// The two pixels that are adjacent to a coordinate in [0, 1], and the weight of the second one.
struct Interpolation
{
  std::size_t first, second;
  double weight;

  Interpolation(double x, std::size_t size)
  {
    const double position = std::clamp(x * double(size) - 0.5, 0., double(size - 1));
    first = std::size_t(position);
    second = std::min(first + 1, size - 1);
    weight = position - double(first);
  }
};

// An image as a function of its coordinates: interpolated between the centers of pixels. Colors
// are weighted by their opacity, so that transparent pixels have no effect.
class Image
{
public:
  Image(const py::object& object, const std::string& name) : m_pixels(object, name, 3) {}

  GP::Decal_color operator()(const GP::Decal_coordinates& uv) const
  {
    // The first row of the array is the highest one.
    const Interpolation row(1. - uv[1], m_pixels.extent(0)), column(uv[0], m_pixels.extent(1));
    GP::Decal_color result = {0., 0., 0., 0.};
    const auto add = [&](std::size_t i, std::size_t j, double weight)
    {
      const double opaque_weight = weight * m_pixels(3, i, j) / 255.;
      for(std::size_t c = 0; c < 3; ++c)
        result[c] += opaque_weight * m_pixels(c, i, j) / 255.;
      result[3] += opaque_weight;
    };
    add(row.first, column.first, (1. - row.weight) * (1. - column.weight));
    add(row.first, column.second, (1. - row.weight) * column.weight);
    add(row.second, column.first, row.weight * (1. - column.weight));
    add(row.second, column.second, row.weight * column.weight);
    if(result[3] > 0.)
      for(std::size_t c = 0; c < 3; ++c)
        result[c] /= result[3];
    return result;
  }

private:
  Bytes m_pixels;
};

// A map of the colors of vertices, which are the rows of an array.
template <typename Key>
struct Color_map
{
  using key_type = Key;
  using value_type = CGAL::IO::Color;
  using reference = CGAL::IO::Color;
  using category = boost::read_write_property_map_tag;

  std::uint8_t* data;
  std::size_t number_of_channels;

  friend CGAL::IO::Color get(const Color_map& map, Key key)
  {
    const std::uint8_t* const row = map.data + map.number_of_channels * std::size_t(key);
    return CGAL::IO::Color(row[0], row[1], row[2], map.number_of_channels == 4 ? row[3] : 255);
  }
  friend void put(const Color_map& map, Key key, const CGAL::IO::Color& color)
  {
    for(std::size_t c = 0; c < map.number_of_channels; ++c)
      map.data[map.number_of_channels * std::size_t(key) + c] = color[int(c)];
  }
};

// ---- Placement

// Copies image coordinates to an array.
double* copy_coordinates(const GP::Decal_coordinates& coordinates, double* next)
{
  return std::copy(coordinates.begin(), coordinates.end(), next);
}

// Returns the axes, the vertices and their coordinates, the faces and the coordinates of their
// corners.
template <typename Input>
py::tuple decal_arrays(const GP::Decal<Input>& decal)
{
  const auto number_of_vertices = py::ssize_t(decal.vertices.size());
  py::array_t<std::int64_t> vertices(number_of_vertices);
  py::array_t<double> coordinates(Shape{number_of_vertices, 2});
  std::int64_t* next_vertex = vertices.mutable_data();
  double* next = coordinates.mutable_data();
  for(const auto& covered : decal.vertices)
  {
    *next_vertex++ = std::int64_t(std::size_t(covered.vertex));
    next = copy_coordinates(covered.coordinates, next);
  }
  py::ssize_t number_of_faces = 0;
  if constexpr(std::is_same_v<Input, Mesh>)
    number_of_faces = py::ssize_t(decal.faces.size());
  py::array_t<std::int64_t> faces(number_of_faces);
  py::array_t<double> corners(Shape{number_of_faces, 3, 2});
  if constexpr(std::is_same_v<Input, Mesh>)
  {
    std::int64_t* next_face = faces.mutable_data();
    next = corners.mutable_data();
    for(const auto& covered : decal.faces)
    {
      *next_face++ = std::int64_t(std::size_t(covered.face));
      for(const auto& corner : covered.coordinates)
        next = copy_coordinates(corner, next);
    }
  }
  return py::make_tuple(frame_arrays(decal.frame), vertices, coordinates, faces, corners);
}

template <typename Method, typename Domain>
py::tuple place(const Surface<Domain>& surface, const py::object& base_object, double width,
                double height, const py::object& up)
{
  using Input = typename Surface<Domain>::Input;
  const auto base = surface.vertex_or_location(base_object);
  GP::Decal<Input> decal;
  with_up_direction(up, GP::parameters::number_of_threads(1u),
                    [&](const auto& np)
                    {
                      Computation().run(
                          [&]
                          {
                            GP::Decal_placer<Input, Method> placer(surface.domain());
                            std::visit([&](const auto& center)
                                       { decal = placer.place(center, width, height, np); },
                                       base);
                          });
                    });
  return decal_arrays<Input>(decal);
}

template <typename Domain>
py::tuple decal(const Surface<Domain>& surface, const py::object& base, const py::object& size,
                const py::object& up, const py::object& method)
{
  const Numbers extents(size, "size", {2});
  const double width = extents(0), height = extents(1);
  const std::string name =
      py::isinstance<py::str>(method) ? method.cast<std::string>() : std::string();
  if(name == "gradient")
    return place<GP::Gradient<>>(surface, base, width, height, up);
  if(name != "exact")
    reject("method is not gradient or exact.");
  if constexpr(Surface<Domain>::is_cloud)
    throw GP::Unsupported_surface_error("Exact tangent vectors need a mesh, because the triangles "
                                        "of a cloud are not connected.");
  else
    return place<GP::Exact>(surface, base, width, height, up);
}

// ---- Colors

// Reads the vertices of a decal and their coordinates.
template <typename Domain>
GP::Decal<typename Surface<Domain>::Input> read_vertices(const Surface<Domain>& surface,
                                                         const py::object& vertices,
                                                         const py::object& coordinates)
{
  GP::Decal<typename Surface<Domain>::Input> result;
  // An array without rows is a decal that covers no vertex.
  if(py::isinstance<py::array>(vertices) && py::len(vertices) == 0)
    return result;
  const Integers indices(vertices, "vertices of the decal", {any});
  const Numbers uv(coordinates, "coordinates of the decal", {py::ssize_t(indices.size()), 2});
  for(std::size_t i = 0; i < indices.size(); ++i)
    result.vertices.push_back(
        {surface.vertex(checked_index(indices(i), "vertex", surface.number_of_points())),
         {uv(i, 0), uv(i, 1)}});
  return result;
}

// Returns the colors after composition.
template <typename Domain>
py::array_t<std::uint8_t> composite_decal(const Surface<Domain>& surface,
                                          const py::object& vertices, const py::object& coordinates,
                                          const py::object& image_object,
                                          const py::object& color_object)
{
  const auto decal = read_vertices(surface, vertices, coordinates);
  const Image image(image_object, "image");
  const Bytes colors(color_object, "colors", 2);
  if(colors.extent(0) != surface.number_of_points())
    reject("colors does not have a row for each vertex.");
  const std::size_t channels = colors.number_of_channels();
  py::array_t<std::uint8_t> result(Shape{py::ssize_t(colors.extent(0)), py::ssize_t(channels)});
  std::uint8_t* const data = result.mutable_data();
  Computation().run(
      [&]
      {
        for(std::size_t i = 0; i < colors.extent(0); ++i)
          for(std::size_t c = 0; c < channels; ++c)
            data[channels * i + c] = colors(c, i);
        GP::composite_decal(decal, image,
                            Color_map<typename Surface<Domain>::Vertex>{data, channels});
      });
  return result;
}

// ---- Textures

// Reads the faces of a decal and the coordinates of their corners.
GP::Decal<Mesh> read_faces(const Mesh_surface& surface, const py::object& faces,
                           const py::object& coordinates)
{
  GP::Decal<Mesh> result;
  if(py::isinstance<py::array>(faces) && py::len(faces) == 0)
    return result;
  const Integers indices(faces, "faces of the decal", {any});
  const Numbers uv(coordinates, "face_coordinates of the decal", {py::ssize_t(indices.size()), 6});
  for(std::size_t i = 0; i < indices.size(); ++i)
  {
    const std::size_t face = checked_index(indices(i), "face", surface.number_of_faces());
    GP::Decal_face<Mesh> covered{Mesh::Face_index(Mesh::size_type(face)), {}};
    for(std::size_t k = 0; k < 6; ++k)
      covered.coordinates[k / 2][k % 2] = uv(i, k);
    result.faces.push_back(covered);
  }
  return result;
}

// Writes texels as bytes, the highest row first.
void write_texels(const GP::Decal_texture<Mesh>& texture, std::uint8_t* next)
{
  for(std::size_t row = texture.height; row-- > 0;)
    for(std::size_t column = 0; column < texture.width; ++column)
      for(const double channel : texture.texels[row * texture.width + column])
        *next++ = std::uint8_t(std::lround(255. * std::clamp(channel, 0., 1.)));
}

// Returns the texture, the texture coordinates of all corners, and the covered faces.
//
// layers  tuples of the faces of a decal, the coordinates of their corners, and an image
py::tuple bake_decals(const Mesh_surface& surface, const py::list& layers,
                      const py::object& segments, const py::object& background)
{
  std::vector<GP::Decal_layer<Mesh>> placed;
  for(const py::handle item : layers)
  {
    const auto layer = py::reinterpret_borrow<py::tuple>(item);
    placed.push_back(
        {read_faces(surface, layer[0], layer[1]), Image(py::object(layer[2]), "image")});
  }
  const std::size_t number_of_segments = size_number(segments, "number of segments");
  const Numbers color(background, "background", {4});
  const auto np = GP::parameters::background(
      GP::Decal_color{color(0) / 255., color(1) / 255., color(2) / 255., color(3) / 255.});
  GP::Decal_texture<Mesh> texture;
  Computation().run([&] { texture = GP::bake_decals(placed, number_of_segments, np); });

  py::array_t<std::uint8_t> image(
      Shape{py::ssize_t(texture.height), py::ssize_t(texture.width), 4});
  write_texels(texture, image.mutable_data());
  py::array_t<double> corner_uv(Shape{py::ssize_t(surface.number_of_faces()), 3, 2});
  double* const uv = corner_uv.mutable_data();
  for(std::size_t corner = 0; corner < 3 * surface.number_of_faces(); ++corner)
    copy_coordinates(texture.background, uv + 2 * corner);
  std::vector<Mesh::Face_index> faces;
  for(const auto& covered : texture.faces)
  {
    faces.push_back(covered.face);
    for(std::size_t k = 0; k < 3; ++k)
      copy_coordinates(covered.coordinates[k], uv + 6 * std::size_t(covered.face) + 2 * k);
  }
  return py::make_tuple(image, corner_uv, index_array(faces));
}

template <typename Domain>
void bind(py::class_<Surface<Domain>, std::shared_ptr<Surface<Domain>>>& surface)
{
  surface.def("decal", &decal<Domain>).def("composite_decal", &composite_decal<Domain>);
}

} // namespace

void bind_decals(Mesh_class& mesh)
{
  bind<Mesh_domain>(mesh);
  mesh.def("bake_decals", &bake_decals);
}
void bind_decals(Cloud_class& cloud) { bind<Cloud_domain>(cloud); }

} // namespace python
