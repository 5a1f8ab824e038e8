// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the processor time and the peak memory of commands of the program on jittered grids.
#include "report.h"

#include "triangulations.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace benchmarks;
using Arguments = std::vector<std::string>;

// Writes a jittered grid of n x n vertices as a binary PLY file of double precision.
void write_grid(const std::filesystem::path& file, std::size_t n)
{
  const auto grid = CGAL::Geodesic_processing::test::square(n - 1, 0.25);
  std::ofstream out(file, std::ios::binary);
  out << "ply\nformat binary_little_endian 1.0\nelement vertex " << grid.points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
      << grid.corners.size() / 3 << "\nproperty list uchar int vertex_indices\nend_header\n";
  const auto write = [&out](const auto& value)
  { out.write(reinterpret_cast<const char*>(&value), sizeof(value)); };
  for(const auto& point : grid.points)
    for(const double x : point)
      write(x);
  for(std::size_t c = 0; c < grid.corners.size(); c += 3)
  {
    write(std::uint8_t(3));
    for(std::size_t i = 0; i < 3; ++i)
      write(std::int32_t(grid.corners[c + i]));
  }
  if(!out.flush())
    throw std::runtime_error("The grid cannot be written.");
}

struct Cost
{
  double seconds;
  double bytes; // peak
};

// Runs a command and returns its cost.
Cost run(const Arguments& command)
{
  std::vector<char*> arguments;
  for(const std::string& argument : command)
    arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  std::fflush(stdout);
  const pid_t process = fork();
  if(process == 0)
  {
    if(std::freopen("/dev/null", "w", stdout) != nullptr)
      execv(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 0;
  rusage usage = {};
  if(process < 0 || wait4(process, &status, 0, &usage) != process || status != 0)
    throw std::runtime_error("The command " + command[1] + " fails.");
  const auto seconds = [](const timeval& time)
  { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); };
  return {seconds(usage.ru_utime) + seconds(usage.ru_stime), 1024. * double(usage.ru_maxrss)};
}

void measure(const std::string& program, const std::filesystem::path& folder, bool is_quick)
{
  Table table("commands on grids", {"vertices", "command", "processor time [s]", "peak [GB]"});
  for(const std::size_t n : is_quick ? std::vector<std::size_t>{100}
                                     : std::vector<std::size_t>{100, 316, 1000, 3162, 4472})
  {
    const std::string input = (folder / "grid.ply").string();
    const std::string output = (folder / "output.ply").string();
    write_grid(input, n);
    const std::string last_vertex = std::to_string(n * n - 1);
    const std::string remeshed_vertices = n < 1000 ? "2000" : "50000";
    const auto add = [&](const std::string& name, const Arguments& arguments)
    {
      Arguments command = {program, name, input, "--threads", "1"};
      command.insert(command.end(), arguments.begin(), arguments.end());
      // The first command that needs this much memory waits until a virtual machine gets it.
      if(name == "distance")
        run(command);
      const Cost cost = run(command);
      table.add({std::to_string(n * n), name, format_significant(cost.seconds),
                 format_significant(cost.bytes / 1e9)});
    };
    add("distance", {"--source", "0", "--method", "fast-marching"});
    add("path", {"--from", "0", "--to", last_vertex});
    add("voronoi", {"--number", "100"});
    add("sample", {"--number", "1000"});
    add("remesh", {"--number", remeshed_vertices, "-o", output});
  }
  table.print();
}

} // namespace

// commands [--quick] PROGRAM
int main(int argc, char* argv[])
{
  const bool is_quick = argc > 1 && std::strcmp(argv[1], "--quick") == 0;
  if(argc < 2 + is_quick)
  {
    std::fprintf(stderr, "commands: the program is missing.\n");
    return EXIT_FAILURE;
  }
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / "geodesic_processing_commands";
  std::filesystem::create_directories(folder);
  measure(argv[1 + is_quick], folder, is_quick);
  std::filesystem::remove_all(folder);
}
