// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Scanner.h"
#include "readers/Surface_file.h"
#include "readers/append_polygon.h"
#include "readers/parse_chunks.h"

#include <algorithm>

namespace program {

namespace {

// Variant of the format, given by the keyword before the counts: [ST][C][N][4][n]OFF.
struct Variant
{
  bool normals = false;
  bool homogeneous = false;
};

Variant parse_variant(std::string_view keyword, const Scanner& scanner)
{
  Variant variant;
  std::string_view rest = keyword;
  const auto take = [&rest](std::string_view prefix)
  {
    if(rest.substr(0, prefix.size()) != prefix)
      return false;
    rest.remove_prefix(prefix.size());
    return true;
  };
  take("ST");
  take("C");
  variant.normals = take("N");
  variant.homogeneous = take("4");
  if(take("nOFF"))
    scanner.fail("the variant '" + printable(keyword) +
                 "' is not supported, only three dimensions are");
  if(rest != "OFF")
    scanner.fail("it is not an OFF file, it begins with '" + printable(keyword) + "'");
  return variant;
}

struct Off_header
{
  Variant variant;
  std::size_t vertices, faces; // their numbers
};

// Reads the lines up to the counts, and checks that the file is long enough.
Off_header read_off_header(Scanner& scanner, const std::string& name, std::size_t file_size)
{
  if(!scanner.next_line())
    fail(name, "it is empty");
  const Variant variant = parse_variant(scanner.word(), scanner);
  const std::string_view word = scanner.next_word();
  if(word == "BINARY")
    fail(name, "binary OFF files are not supported");
  // The number of edges is ignored, because it is often missing or wrong.
  const long long vertices = scanner.parse_integer(word);
  const long long faces = scanner.parse_integer(scanner.next_word());
  if(vertices < 0 || faces < 0)
    scanner.fail("a count is negative");
  // A vertex needs at least six characters, a face two.
  if(static_cast<double>(vertices) * 6. + static_cast<double>(faces) * 2. >
     static_cast<double>(file_size) + 1.)
    scanner.fail("it declares " + std::to_string(vertices) + " vertices and " +
                 std::to_string(faces) + " faces, but the file is too short for them");
  return {variant, static_cast<std::size_t>(vertices), static_cast<std::size_t>(faces)};
}

void read_vertex(Scanner& scanner, const Variant& variant, std::size_t i, Surface_file& surface)
{
  for(double& x : surface.points[i])
    x = scanner.coordinate();
  if(variant.homogeneous)
  {
    const double w = scanner.coordinate();
    if(w == 0.)
      scanner.fail("the homogeneous coordinate of a vertex is zero");
    for(double& x : surface.points[i])
      x /= w;
  }
  if(variant.normals)
    for(double& x : surface.normals[i])
      x = scanner.number();
}

void read_face(Scanner& scanner, std::size_t number_of_vertices, Surface_file& surface)
{
  const long long degree = scanner.integer();
  if(degree < 0)
    scanner.fail("a face has a negative number of vertices");
  for(long long k = 0; k < degree; ++k)
  {
    const long long index = scanner.integer();
    if(index < 0 || index >= static_cast<long long>(number_of_vertices))
      scanner.fail("a face refers to vertex " + std::to_string(index) +
                   ", but the number of vertices is " + std::to_string(number_of_vertices));
    append_corner(surface, index);
  }
  end_polygon(surface);
}

// Allocates the arrays of the vertices, and reserves memory for triangles.
Surface_file allocate_surface(const Off_header& header)
{
  Surface_file surface;
  surface.points.resize(header.vertices);
  if(header.variant.normals)
    surface.normals.resize(header.vertices);
  surface.corners.reserve(3 * header.faces);
  surface.polygon_begin.reserve(header.faces + 1);
  return surface;
}

// Reads the items begin, ..., end - 1, each on its own line: first all vertices of the file, then
// all faces. Writes the vertices to one surface and appends the faces to another.
void read_items(Scanner& scanner, const Off_header& header, const std::string& name,
                std::size_t begin, std::size_t end, Surface_file& vertices, Surface_file& faces)
{
  const auto next_line = [&](std::size_t i, std::size_t count, const char* kind)
  {
    if(!scanner.next_line())
      fail(name,
           "it ends after " + std::to_string(i) + " of " + std::to_string(count) + ' ' + kind);
  };
  std::size_t i = begin;
  for(; i < std::min(end, header.vertices); ++i)
  {
    next_line(i, header.vertices, "vertices");
    read_vertex(scanner, header.variant, i, vertices);
  }
  for(; i < end; ++i)
  {
    next_line(i - header.vertices, header.faces, "faces");
    read_face(scanner, header.vertices, faces);
  }
}

} // namespace

Surface_file read_off(std::string_view bytes, const std::string& name)
{
  Scanner scanner(bytes, name, '#', Scanner::Separators::blanks_and_commas);
  const Off_header header = read_off_header(scanner, name, bytes.size());
  Surface_file surface = allocate_surface(header);
  read_items(scanner, header, name, 0, header.vertices + header.faces, surface, surface);
  return surface;
}

Surface_file read_off_in_parallel(std::string_view bytes, const std::string& name,
                                  unsigned number_of_threads)
{
  const std::vector<std::string_view> chunks =
      split_lines(bytes, number_of_chunks(bytes.size(), number_of_threads));
  if(chunks.size() < 2)
    return read_off(bytes, name);
  Scanner scanner(bytes, name, '#', Scanner::Separators::blanks_and_commas);
  const Off_header header = read_off_header(scanner, name, bytes.size());
  Surface_file surface = allocate_surface(header);
  const std::size_t number_of_items = header.vertices + header.faces;
  const std::vector<std::size_t> lines = first_lines(chunks, number_of_threads);
  std::vector<Surface_file> faces(chunks.size());
  // An item is read at the right position only if no line before it is empty or a comment. This is
  // true if the items of each chunk are its lines.
  const auto read_chunk = [&](std::size_t chunk)
  {
    Scanner chunk_scanner(chunks[chunk], name, '#', Scanner::Separators::blanks_and_commas);
    if(chunk == 0)
      read_off_header(chunk_scanner, name, bytes.size());
    const auto item = [&](std::size_t line)
    {
      return std::min(number_of_items,
                      std::max(line, scanner.line_number()) - scanner.line_number());
    };
    const std::size_t begin = chunk == 0 ? 0 : item(lines[chunk]), end = item(lines[chunk + 1]);
    read_items(chunk_scanner, header, name, begin, end, surface, faces[chunk]);
    return end == number_of_items || !chunk_scanner.next_line();
  };
  if(lines.back() < scanner.line_number() + number_of_items ||
     !parse_chunks(chunks.size(), number_of_threads, read_chunk))
    return read_off(bytes, name);
  append_chunks(surface, faces);
  return surface;
}

} // namespace program
