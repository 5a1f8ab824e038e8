// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_VIEW_QUERIES_H
#define GEODESIC_VIEW_QUERIES_H

#include "repair/Surface.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace view {

using program::Point;

// A location: a vertex or surfel, or barycentric coordinates in a face.
struct Place
{
  std::size_t element = 0; // a vertex, a surfel or a face
  bool is_in_face = false;
  std::array<double, 3> weights = {0., 0., 0.}; // of the corners of the face
};

// A path between two locations.
struct Path
{
  std::vector<Point> points; // empty if there is no path
  double length = 0.;
};

// The label of a vertex that no seed reaches.
constexpr std::uint32_t no_label = 0xffffffff;

// A Voronoi diagram.
struct Cells
{
  std::vector<std::uint32_t> labels;          // #vertices or surfels: the nearest seed, or no_label
  std::vector<Point> points;                  // of the mesh that is split along the bisectors
  std::vector<std::uint32_t> corners;         // #triangles of the split mesh, 3 each
  std::vector<std::uint32_t> triangle_labels; // #triangles of the split mesh
};

// Farthest point samples.
struct Samples
{
  std::vector<Point> points;
  std::vector<Place> places;
  std::vector<double> radii; // the covering radius after each sample
};

// The placement of an image. Image coordinates are (0, 0) at the lower left corner and (1, 1) at
// the upper right one.
struct Decal
{
  std::vector<std::uint32_t> faces;             // that the image intersects; empty on clouds
  std::vector<std::array<double, 2>> corner_uv; // 3 for each of these faces
  std::vector<std::uint32_t> vertices;          // vertices or surfels that the image covers
  std::vector<std::array<double, 2>> vertex_uv; // of these
};

// A callback of the library: returns whether the computation continues.
using Callback = std::function<bool(double)>;

// All queries that the page makes on one surface. What a query precomputes is kept for later ones.
// Functions throw the exceptions of the library.
class Queries
{
public:
  virtual ~Queries() = default;

  // Returns the corners of the triangles, 3 each. Face f of a location is triangle f. Empty on
  // clouds.
  virtual std::vector<std::uint32_t> triangles() const = 0;

  // Returns the distance of each vertex or surfel to the nearest source; infinity if no source
  // reaches it. `method` is a name of the program's option --method.
  virtual std::vector<double> distances(const std::vector<Place>& sources,
                                        const std::string& method, double limit,
                                        const Callback& callback) = 0;

  // Returns the isolines of distances. Empty on clouds.
  virtual std::vector<std::vector<Point>> isolines(const std::vector<double>& values,
                                                   const std::vector<double>& isovalues) const = 0;

  // Returns a shortest path, or, if `is_shortest` is false, a locally shortest path in less time.
  virtual Path path(const Place& from, const Place& to, bool is_shortest) = 0;

  virtual Cells voronoi(const std::vector<Place>& seeds, const Callback& callback) const = 0;
  virtual Samples samples(std::size_t number, const Callback& callback) const = 0;

  // Places an image of the given size. `up` is its upward direction.
  virtual Decal decal(const Place& center, const Point& up, double width, double height) = 0;
};

// Precompute the queries of a surface, which must exist as long as they.
std::unique_ptr<Queries> mesh_queries(const program::Surface& surface);
std::unique_ptr<Queries> cloud_queries(const program::Surface& surface);

} // namespace view

#endif // GEODESIC_VIEW_QUERIES_H
