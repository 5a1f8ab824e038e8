// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command view.
#include "Program.h"

#include "io/compress.h"
#include "readers/Surface_file.h"
#include "readers/base64.h"
#include "readers/decompress.h"

namespace view_program_test {

using namespace program_test;

const std::string empty_page =
    "<p>before</p><script type=\"text/plain\" id=\"model\" data-name=\"\"></script><p>after</p>";

// Returns the text between two others, or an empty text.
std::string between(const std::string& text, const std::string& begin, const std::string& end)
{
  const std::size_t first = text.find(begin);
  if(first == std::string::npos)
    return "";
  const std::size_t start = first + begin.size();
  return text.substr(start, text.find(end, start) - start);
}

// Returns the surface in a page.
program::Surface_file embedded(const std::string& page)
{
  const std::string text = between(between(page, "id=\"model\"", "/script"), ">", "<");
  const auto bytes = program::from_base64(text);
  EXPECT_TRUE(bytes.has_value());
  return program::read_ply(program::inflate(bytes.value_or(""), "page"), "page");
}

TEST(compress, is_the_inverse_of_inflate)
{
  std::string bytes = "abc";
  for(int i = 0; i < 20; ++i)
    bytes += bytes.substr(bytes.size() / 3) + static_cast<char>(i);
  for(const std::string& text : {std::string("a"), bytes})
    EXPECT_EQ(program::inflate(program::compress(text), "text"), text);
  EXPECT_LT(program::compress(bytes).size(), bytes.size() / 2);
}

TEST_F(Program, view_writes_the_surface_into_the_page)
{
  write("page.html", empty_page);
  const nlohmann::json result = json("view square.ply --page page.html -o view.html");
  const std::string page = read_file(m_folder / "view.html");
  EXPECT_EQ(result["bytes"], page.size());
  EXPECT_EQ(between(page, "data-name=\"", "\""), "square.ply");
  EXPECT_EQ(page.rfind("<p>before</p>", 0), 0u);
  EXPECT_NE(page.find("</script><p>after</p>"), std::string::npos);
  const program::Surface_file surface = embedded(page);
  EXPECT_EQ(surface.points.size(), 81u);
  EXPECT_EQ(surface.number_of_polygons(), 128u);
  EXPECT_EQ(surface.points[10], (program::Point{1. / 8., 1. / 8., 0.}));
  EXPECT_TRUE(surface.properties.empty());
}

TEST_F(Program, view_of_a_cloud_has_normals_and_radii)
{
  write("page.html", empty_page);
  write("radii.ply",
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\nproperty double y\n"
        "property double z\nproperty double nx\nproperty double ny\n"
        "property double nz\nproperty double radius\nproperty double other\nend_header\n"
        "0 0 0 0 0 1 0.5 7\n1 0 0 0 0 1 0.25 8\n");
  json("view radii.ply --page page.html -o view.html");
  const program::Surface_file cloud = embedded(read_file(m_folder / "view.html"));
  EXPECT_EQ(cloud.normals, (std::vector<program::Point>{{0., 0., 1.}, {0., 0., 1.}}));
  ASSERT_EQ(cloud.properties.size(), 1u);
  EXPECT_EQ(cloud.properties.at("radius"), (std::vector<double>{0.5, 0.25}));
}

TEST_F(Program, view_escapes_the_name_of_the_file)
{
  write("page.html", empty_page);
  write("a\"<&.off", read_file(m_folder / "closed.off"));
  json("view 'a\"<&.off' --page page.html -o view.html");
  EXPECT_EQ(between(read_file(m_folder / "view.html"), "data-name=\"", "\""),
            "a&quot;&lt;&amp;.off");
}

TEST_F(Program, view_rejects_invalid_options)
{
  write("page.html", empty_page);
  write("other.html", "<p>another page</p>");
  expect_failure("view square.ply --page page.html", 1, "-o");
  expect_failure("view square.ply --page page.html -o view.ply", 1, ".html");
  expect_failure("view square.ply --page page.html -o view.html --values v.txt", 1, "only -o");
  expect_failure("view square.ply --page page.html -o view.html --picture p.png", 1, "only -o");
  expect_failure("view square.ply --page none.html -o view.html", 2, "none.html");
  expect_failure("view square.ply --page other.html -o view.html", 2,
                 "it is not the page of the viewer");
  EXPECT_FALSE(fs::exists(m_folder / "view.html"));
}

} // namespace view_program_test
