// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Scanner.h"
#include "readers/Surface_file.h"
#include "readers/count_lines.h"
#include "readers/parse_chunks.h"

#include <algorithm>
#include <utility>

namespace program {

namespace {

// Rows of numbers, all with the same number of columns.
struct Rows
{
  std::optional<double> count; // a single number on the first line
  std::size_t columns = 0;
  Surface_file surface; // the first three columns, and the next three as normals if they exist
};

// Only the first line of a text can be a count. Reserves memory for the lines of another text, to
// which this one belongs.
Rows read_rows(std::string_view bytes, const std::string& name, bool is_first_line,
               std::string_view whole_text)
{
  Rows rows;
  Surface_file& surface = rows.surface;
  Scanner scanner(bytes, name, '#', Scanner::Separators::blanks_and_commas);
  for(; scanner.next_line(); is_first_line = false)
  {
    if(scanner.starts_with("//"))
      continue;
    std::array<Point, 2> row;
    std::size_t columns = 0;
    for(; !scanner.is_line_empty(); ++columns)
    {
      const double x = columns < 3 ? scanner.coordinate() : scanner.number();
      if(columns < 6)
        row[columns / 3][columns % 3] = x;
    }
    // Some writers begin with the number of points.
    if(is_first_line && columns == 1)
    {
      rows.count = row[0][0];
      continue;
    }
    if(columns < 3)
      scanner.fail("a point needs three coordinates");
    if(rows.columns == 0)
    {
      rows.columns = columns;
      surface.points.reserve(max_number_of_lines(whole_text, std::string_view("0 0 0\n").size()));
      if(columns >= 6)
        surface.normals.reserve(surface.points.capacity());
    }
    if(columns != rows.columns)
      scanner.fail("it has " + std::to_string(columns) + " numbers, but the previous lines have " +
                   std::to_string(rows.columns));
    surface.points.push_back(row[0]);
    if(columns >= 6)
      surface.normals.push_back(row[1]);
  }
  return rows;
}

Surface_file with_checked_count(Rows rows, const std::string& name)
{
  const std::size_t number_of_points = rows.surface.points.size();
  if(rows.count && *rows.count != static_cast<double>(number_of_points))
    fail(name, "the count in its first line differs from the number of points, " +
                   std::to_string(number_of_points));
  return std::move(rows.surface);
}

} // namespace

// Reads rows of x y z or x y z nx ny nz, optionally after a count. Additional columns are skipped.
Surface_file read_xyz(std::string_view bytes, const std::string& name)
{
  return with_checked_count(read_rows(bytes, name, true, bytes), name);
}

Surface_file read_xyz_in_parallel(std::string_view bytes, const std::string& name,
                                  unsigned number_of_threads)
{
  const std::vector<std::string_view> chunks =
      split_lines(bytes, number_of_chunks(bytes.size(), number_of_threads));
  std::vector<Rows> rows(chunks.size());
  const bool is_parsed =
      chunks.size() > 1 &&
      parse_chunks(chunks.size(), number_of_threads,
                   [&](std::size_t i)
                   {
                     rows[i] = read_rows(chunks[i], name, i == 0, i == 0 ? bytes : chunks[i]);
                     return rows[i].columns > 0;
                   });
  const bool has_equal_columns =
      std::all_of(rows.begin(), rows.end(),
                  [&](const Rows& chunk) { return chunk.columns == rows[0].columns; });
  if(!is_parsed || !has_equal_columns)
    return read_xyz(bytes, name);
  Surface_file& surface = rows[0].surface;
  for(std::size_t i = 1; i < rows.size(); ++i)
  {
    const Surface_file& next = rows[i].surface;
    surface.points.insert(surface.points.end(), next.points.begin(), next.points.end());
    surface.normals.insert(surface.normals.end(), next.normals.begin(), next.normals.end());
  }
  return with_checked_count(std::move(rows[0]), name);
}

// Reads rows with normals. If a count precedes them, the file contains all points and then all
// normals.
Surface_file read_pwn(std::string_view bytes, const std::string& name)
{
  Rows rows = read_rows(bytes, name, true, bytes);
  std::vector<Point>& points = rows.surface.points;
  if(!rows.count || rows.columns != 3 || *rows.count * 2. != static_cast<double>(points.size()))
    return with_checked_count(std::move(rows), name);
  const auto first_normal = points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2);
  rows.surface.normals.assign(first_normal, points.end());
  points.erase(first_normal, points.end());
  return std::move(rows.surface);
}

} // namespace program
