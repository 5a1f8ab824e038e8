// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Output_file.h"
#include "io/write_surface_file.h"
#include "repair/Surface.h"
#include "io/colors.h"
#include "io/errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace write_files_test {

namespace fs = std::filesystem;
using program::Surface_file;

Surface_file triangle_strip()
{
  Surface_file surface;
  surface.points = {{0, 0, 0.1}, {1. / 3., 0, 1e-300}, {0, 1e300, -0.}, {1, 1, 1}};
  surface.corners = {0, 1, 2, 2, 1, 3};
  surface.polygon_begin = {0, 3, 6};
  surface.normals = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}};
  surface.properties["distance"] = {0., 0.1, INFINITY, 2.};
  return surface;
}

// Provides a new folder that is removed by the destructor.
struct Folder
{
  fs::path path =
      fs::path(testing::TempDir()) /
      ("write_files_" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
       testing::UnitTest::GetInstance()->current_test_info()->name());
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  std::string operator/(const std::string& name) const { return (path / name).string(); }
  std::size_t files() const
  {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path), {}));
  }
};

TEST(Write_files, ply_and_vtp_round_trip_exactly)
{
  const Folder folder;
  const Surface_file surface = triangle_strip();
  for(const char* const name : {"a.ply", "a.vtp"})
  {
    program::write_surface_file(folder / name, surface);
    const Surface_file again = program::read_surface_file(folder / name);
    EXPECT_EQ(again.points, surface.points) << name;
    EXPECT_EQ(again.corners, surface.corners) << name;
    EXPECT_EQ(again.polygon_begin, surface.polygon_begin) << name;
    EXPECT_EQ(again.normals, surface.normals) << name;
    EXPECT_EQ(again.properties, surface.properties) << name;
  }
}

TEST(Write_files, readers_skip_face_attributes)
{
  const Folder folder;
  Surface_file surface = triangle_strip();
  surface.vectors["flow"] = {{1., 2., 3.}, {4., 5., 6.}};
  surface.face_numbers["part"] = {7, 4000000000};
  for(const char* const name : {"a.ply", "a.vtp"})
  {
    program::write_surface_file(folder / name, surface);
    const Surface_file again = program::read_surface_file(folder / name);
    EXPECT_EQ(again.points, surface.points) << name;
    EXPECT_EQ(again.corners, surface.corners) << name;
    EXPECT_EQ(again.properties, surface.properties) << name;
  }
  const std::string ply = program::to_ply(surface);
  EXPECT_NE(ply.find("property double flow_y\n"), std::string::npos);
  EXPECT_NE(ply.find("property uint part\n"), std::string::npos);
  const std::string vtp = program::to_vtp(surface);
  EXPECT_GT(vtp.find("Name=\"flow\" NumberOfComponents=\"3\""), vtp.find("<CellData>"));
  EXPECT_NE(vtp.find("Name=\"flow\""), std::string::npos);
  EXPECT_GT(vtp.find("Name=\"part\" NumberOfComponents=\"1\""), vtp.find("<CellData>"));
  EXPECT_NE(vtp.find("Name=\"part\""), std::string::npos);
}

TEST(Write_files, off_and_obj_round_trip_geometry_exactly)
{
  const Folder folder;
  const Surface_file surface = triangle_strip();
  for(const char* const name : {"a.off", "a.obj"})
  {
    program::write_surface_file(folder / name, surface, "distance");
    const Surface_file again = program::read_surface_file(folder / name);
    EXPECT_EQ(again.points, surface.points) << name;
    EXPECT_EQ(again.corners, surface.corners) << name;
  }
  EXPECT_EQ(program::read_surface_file(folder / "a.off").normals, surface.normals);
}

TEST(Write_files, ply_writes_colors_as_bytes)
{
  const Folder folder;
  Surface_file surface = triangle_strip();
  surface.properties["red"] = {0., 17., 255., 3.};
  surface.properties["green"] = {0., 0.5, 1., 0.}; // not byte values
  surface.polylines = {{{0., 0., 0.}, {1., 0., 0.}}};
  program::write_surface_file(folder / "a.ply", surface);
  const std::string bytes = program::to_ply(surface);
  EXPECT_NE(bytes.find("property uchar red\n"), std::string::npos);
  EXPECT_NE(bytes.find("property double green\n"), std::string::npos);
  Surface_file again = program::read_surface_file(folder / "a.ply");
  for(auto& [name, values] : again.properties)
  {
    EXPECT_EQ(values.size(), 6u); // including the values of the polyline
    values.resize(4);
  }
  EXPECT_EQ(again.properties, surface.properties);
  EXPECT_EQ(again.corners, surface.corners);
}

