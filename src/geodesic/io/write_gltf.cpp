// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/base64.h"
#include "io/errors.h"
#include "io/write_textured.h"
#include "io/write_utilities.h"

#include <boost/functional/hash.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

namespace program {

namespace {

using Json = nlohmann::ordered_json;

// Constants of glTF
constexpr int component_float = 5126, component_unsigned_int = 5125, target_array_buffer = 34962,
              target_element_array_buffer = 34963, filter_linear = 9729,
              filter_linear_mipmap_linear = 9987, wrap_clamp_to_edge = 33071;

void append_float(std::string& bytes, double value)
{
  const float single = static_cast<float>(value);
  std::uint32_t bits;
  static_assert(sizeof bits == sizeof single);
  std::memcpy(&bits, &single, sizeof bits);
  append_little_endian(bytes, bits);
}

// Returns unit normals weighted by face area. If a vertex has no incident face of positive area,
// its normal is (0, 0, 1).
std::vector<Point> vertex_normals(const Surface_file& surface)
{
  std::vector<Point> result(surface.points.size(), Point{0., 0., 0.});
  for(std::size_t c = 0; c + 2 < surface.corners.size(); c += 3)
  {
    const Point &p = surface.points[surface.corners[c]],
                &q = surface.points[surface.corners[c + 1]],
                &r = surface.points[surface.corners[c + 2]];
    for(std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const double coordinate = (q[i] - p[i]) * (r[j] - p[j]) - (q[j] - p[j]) * (r[i] - p[i]);
      for(std::size_t corner = c; corner < c + 3; ++corner)
        result[surface.corners[corner]][k] += coordinate;
    }
  }
  for(Point& normal : result)
  {
    const double size = std::hypot(normal[0], normal[1], normal[2]);
    if(size > 0. && std::isfinite(size))
      for(double& coordinate : normal)
        coordinate /= size;
    else
      normal = {0., 0., 1.};
  }
  return result;
}

// The contents of the buffers
struct Vertex_arrays
{
  std::size_t number_of_vertices = 0;
  std::string indices, positions, normals, texture_coordinates;
  std::array<std::vector<float>, 2> bounds = {
      std::vector<float>(3, std::numeric_limits<float>::infinity()),
      std::vector<float>(3, -std::numeric_limits<float>::infinity())};
};

// Appends the indices of the corners. A vertex has one texture coordinate in glTF, so each pair of
// point and texture coordinate becomes a vertex. Returns a corner of each vertex.
std::vector<std::size_t> append_indices(const Surface_file& surface, std::string& indices)
{
  using Key = std::pair<std::uint32_t, std::array<double, 2>>;
  std::unordered_map<Key, std::uint32_t, boost::hash<Key>> vertex_index;
  std::vector<std::size_t> first_corner;
  for(std::size_t c = 0; c < surface.corners.size(); ++c)
  {
    const auto [entry, is_new] =
        vertex_index.try_emplace({surface.corners[c], surface.corner_uv[c]},
                                 static_cast<std::uint32_t>(first_corner.size()));
    if(is_new)
      first_corner.push_back(c);
    append_little_endian(indices, entry->second);
  }
  return first_corner;
}

Vertex_arrays make_vertex_arrays(const std::string& filename, const Surface_file& surface)
{
  Vertex_arrays result;
  const std::vector<std::size_t> first_corner = append_indices(surface, result.indices);
  result.number_of_vertices = first_corner.size();
  const std::vector<Point> normal = vertex_normals(surface);
  for(const std::size_t c : first_corner)
  {
    const std::uint32_t point = surface.corners[c];
    for(std::size_t k = 0; k < 3; ++k)
    {
      const double coordinate = surface.points[point][k];
      if(!(std::abs(coordinate) <= double((std::numeric_limits<float>::max)())))
        throw Output_error(filename + ": a coordinate exceeds the range of single precision.");
      result.bounds[0][k] = std::min(result.bounds[0][k], float(coordinate));
      result.bounds[1][k] = std::max(result.bounds[1][k], float(coordinate));
      append_float(result.positions, coordinate);
      append_float(result.normals, normal[point][k]);
    }
    // The origin of texture coordinates is the upper left corner in glTF.
    append_float(result.texture_coordinates, surface.corner_uv[c][0]);
    append_float(result.texture_coordinates, 1. - surface.corner_uv[c][1]);
  }
  return result;
}

// The JSON document and its binary buffer.
struct Gltf
{
  Json json;
  std::string buffer;

