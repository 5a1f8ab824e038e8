// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Input_error.h"
#include "readers/Surface_file.h"
#include "readers/base64.h"
#include "readers/vectors.h"
#include "io/write_textured.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <type_traits>

namespace read_gltf_test {

namespace fs = std::filesystem;
using nlohmann::json;
using program::Point;
using program::Surface_file;
using program::operator-;

const std::vector<float> tetrahedron_points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
const std::vector<std::uint8_t> tetrahedron_corners = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};

template <typename Number>
constexpr int component_type()
{
  return std::is_same_v<Number, float>           ? 5126
         : std::is_same_v<Number, std::uint32_t> ? 5125
         : std::is_same_v<Number, std::uint16_t> ? 5123
         : std::is_same_v<Number, std::int16_t>  ? 5122
         : std::is_same_v<Number, std::uint8_t>  ? 5121
                                                 : 5120;
}

// A glTF file under construction. Tests run on little-endian machines.
struct Gltf
{
  json document = {{"asset", {{"version", "2.0"}}}};
  std::string buffer;

  template <typename Number>
  int add_view(const std::vector<Number>& numbers)
  {
    const std::size_t size = numbers.size() * sizeof(Number);
    document["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", size}});
    buffer.append(reinterpret_cast<const char*>(numbers.data()), size);
    buffer.resize((buffer.size() + 3) / 4 * 4);
    return static_cast<int>(document["bufferViews"].size()) - 1;
  }

  template <typename Number>
  int add(const std::vector<Number>& numbers, const std::string& type, bool normalized = false)
  {
    const std::size_t components = type == "SCALAR" ? 1 : type == "VEC2" ? 2 : 3;
    document["accessors"].push_back({{"bufferView", add_view(numbers)},
                                     {"componentType", component_type<Number>()},
                                     {"count", numbers.size() / components},
                                     {"type", type}});
    if(normalized)
      document["accessors"].back()["normalized"] = true;
    return static_cast<int>(document["accessors"].size()) - 1;
  }

  void add_primitive(json primitive)
  {
    document["meshes"][0]["primitives"].push_back(std::move(primitive));
  }

  std::string text() const
  {
    json result = document;
    result["buffers"] = {
        {{"byteLength", buffer.size()},
         {"uri", "data:application/gltf-buffer;base64," + program::to_base64(buffer)}}};
    return result.dump();
  }

  std::string glb() const
  {
    json result = document;
    result["buffers"] = {{{"byteLength", buffer.size()}}};
    std::string header = result.dump();
    header.resize((header.size() + 3) / 4 * 4, ' ');
    const auto word = [](std::size_t value)
    {
      const auto number = static_cast<std::uint32_t>(value);
      return std::string(reinterpret_cast<const char*>(&number), 4);
    };
    return "glTF" + word(2) + word(28 + header.size() + buffer.size()) + word(header.size()) +
           "JSON" + header + word(buffer.size()) + std::string("BIN\0", 4) + buffer;
  }

  Surface_file read() const { return program::read_gltf(text(), "name"); }
};

Gltf tetrahedron()
{
  Gltf gltf;
  gltf.add(tetrahedron_points, "VEC3");
  gltf.add(tetrahedron_corners, "SCALAR");
  gltf.add_primitive({{"attributes", {{"POSITION", 0}}}, {"indices", 1}});
  return gltf;
}

void expect_tetrahedron(const Surface_file& surface)
{
  EXPECT_EQ(surface.points, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_EQ(surface.corners, (std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}));
  EXPECT_EQ(surface.polygon_begin, (std::vector<std::size_t>{0, 3, 6, 9, 12}));
}

std::string error_of(const std::string& bytes, const std::string& name = "name")
{
  try
  {
    program::check(program::read_gltf(bytes, name), name);
    return {};
  }
  catch(const program::Input_error& error)
  {
    return error.what();
  }
}

void expect_error(const Gltf& gltf, const std::string& text)
{
  EXPECT_PRED_FORMAT2(testing::IsSubstring, text, error_of(gltf.text()));
}

