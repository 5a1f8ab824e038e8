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

// The longest side of the triangles that hold a location.
CGAL_GEODESIC_PROCESSING_EXPORT
double longest_edge_at(const Surface_arrays& triangles, const Surface_location& location);

// A triangle with the images of its corners.
struct Triangle_image
{
  Index triangle;
  std::array<Vec2, 3> corners;
};

// The triangles that a rectangle around the base of a map to the plane lies on.
struct Decal_triangles
{
  std::vector<Triangle_image> covered; // all corners of which have an image
  double longest_edge = 0.; // of those that have not; zero when all of the rectangle is inside
};

// One that is cut has the image that its longest side that is not gives it, as long as that is there: so
// on either side of a cut locus the image goes on as far as that, without a hole.
//
// A triangle belongs to the rectangle when the inner parts of both meet in the plane.  One without all
// of its images is noticed by a corner or a side that meets it: as a rectangle is connected, those that
// it goes through are when the triangles at the base have theirs.
//
// reached  sites; coordinates  #sites, those of the others are not a number
// half     of the width and of the height of the rectangle
CGAL_GEODESIC_PROCESSING_EXPORT
Decal_triangles find_decal_triangles(const Surface_arrays& triangles,
                                     const std::vector<Index>& reached,
                                     const std::vector<Vec2>& coordinates, const Vec2& half_size);

// Red, green, blue and opacity in [0, 1]; the colours are not multiplied by the opacity.
using Rgba = std::array<double, 4>;

// What is seen of a colour through another one in front of it (Porter and Duff 1984, "over").
CGAL_GEODESIC_PROCESSING_EXPORT
Rgba blend_over(const Rgba& front, const Rgba& back);

// Where triangles lie in a texture of square texels: two in each square cell, their corners in the
// middle of texels.  Around each triangle texels are its own as far as interpolation between the middles
// of four of them looks.
class CGAL_GEODESIC_PROCESSING_EXPORT Texture_cells
{
public:
  // Along a leg of each triangle lie `segments` texels and one.
  // Throws Invalid_argument_error for none, and for more than 2^28 texels altogether.
  Texture_cells(std::size_t number_of_triangles, std::size_t segments);

  std::size_t width() const { return m_columns * cell_size(); }
  std::size_t height() const { return m_rows * cell_size(); }

  // The corners of a triangle, in [0, 1] x [0, 1] from the lower left corner of the texture.
  std::array<Vec2, 3> corners(std::size_t triangle) const;

  // Calls f(texel, barycentric coordinates of its middle) for all texels that belong to a triangle;
  // coordinates are negative outside.  Texels are counted in rows from the lowest one up.
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
  // The corners of the lower triangle are at 1 and 1 + segments, those of the upper one at
  // 3 + segments and 3.
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
