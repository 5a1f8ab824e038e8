// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_MASS_RESULTS_H
#define CGAL_GEODESIC_PROCESSING_TEST_MASS_RESULTS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mass_test {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Polygons = std::vector<std::vector<std::size_t>>;

// A polygon soup, as CGAL reads it from a file.
struct Soup
{
  std::vector<Point> points;
  Polygons polygons;
};

// Reads a mesh file with the readers of CGAL. Returns no value if they fail.
std::optional<Soup> read_soup(const std::filesystem::path& file);

// The triangles of an OBJ file with texture coordinates.
struct Textured_mesh
{
  std::vector<Point> points;
  std::vector<Kernel::Point_2> uv;
  std::vector<std::array<std::size_t, 3>> corners;    // indices of points
  std::vector<std::array<std::size_t, 3>> uv_corners; // indices of texture coordinates
};

// Reads an OBJ file. Returns no value if a face is not a triangle with texture coordinates.
std::optional<Textured_mesh> read_textured_mesh(const std::filesystem::path& file);

// The results of all commands on one surface, in a folder that mass.sh fills:
//   file          the path of the surface
//   runs          one line for each run: command, exit code, seconds, number of lines on standard
//                 error, the first of these lines; separated by tabs
//   target        the vertex at the end of `path` and `emd`, which start at vertex 0
//   COMMAND.json  standard output of a run
//   COMMAND.txt   the values of a run (--values)
//   remesh.off, semiregular.off, flatten.off, atlas.obj   the meshes that were written
class Results
{
public:
  explicit Results(const std::filesystem::path& folder);

  // One line for each violated invariant: command, tab, sentence
  const std::vector<std::string>& violations() const { return m_violations; }
  void add_violation(const std::string& command, const std::string& sentence);
  // Adds the sentence, in which `%` is replaced by the numbers, if the condition is false.
  void expect(bool condition, const std::string& command, const std::string& sentence,
              const std::vector<double>& numbers = {});

  std::filesystem::path path(const std::string& name) const { return m_folder / name; }
  const std::filesystem::path& surface() const { return m_surface; }
  std::size_t target() const { return m_target; }

  // Returns whether the command succeeded and has a JSON object, which json() returns.
  bool has(const std::string& command) const { return m_json.count(command) > 0; }
  const nlohmann::json& json(const std::string& command) const { return m_json.at(command); }
  // Returns a number of the JSON object. Adds a violation and returns NaN if it is missing.
  double number(const std::string& command, const std::string& key);
  // Returns the numbers of COMMAND.txt, row by row. Adds a violation and returns no number if a row
  // has another number of columns, or if a number is NaN, or infinite although `is_finite` is true.
  std::vector<double> values(const std::string& command, std::size_t columns,
                             bool is_finite = true);

private:
  void read_runs();

  std::filesystem::path m_folder, m_surface;
  std::size_t m_target = 0;
  std::map<std::string, nlohmann::json> m_json;
  std::vector<std::string> m_violations;
};

} // namespace mass_test

#endif // CGAL_GEODESIC_PROCESSING_TEST_MASS_RESULTS_H
