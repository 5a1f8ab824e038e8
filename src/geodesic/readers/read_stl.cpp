// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Scanner.h"
#include "readers/Surface_file.h"
#include "readers/Welder.h"
#include "readers/append_polygon.h"

#include <cmath>
#include <cstring>

namespace program {

namespace {

std::uint32_t little_endian(std::string_view bytes)
{
  std::uint32_t result = 0;
  for(unsigned i = 0; i < 4; ++i)
    result |= std::uint32_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
  return result;
}

Surface_file read_binary(std::string_view bytes, const std::string& name)
{
  Surface_file surface;
  Welder welder(surface); // STL repeats the vertices in each facet
  for(bytes.remove_prefix(84); bytes.size() >= 50; bytes.remove_prefix(50))
  {
    for(std::size_t k = 0; k < 3; ++k)
    {
      Point point;
      for(std::size_t c = 0; c < 3; ++c)
      {
        const std::uint32_t bits = little_endian(bytes.substr(12 + 12 * k + 4 * c));
        float x;
        std::memcpy(&x, &bits, sizeof x);
        if(!std::isfinite(x))
          fail(name, "a coordinate of facet " + std::to_string(surface.number_of_polygons()) +
                         " is not finite");
        point[c] = x;
      }
      append_corner(surface, welder.index(point));
    }
    end_polygon(surface);
  }
  return surface;
}

Surface_file read_text(std::string_view bytes, const std::string& name)
{
  Surface_file surface;
  Welder welder(surface); // STL repeats the vertices in each facet
  Scanner scanner(bytes, name, 0);
  std::size_t corners_in_loop = 0;
  while(scanner.next_line())
    // Lines are parsed separately, because the name of a solid is arbitrary text. A line may
    // contain several keywords of a facet.
    for(std::string_view word = scanner.word(); !word.empty(); word = scanner.word())
    {
      if(word == "solid" || word == "endsolid")
        break;
      if(word == "vertex")
      {
        Point point;
        for(double& x : point)
          x = scanner.parse_coordinate(scanner.word());
        append_corner(surface, welder.index(point));
        ++corners_in_loop;
      }
      else if(word == "endloop")
      {
        if(corners_in_loop < 3)
          scanner.fail("a facet has " + std::to_string(corners_in_loop) + " vertices");
        end_polygon(surface);
        corners_in_loop = 0;
      }
    }
  if(corners_in_loop != 0)
    fail(name, "it ends within a facet");
  return surface;
}

} // namespace

Surface_file read_stl(std::string_view bytes, const std::string& name)
{
  // Many binary files also begin with "solid", so they are detected by their size.
  if(bytes.size() >= 84 && bytes.size() == 84 + 50 * std::size_t{little_endian(bytes.substr(80))})
    return read_binary(bytes, name);
  Scanner scanner(bytes, name, 0);
  if(scanner.next_word() == "solid")
    return read_text(bytes, name);
  if(bytes.size() < 84)
    fail(name, "it is not an STL file");
  fail(name, "it is not an ASCII STL file, and its size does not match a binary STL file of " +
                 std::to_string(little_endian(bytes.substr(80))) + " facets");
}

} // namespace program
