// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/Scanner.h"
#include "readers/Surface_file.h"
#include "readers/append_polygon.h"

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

struct Counts
{
  long long vertices, faces;
};

// Reads the counts and checks that the file is long enough. `word` is the number of vertices.
Counts read_counts(std::string_view word, Scanner& scanner, std::size_t file_size)
{
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
  return {vertices, faces};
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

void read_face(Scanner& scanner, long long number_of_vertices, Surface_file& surface)
{
  const long long degree = scanner.integer();
  if(degree < 0)
    scanner.fail("a face has a negative number of vertices");
  for(long long k = 0; k < degree; ++k)
  {
    const long long index = scanner.integer();
    if(index < 0 || index >= number_of_vertices)
      scanner.fail("a face refers to vertex " + std::to_string(index) +
                   ", but the number of vertices is " + std::to_string(number_of_vertices));
    append_corner(surface, index);
  }
  end_polygon(surface);
}

} // namespace

Surface_file read_off(std::string_view bytes, const std::string& name)
{
  Scanner scanner(bytes, name, '#', Scanner::Separators::blanks_and_commas);
  if(!scanner.next_line())
    fail(name, "it is empty");
  const Variant variant = parse_variant(scanner.word(), scanner);
  const std::string_view word = scanner.next_word();
  if(word == "BINARY")
    fail(name, "binary OFF files are not supported");
  const Counts counts = read_counts(word, scanner, bytes.size());

  const auto next_line = [&](long long i, long long count, const char* kind)
  {
    if(!scanner.next_line())
      fail(name,
           "it ends after " + std::to_string(i) + " of " + std::to_string(count) + ' ' + kind);
  };
  Surface_file surface;
  surface.points.resize(static_cast<std::size_t>(counts.vertices));
  if(variant.normals)
    surface.normals.resize(surface.points.size());
  for(long long i = 0; i < counts.vertices; ++i)
  {
    next_line(i, counts.vertices, "vertices");
    read_vertex(scanner, variant, static_cast<std::size_t>(i), surface);
  }
  surface.corners.reserve(3 * static_cast<std::size_t>(counts.faces));
  surface.polygon_begin.reserve(static_cast<std::size_t>(counts.faces) + 1);
  for(long long i = 0; i < counts.faces; ++i)
  {
    next_line(i, counts.faces, "faces");
    read_face(scanner, counts.vertices, surface);
  }
  return surface;
}

} // namespace program
