// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Scanner.h"
#include "readers/Surface_file.h"

namespace program {

namespace {

// Rows of numbers, all with the same number of columns.
struct Table
{
  std::optional<double> count; // a single number on the first line
  std::size_t columns = 0;
  std::vector<double> values;
  std::size_t rows() const { return columns == 0 ? 0 : values.size() / columns; }
};

Table read_table(std::string_view bytes, const std::string& name)
{
  Table table;
  Scanner scanner(bytes, name, '#');
  scanner.splits_at_commas = true;
  std::vector<double> row;
  for(bool is_first_line = true; scanner.next_line(); is_first_line = false)
  {
    if(scanner.rest_of_line().substr(0, 2) == "//")
      continue;
    row.clear();
    for(std::string_view word = scanner.word(); !word.empty(); word = scanner.word())
      row.push_back(row.size() < 3 ? scanner.parse_coordinate(word) : scanner.parse_number(word));
    // Some writers begin with the number of points.
    if(is_first_line && row.size() == 1)
    {
      table.count = row[0];
      continue;
    }
    if(row.size() < 3)
      scanner.fail("a point needs three coordinates");
    if(table.columns == 0)
      table.columns = row.size();
    if(row.size() != table.columns)
      scanner.fail("it has " + std::to_string(row.size()) +
                   " numbers, but the previous lines have " + std::to_string(table.columns));
    table.values.insert(table.values.end(), row.begin(), row.end());
  }
  return table;
}

Surface_file from_table(const Table& table, std::size_t number_of_points, bool normals_after_points)
{
  Surface_file surface;
  surface.points.resize(number_of_points);
  const bool has_normals = normals_after_points || table.columns >= 6;
  if(has_normals)
    surface.normals.resize(number_of_points);
  for(std::size_t i = 0; i < number_of_points; ++i)
    for(std::size_t c = 0; c < 3; ++c)
    {
      surface.points[i][c] = table.values[i * table.columns + c];
      if(has_normals)
        surface.normals[i][c] = normals_after_points ? table.values[(i + number_of_points) * 3 + c]
                                                     : table.values[i * table.columns + 3 + c];
    }
  return surface;
}

} // namespace

// Reads rows of x y z or x y z nx ny nz, optionally after a count. Additional columns are skipped.
Surface_file read_xyz(std::string_view bytes, const std::string& name)
{
  const Table table = read_table(bytes, name);
  if(table.count && *table.count != static_cast<double>(table.rows()))
    fail(name, "the count in its first line differs from the number of points, " +
                   std::to_string(table.rows()));
  return from_table(table, table.rows(), false);
}

// Reads rows with normals. If a count precedes them, the file contains all points and then all
// normals.
Surface_file read_pwn(std::string_view bytes, const std::string& name)
{
  const Table table = read_table(bytes, name);
  if(table.count && table.columns == 3 && *table.count * 2. == static_cast<double>(table.rows()))
    return from_table(table, table.rows() / 2, true);
  return read_xyz(bytes, name);
}

} // namespace program
