// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_VORONOI_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_VORONOI_H

#include <CGAL/Geodesic_processing/internal/distances/front.h>

#include <array>
#include <memory>
#include <tuple>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Which of several sources is nearest, the cells of a Voronoi diagram, and how far the others are where
// cells meet.  A cell belongs to all sources of one label.
class CGAL_GEODESIC_PROCESSING_EXPORT Voronoi
{
public:
  // One front from all sources, and one from those of each cell that ends soon after others come
  // first: the time of two fronts over the whole surface, and what cells visit beyond themselves.
  // sources: their labels are below `number_of_cells`.
  Voronoi(std::shared_ptr<const Glued_triangles> triangles, Front front,
          const std::vector<Source>& sources, Index number_of_cells,
          const Front_limits& limits = {});

  // False when the callback cancelled it: then cells are too small.
  bool is_finished() const { return m_is_finished; }

  const std::vector<double>& distances() const { return m_distances; }
  const std::vector<Index>& labels() const { return m_labels; } // none where no source reaches
  // The cell that a triangle's centre lies in; none unless all of its corners are reached.
  Index label_of_triangle(Index triangle) const;

  // Part of the line between two cells, from one place where three meet, or from a border, to the
  // next, or closed.  Consecutive locations lie in a common
  // triangle; inside it the line is straight.
  struct Bisector
  {
    Index left, right; // the cells on either side
    std::vector<Location> line;
    bool is_closed = false; // the last location is the first one
  };
  // On a mesh.
  std::vector<Bisector> bisectors() const;

  // The mesh cut along the bisectors, so that each triangle lies in one cell.
  struct Cut
  {
    // Sites first, then where bisectors cross sides, then where three meet.
    std::vector<Location> vertices;
    std::vector<Index> corners; // 3 #triangles
    // #triangles: none unless all corners of the triangle that it is part of are reached.
    std::vector<Index> labels;
  };
  // On a mesh.
  Cut cut() const;

private:
  // What a site knows of a cell other than its own.
  struct Other
  {
    Index site, label;
    double distance;
    bool operator<(const Other& other) const
    {
      return std::tie(site, label, distance) < std::tie(other.site, other.label, other.distance);
    }
  };
  struct Trace;

  double longest_around(Index site) const;
  double distance(Index site, Index label) const;
  double height(Index site, Index label) const;
  double share(Index side) const;
  Location crossing(Index side) const;
  Location triple_point(Index triangle) const;
  bool is_crossed(Index side) const;
  int number_of_labels(Index triangle) const;

  std::shared_ptr<const Glued_triangles> m_triangles;
  std::shared_ptr<const std::vector<double>> m_slowness;
  bool m_is_circular = true; // fronts are circles about their sources
  bool m_is_finished = true;
  std::vector<double> m_distances;
  std::vector<Index> m_labels;
  std::vector<Other> m_others; // sorted
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_VORONOI_H
