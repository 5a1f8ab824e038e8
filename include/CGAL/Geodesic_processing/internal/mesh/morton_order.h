// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_MORTON_ORDER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_MORTON_ORDER_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A scaled coordinate system: coordinates of the caller are origin + scale * scaled coordinates.
// The scale is a power of two.
struct Frame
{
  std::array<double, 3> origin = {0., 0., 0.};
  double scale = 1.;
};

// Computes the frame in which the bounding box is centered at the origin and half of its longest
// edge is in [1, 2). In it, squares of coordinates neither overflow nor underflow. Throws
// Invalid_argument_error if a coordinate is not finite or if the extent of all points overflows.
//
// used  indices of the points in the bounding box; if empty, all points are
CGAL_GEODESIC_PROCESSING_EXPORT
Frame unit_frame(const std::vector<std::array<double, 3>>& points,
                 const std::vector<Index>& used = {}, unsigned number_of_threads = 1);

// Divides lengths of the caller by the scale of a frame, which is exact unless they underflow.
class Scaling
{
public:
  explicit Scaling(const Frame& frame)
      : m_exponent(-std::ilogb(frame.scale)), m_factor(std::ldexp(1., m_exponent))
  {}

  double operator()(double length) const
  {
    // The reciprocal of the scale may be subnormal.
    return std::isnormal(m_factor) ? length * m_factor : std::ldexp(length, m_exponent);
  }

private:
  int m_exponent;
  double m_factor;
};

// Transforms points from the coordinates of the caller to scaled coordinates, whose absolute values
// are at most 1e150.
CGAL_GEODESIC_PROCESSING_EXPORT
void to_frame(std::vector<std::array<double, 3>>& points, const Frame& frame,
              unsigned number_of_threads = 1);

// Returns the indices of the points in Morton order; points in the same cell are in the order of
// their indices. Cells divide the cube [-2, 2]^3 of the scaled coordinates; points outside of it
// are in the closest cells. O(n) by radix sort.
//
// frame  of the scaled coordinates; if it is the default, those of the caller are scaled
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Index> morton_order(const std::vector<std::array<double, 3>>& points,
                                const Frame& frame = Frame(), unsigned number_of_threads = 1);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_MORTON_ORDER_H
