// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/write_textured.h"

#include "io/errors.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

#ifdef GEODESIC_PROCESSING_HAS_ASSIMP
#  include <assimp/Importer.hpp>
#  include <assimp/postprocess.h>
#  include <assimp/scene.h>
#endif

namespace write_textured_test {

namespace fs = std::filesystem;
using program::Surface_file;

// Returns two triangles of a square that is folded along the diagonal, with a UV seam there.
Surface_file bent_square()
{
  Surface_file surface;
  surface.points = {{0, 0, 0}, {1, 0, 0.5}, {1, 1, 0}, {0, 1, 0.25}};
  surface.corners = {0, 1, 2, 0, 2, 3};
  surface.polygon_begin = {0, 3, 6};
  surface.corner_uv = {{0.1, 0.1}, {0.4, 0.1}, {0.4, 0.4}, {0.6, 0.6}, {0.9, 0.9}, {0.6, 0.9}};
  return surface;
}

program::Image four_pixels() { return {2, 2, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}}; }

std::string read_file(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Write_textured, glb_buffer_matches_json)
{
  const std::string bytes = program::to_glb("a.glb", bent_square(), "PNG");
  const auto word = [&](std::size_t at)
  {
    std::uint32_t result;
    std::memcpy(&result, bytes.data() + at, 4); // tests run on little-endian machines
    return result;
  };
  ASSERT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(word(4), 2u);
  EXPECT_EQ(word(8), bytes.size());
  EXPECT_EQ(bytes.size() % 4, 0u);
  const std::size_t length = word(12), buffer = 20 + length + 8;
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  EXPECT_EQ(bytes.substr(buffer - 4, 4), std::string("BIN\0", 4));
  EXPECT_EQ(word(buffer - 8), bytes.size() - buffer);
  const auto json = nlohmann::json::parse(bytes.substr(20, length));
  EXPECT_EQ(json["buffers"][0]["byteLength"], bytes.size() - buffer);
  EXPECT_EQ(json["asset"]["version"], "2.0");
  EXPECT_EQ(json["scenes"][0]["nodes"][0], 0);
  EXPECT_EQ(json["nodes"][0]["mesh"], 0);
  const auto& primitive = json["meshes"][0]["primitives"][0];
  const auto attribute_value = [&](const char* attribute, std::size_t at)
  {
    const auto& accessor = json["accessors"][primitive["attributes"][attribute].get<int>()];
    const auto& view = json["bufferViews"][accessor["bufferView"].get<int>()];
    float result;
    std::memcpy(&result, bytes.data() + buffer + view["byteOffset"].get<std::size_t>() + 4 * at, 4);
    return result;
  };
  EXPECT_EQ(json["accessors"][0]["count"], 6); // vertices on the seam are duplicated
  EXPECT_EQ(attribute_value("POSITION", 5), 0.5f);
  EXPECT_EQ(attribute_value("TEXCOORD_0", 4), 0.4f);
  EXPECT_EQ(attribute_value("TEXCOORD_0", 5), 0.6f); // the v coordinate is measured from the top
  const auto& image = json["bufferViews"][json["images"][0]["bufferView"].get<int>()];
  EXPECT_EQ(bytes.substr(buffer + image["byteOffset"].get<std::size_t>(), 3), "PNG");
  EXPECT_EQ(json["accessors"][0]["max"], nlohmann::json({1., 1., 0.5}));
}

TEST(Write_textured, throws_on_float_overflow)
{
  Surface_file surface = bent_square();
  surface.points[0][0] = 1e300;
  EXPECT_THROW(program::to_glb("a.glb", surface, ""), program::Output_error);
}

TEST(Write_textured, assimp_reads_output)
{
#ifdef GEODESIC_PROCESSING_HAS_ASSIMP
  const fs::path folder = fs::path(testing::TempDir()) / "textured";
  fs::create_directories(folder);
  const Surface_file surface = bent_square();
  for(const char* const name : {"a.obj", "a.gltf", "a.glb"})
  {
    const std::string file = (folder / name).string();
    program::write_textured(file, surface, four_pixels());
    Assimp::Importer importer;
    const aiScene* const scene = importer.ReadFile(file, aiProcess_ValidateDataStructure);
    ASSERT_TRUE(scene) << name << ": " << importer.GetErrorString();
    ASSERT_EQ(scene->mNumMeshes, 1u) << name;
    const aiMesh& mesh = *scene->mMeshes[0];
    ASSERT_EQ(mesh.mNumFaces, 2u);
    ASSERT_TRUE(mesh.HasTextureCoords(0));
    for(unsigned corner = 0; corner < 6; ++corner)
    {
      const unsigned i = mesh.mFaces[corner / 3].mIndices[corner % 3];
      const program::Point& p = surface.points[surface.corners[corner]];
      EXPECT_FLOAT_EQ(mesh.mVertices[i].x, float(p[0])) << name;
      EXPECT_FLOAT_EQ(mesh.mVertices[i].z, float(p[2])) << name;
      EXPECT_FLOAT_EQ(mesh.mTextureCoords[0][i].x, float(surface.corner_uv[corner][0])) << name;
      EXPECT_FLOAT_EQ(mesh.mTextureCoords[0][i].y, float(surface.corner_uv[corner][1])) << name;
    }
    // The texture is a PNG file, embedded or in the same folder.
    aiString path;
    ASSERT_EQ(scene->mMaterials[mesh.mMaterialIndex]->GetTexture(aiTextureType_DIFFUSE, 0, &path),
              aiReturn_SUCCESS)
        << name;
    const aiTexture* const embedded = scene->GetEmbeddedTexture(path.C_Str());
    const std::string png =
        embedded ? std::string(reinterpret_cast<const char*>(embedded->pcData), embedded->mWidth)
                 : read_file(folder / path.C_Str());
    EXPECT_EQ(png, program::to_png("", four_pixels())) << name;
  }
  fs::remove_all(folder);
#else
  GTEST_SKIP() << "Without assimp, the test has no second reader of these files.";
#endif
}

} // namespace write_textured_test
