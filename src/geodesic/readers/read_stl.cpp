// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Scanner.h"
#include "readers/Surface_file.h"
#include "readers/Welder.h"
#include "readers/binary_numbers.h"
#include "readers/count_lines.h"
#include "readers/parse_chunks.h"

#include <algorithm>
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

// Calls append_corner(point) for each vertex of the lines of a text, and end_facet() behind each
// facet.
template <typename Append_corner, typename End_facet>
void read_lines(Scanner& scanner, const Append_corner& append_corner, const End_facet& end_facet)
{
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
        append_corner(point);
      }
      else if(word == "endloop")
        end_facet();
    }
}

std::size_t expected_number_of_facets(std::string_view text)
{
  constexpr std::size_t lines_of_facet = 7, min_size_of_line = 6;
  return max_number_of_lines(text, min_size_of_line) / lines_of_facet;
}

Surface_file read_text(std::string_view bytes, const std::string& name)
{
  Surface_file surface;
  const std::size_t expected_facets = expected_number_of_facets(bytes);
  reserve(expected_facets, surface);
  Welder welder(surface, expected_facets / 2); // STL repeats the vertices in each facet
  Scanner scanner(bytes, name, 0);
  std::size_t corners_of_facet = 0;
  read_lines(
      scanner,
      [&](const Point& point)
      {
        welder.append_corner(point);
        ++corners_of_facet;
      },
      [&]
      {
        if(corners_of_facet < 3)
          scanner.fail("a facet has " + std::to_string(corners_of_facet) + " vertices");
        welder.end_polygon();
        corners_of_facet = 0;
      });
  if(corners_of_facet != 0)
    fail(name, "it ends within a facet");
  welder.flush();
  return surface;
}

// The content of a chunk of a text. Its first and its last facet can be in two chunks.
struct Chunk
{
  std::vector<Point> corners;
  std::vector<std::size_t> facet_end; // number of corners before the end of each facet
};

void read_chunk(std::string_view text, const std::string& name, Chunk& chunk)
{
  chunk.corners.clear();
  chunk.facet_end.clear();
  Scanner scanner(text, name, 0);
  read_lines(
      scanner, [&](const Point& point) { chunk.corners.push_back(point); },
      [&] { chunk.facet_end.push_back(chunk.corners.size()); });
}

// Threads read some chunks, whose vertices are then merged in their order, and so on: the corners of
// all chunks would need as much memory as the surface. Returns false if the text has an error.
bool read_text_in_parallel(std::string_view bytes, const std::string& name,
                           unsigned number_of_threads, Surface_file& surface)
{
  constexpr std::size_t max_chunk_size = std::size_t{1} << 19;
  const std::vector<std::string_view> texts = split_lines(bytes, bytes.size() / max_chunk_size + 1);
  const std::size_t expected_facets = expected_number_of_facets(bytes);
  reserve(expected_facets, surface);
  Welder welder(surface, expected_facets / 2);
  std::vector<Chunk> chunks(2 * number_of_threads);
  std::size_t corners_of_facet = 0;
  for(std::size_t begin = 0; begin < texts.size(); begin += chunks.size())
  {
    chunks.resize(std::min(chunks.size(), texts.size() - begin));
    const auto read = [&](std::size_t i)
    {
      read_chunk(texts[begin + i], name, chunks[i]);
      return true;
    };
    if(!parse_chunks(chunks.size(), number_of_threads, read))
      return false;
    for(const Chunk& chunk : chunks)
    {
      std::size_t corner = 0;
      const auto append_corners = [&](std::size_t end)
      {
        corners_of_facet += end - corner;
        for(; corner < end; ++corner)
          welder.append_corner(chunk.corners[corner]);
      };
      for(const std::size_t end : chunk.facet_end)
      {
        append_corners(end);
        if(corners_of_facet < 3)
          return false;
        welder.end_polygon();
        corners_of_facet = 0;
      }
      append_corners(chunk.corners.size());
    }
  }
  welder.flush();
  return corners_of_facet == 0;
}

// Many binary files also begin with "solid", so they are detected by their size.
bool is_binary(std::string_view bytes)
{
  return bytes.size() >= header_size &&
         bytes.size() == header_size + facet_size * number_of_facets(bytes);
}

} // namespace

Surface_file read_stl(std::string_view bytes, const std::string& name)
{
  if(is_binary(bytes))
    return read_binary(bytes, name);
  Scanner scanner(bytes, name, 0);
  if(scanner.next_word() == "solid")
    return read_text(bytes, name);
  if(bytes.size() < header_size)
    fail(name, "it is not an STL file");
  fail(name, "it is not an ASCII STL file, and its size does not match a binary STL file of " +
                 std::to_string(number_of_facets(bytes)) + " facets");
}

Surface_file read_stl_in_parallel(std::string_view bytes, const std::string& name,
                                  unsigned number_of_threads)
{
  Surface_file surface;
  if(number_of_chunks(bytes.size(), number_of_threads) > 1 && !is_binary(bytes) &&
     Scanner(bytes, name, 0).next_word() == "solid" &&
     read_text_in_parallel(bytes, name, number_of_threads, surface))
    return surface;
  return read_stl(bytes, name);
}

} // namespace program
