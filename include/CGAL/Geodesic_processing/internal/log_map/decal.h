// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_DECAL_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_DECAL_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Returns the length of the longest edge of the triangles that contain a location.
CGAL_GEODESIC_PROCESSING_EXPORT
double longest_edge_at(const Surface_arrays& triangles, const Surface_location& location);

// A triangle with the images of its corners in the plane.
struct Triangle_image
{
  Index triangle;
  std::array<Vec2, 3> corners;
};

// The triangles whose images intersect a rectangle.
struct Decal_triangles
{
  std::vector<Triangle_image> covered; // triangles with images of all corners
  // The longest edge of intersecting triangles that lack an image of a corner. Zero if there are
  // no such triangles: then `covered` covers the whole rectangle.
  double longest_edge = 0.;
};

// Finds the triangles whose images under a map to the plane intersect the interior of a rectangle
// centered at the origin.
//
// A triangle that is cut (see is_cut()) gets the image that is similar to the triangle and attached
// to its longest edge that is not cut. So the image extends across a cut locus without holes. A
// triangle whose edges are all cut is omitted.
//
// A triangle without images of all corners is detected if the image of a corner or an edge
// intersects the rectangle. If there are such triangles, at least one is detected: the rectangle
// is connected, and all triangles at the base point must have images.
//
// reached      the vertices that have an image
// coordinates  #vertices: the images; NaN for vertices that are not reached
// half_size    half of the width and of the height of the rectangle
//
// Linear in the number of triangles at reached vertices.
CGAL_GEODESIC_PROCESSING_EXPORT
Decal_triangles find_decal_triangles(const Surface_arrays& triangles,
                                     const std::vector<Index>& reached,
                                     const std::vector<Vec2>& coordinates, const Vec2& half_size);

// Red, green, blue and opacity in [0, 1]; the colors are not premultiplied by the opacity.
using Rgba = std::array<double, 4>;

// Returns the composite of a color in front of another one (operator "over", Porter and Duff 1984).
CGAL_GEODESIC_PROCESSING_EXPORT
Rgba blend_over(const Rgba& front, const Rgba& back);

// The layout of triangles in a texture: a grid of square cells with two right triangles each, whose
// corners are at texel centers. All texels that bilinear interpolation reads inside a triangle
// belong to that triangle.
class CGAL_GEODESIC_PROCESSING_EXPORT Texture_cells
{
public:
  // segments  the length of each triangle's legs, in texels; a leg contains segments + 1 texel
  //           centers
  //
  // Throws Invalid_argument_error if `segments` is zero or the texture has more than 2^28 texels.
  Texture_cells(std::size_t number_of_triangles, std::size_t segments);

  // Return the size of the texture, in texels.
  std::size_t width() const { return m_columns * cell_size(); }
  std::size_t height() const { return m_rows * cell_size(); }

  // Returns the texture coordinates of a triangle's corners, in [0, 1] x [0, 1]. The lower left
  // corner of the texture is (0, 0).
  std::array<Vec2, 3> corners(std::size_t triangle) const;

  // Calls f(texel, barycentric coordinates of its center) for all texels that belong to a triangle.
  // Some of them are outside the triangle and have negative coordinates. Texels are numbered by
  // rows, from the lowest row up.
  template <typename Function>
  void for_each_texel(std::size_t triangle, Function f) const
  {
    const bool is_upper = triangle % 2 == 1;
    const std::size_t size = cell_size(), begin = first_texel(triangle);
    const double step = 1. / double(m_segments);
    for(std::size_t j = 0; j < size; ++j)
      for(std::size_t i = 0; i < size; ++i)
        if((i + j > m_segments + 3) == is_upper)
        {
          const Vec2 local_position = is_upper ? Vec2{double(m_segments + 3) - double(i),
                                                      double(m_segments + 3) - double(j)}
                                               : Vec2{double(i) - 1., double(j) - 1.};
          const double b = step * local_position[0], c = step * local_position[1];
          f(begin + j * width() + i, std::array<double, 3>{1. - b - c, b, c});
        }
  }

private:
  // In each direction of a cell, the lower triangle extends from texel 1 to 1 + segments, and the
  // upper one from 3 to 3 + segments.
  std::size_t cell_size() const { return m_segments + 5; }
  std::size_t first_texel(std::size_t triangle) const
  {
    const std::size_t cell = triangle / 2;
    return cell_size() * (cell / m_columns * width() + cell % m_columns);
  }

  std::size_t m_segments, m_columns = 1, m_rows = 1;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_DECAL_H
