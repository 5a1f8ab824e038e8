// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SAMPLING_VORONOI_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SAMPLING_VORONOI_H

#include <CGAL/Geodesic_processing/internal/distances/front.h>

#include <array>
#include <memory>
#include <tuple>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Which of several sources is nearest, the cells of a Voronoi diagram, and how far the others are where
// cells meet.  A cell belongs to all sources of one label.
class CGAL_GEODESIC_PROCESSING_EXPORT Voronoi_diagram
{
public:
  // One front from all sources, and one from those of each cell that ends soon after others come
  // first: the time of two fronts over the whole surface, and what cells visit beyond themselves.
  // sources: their labels are below `number_of_cells`.
  Voronoi_diagram(std::shared_ptr<const Surface_arrays> triangles, Front front,
                  const std::vector<Front_source>& sources, Index number_of_cells,
                  const Front_limits& limits = {});

  // False when the callback cancelled it: then cells are too small.
  bool is_finished() const { return m_is_finished; }

  const std::vector<double>& distances() const { return m_distances; }
  const std::vector<Index>& labels() const { return m_labels; } // none where no source reaches
  // The cell that a triangle's centre lies in; none unless all of its corners are reached.
  Index triangle_label(Index triangle) const;

  // Part of the line between two cells, from one place where three meet, or from a border, to the
  // next, or closed.  Consecutive locations lie in a common
  // triangle; inside it the line is straight.
  struct Bisector
  {
    Index left, right; // the cells on either side
    std::vector<Surface_location> polyline;
    bool is_closed = false; // the last location is the first one
  };
  // On a mesh.
  std::vector<Bisector> bisectors() const;

  // The mesh cut along the bisectors, so that each triangle lies in one cell.
  struct Cut_mesh
  {
    // Sites first, then where bisectors cross sides, then where three meet.
    std::vector<Surface_location> vertices;
    std::vector<Index> corners; // 3 #triangles
    // #triangles: none unless all corners of the triangle that it is part of are reached.
    std::vector<Index> labels;
  };
  // On a mesh.
  Cut_mesh cut() const;

private:
  // What a site knows of a cell other than its own.
  struct Other_distance
  {
    Index vertex, label;
    double distance;
    bool operator<(const Other_distance& other) const
    {
      return std::tie(vertex, label, distance) <
             std::tie(other.vertex, other.label, other.distance);
    }
  };
  struct Bisector_tracer;

  double max_edge_time(Index vertex) const;
  double distance(Index vertex, Index label) const;
  double comparison_value(Index vertex, Index label) const;
  double crossing_fraction(Index h) const;
  Surface_location crossing_location(Index h) const;
  Surface_location triple_point(Index triangle) const;
  bool is_crossed(Index h) const;
  int number_of_labels(Index triangle) const;

  std::shared_ptr<const Surface_arrays> m_triangles;
  std::shared_ptr<const std::vector<double>> m_slowness;
  bool m_has_circular_fronts = true; // fronts are circles about their sources
  bool m_is_finished = true;
  std::vector<double> m_distances;
  std::vector<Index> m_labels;
  std::vector<Other_distance> m_other_distances; // sorted
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SAMPLING_VORONOI_H