// Returns the volume that a triangle mesh encloses, by the divergence theorem.
double volume(const Surface_file& surface)
{
  double result = 0.;
  for(std::size_t c = 0; c < surface.corners.size(); c += 3)
  {
    const auto point = [&](std::size_t k) { return surface.points[surface.corners[c + k]]; };
    result += program::dot(point(0), program::cross(point(1), point(2))) / 6.;
  }
  return result;
}

TEST(Read_gltf, reads_text_and_binary)
{
  expect_tetrahedron(tetrahedron().read());
  expect_tetrahedron(program::read_gltf(tetrahedron().glb(), ""));
}

TEST(Read_gltf, reads_all_index_types)
{
  for(const int type : {5121, 5123, 5125})
  {
    Gltf gltf;
    gltf.add(tetrahedron_points, "VEC3");
    const auto &begin = tetrahedron_corners.begin(), &end = tetrahedron_corners.end();
    if(type == 5121)
      gltf.add(tetrahedron_corners, "SCALAR");
    else if(type == 5123)
      gltf.add(std::vector<std::uint16_t>(begin, end), "SCALAR");
    else
      gltf.add(std::vector<std::uint32_t>(begin, end), "SCALAR");
    gltf.add_primitive({{"attributes", {{"POSITION", 0}}}, {"indices", 1}});
    expect_tetrahedron(gltf.read());
  }
}

// Each face has its own vertices, in two primitives without indices.
TEST(Read_gltf, merges_repeated_vertices)
{
  Gltf gltf;
  std::vector<float> points;
  for(const std::uint8_t corner : tetrahedron_corners)
    points.insert(points.end(), tetrahedron_points.begin() + 3 * corner,
                  tetrahedron_points.begin() + 3 * corner + 3);
  gltf.add(std::vector<float>(points.begin(), points.begin() + 18), "VEC3");
  gltf.add(std::vector<float>(points.begin() + 18, points.end()), "VEC3");
  gltf.add_primitive({{"attributes", {{"POSITION", 0}}}});
  gltf.add_primitive({{"attributes", {{"POSITION", 1}}}});
  const Surface_file surface = gltf.read();
  EXPECT_EQ(surface.points, (std::vector<Point>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}));
  EXPECT_EQ(surface.corners, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 2, 1, 3, 1, 0, 3}));
}

TEST(Read_gltf, reads_strips_and_fans)
{
  Gltf gltf;
  gltf.add(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, "VEC3");
  gltf.add(std::vector<std::uint8_t>{0, 1, 3, 2}, "SCALAR");
  gltf.add_primitive({{"attributes", {{"POSITION", 0}}}, {"mode", 5}});
  gltf.add_primitive({{"attributes", {{"POSITION", 0}}}, {"mode", 6}, {"indices", 1}});
  gltf.add_primitive({{"attributes", {{"POSITION", 0}}}, {"mode", 3}}); // lines are ignored
  const Surface_file surface = gltf.read();
  EXPECT_EQ(surface.corners, (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3, 0, 1, 3, 0, 3, 2}));
}

TEST(Read_gltf, applies_transforms_of_the_hierarchy)
{
  // (x, y, z) is scaled to (x, 2 y, 3 z), turned by 90 degrees to (-2 y, x, 3 z) and translated.
  Gltf gltf = tetrahedron();
  const double root = std::sqrt(0.5);
  gltf.document["nodes"] = {
      {{"mesh", 0}, {"rotation", {0, 0, root, root}}, {"scale", {1, 2, 3}}},
      {{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 10, 20, 30, 1}}, {"children", {0}}}};
  const std::vector<Point> expected = {{10, 20, 30}, {10, 21, 30}, {8, 20, 30}, {10, 20, 33}};
  for(const bool has_scene : {false, true})
  {
    if(has_scene)
      gltf.document["scenes"] = {{{"nodes", {1}}}};
    const Surface_file surface = gltf.read();
    ASSERT_EQ(surface.points.size(), 4u);
    for(std::size_t i = 0; i < 4; ++i)
      EXPECT_LT(program::norm(surface.points[i] - expected[i]), 1e-14); // 10 round-off errors
    EXPECT_NEAR(volume(surface), 1., 1e-12); // six times the volume of the tetrahedron, 1 / 6
  }
}

