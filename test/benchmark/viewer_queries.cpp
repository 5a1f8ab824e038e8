// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// viewer_queries [MODEL]: measures the processor time of the queries of the interactive viewer,
// compiled for this processor. test/view/speed.mjs measures the same queries, compiled to
// WebAssembly.
#include "view/Queries.h"

#include "report.h"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>

namespace {

using view::Place;

constexpr unsigned number_of_warm_up_queries = 10, number_of_queries = 15;

// A linear congruential generator with the constants of Numerical Recipes, as in speed.mjs.
class Generator
{
public:
  // Returns a number below `size`.
  std::size_t operator()(std::size_t size)
  {
    m_state = m_state * 1664525u + 1013904223u;
    return static_cast<std::size_t>(m_state / 4294967296. * double(size));
  }

private:
  std::uint32_t m_state = 1;
};

void measure(benchmarks::Table& table, const char* name, const std::function<void()>& query)
{
  for(unsigned i = 0; i < number_of_warm_up_queries; ++i)
    query();
  std::vector<double> seconds;
  for(unsigned i = 0; i < number_of_queries; ++i)
    seconds.push_back(benchmarks::cpu_seconds(query));
  table.add({name, benchmarks::format_fixed(1000. * benchmarks::median(seconds), 1)});
}

void run(const std::string& filename)
{
  program::Surface surface;
  std::unique_ptr<view::Queries> queries;
  const double seconds = benchmarks::cpu_seconds(
      [&]
      {
        surface = program::repair(program::read_surface_file(filename), filename);
        queries = view::mesh_queries(surface);
      });
  benchmarks::Table table("queries", {"query", "time [ms]"});
  table.add({"load", benchmarks::format_fixed(1000. * seconds, 1)});
  const std::size_t size = surface.file.points.size();
  Generator random;
  const auto vertex = [&] { return Place{random(size)}; };
  const auto distances = [&](const char* method)
  {
    queries->distances({vertex()}, method, std::numeric_limits<double>::infinity(),
                       [](double) { return true; });
  };
  measure(table, "euclidean", [&] { distances("euclidean"); });
  measure(table, "exact", [&] { distances("exact"); });
  measure(table, "path", [&] { queries->path(vertex(), vertex(), true); });
  // The decal covers about 2,000 faces.
  double area = 0.;
  for(std::size_t f = 0; f < surface.file.corners.size(); f += 3)
  {
    const std::uint32_t* const c = surface.file.corners.data() + f;
    const auto &p = surface.file.points[c[0]], &q = surface.file.points[c[1]],
               &r = surface.file.points[c[2]];
    const double u[3] = {q[0] - p[0], q[1] - p[1], q[2] - p[2]},
                 v[3] = {r[0] - p[0], r[1] - p[1], r[2] - p[2]};
    area += 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                             u[0] * v[1] - u[1] * v[0]);
  }
  const double width = std::sqrt(2000. * area / (double(surface.file.corners.size()) / 3.));
  measure(table, "decal", [&] { queries->decal(vertex(), {0.1, 0.2, 1.}, width, width); });
  measure(table, "locally", [&] { queries->path(vertex(), vertex(), false); });
  table.print();
}

} // namespace

int main(int argc, char* argv[])
{
  const bool is_default = argc == 1 || argv[1][0] == '-'; // an option of all benchmarks
  const std::string model = is_default ? GEODESIC_PROCESSING_DATA "/meshes/bunny_37k.ply" : argv[1];
  if(is_default && !std::filesystem::exists(model))
    std::printf("%s does not exist.\n", model.c_str());
  else
    run(model);
}
