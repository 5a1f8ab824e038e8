// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the time of isolines and of splits along them. --quick: small meshes only.
#include "models.h"
#include "report.h"

#include <CGAL/Geodesic_processing/isolines.h>
#include <CGAL/Geodesic_processing/split_at_isolines.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <string>
#include <vector>

namespace {

using namespace benchmarks;
namespace GP = CGAL::Geodesic_processing;

// Returns the median of the milliseconds of several calls.
template <typename Function>
std::string milliseconds(const Function& f)
{
  std::vector<double> times;
  for(int i = 0; i < 5; ++i)
    times.push_back(cpu_seconds(f));
  return format_fixed(1e3 * median(times), 0);
}

// Adds the times for 20 isolines of the distance from a vertex in the middle of the range.
void add_row(const std::string& name, Mesh mesh, Table& table)
{
  const auto value = mesh.add_property_map<Vertex, double>("v:value").first;
  const auto center = mesh.point(Vertex(Mesh::size_type(mesh.number_of_vertices() / 2)));
  double largest = 0.;
  for(const Vertex v : mesh.vertices())
  {
    value[v] = std::sqrt(CGAL::squared_distance(mesh.point(v), center));
    largest = std::max(largest, value[v]);
  }
  std::vector<double> isovalues;
  for(int i = 1; i <= 20; ++i)
    isovalues.push_back(largest * i / 21.);

  const auto domain = GP::make_domain(mesh);
  std::vector<GP::Isoline<Mesh>> lines;
  Mesh split;
  const auto label = split.add_property_map<Face, std::size_t>("f:label").first;
  const auto find = [&](const auto& surface)
  {
    lines.clear();
    GP::isolines(surface, value, isovalues, std::back_inserter(lines));
  };
  const auto cut = [&](const auto& surface)
  {
    split.clear_without_removing_property_maps();
    GP::split_at_isolines(surface, value, isovalues, split, label);
  };
  const std::string of_domain = milliseconds([&] { GP::make_domain(mesh); }),
                    lines_of_domain = milliseconds([&] { find(domain); }),
                    lines_of_mesh = milliseconds([&] { find(mesh); }),
                    split_of_domain = milliseconds([&] { cut(domain); }),
                    split_of_mesh = milliseconds([&] { cut(mesh); });
  std::size_t number_of_locations = 0;
  for(const auto& line : lines)
    number_of_locations += line.locations.size();
  table.add({name, std::to_string(mesh.number_of_vertices()), std::to_string(number_of_locations),
             of_domain, lines_of_domain, lines_of_mesh, split_of_domain, split_of_mesh});
}

} // namespace

int main(int argc, char* argv[])
{
  const bool is_quick = argc > 1 && std::string(argv[1]) == "--quick";
  std::printf("20 isolines of the distance from a vertex: milliseconds\n\n");
  Table table("milliseconds", {"mesh", "vertices", "locations", "domain", "isolines, domain",
                               "isolines, mesh", "split, domain", "split, mesh"});
  for(const unsigned level : {5u, 8u})
    if(!is_quick || level == 5)
      add_row("icosphere " + std::to_string(level), icosphere(level), table);
  for(const std::size_t n : {100u, 1000u})
    if(!is_quick || n == 100)
      add_row("square " + std::to_string(n), jittered_square(n), table);
  table.print();
}