TEST(Read_gltf, joins_instances_and_keeps_the_orientation_of_mirrored_ones)
{
  Gltf gltf = tetrahedron();
  gltf.document["nodes"] = {
      {{"mesh", 0}},
      {{"mesh", 0}, {"translation", {5, 0, 0}}, {"scale", {-2, 1, 1}}},
      {{"mesh", 0}, {"matrix", {0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 8, 0, 0, 1}}}};
  gltf.document["scenes"] = {{{"nodes", {2}}}, {{"nodes", {0, 1}}}};
  gltf.document["scene"] = 1;
  const Surface_file two = gltf.read();
  EXPECT_EQ(two.points.size(), 8u);
  EXPECT_EQ(two.number_of_polygons(), 8u);
  EXPECT_EQ(two.points[5], (Point{3, 0, 0}));
  EXPECT_DOUBLE_EQ(volume(two), 1. / 6. + 2. / 6.);
  gltf.document["scene"] = 0;
  EXPECT_DOUBLE_EQ(volume(gltf.read()), 1. / 6.);
}

TEST(Read_gltf, reads_sparse_and_quantized_positions)
{
  for(const bool has_view : {false, true})
  {
    Gltf gltf;
    // The maximum of the type is 1. Each element is padded to eight bytes.
    const std::int16_t one = 32767;
    const int points = gltf.add_view(
        std::vector<std::int16_t>{0, 0, 0, 7, 9, 9, 9, 7, 0, one, 0, 7, 0, 0, one, 7});
    gltf.document["bufferViews"][0]["byteStride"] = 8;
    const int indices = gltf.add_view(std::vector<std::uint8_t>{1, 2, 3});
    const int values = gltf.add_view(std::vector<std::int16_t>{one, 0, 0, 0, one, 0, 0, 0, one});
    json accessor = {{"componentType", 5122},
                     {"normalized", true},
                     {"count", 4},
                     {"type", "VEC3"},
                     {"sparse",
                      {{"count", 3},
                       {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                       {"values", {{"bufferView", values}}}}}};
    if(has_view)
      accessor["bufferView"] = points;
    gltf.document["accessors"].push_back(accessor);
    gltf.add(tetrahedron_corners, "SCALAR");
    gltf.add_primitive({{"attributes", {{"POSITION", 0}}}, {"indices", 1}});
    gltf.document["extensionsRequired"] = {"KHR_mesh_quantization"};
    expect_tetrahedron(gltf.read());
  }
}

TEST(Read_gltf, reads_texture_coordinates)
{
  const auto uv_of = [](const auto& numbers, bool normalized)
  {
    Gltf gltf;
    gltf.add(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    gltf.add(numbers, "VEC2", normalized);
    gltf.add_primitive({{"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 1}}}});
    return gltf.read().uv;
  };
  // The v coordinate is measured from the top.
  const std::vector<std::array<double, 2>> expected = {{0, 1}, {1, 1}, {0.2, 0}};
  EXPECT_EQ(uv_of(std::vector<std::uint8_t>{0, 0, 255, 0, 51, 255}, true), expected);
  EXPECT_EQ(uv_of(std::vector<std::uint16_t>{0, 0, 65535, 0, 13107, 65535}, true), expected);
  EXPECT_EQ(uv_of(std::vector<float>{0, 0, 1, 0, 0.25, 1}, false),
            (std::vector<std::array<double, 2>>{{0, 1}, {1, 1}, {0.25, 0}}));
  // If a primitive has none, all are discarded.
  Gltf gltf = tetrahedron();
  gltf.add(std::vector<float>(8, 0.f), "VEC2");
  gltf.add_primitive({{"attributes", {{"POSITION", 0}, {"TEXCOORD_0", 2}}}});
  EXPECT_TRUE(gltf.read().uv.empty());
}

TEST(Read_gltf, points_become_a_cloud)
{
  Gltf gltf;
  gltf.add(tetrahedron_points, "VEC3");
  gltf.add(std::vector<float>{0, 0, 1, 0, 1, 0, 1, 0, 0, 0, 1, 1}, "VEC3");
  gltf.add_primitive({{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}, {"mode", 0}});
  gltf.document["nodes"] = {{{"mesh", 0}, {"scale", {1, 1, -2}}}};
  const Surface_file cloud = gltf.read();
  EXPECT_EQ(cloud.number_of_polygons(), 0u);
  EXPECT_EQ(cloud.points, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -2}}));
  // The plane y + z = 0 becomes y - z / 2 = 0.
  const Point& normal = cloud.normals[3];
  EXPECT_EQ(normal[1], -2. * normal[2]);
  EXPECT_GT(normal[1], 0.);
  EXPECT_LT(cloud.normals[0][2], 0.);
}

TEST(Read_gltf, reads_buffers_in_the_same_folder_only)
{
  const fs::path folder = fs::path(testing::TempDir()) / "read_gltf_test";
  fs::create_directories(folder / "sub");
  Gltf gltf = tetrahedron();
  std::ofstream(folder / "sub/a b.bin", std::ios::binary) << gltf.buffer;
  const auto write = [&](const std::string& uri)
  {
    gltf.document["buffers"] = {{{"byteLength", gltf.buffer.size()}, {"uri", uri}}};
    std::ofstream(folder / "a.gltf") << gltf.document.dump();
    return (folder / "a.gltf").string();
  };
  expect_tetrahedron(program::read_surface_file(write("sub/a%20b.bin")));
  const auto expect = [&](const std::string& uri, const std::string& error)
  {
    const std::string name = write(uri);
    EXPECT_PRED_FORMAT2(testing::IsSubstring, error, error_of(gltf.document.dump(), name));
  };
  expect("sub/b.bin", "sub/b.bin: there is no such file");
  expect("../read_gltf_test/sub/a%20b.bin", "is not in its folder");
  expect("sub/../../a.bin", "is not in its folder");
  expect((folder / "sub/a b.bin").string(), "is not in its folder");
  expect("", "is not in its folder");
  fs::remove_all(folder);
}

TEST(Read_gltf, reads_what_the_program_writes)
{
  Surface_file surface;
  surface.points = {{0, 0, 0}, {1, 0, 0.5}, {1, 1, 0}, {0, 1, 0.25}};
  surface.corners = {0, 1, 2, 0, 2, 3};
  surface.polygon_begin = {0, 3, 6};
  // The diagonal is a seam, where vertices are repeated.
  surface.corner_uv = {{0.1, 0.1}, {0.4, 0.1}, {0.4, 0.4}, {0.6, 0.6}, {0.9, 0.9}, {0.6, 0.9}};
  for(const std::string& bytes :
      {program::to_gltf("", surface, "PNG"), program::to_glb("", surface, "PNG")})
  {
    const Surface_file result = program::read_gltf(bytes, "");
    EXPECT_EQ(result.points, surface.points); // which are exact in single precision
    EXPECT_EQ(result.corners, surface.corners);
    EXPECT_EQ(result.polygon_begin, surface.polygon_begin);
    for(std::size_t i = 0; i < 4; ++i)
      for(std::size_t k = 0; k < 2; ++k)
      {
        const std::size_t first_corner[] = {0, 1, 2, 5};
        // Two round-off errors of single precision
        EXPECT_NEAR(result.uv[i][k], surface.corner_uv[first_corner[i]][k], 1.2e-7);
      }
  }
}

TEST(Read_gltf, names_required_extensions_that_are_not_supported)
{
  for(const std::string extension :
      {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "EXT_mesh_gpu_instancing"})
  {
    Gltf gltf = tetrahedron();
    gltf.document["extensionsRequired"] = {"KHR_materials_unlit", extension};
    expect_error(gltf, "it requires the extension '" + extension + "', which is not supported");
  }
}

TEST(Read_gltf, reports_errors)
{
  const auto expect = [](const json& patch, const std::string& error)
  {
    Gltf gltf = tetrahedron();
    gltf.document = gltf.document.patch(patch);
    expect_error(gltf, error);
  };
  const auto replace = [](const std::string& path, const json& value) {
    return json{{{"op", "add"}, {"path", path}, {"value", value}}};
  };
  expect(replace("/asset/version", "1.0"), "not a glTF 2.0 file");
  expect(replace("/accessors/0/count", 5), "an array exceeds its buffer");
  expect(replace("/accessors/0/count", 18446744073709551615u), "an array exceeds its buffer");
  expect(replace("/accessors/0/count", -1), "'count' is missing or not a nonnegative integer");
  expect(replace("/accessors/0/byteOffset", 4), "an array exceeds its buffer");
  expect(replace("/accessors/0/type", "VEC2"), "does not have the type VEC3");
  expect(replace("/accessors/0/componentType", 5124), "component type");
  expect(replace("/accessors/0/bufferView", 2), "element 2 of 'bufferViews', which does not exist");
  expect(replace("/bufferViews/0/byteOffset", 1000), "an array exceeds its buffer");
  expect(replace("/bufferViews/0/byteStride", 4), "'byteStride' is too small");
  expect(replace("/bufferViews/0/buffer", 1), "element 1 of 'buffers'");
  expect(replace("/accessors/0/count", 3), "an index exceeds the number of vertices, 3");
  expect(replace("/meshes/0/primitives/0/mode", 7), "mode");
  expect(replace("/meshes/0/primitives/0/attributes/TEXCOORD_0", 1), "the type VEC2");
  expect(replace("/nodes", {{{"mesh", 0}, {"scale", {1, 2}}}}), "'scale' is not an array of 3");
  expect(replace("/nodes", {{{"mesh", 0}, {"scale", {1e300, 1, 1}}, {"children", {1}}},
                            {{"mesh", 0}, {"scale", {1e300, 1, 1}}}}),
         "not finite");
  expect(json{{{"op", "remove"}, {"path", "/accessors/0/bufferView"}}}, "an accessor has no data");
  expect(json{{{"op", "remove"}, {"path", "/meshes"}}}, "it has no points");
  EXPECT_PRED_FORMAT2(testing::IsSubstring, "not a glTF 2.0 file", error_of("[1]"));
}

TEST(Read_gltf, hierarchies_and_shared_arrays_are_bounded)
{
  Gltf gltf = tetrahedron();
  gltf.document["nodes"] = {{{"children", {1}}}, {{"children", {0}}}};
  gltf.document["scenes"] = {{{"nodes", {0}}}};
  expect_error(gltf, "a node has several parents");
  gltf = Gltf();
  gltf.add(std::vector<float>(30000), "VEC3");
  gltf.add_primitive({{"attributes", {{"POSITION", 0}}}});
  for(int i = 0; i < 2000; ++i)
    gltf.document["nodes"].push_back({{"mesh", 0}});
  expect_error(gltf, "repeated too often");
  EXPECT_PRED_FORMAT2(testing::IsSubstring, "not a glTF 2.0 file",
                      error_of(std::string(100000, '[')));
  EXPECT_PRED_FORMAT2(
      testing::IsSubstring, "not a glTF 2.0 file",
      error_of("{\"a\":" + std::string(100000, '[') + std::string(100000, ']') + "}"));
}

TEST(Read_gltf, truncated_files_are_rejected)
{
  for(const std::string& bytes : {tetrahedron().text(), tetrahedron().glb()})
    for(std::size_t i = 0; i < bytes.size(); ++i)
      EXPECT_EQ(error_of(bytes.substr(0, i)).substr(0, 6), "name: ") << i;
}

} // namespace read_gltf_test
