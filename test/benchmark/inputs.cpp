// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the time from a file to a solver that is ready for a front. --quick: a small mesh only.
#include "models.h"
#include "readers/Surface_file.h"
#include "report.h"

#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>
#include <CGAL/Geodesic_processing/Soup_domain.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/IO/write_points.h>

#include <boost/range/irange.hpp>
#include <boost/range/adaptor/transformed.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

namespace {

using namespace benchmarks;
namespace GP = CGAL::Geodesic_processing;
namespace params = CGAL::parameters;
namespace fs = std::filesystem;

using Domain = GP::Soup_domain<Kernel::Point_3>;

// Returns the least seconds of several calls; the others are longer because of other processes.
template <typename Measure, typename Function>
double least_seconds(const Measure& measure, const Function& f)
{
  double result = measure(f);
  for(int i = 1; i < 5; ++i)
    result = std::min(result, measure(f));
  return result;
}

const auto cpu = [](const auto& f) { return cpu_seconds(f); };
const auto wall = [](const auto& f) { return wall_seconds(f); };

Domain domain_of(const program::Surface_file& file, unsigned number_of_threads)
{
  std::vector<Kernel::Point_3> points;
  points.reserve(file.points.size());
  for(const program::Point& p : file.points)
    points.emplace_back(p[0], p[1], p[2]);
  const auto polygon = [&file](std::size_t f)
  {
    return boost::make_iterator_range(file.corners.data() + file.polygon_begin[f],
                                      file.corners.data() + file.polygon_begin[f + 1]);
  };
  return GP::make_domain(points,
                         boost::irange<std::size_t>(0, file.number_of_polygons()) |
                             boost::adaptors::transformed(polygon),
                         GP::parameters::number_of_threads(number_of_threads));
}

// Reads a file, and constructs a domain and a solver.
void prepare(const std::string& file, unsigned number_of_threads)
{
  const Domain domain =
      domain_of(program::read_surface_file(file, {}, number_of_threads), number_of_threads);
  const GP::Geodesic_distance_solver<CGAL::Surface_mesh<Kernel::Point_3>, GP::Fast_marching> solver(
      domain);
}

void read_by_cgal(const std::string& file, bool as_mesh)
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  if(fs::path(file).extension() == ".xyz")
    CGAL::IO::read_points(file, std::back_inserter(points));
  else if(as_mesh)
  {
    Mesh mesh;
    CGAL::IO::read_polygon_mesh(file, mesh);
  }
  else
    CGAL::IO::read_polygon_soup(file, points, polygons);
}

// Writes a mesh to files of all formats. The names tell the format.
std::vector<std::string> write_files(const Mesh& mesh, const fs::path& folder)
{
  const std::vector<std::pair<std::string, bool>> formats = {
      {"binary.ply", true}, {"text.ply", false},  {"text.off", false}, {"text.obj", false},
      {"text.xyz", false},  {"binary.stl", true}, {"text.stl", false}};
  std::vector<std::string> files;
  for(const auto& [name, is_binary] : formats)
  {
    files.push_back((folder / name).string());
    if(name == "text.xyz")
    {
      std::vector<Kernel::Point_3> points;
      for(const Vertex v : mesh.vertices())
        points.push_back(mesh.point(v));
      CGAL::IO::write_points(files.back(), points, params::stream_precision(17));
    }
    else
      CGAL::IO::write_polygon_mesh(files.back(), mesh,
                                   params::stream_precision(17).use_binary_mode(is_binary));
  }
  return files;
}

void add_row(const std::string& file, double seconds_of_ply, Table& table)
{
  const bool is_mesh = fs::path(file).extension() != ".xyz";
  const double read = least_seconds(cpu, [&] { program::read_surface_file(file); }),
               soup = least_seconds(cpu, [&] { read_by_cgal(file, false); }),
               mesh = is_mesh ? least_seconds(cpu, [&] { read_by_cgal(file, true); }) : 0.;
  std::vector<std::string> row = {fs::path(file).filename().string(),
                                  format_fixed(1e-6 * double(fs::file_size(file)), 1),
                                  format_fixed(1e3 * read, 1), format_fixed(soup / read, 1)};
  if(is_mesh)
  {
    const double total = least_seconds(cpu, [&] { prepare(file, 1); }),
                 one_thread = least_seconds(wall, [&] { prepare(file, 1); }),
                 two_threads = least_seconds(wall, [&] { prepare(file, 2); });
    for(const std::string& cell :
        {format_fixed(mesh / read, 1), format_fixed(1e3 * total, 0),
         format_fixed(total / seconds_of_ply, 2), format_fixed(total / mesh, 2),
         format_fixed(one_thread / two_threads, 2)})
      row.push_back(cell);
  }
  table.add(row);
}

} // namespace

int main(int argc, char* argv[])
{
  const bool is_quick = argc > 1 && std::string(argv[1]) == "--quick";
  const std::size_t n = is_quick ? 100 : 1000;
  const fs::path folder = fs::temp_directory_path() / ("inputs_" + std::to_string(getpid()));
  fs::create_directory(folder);
  const std::vector<std::string> files = write_files(jittered_square(n), folder);
  std::printf("From a file to a solver, square %zu: milliseconds\n\n", n);
  Table table("files", {"file", "MB", "read", "CGAL soup/read", "CGAL mesh/read", "solver",
                        "solver/PLY", "solver/CGAL mesh", "speed-up of 2 threads"});
  const double seconds_of_ply = least_seconds(cpu, [&] { prepare(files.front(), 1); });
  for(const std::string& file : files)
    add_row(file, seconds_of_ply, table);
  table.print();
  fs::remove_all(folder);
}
