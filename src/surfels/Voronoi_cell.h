// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_VORONOI_CELL_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_VORONOI_CELL_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A convex polygon in the plane: the Voronoi cell of the origin, which is computed by clipping a
// square at the bisectors with other points. Each clip is linear in the number of corners.
class Voronoi_cell
{
public:
  struct Corner
  {
    double x, y;
    Index edge; // the label of the edge to the next corner; none on the initial square
  };

  // Sets the cell to the square [-half_width, half_width]^2. Keeps the allocated memory.
  void reset(double half_width)
  {
    m_corners.assign({{half_width, -half_width, none},
                      {half_width, half_width, none},
                      {-half_width, half_width, none},
                      {-half_width, -half_width, none}});
    m_squared_radius = 2. * half_width * half_width;
  }

  // Returns the squared distance from the origin to the farthest corner.
  double squared_radius() const { return m_squared_radius; }

  // Returns the corners in counterclockwise order.
  const std::vector<Corner>& corners() const { return m_corners; }

  // Intersects the cell with the half-plane x qx + y qy <= offset. A new edge on the line gets the
  // label. If the half-plane contains no corner, the cell remains unchanged.
  void clip(double qx, double qy, double offset, Index label)
  {
    const std::size_t n = m_corners.size();
    std::size_t number_outside = 0, any_outside = n;
    m_signed_distances.resize(n);
    for(std::size_t i = 0; i < n; ++i)
    {
      m_signed_distances[i] = m_corners[i].x * qx + m_corners[i].y * qy - offset;
      if(m_signed_distances[i] > 0.)
      {
        ++number_outside;
        any_outside = i;
      }
    }
    if(number_outside == 0 || number_outside == n)
      return;
    // The cell is convex, so the corners outside are consecutive: [begin, end) modulo n.
    std::size_t end = any_outside, begin = any_outside;
    while(m_signed_distances[end] > 0.)
      end = end + 1 == n ? 0 : end + 1;
    while(m_signed_distances[begin == 0 ? n - 1 : begin - 1] > 0.)
      begin = begin == 0 ? n - 1 : begin - 1;
    const std::size_t last_inside = begin == 0 ? n - 1 : begin - 1;
    const std::size_t last_outside = end == 0 ? n - 1 : end - 1;

    m_clipped.clear();
    for(std::size_t i = end;; i = i + 1 == n ? 0 : i + 1)
    {
      m_clipped.push_back(m_corners[i]);
      if(i == last_inside)
        break;
    }
    m_clipped.push_back(intersection(last_inside, begin, label));
    m_clipped.push_back(intersection(end, last_outside, m_corners[last_outside].edge));
    std::swap(m_corners, m_clipped);
    m_squared_radius = 0.;
    for(const Corner& c : m_corners)
      m_squared_radius = std::max(m_squared_radius, c.x * c.x + c.y * c.y);
  }

private:
  // Returns the intersection of the clipping line with the segment between two corners.
  Corner intersection(std::size_t inside, std::size_t outside, Index edge) const
  {
    const Corner &a = m_corners[inside], &b = m_corners[outside];
    const double t =
        m_signed_distances[inside] / (m_signed_distances[inside] - m_signed_distances[outside]);
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), edge};
  }

  std::vector<Corner> m_corners, m_clipped;
  std::vector<double> m_signed_distances; // #corners: positive outside of the half-plane
  double m_squared_radius = 0.;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_VORONOI_CELL_H
