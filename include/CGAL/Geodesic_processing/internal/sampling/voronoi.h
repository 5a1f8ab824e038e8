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

// The geodesic Voronoi diagram of sources. Each vertex stores the label of the closest source and,
// near bisectors, the distances to the adjacent cells. All sources with the same label share a
// cell.
class CGAL_GEODESIC_PROCESSING_EXPORT Voronoi_diagram
{
public:
  // Runs one front from all sources, and one from the sources of each cell, which stops shortly
  // beyond the cell. Takes the time of two fronts over the surface, plus that of the overlaps of
  // cells.
  // sources: labels must be below `number_of_cells`
  Voronoi_diagram(std::shared_ptr<const Surface_arrays> triangles, Front front,
                  const std::vector<Front_source>& sources, Index number_of_cells,
                  const Front_limits& limits = {});

  // Returns false if the callback cancelled; cells are then too small.
  bool is_finished() const { return m_is_finished; }

  // #vertices: the distance to the closest source, and its label; infinity and none if unreached.
  const std::vector<double>& distances() const { return m_distances; }
  const std::vector<Index>& labels() const { return m_labels; }
  // Returns the cell of the centroid of a triangle, or none if a corner is unreached.
  Index triangle_label(Index triangle) const;

  // A bisector of two cells. Its ends are Voronoi vertices or boundary points, unless it is closed.
  // Consecutive locations are connected by a segment in a common triangle.
  struct Bisector
  {
    Index left, right; // the cells to the left and to the right
    std::vector<Surface_location> polyline;
    bool is_closed = false; // if true, the last location equals the first one
  };
  // Returns all bisectors of a mesh. O(n).
  std::vector<Bisector> bisectors() const;

  // The mesh split along the bisectors, so that each triangle lies in one cell.
  struct Cut_mesh
  {
    // The vertices of the mesh, the crossings of bisectors and edges, and the Voronoi vertices.
    std::vector<Surface_location> vertices;
    std::vector<Index> corners; // 3 #triangles
    // #triangles: the cell, or none if a corner of the original triangle is unreached.
    std::vector<Index> labels;

    Index add_vertex(const Surface_location& location)
    {
      vertices.push_back(location);
      return Index(vertices.size() - 1);
    }
  };
  // Splits a mesh along all bisectors. O(n).
  Cut_mesh cut() const;

private:
  // The distance from a vertex to a cell other than its own.
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
  // Adds a vertex for each crossed edge. Returns for each halfedge that vertex, or none.
  std::vector<Index> add_crossings(Cut_mesh& mesh) const;

  std::shared_ptr<const Surface_arrays> m_triangles;
  std::shared_ptr<const std::vector<double>> m_slowness;
  bool m_has_circular_fronts = true; // neither offsets nor slowness: fronts are circles
  bool m_is_finished = true;
  std::vector<double> m_distances;
  std::vector<Index> m_labels;
  std::vector<Other_distance> m_other_distances; // sorted
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SAMPLING_VORONOI_H