TEST(Write_files, obj_writes_colors_without_texture)
{
  const Folder folder;
  Surface_file surface = triangle_strip();
  surface.polylines = {{{0., 0., 0.}, {1., 0., 0.}}};
  surface.properties = {
      {"red", {0., 17., 255., 3.}}, {"green", {0., 1., 128., 0.}}, {"blue", {2., 0., 0., 254.}}};
  program::write_surface_file(folder / "a.obj", surface);
  Surface_file again = program::read_surface_file(folder / "a.obj");
  for(auto& [name, values] : again.properties)
  {
    EXPECT_EQ(values.size(), 6u); // including the values of the polyline
    values.resize(4);
  }
  EXPECT_EQ(again.properties, surface.properties);
  surface.uv.resize(4);
  EXPECT_NE(program::to_obj(surface).find("v 1 1 1\n"), std::string::npos);
}

TEST(Write_files, obj_writes_texture_coordinates_per_corner)
{
  Surface_file surface = triangle_strip();
  surface.normals.clear();
  surface.corner_uv = {{0., 0.}, {1., 0.}, {0., 1.}, {0., 0.}, {0.5, 0.5}, {1., 0.}};
  surface.material = "a.mtl";
  const std::string text = program::to_obj(surface);
  EXPECT_EQ(text.substr(0, text.find("v ")), "mtllib a.mtl\nusemtl texture\n");
  EXPECT_NE(text.find("vt 0 0\nvt 1 0\nvt 0 1\nvt 0.5 0.5\nf 1/1 2/2 3/3\nf 3/1 2/4 4/2\n"),
            std::string::npos);
}

TEST(Write_files, keeps_point_clouds)
{
  const Folder folder;
  Surface_file surface = triangle_strip();
  surface.corners.clear();
  surface.polygon_begin = {0};
  for(const char* const name : {"a.ply", "a.off", "a.obj", "a.vtp"})
  {
    program::write_surface_file(folder / name, surface);
    const Surface_file again = program::read_surface_file(folder / name);
    EXPECT_EQ(again.points, surface.points) << name;
    EXPECT_EQ(again.number_of_polygons(), 0u) << name;
  }
}

TEST(Write_files, writes_polylines_after_points)
{
  Surface_file surface;
  surface.polylines = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}};
  const std::string obj = program::to_obj(surface);
  EXPECT_EQ(obj, "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\n");
  EXPECT_EQ(program::read_vtp(program::to_vtp(surface), "").points, surface.polylines[0]);
  EXPECT_EQ(program::read_ply(program::to_ply(surface), "").points, surface.polylines[0]);
}

TEST(Write_files, ply_keeps_edges)
{
  Surface_file surface;
  surface.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  surface.edges = {{2, 0}, {1, 2}};
  EXPECT_EQ(program::read_ply(program::to_ply(surface), "").edges, surface.edges);
}

TEST(Write_files, write_is_atomic)
{
  const Folder folder;
  const std::string name = folder / "a.ply";
  std::ofstream(name) << "old";
  program::write_file(name, "new");
  std::ifstream file(name);
  std::string content;
  file >> content;
  EXPECT_EQ(content, "new");
  EXPECT_EQ(folder.files(), 1u);

  EXPECT_THROW(program::write_file(folder / "none/a.ply", "x"), program::Output_error);
  EXPECT_THROW(program::write_file(folder.path.string(), "x"), program::Output_error);
  if(fs::exists("/dev/full"))
  {
    EXPECT_THROW(program::write_file("/dev/full", "x"), program::Output_error);
    EXPECT_TRUE(fs::is_character_file("/dev/full")); // the device was not replaced
  }
  EXPECT_EQ(folder.files(), 1u);
}

TEST(Write_files, follows_symbolic_links)
{
  const Folder folder;
  std::ofstream(folder / "a.ply") << "old";
  fs::create_symlink("a.ply", folder / "link.ply");
  program::write_file(folder / "link.ply", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link.ply"));
  EXPECT_EQ(fs::file_size(folder / "a.ply"), 3u);
  EXPECT_EQ(folder.files(), 2u);
}

TEST(Write_files, rejects_unknown_extensions)
{
  EXPECT_THROW(program::check_output_extension("a.stl"), program::Usage_error);
  EXPECT_NO_THROW(program::check_output_extension("A.PLY"));
}

TEST(Colors, nonfinite_values_are_gray)
{
  const std::vector<program::Color> colors = program::colors_of({0., 0.5, 1., INFINITY, NAN});
  EXPECT_EQ(colors[0], program::viridis(0.));
  EXPECT_EQ(colors[1], program::viridis(0.5));
  EXPECT_EQ(colors[2], program::viridis(1.));
  EXPECT_EQ(colors[3], program::gray);
  EXPECT_EQ(colors[4], program::gray);
}

TEST(Colors, labels_have_distinct_colors)
{
  // The tour draws sixty seeds. A screen can show colors that differ by two of 255 levels.
  for(long long i = 0; i < 60; ++i)
    for(long long j = 0; j < i; ++j)
    {
      const program::Color a = program::color_of_label(i), b = program::color_of_label(j);
      EXPECT_GT(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 2. / 255.) << i << ' ' << j;
    }
  EXPECT_EQ(program::color_of_label(-1), program::gray);
}

} // namespace write_files_test
