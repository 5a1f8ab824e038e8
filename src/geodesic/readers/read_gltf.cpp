// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Gltf_document.h"
#include "readers/Surface_file.h"
#include "readers/Welder.h"
#include "readers/append_polygon.h"
#include "readers/arrays.h"
#include "readers/vectors.h"

#include <cmath>
#include <numeric>
#include <utility>

namespace program {

namespace {

// An affine map: the images of the unit vectors, and the translation.
using Transform = std::array<Point, 4>;

constexpr Transform identity = {{{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}, {0., 0., 0.}}};

Point transform_vector(const Transform& t, const Point& v)
{
  return v[0] * t[0] + v[1] * t[1] + v[2] * t[2];
}

Point transform_point(const Transform& t, const Point& p) { return transform_vector(t, p) + t[3]; }

// Applies `second` after `first`.
Transform compose(const Transform& second, const Transform& first)
{
  return {transform_vector(second, first[0]), transform_vector(second, first[1]),
          transform_vector(second, first[2]), transform_point(second, first[3])};
}

double determinant(const Transform& t) { return dot(t[0], cross(t[1], t[2])); }

// Reads the meshes of the nodes. Skins, morph targets and animations are not applied.
class Gltf_reader
{
public:
  Gltf_reader(std::string_view bytes, const std::string& name) : m_document(bytes, name) {}

  Surface_file read()
  {
    read_scene();
    if(!m_has_uv)
      m_mesh.uv.clear();
    if(!m_has_normals)
      m_cloud.normals.clear();
    return std::move(m_mesh.corners.empty() ? m_cloud : m_mesh);
  }

private:
  void read_scene();
  void read_nodes(const std::vector<std::size_t>& roots);
  Transform local_transform(const Json& node) const;
  std::vector<std::size_t> indices(const Json& list, const char* key) const;
  void read_mesh(const Json& mesh, const Transform& transform);
  void read_primitive(const Json& primitive, const Transform& transform);
  void append_points(const Json& attributes, const std::vector<Point>& points,
                     const std::vector<std::size_t>& vertices, const Transform& transform);
  void append_triangles(std::size_t mode, const std::vector<std::int64_t>& vertices,
                        bool is_mirrored);
  std::vector<double> attribute(const Json& attributes, const char* key, const char* type,
                                const std::vector<Point>& points);
  std::vector<std::int64_t> weld(const Json& attributes, const std::vector<Point>& points,
                                 const std::vector<std::size_t>& vertices);

  Gltf_document m_document;
  Surface_file m_mesh, m_cloud;
  Welder m_welder{m_mesh};
  bool m_has_uv = true, m_has_normals = true; // of all primitives
};

std::vector<std::size_t> Gltf_reader::indices(const Json& list, const char* key) const
{
  std::vector<std::size_t> result;
  if(list.is_array())
    for(const Json& index : list)
      result.push_back(m_document.as_integer(index, key));
  return result;
}

// Reads the default scene. A file without scenes is a collection of nodes or meshes.
void Gltf_reader::read_scene()
{
  const Json &json = m_document.json(), &nodes = member(json, "nodes");
  if(!member(json, "scenes").is_null())
  {
    const std::size_t scene = m_document.integer(json, "scene", 0);
    read_nodes(indices(member(m_document.element("scenes", scene), "nodes"), "nodes"));
  }
  else if(nodes.is_array())
  {
    std::vector<char> is_child(nodes.size(), 0);
    for(const Json& node : nodes)
      for(const std::size_t child : indices(member(node, "children"), "children"))
        if(child < is_child.size())
          is_child[child] = 1;
    std::vector<std::size_t> roots;
    for(std::size_t i = 0; i < nodes.size(); ++i)
      if(is_child[i] == 0)
        roots.push_back(i);
    read_nodes(roots);
  }
  else
    for(const Json& mesh : member(json, "meshes"))
      read_mesh(mesh, identity);
}

void Gltf_reader::read_nodes(const std::vector<std::size_t>& roots)
{
  std::vector<std::pair<std::size_t, Transform>> stack;
  const auto push = [&stack](const std::vector<std::size_t>& nodes, const Transform& transform)
  {
    for(std::size_t i = nodes.size(); i-- > 0;)
      stack.push_back({nodes[i], transform});
  };
  push(roots, identity);
  std::vector<char> is_visited(member(m_document.json(), "nodes").size(), 0);
  while(!stack.empty())
  {
    const auto [index, parent] = stack.back();
    stack.pop_back();
    const Json& node = m_document.element("nodes", index);
    if(std::exchange(is_visited[index], 1) != 0)
      m_document.fail("a node has several parents");
    const Transform transform = compose(parent, local_transform(node));
    if(!member(node, "mesh").is_null())
      read_mesh(m_document.element("meshes", m_document.integer(node, "mesh")), transform);
    push(indices(member(node, "children"), "children"), transform);
  }
}

Transform Gltf_reader::local_transform(const Json& node) const
{
  if(!member(node, "matrix").is_null())
  {
    const std::array<double, 16> m = m_document.numbers<16>(node, "matrix", {});
    return {{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}}};
  }
  const Point scale = m_document.numbers<3>(node, "scale", {1., 1., 1.});
  const auto [x, y, z, w] = m_document.numbers<4>(node, "rotation", {0., 0., 0., 1.});
  return {scale[0] * Point{1. - 2. * (y * y + z * z), 2. * (x * y + z * w), 2. * (x * z - y * w)},
          scale[1] * Point{2. * (x * y - z * w), 1. - 2. * (x * x + z * z), 2. * (y * z + x * w)},
          scale[2] * Point{2. * (x * z + y * w), 2. * (y * z - x * w), 1. - 2. * (x * x + y * y)},
          m_document.numbers<3>(node, "translation", {0., 0., 0.})};
}

void Gltf_reader::read_mesh(const Json& mesh, const Transform& transform)
{
  for(const Json& primitive : member(mesh, "primitives"))
  {
    m_document.count_values(1); // even if the primitive is empty
    read_primitive(primitive, transform);
  }
}

void Gltf_reader::read_primitive(const Json& primitive, const Transform& transform)
{
  constexpr std::size_t points_mode = 0, triangles_mode = 4, last_mode = 6;
  const std::size_t mode = m_document.integer(primitive, "mode", triangles_mode);
  if(mode > last_mode)
    m_document.fail("the mode of a primitive is unknown");
  const Json& attributes = member(primitive, "attributes");
  const bool are_lines = mode != points_mode && mode < triangles_mode;
  if(are_lines || member(attributes, "POSITION").is_null())
    return;
  std::vector<Point> points =
      to_points(m_document.values(m_document.integer(attributes, "POSITION"), "VEC3"));
  for(Point& point : points)
  {
    point = transform_point(transform, point);
    if(!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2]))
      m_document.fail("a coordinate is not finite");
  }
  std::vector<std::size_t> vertices(points.size());
  std::iota(vertices.begin(), vertices.end(), std::size_t{0});
  if(!member(primitive, "indices").is_null())
  {
    vertices.clear();
    for(const double i : m_document.values(m_document.integer(primitive, "indices"), "SCALAR"))
    {
      if(!(i >= 0. && i < static_cast<double>(points.size())))
        m_document.fail("an index exceeds the number of vertices, " +
                        std::to_string(points.size()));
      vertices.push_back(static_cast<std::size_t>(i));
    }
  }
  if(mode == points_mode)
    append_points(attributes, points, vertices, transform);
  else
    append_triangles(mode, weld(attributes, points, vertices), determinant(transform) < 0.);
}

