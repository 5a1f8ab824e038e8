// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_PICTURE_LABEL_REGIONS_H
#define GEODESIC_PROGRAM_PICTURE_LABEL_REGIONS_H

#include "picture/Render_mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace program {

// Splits triangles with several labels, so that each piece has a single label.
class Label_regions
{
public:
  Label_regions(const std::vector<Point>& points, const std::vector<std::uint32_t>& corners,
                const std::vector<long long>& labels);

  const Render_mesh& mesh() const { return m_mesh; }

  // Returns the segments of the boundaries between regions.
  std::vector<std::vector<Point>> boundaries() const;

private:
  using Triangle = std::array<std::uint32_t, 3>;

  void split_triangle(Triangle c, const std::vector<long long>& labels);
  void add(const Triangle& corners, long long label);

  // Returns the point at which an edge is cut, initially its midpoint.
  std::uint32_t edge_point(std::uint32_t a, std::uint32_t b);
  void update_center(std::uint32_t middle, const Triangle& p);
  void smooth_boundaries();

  std::size_t m_number_of_points; // number of input points; cut points and centers follow
  Render_mesh m_mesh;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> m_edge_points;
  std::vector<std::array<std::uint32_t, 2>>
      m_point_edges; // #cut points and centers: the edge that is cut
  std::vector<std::pair<std::uint32_t, std::uint32_t>> m_boundaries;
  std::vector<std::uint32_t> m_centers;
  std::vector<Triangle> m_center_corners; // #centers: the cut points around each
};

} // namespace program

#endif // GEODESIC_PROGRAM_PICTURE_LABEL_REGIONS_H
