// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_BENCHMARK_PATH_COMPARISON_H
#define CGAL_GEODESIC_PROCESSING_BENCHMARK_PATH_COMPARISON_H

#include <CGAL/Geodesic_processing.h>

#include "Paper_path_tracer.h"
#include "models.h"
#include "report.h"

#include "paths/descent.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace benchmarks {

// Measures the lengths of paths from random vertices to three sources of a mesh. All methods trace
// the same pairs of vertices.
class Path_comparison
{
  using Index = CGAL::Geodesic_processing::internal::Index;
  using Location = CGAL::Geodesic_processing::internal::Surface_location;

public:
  // step  of Paper_path_tracer, in mean edge lengths
  Path_comparison(const Mesh& mesh, double step)
      : m_domain(CGAL::Geodesic_processing::make_domain(mesh)), m_arrays(*m_domain.triangles()),
        m_exact(m_domain), m_marching(m_domain), m_finder(m_domain), m_step(step)
  {
    std::mt19937 random(1);
    for(const Vertex source : three_sources(num_vertices(mesh)))
      add_source(source, random);
  }

  static std::vector<std::string> table_header()
  {
    return {"mesh",    "distances",   "path",      "excess %",      "shortened: excess %",
            "arrived", "set-up [ms]", "path [ms]", "shortened [ms]"};
  }

  // Adds at most `max_number` rows. The first one is that of the paper's tracer.
  void add_rows(Table& table, const std::string& name, std::size_t max_number = 100) const
  {
    for(std::size_t i = 0; i < std::min(max_number, m_rows.size()); ++i)
    {
      const Row& row = m_rows[i];
      const bool is_shortened = row.shortened.count > 0;
      const auto milliseconds = [&](double seconds) { return format_significant(1e3 * seconds); };
      table.add({name, row.distances, row.path, row.excess.percent(3),
                 is_shortened ? row.shortened.percent(3) : "-",
                 std::to_string(row.excess.count) + " of " + std::to_string(number_of_paths),
                 is_shortened ? milliseconds(row.setup / number_of_sources) : "-",
                 milliseconds(row.seconds / number_of_paths),
                 is_shortened ? milliseconds(row.shortened_seconds / number_of_paths) : "-"});
    }
  }

private:
  static constexpr std::size_t number_of_paths = 300, number_of_sources = 3; // in total

  struct Row
  {
    std::string distances, path;
    Mean_and_max excess = {}, shortened = {}; // of the length over the exact distance, relative
    double setup = 0., seconds = 0., shortened_seconds = 0.;
  };

  Row& row(const std::string& distances, const std::string& path)
  {
    const auto found =
        std::find_if(m_rows.begin(), m_rows.end(),
                     [&](const Row& r) { return r.distances == distances && r.path == path; });
    if(found != m_rows.end())
      return *found;
    m_rows.push_back({distances, path});
    return m_rows.back();
  }

  void add_source(Vertex source, std::mt19937& random)
  {
    m_exact.compute(source);
    m_marching.compute(source);
    const auto field = [&](const auto& solver)
    {
      std::vector<double> result(m_arrays.number_of_vertices());
      for(Index i = 0; i < result.size(); ++i)
        result[i] = solver.distance(m_domain.vertex(i)) / m_arrays.scale;
      return result;
    };
    const std::vector<double> exact = field(m_exact), marching = field(m_marching);

    // Relative errors of shorter paths depend on the first triangles.
    const double min_distance = 0.05 * *std::max_element(exact.begin(), exact.end());
    std::vector<Index> starts;
    while(starts.size() < number_of_paths / number_of_sources)
      if(const auto v = Index(random() % exact.size()); exact[v] >= min_distance)
        starts.push_back(v);

    trace(m_domain.index(source), starts, exact, marching, "marching");
    trace(m_domain.index(source), starts, exact, exact, "exact");
    const auto measure_finder = [&](const char* name, const auto& find)
    {
      for(const Index start : starts)
      {
        Row& found = row("-", name);
        double length = 0.;
        found.seconds += cpu_seconds([&] { length = find(m_domain.vertex(start)).length; });
        found.excess.add(length / (m_arrays.scale * exact[start]) - 1.);
      }
    };
    measure_finder("locally_shortest_path()",
                   [&](Vertex v) { return m_finder.locally_shortest_path(v, source); });
    measure_finder("Geodesic_path_finder", [&](Vertex v) { return m_finder(v, source); });
  }

  // Traces paths in a distance field by both methods, before and after shortening.
  void trace(Index source, const std::vector<Index>& starts, const std::vector<double>& exact,
             const std::vector<double>& distance, const std::string& distances)
  {
    using namespace CGAL::Geodesic_processing::internal;
    std::optional<Paper_path_tracer> tracer;
    std::optional<Descent> descent;
    row(distances, "vertex gradients").setup +=
        cpu_seconds([&] { tracer.emplace(m_arrays, distance, source, m_step); });
    row(distances, "face gradients").setup += cpu_seconds(
        [&]
        {
          const Front_source point = {{vertex_location(m_arrays, source)}, 0., 0};
          descent.emplace(m_arrays, std::vector<Front_source>{point});
        });
    const auto add = [&](const char* name, Index start, const auto& trace_path)
    {
      Row& found = row(distances, name);
      std::vector<Location> path;
      found.seconds += cpu_seconds([&] { path = trace_path(start); });
      if(path.empty())
        return;
      found.excess.add(polyline_length(m_arrays, path) / exact[start] - 1.);
      found.shortened_seconds += cpu_seconds([&] { path = shorten_path(m_arrays, path); });
      found.shortened.add(polyline_length(m_arrays, path) / exact[start] - 1.);
    };
    for(const Index start : starts)
    {
      add("vertex gradients", start, [&](Index v) { return (*tracer)(v); });
      add("face gradients", start,
          [&](Index v)
          {
            return (*descent)(vertex_location(m_arrays, v), [&](Index i) { return distance[i]; })
                .locations;
          });
    }
  }

  CGAL::Geodesic_processing::Mesh_domain<Mesh> m_domain;
  const CGAL::Geodesic_processing::internal::Surface_arrays& m_arrays;
  CGAL::Geodesic_processing::Geodesic_distance_solver<Mesh, CGAL::Geodesic_processing::Exact>
      m_exact;
  CGAL::Geodesic_processing::Geodesic_distance_solver<Mesh,
                                                      CGAL::Geodesic_processing::Fast_marching>
      m_marching;
  CGAL::Geodesic_processing::Geodesic_path_finder<Mesh> m_finder;
  double m_step;
  std::vector<Row> m_rows;
};

} // namespace benchmarks

#endif // CGAL_GEODESIC_PROCESSING_BENCHMARK_PATH_COMPARISON_H