// Appends a cloud. If any primitive has no normals, all are discarded.
void Gltf_reader::append_points(const Json& attributes, const std::vector<Point>& points,
                                const std::vector<std::size_t>& vertices,
                                const Transform& transform)
{
  for(const std::size_t v : vertices)
    m_cloud.points.push_back(points[v]);
  m_has_normals = m_has_normals && !member(attributes, "NORMAL").is_null();
  if(!m_has_normals)
    return;
  const std::vector<Point> normals = to_points(attribute(attributes, "NORMAL", "VEC3", points));
  // Normals are transformed by the matrix of cofactors, which is the inverse transpose times the
  // determinant.
  const double sign = determinant(transform) < 0. ? -1. : 1.;
  const Transform cofactors = {cross(transform[1], transform[2]), cross(transform[2], transform[0]),
                               cross(transform[0], transform[1])};
  for(const std::size_t v : vertices)
    m_cloud.normals.push_back(sign * transform_vector(cofactors, normals[v]));
}

// Merges vertices with equal positions, because glTF repeats a vertex if its normals or texture
// coordinates differ between faces. A vertex keeps its first texture coordinates. If any primitive
// has none, all are discarded.
std::vector<std::int64_t> Gltf_reader::weld(const Json& attributes,
                                            const std::vector<Point>& points,
                                            const std::vector<std::size_t>& vertices)
{
  m_has_uv = m_has_uv && !member(attributes, "TEXCOORD_0").is_null();
  std::vector<double> uv;
  if(m_has_uv)
    uv = attribute(attributes, "TEXCOORD_0", "VEC2", points);
  std::vector<std::int64_t> welded(points.size(), -1);
  for(const std::size_t v : vertices)
    welded[v] = 0;
  // Vertices keep their order in the file. Vertices that no triangle uses are discarded.
  for(std::size_t v = 0; v < points.size(); ++v)
    if(welded[v] == 0)
    {
      welded[v] = m_welder.index(points[v]);
      // The origin of texture coordinates is the upper left corner in glTF.
      if(m_has_uv)
        m_mesh.uv.resize(m_mesh.points.size(), {uv[2 * v], 1. - uv[2 * v + 1]});
    }
  std::vector<std::int64_t> result;
  for(const std::size_t v : vertices)
    result.push_back(welded[v]);
  return result;
}

// Appends triangles, a strip (mode 5) or a fan (mode 6). The orientation is reversed if
// `is_mirrored`.
void Gltf_reader::append_triangles(std::size_t mode, const std::vector<std::int64_t>& vertices,
                                   bool is_mirrored)
{
  const std::size_t begin = m_mesh.corners.size();
  if(mode == 5)
    append_strip(m_mesh, vertices);
  else
    for(std::size_t i = 0; i + 2 < vertices.size(); i += mode == 6 ? 1 : 3)
    {
      for(const std::size_t k : {mode == 6 ? 0 : i, i + 1, i + 2})
        append_corner(m_mesh, static_cast<double>(vertices[k]));
      end_polygon(m_mesh);
    }
  if(is_mirrored)
    for(std::size_t c = begin; c < m_mesh.corners.size(); c += 3)
      std::swap(m_mesh.corners[c + 1], m_mesh.corners[c + 2]);
}

// Returns the values of an attribute other than the position.
std::vector<double> Gltf_reader::attribute(const Json& attributes, const char* key,
                                           const char* type, const std::vector<Point>& points)
{
  std::vector<double> result = m_document.values(m_document.integer(attributes, key), type);
  if(result.size() < points.size() * (type == std::string_view("VEC2") ? 2 : 3))
    m_document.fail(std::string(key) + " has fewer elements than POSITION");
  return result;
}

} // namespace

Surface_file read_gltf(std::string_view bytes, const std::string& name)
{
  return Gltf_reader(bytes, name).read();
}

} // namespace program
