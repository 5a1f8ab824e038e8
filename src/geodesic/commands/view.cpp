// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"
#include "commands/command_utilities.h"
#include "io/Output_file.h"
#include "io/compress.h"
#include "io/errors.h"
#include "io/write_surface_file.h"
#include "readers/Scanner.h"
#include "readers/base64.h"
#include "readers/read_bytes.h"

#include <filesystem>
#include <string_view>
#include <system_error>

namespace program {

namespace {

// The element of the page that contains the surface.
constexpr std::string_view empty_model =
    R"(<script type="text/plain" id="model" data-name=""></script>)";

// The page responds quickly up to this number of faces.
constexpr std::size_t max_number_of_faces = 500'000;

// Returns the file of the page: that of the installation, or that of the build folder. Empty if
// there is none.
std::string find_page()
{
  std::error_code error;
  const auto executable = std::filesystem::read_symlink("/proc/self/exe", error);
  for(const char* const relative :
      {"../" GEODESIC_PROCESSING_DATA_FOLDER "/viewer.html", "viewer/viewer.html"})
  {
    const auto file = executable.parent_path() / relative;
    if(std::filesystem::is_regular_file(file, error))
      return file.lexically_normal().string();
  }
  return {};
}

// Reads the page and checks that a surface can be added.
std::string read_page(const std::string& filename)
{
  std::string page(std::string_view(read_bytes(filename)));
  if(page.find(empty_model) == std::string::npos)
    fail(filename, "it is not the page of the viewer");
  return page;
}

// Returns a text as the value of an attribute.
std::string escaped(const std::string& text)
{
  std::string result;
  for(const char c : text)
    switch(c)
    {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += c;
    }
  return result;
}

// Returns the part of a surface that queries depend on.
Surface_file without_properties(const Surface_file& file)
{
  Surface_file result;
  result.points = file.points;
  result.corners = file.corners;
  result.polygon_begin = file.polygon_begin;
  if(file.number_of_polygons() > 0)
    return result;
  result.normals = file.normals;
  const auto radius = file.properties.find("radius");
  if(radius != file.properties.end())
    result.properties.insert(*radius);
  return result;
}

// Returns the element with the surface. The page decompresses it.
std::string model_element(const Surface_file& file, const std::string& name)
{
  return "<script type=\"text/plain\" id=\"model\" data-name=\"" + escaped(name) + "\">" +
         to_base64(compress(to_ply(without_properties(file)))) + "</script>";
}

void run_view(Job& job, const std::string& page_option)
{
  if(job.output().empty())
    throw Usage_error("view: -o with the file of the page is required.");
  if(!job.values().empty() || !job.picture().empty())
    throw Usage_error("view: only -o is written; the page itself saves values and pictures.");
  const std::string filename = page_option.empty() ? find_page() : page_option;
  if(filename.empty())
    throw Usage_error("view: the page of the viewer was not built; the target viewer builds it if "
                      "emscripten and npm are installed, or pass its file by --page.");
  const Surface& surface = job.read({"html"});
  if(surface.file.number_of_polygons() > max_number_of_faces)
    job.print_warning(surface.name + ": it has more than 500,000 faces, so the page will be slow.");

  job.begin_stage("write");
  std::string page = read_page(filename);
  page.replace(page.find(empty_model), empty_model.size(),
               model_element(surface.file, std::filesystem::path(job.input()).filename().string()));
  write_file(job.output(), page);
  job.report("bytes", page.size());
  job.finish();
}

} // namespace

void add_view(CLI::App& program)
{
  Command command(program, "view",
                  "write a page for the browser that shows the surface and computes distances, "
                  "paths, cells, samples and decals where the reader clicks");
  const auto job = std::make_shared<Job>(command);
  const auto page = std::make_shared<std::string>();
  command.describe("--output", "write the page: .html");
  command.add("--page", *page, "FILE",
              "page of the viewer without a surface (default: that of the installation)");
  command.set_callback([job, page] { run_view(*job, *page); });
}

} // namespace program
