// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Scanner.h"
#include "readers/Surface_file.h"
#include "readers/Welder.h"
#include "readers/binary_numbers.h"
#include "readers/count_lines.h"

#include <cmath>

namespace program {

namespace {

constexpr std::size_t header_size = 84, facet_size = 50;

// Returns the number of facets in the header of a binary file.
std::size_t number_of_facets(std::string_view bytes)
{
  return static_cast<std::size_t>(bits_at(bytes.substr(header_size - 4), 4, false));
}

// Reserves memory for facets, most of which are adjacent to three others.
void reserve(std::size_t number_of_facets, Surface_file& surface)
{
  surface.points.reserve(number_of_facets / 2 + 64);
  surface.corners.reserve(3 * number_of_facets);
  surface.polygon_begin.reserve(number_of_facets + 1);
}

// Returns a vertex of a facet.
Point corner_at(std::string_view facet, std::size_t k)
{
  Point point;
  for(std::size_t c = 0; c < 3; ++c)
    point[c] = to_value(bits_at(facet.substr(12 + 12 * k + 4 * c), 4, false), {'f', 4});
  return point;
}

Surface_file read_binary(std::string_view bytes, const std::string& name)
{
  Surface_file surface;
  reserve(bytes.size() / facet_size, surface);
  Welder welder(surface, bytes.size() / facet_size / 2); // STL repeats the vertices in each facet
  for(bytes.remove_prefix(header_size); bytes.size() >= facet_size; bytes.remove_prefix(facet_size))
  {
    for(std::size_t k = 0; k < 3; ++k)
    {
      const Point point = corner_at(bytes, k);
      if(!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2]))
        fail(name, "a coordinate of facet " + std::to_string(surface.number_of_polygons()) +
                       " is not finite");
      welder.append_corner(point);
    }
    welder.end_polygon();
  }
  welder.flush();
  return surface;
}

Surface_file read_text(std::string_view bytes, const std::string& name)
{
  Surface_file surface;
  constexpr std::size_t lines_of_facet = 7, min_size_of_line = 6;
  const std::size_t expected_facets = max_number_of_lines(bytes, min_size_of_line) / lines_of_facet;
  reserve(expected_facets, surface);
  Welder welder(surface, expected_facets / 2); // STL repeats the vertices in each facet
  Scanner scanner(bytes, name, 0);
  std::size_t corners_in_loop = 0;
  while(scanner.next_line())
    // Lines are parsed separately, because the name of a solid is arbitrary text. A line may
    // contain several keywords of a facet.
    for(std::string_view word = scanner.word(); !word.empty(); word = scanner.word())
    {
      if(word == "solid" || word == "endsolid")
        break;
      if(word == "normal")
        scanner.skip_line_without('t'); // as in "outer" and "vertex", but in no number
      else if(word == "vertex")
      {
        Point point;
        for(double& x : point)
          x = scanner.coordinate();
        welder.append_corner(point);
        ++corners_in_loop;
      }
      else if(word == "endloop")
      {
        if(corners_in_loop < 3)
          scanner.fail("a facet has " + std::to_string(corners_in_loop) + " vertices");
        welder.end_polygon();
        corners_in_loop = 0;
      }
    }
  if(corners_in_loop != 0)
    fail(name, "it ends within a facet");
  welder.flush();
  return surface;
}

} // namespace

Surface_file read_stl(std::string_view bytes, const std::string& name)
{
  // Many binary files also begin with "solid", so they are detected by their size.
  if(bytes.size() >= header_size &&
     bytes.size() == header_size + facet_size * number_of_facets(bytes))
    return read_binary(bytes, name);
  Scanner scanner(bytes, name, 0);
  if(scanner.next_word() == "solid")
    return read_text(bytes, name);
  if(bytes.size() < header_size)
    fail(name, "it is not an STL file");
  fail(name, "it is not an ASCII STL file, and its size does not match a binary STL file of " +
                 std::to_string(number_of_facets(bytes)) + " facets");
}

} // namespace program