  Gltf(const std::string& filename, const Surface_file& surface, const std::string& png)
  {
    const Vertex_arrays arrays = make_vertex_arrays(filename, surface);
    add_scene();
    add_material();
    json["accessors"] = Json::array();
    json["bufferViews"] = Json::array();
    const std::size_t n = arrays.number_of_vertices;
    add_accessor(arrays.positions, target_array_buffer, component_float, n, "VEC3");
    json["accessors"][0]["min"] = arrays.bounds[0];
    json["accessors"][0]["max"] = arrays.bounds[1];
    add_accessor(arrays.normals, target_array_buffer, component_float, n, "VEC3");
    add_accessor(arrays.texture_coordinates, target_array_buffer, component_float, n, "VEC2");
    add_accessor(arrays.indices, target_element_array_buffer, component_unsigned_int,
                 surface.corners.size(), "SCALAR");
    add_buffer_view(png);
    json["images"] = {{{"name", "texture"},
                       {"mimeType", "image/png"},
                       {"bufferView", json["bufferViews"].size() - 1}}};
  }

private:
  void add_scene()
  {
    json["asset"] = {{"version", "2.0"}, {"generator", "geodesic"}};
    json["scene"] = 0;
    json["scenes"] = {{{"nodes", {0}}}};
    json["nodes"] = {{{"mesh", 0}}};
    json["meshes"] = {{{"primitives",
                        {{{"attributes", {{"POSITION", 0}, {"NORMAL", 1}, {"TEXCOORD_0", 2}}},
                          {"indices", 3},
                          {"material", 0}}}}}};
  }

  void add_material()
  {
    json["materials"] = {
        {{"name", "texture"},
         {"pbrMetallicRoughness",
          {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0.}, {"roughnessFactor", 1.}}},
         {"doubleSided", true}}};
    json["textures"] = {{{"sampler", 0}, {"source", 0}}};
    json["samplers"] = {{{"magFilter", filter_linear},
                         {"minFilter", filter_linear_mipmap_linear},
                         {"wrapS", wrap_clamp_to_edge},
                         {"wrapT", wrap_clamp_to_edge}}};
  }

  Json& add_buffer_view(const std::string& bytes)
  {
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}});
    buffer += bytes;
    buffer.resize((buffer.size() + 3) / 4 * 4);
    return json["bufferViews"].back();
  }

  void add_accessor(const std::string& bytes, int target, int component, std::size_t count,
                    const char* type)
  {
    add_buffer_view(bytes)["target"] = target;
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                 {"componentType", component},
                                 {"count", count},
                                 {"type", type}});
  }
};

} // namespace

std::string to_gltf(const std::string& filename, const Surface_file& surface,
                    const std::string& png)
{
  Gltf gltf(filename, surface, png);
  gltf.json["buffers"] = {
      {{"byteLength", gltf.buffer.size()},
       {"uri", "data:application/octet-stream;base64," + to_base64(gltf.buffer)}}};
  return gltf.json.dump(1) + '\n';
}

std::string to_glb(const std::string& filename, const Surface_file& surface, const std::string& png)
{
  Gltf gltf(filename, surface, png);
  gltf.json["buffers"] = {{{"byteLength", gltf.buffer.size()}}};
  std::string text = gltf.json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::uint64_t size = 12 + 8 + text.size() + 8 + gltf.buffer.size();
  if(size > (std::numeric_limits<std::uint32_t>::max)())
    throw Output_error(filename + ": it would exceed the maximum size of the format, 4 GiB.");
  std::string bytes = "glTF";
  append_little_endian(bytes, std::uint32_t(2));
  append_little_endian(bytes, std::uint32_t(size));
  append_little_endian(bytes, std::uint32_t(text.size()));
  bytes += "JSON" + text;
  append_little_endian(bytes, std::uint32_t(gltf.buffer.size()));
  bytes += std::string("BIN\0", 4) + gltf.buffer;
  return bytes;
}

} // namespace program
